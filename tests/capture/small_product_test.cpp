// Products of small matrices compared with sums in double precision, for each kernel that runs
// here.
#include "capture/product/small_product.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "capture/product/small_product_kernels.hpp"
#include "table_support.hpp"

namespace burnish {
namespace {

struct Named {
    const char* name;
    SmallProduct* product;
};

std::vector<Named> kernels() {
    std::vector<Named> out = {{"dispatched", small_product}, {"baseline", small_product_baseline}};
#ifdef BURNISH_HAS_AVX
    const std::string_view best = small_product_instructions();
    if (best != "baseline") out.push_back({"avx2", small_product_avx2});
    if (best == "avx512") out.push_back({"avx512", small_product_avx512});
#endif
    return out;
}

constexpr float kUntouched = -77.0f;

// Error bound of sums of k products of numbers up to 1, each rounded once: at most k half units in
// the last place of sums up to k.
double rounding(std::size_t k) {
    const auto terms = static_cast<double>(k);
    return terms * terms * 6e-8 + 1e-12;
}

void expect_product(const Named& kernel, std::size_t m, std::size_t n, std::size_t k,
                    std::size_t gap) {
    test::Random random(static_cast<unsigned>(m * 1000 + n * 10 + k));
    const std::size_t b_row = n + gap;
    std::vector<float> a(k * m), b(k * b_row + gap), c(m * n + 4, kUntouched);
    for (float& v : a) v = static_cast<float>(random.uniform(-1, 1));
    for (float& v : b) v = static_cast<float>(random.uniform(-1, 1));
    kernel.product(m, n, k, a.data(), b.data(), b_row, c.data());
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            double sum = 0;
            for (std::size_t l = 0; l < k; ++l)
                sum += static_cast<double>(a[l * m + i]) * static_cast<double>(b[l * b_row + j]);
            ASSERT_NEAR(static_cast<double>(c[i * n + j]), sum, rounding(k))
                << kernel.name << ": " << m << " x " << n << " over " << k << ", gap " << gap
                << ", at " << i << ", " << j;
        }
    for (std::size_t i = m * n; i < c.size(); ++i) ASSERT_EQ(c[i], kUntouched) << kernel.name;
}

// Sizes one above and one below those of registers, blocks and copies, and the matcher's sizes.
TEST(SmallProduct, IsTheSumOfProducts) {
    for (const Named& kernel : kernels())
        for (const std::size_t m : {1u, 2u, 5u, 6u, 7u, 13u, 14u, 25u, 27u, 64u, 128u})
            for (const std::size_t n : {1u, 3u, 4u, 5u, 8u, 15u, 16u, 17u, 31u, 33u, 64u, 98u})
                for (const std::size_t k : {1u, 24u, 64u, 130u})
                    for (const std::size_t gap : {0u, 7u}) expect_product(kernel, m, n, k, gap);
}

TEST(SmallProduct, OfNothingIsZero) {
    for (const Named& kernel : kernels())
        for (const std::size_t n : {3u, 40u}) {
            std::vector<float> c(5 * n, kUntouched);
            const float none = 0;
            kernel.product(5, n, 0, &none, &none, n, c.data());
            for (const float v : c) EXPECT_EQ(v, 0.0f) << kernel.name;
        }
}

// A sum does not depend on the rows and columns computed with it, so that matches of parts agree.
TEST(SmallProduct, ASumDoesNotDependOnItsNeighbors) {
    test::Random random(5);
    const std::size_t k = 50, m = 30, n = 45;
    std::vector<float> a(k * m), b(k * n), whole(m * n), column(m);
    for (float& v : a) v = static_cast<float>(random.uniform(-1, 1));
    for (float& v : b) v = static_cast<float>(random.uniform(-1, 1));
    for (const Named& kernel : kernels()) {
        kernel.product(m, n, k, a.data(), b.data(), n, whole.data());
        for (std::size_t j = 0; j < n; ++j) {
            kernel.product(m, 1, k, a.data(), b.data() + j, n, column.data());
            for (std::size_t i = 0; i < m; ++i)
                ASSERT_EQ(column[i], whole[i * n + j]) << kernel.name << " " << i << " " << j;
        }
    }
}

}  // namespace
}  // namespace burnish
