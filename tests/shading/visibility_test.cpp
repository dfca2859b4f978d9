// Functions on the sphere by harmonics (shading/surface/visibility.glsl), against quadrature.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "burnish/f32.hpp"
#include "burnish/f64.hpp"
#include "core/constants.hpp"

namespace burnish {
namespace {

using f64::Harmonics;
using f64::vec3;

struct Node {
    double x = 0, weight = 0;
};

// Gauss-Legendre's 12 nodes over [low, high]: exact for polynomials up to degree 23.
std::vector<Node> gauss_nodes(double low, double high) {
    constexpr unsigned kCount = 12;
    std::vector<Node> nodes;
    for (unsigned i = 0; i < kCount; ++i) {
        double x = std::cos(kPi * (i + 0.75) / (kCount + 0.5)), slope = 1;
        for (int step = 0; step < 20; ++step) {
            slope = kCount * (x * std::legendre(kCount, x) - std::legendre(kCount - 1, x)) /
                    (x * x - 1);
            x -= std::legendre(kCount, x) / slope;
        }
        nodes.push_back(
            {low + (high - low) * (x + 1) / 2, (high - low) / ((1 - x * x) * slope * slope)});
    }
    return nodes;
}

// The sum of `f` over the directions whose cosine to `n` lies in [low, 1], times the solid angle; exact for
// polynomials in the direction up to degree 15.
template <typename Value>
Value integral(vec3 n, double low, const std::function<Value(vec3)>& f) {
    const vec3 side = std::abs(n.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0);
    const vec3 t = f64::normalize(f64::cross(side, n)), b = f64::cross(n, t);
    constexpr int kTurns = 16;
    Value sum{};
    for (const Node& node : gauss_nodes(low, 1.0)) {
        const double sine = std::sqrt(1 - node.x * node.x);
        for (int i = 0; i < kTurns; ++i) {
            const double phi = 2 * kPi * (i + 0.5) / kTurns;
            sum = sum + f(t * (sine * std::cos(phi)) + b * (sine * std::sin(phi)) + n * node.x) *
                            (node.weight * 2 * kPi / kTurns);
        }
    }
    return sum;
}

std::array<double, 16> values_of(const Harmonics& h) {
    return {h.mean, h.x1.x, h.x1.y, h.x1.z, h.x2.x, h.x2.y, h.x2.z, h.y2.x,
            h.y2.y, h.x3.x, h.x3.y, h.x3.z, h.y3.x, h.y3.y, h.y3.z, h.z3};
}

Harmonics harmonics_of(const std::array<double, 16>& v) {
    return {v[0],         {v[1], v[2], v[3]},   {v[4], v[5], v[6]},
            {v[7], v[8]}, {v[9], v[10], v[11]}, {v[12], v[13], v[14]},
            v[15]};
}

f32::vec3 to_single(vec3 v) {
    return f32::vec3(v);
}

f32::Harmonics to_single(const Harmonics& h) {
    return {static_cast<float>(h.mean),
            to_single(h.x1),
            to_single(h.x2),
            {static_cast<float>(h.y2.x), static_cast<float>(h.y2.y)},
            to_single(h.x3),
            to_single(h.y3),
            static_cast<float>(h.z3)};
}

// The coefficients of a function on the sphere.
Harmonics coefficients_of(const std::function<double(vec3)>& f) {
    std::array<double, 16> sums{};
    for (std::size_t k = 0; k < sums.size(); ++k)
        sums[k] =
            integral<double>({0, 0, 1}, -1.0,
                             [&](vec3 w) { return f(w) * values_of(f64::harmonics_at(w))[k]; }) /
            (4 * kPi);
    return harmonics_of(sums);
}

class Random {
  public:
    double operator()() { return uniform_(engine_); }  // in [-1, 1]
    vec3 direction() {
        const double z = (*this)(), phi = kPi * (*this)(), sine = std::sqrt(1 - z * z);
        return {sine * std::cos(phi), sine * std::sin(phi), z};
    }

