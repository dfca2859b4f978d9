#include "capture/product/small_product.hpp"

#include "capture/product/small_product_kernels.hpp"

namespace burnish {

namespace {

struct Kernel {
    const char* instructions;
    SmallProduct* product;
};

Kernel chosen() {
#ifdef BURNISH_HAS_AVX
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
        return {"avx512", small_product_avx512};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return {"avx2", small_product_avx2};
#endif
    return {"baseline", small_product_baseline};
}

const Kernel& kernel() {
    static const Kernel once = chosen();
    return once;
}

}  // namespace

void small_product(std::size_t m, std::size_t n, std::size_t k, const float* a, const float* b,
                   std::size_t b_row, float* c) {
    kernel().product(m, n, k, a, b, b_row, c);
}

const char* small_product_instructions() {
    return kernel().instructions;
}

}  // namespace burnish
