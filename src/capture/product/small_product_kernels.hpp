// The compiled kernels of small_product.hpp, one for each instruction set. Plain pointers only: a
// file compiled for AVX2 must not share inline functions of the standard library with the rest.
#pragma once

#include <cstddef>

namespace burnish {

using SmallProduct = void(std::size_t m, std::size_t n, std::size_t k, const float* a,
                          const float* b, std::size_t b_row, float* c);

SmallProduct small_product_baseline;
#ifdef BURNISH_HAS_AVX
SmallProduct small_product_avx2, small_product_avx512;
#endif

}  // namespace burnish