  private:
    std::mt19937 engine_{7};
    std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

// A polynomial of degree `degree` at most in x, y and z, whose values on the sphere lie in [0.05, 0.95]. On the
// sphere those of degree 3 are the functions of bands 0 to 3.
std::function<double(vec3)> random_polynomial(Random& random, int degree) {
    std::vector<std::array<int, 3>> powers;
    for (int i = 0; i <= degree; ++i)
        for (int j = 0; i + j <= degree; ++j)
            for (int k = 0; i + j + k <= degree; ++k) powers.push_back({i, j, k});
    std::vector<double> factors;
    double sum = 0;
    for (std::size_t i = 0; i < powers.size(); ++i) {
        factors.push_back(random());
        sum += std::abs(factors.back());
    }
    return [=](vec3 w) {
        double value = 0;
        for (std::size_t i = 0; i < powers.size(); ++i)
            value += factors[i] * std::pow(w.x, powers[i][0]) * std::pow(w.y, powers[i][1]) *
                     std::pow(w.z, powers[i][2]);
        return 0.5 + 0.45 * value / sum;
    };
}

// The constants of the text have 7 decimals: 1.3228757 is 3.4e-8 of itself too large, and enters squared.
constexpr double kDigits = 1e-7;

TEST(Harmonics, AreOrthonormalInTheMeanOverTheSphere) {
    for (std::size_t i = 0; i < 16; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const double mean = integral<double>({0, 0, 1}, -1.0,
                                                 [&](vec3 w) {
                                                     const auto h = values_of(f64::harmonics_at(w));
                                                     return h[i] * h[j];
                                                 }) /
                                (4 * kPi);
            EXPECT_NEAR(mean, i == j ? 1.0 : 0.0, kDigits) << i << ", " << j;
        }
}

TEST(BlockedTowards, ReturnsFunctionsOfFourBands) {
    Random random;
    for (int repeat = 0; repeat < 20; ++repeat) {
        const auto f = random_polynomial(random, 3);
        const Harmonics h = coefficients_of(f);
        for (int i = 0; i < 50; ++i) {
            const vec3 w = random.direction();
            EXPECT_NEAR(f64::blocked_towards(h, w), f(w), 4 * kDigits);
        }
    }
}

TEST(BlockedTowards, StaysBetweenNothingAndAll) {
    const Harmonics h = coefficients_of([](vec3 w) { return 0.5 + 2 * w.x; });
    EXPECT_EQ(f64::blocked_towards(h, {1, 0, 0}), 1.0);
    EXPECT_EQ(f64::blocked_towards(h, {-1, 0, 0}), 0.0);
}

// A clamped cosine passes nothing of band 3, so that the mean of four bands is exact.
TEST(BlockedAbout, IsTheMeanOverTheHemisphereWeightedByTheCosine) {
    Random random;
    for (int repeat = 0; repeat < 20; ++repeat) {
        const auto f = random_polynomial(random, 3);
        const Harmonics h = coefficients_of(f);
        for (int i = 0; i < 10; ++i) {
            const vec3 n = random.direction();
            const double mean =
                integral<double>(n, 0.0, [&](vec3 w) { return f(w) * f64::dot(w, n); }) / kPi;
            EXPECT_NEAR(f64::blocked_about(h, n), mean, 4 * kDigits);
        }
    }
}

TEST(BlockedAbout, LeavesBand3Out) {
    Random random;
    for (std::size_t k = 9; k < 16; ++k) {
        std::array<double, 16> values{};
        values[0] = 0.5;
        const Harmonics without = harmonics_of(values);
        values[k] = 0.3;
        const vec3 n = random.direction();
        EXPECT_EQ(f64::blocked_about(harmonics_of(values), n), f64::blocked_about(without, n));
        // The mean itself has nothing of it.
        const double mean = integral<double>(
            n, 0.0, [&](vec3 w) { return values_of(f64::harmonics_at(w))[k] * f64::dot(w, n); });
        EXPECT_NEAR(mean, 0.0, 1e-12) << k;
    }
}

TEST(OpenDirection, IsTheIntegralOfOpenDirectionsWeightedByTheCosine) {
    Random random;
    for (int repeat = 0; repeat < 50; ++repeat) {
        const auto f = random_polynomial(random, 1);
        const Harmonics h = coefficients_of(f);
        const vec3 n = random.direction();
        const vec3 wanted =
            integral<vec3>(n, 0.0, [&](vec3 w) { return w * ((1 - f(w)) * f64::dot(w, n)); }) *
            (1 / kPi);
        const vec3 found = f64::open_direction(h, n);
        EXPECT_NEAR(f64::length(found - wanted), 0.0, 4 * kDigits);
        // Its direction is what is read.
        EXPECT_NEAR(f64::dot(f64::normalize(found), f64::normalize(wanted)), 1.0, kDigits);
    }
}

TEST(OpenDirection, IsTheNormalWhereNothingAndZeroWhereEverythingIsBlocked) {
    Random random;
    const vec3 n = random.direction();
    EXPECT_NEAR(f64::length(f64::open_direction(Harmonics{}, n) - n * (2.0 / 3)), 0.0, 1e-15);
    Harmonics all{};
    all.mean = 1;
    EXPECT_EQ(f64::length(f64::open_direction(all, n)), 0.0);
}

// Whatever the coefficients, it does not point below the surface.
TEST(OpenDirection, StaysAboveTheSurface) {
    Random random;
    for (int repeat = 0; repeat < 1000; ++repeat) {
        std::array<double, 16> values{};
        for (double& value : values) value = random();
        const vec3 n = random.direction();
        // 1e-15: rounding of a vector of length 1.
        EXPECT_GE(f64::dot(f64::open_direction(harmonics_of(values), n), n), -1e-15);
    }
}

TEST(SurroundingsAbout, IsTheMeanOverTheHemisphereWeightedByTheCosine) {
    Random random;
    for (int repeat = 0; repeat < 50; ++repeat) {
        // Slopes below 1 leave no direction without light.
        const f64::Surroundings s{{0.2, 0.5, 3.0}, random.direction() * 0.9, 1.0};
        const vec3 n = random.direction();
        const double share = 0.5 + 0.5 * random();
        const vec3 wanted =
            integral<vec3>(
                n, 0.0, [&](vec3 w) { return f64::surroundings_towards(s, w) * f64::dot(w, n); }) *
            (share / kPi);
        EXPECT_NEAR(f64::length(f64::surroundings_about(s, share, n) - wanted), 0.0, 1e-12);
    }
}

TEST(SurroundingsTowards, AreNeverNegative) {
    const f64::Surroundings s{{1, 2, 3}, {0, 0, 2}, 1.0};
    EXPECT_EQ(f64::length(f64::surroundings_towards(s, {0, 0, -1})), 0.0);
    EXPECT_EQ(f64::surroundings_towards(s, {0, 0, 1}).z, 9.0);
}

// Sixteen products of up to 3.3 times coefficients of up to 1, each within 2^-23: 6e-6 at most, and less as
// their errors differ in sign. Measured: 8e-7.
TEST(Visibility, IsTheSameInSinglePrecision) {
    constexpr double kRounding = 2e-6;
    Random random;
    for (int repeat = 0; repeat < 200; ++repeat) {
        std::array<double, 16> values{};
        for (double& value : values) value = static_cast<float>(random() / 4);
        values[0] += 0.5;
        const Harmonics h = harmonics_of(values);
        const f32::Harmonics single = to_single(h);
        const vec3 w = random.direction();
        const f32::vec3 w1 = to_single(w);
        EXPECT_NEAR(f32::blocked_towards(single, w1), f64::blocked_towards(h, w), kRounding);
        EXPECT_NEAR(f32::blocked_about(single, w1), f64::blocked_about(h, w), kRounding);
        const vec3 open(f32::open_direction(single, w1));
        EXPECT_NEAR(f64::length(open - f64::open_direction(h, w)), 0.0, kRounding);
        const f64::Surroundings s{{1, 0.5, 0.25}, random.direction(), 1.0};
        const f32::Surroundings s1{to_single(s.color), to_single(s.slope), 1.0f};
        const vec3 around(f32::surroundings_about(s1, 0.5f, w1));
        EXPECT_NEAR(f64::length(around - f64::surroundings_about(s, 0.5, w)), 0.0, kRounding);
    }
}

}  // namespace
}  // namespace burnish
