// Products of small matrices on the calling thread. A BLAS would be as fast (bench/results), but
// its number of threads is a setting of the whole process, which a library must not change. These
// products need no setting and no lock.
#pragma once

#include <cstddef>

namespace burnish {

// C = A^T B in single precision; row-major: A is k x m and C is m x n, both without gaps; B is k x
// n, `b_row` floats from one row to the next. C must not overlap A or B. Each element is a sum over
// k in increasing order, by fused multiply and add where the processor has it. Thread-safe.
void small_product(std::size_t m, std::size_t n, std::size_t k, const float* a, const float* b,
                   std::size_t b_row, float* c);

// The instructions that small_product uses here: "avx512", "avx2" or "baseline".
const char* small_product_instructions();

}  // namespace burnish
