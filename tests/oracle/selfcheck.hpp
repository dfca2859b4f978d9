// What the self checks of the oracle share: lobes, tolerances, points of the disk.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "make_cases.hpp"
#include "oracle.hpp"

namespace burnish::oracle {

inline constexpr long double kPi = std::numbers::pi_v<long double>;
inline constexpr Vec3 kUp{0, 0, 1};
inline constexpr std::array<long double, 4> kAzimuths{0, 30, 60, 90};

struct Lobe {
    std::string mdf;
    long double p0, p1;
};

inline const Lobe kRound{"ashikhmin-shirley", 20, 20};
inline const Lobe kBrushed{"ashikhmin-shirley", 200, 10};
inline const Lobe kBroad{"ashikhmin-shirley", 1, 40};
inline const Lobe kWard{"ward", 0.1L, 0.5L};
inline const Lobe kGgx{"ggx", 0.3L, 0.8L};

inline MdfValue value(const Lobe& l, const std::string& method, Vec3 n, Vec3 h) {
    return mdf_eval(l.mdf, l.p0, l.p1, method, n, h);
}

inline Transformed transformed(const std::string& method, Vec3 n, Vec3 h) {
    return mdf_transform("ggx", 0.1L, 0.2L, method, n, h);
}

inline void expect_close(long double got, long double expected, long double relative) {
    EXPECT_NEAR(static_cast<double>(got / expected), 1, static_cast<double>(relative));
}

inline void expect_near(Vec3 got, Vec3 expected, long double tolerance) {
    EXPECT_LT(length(got - expected), tolerance)
        << static_cast<double>(got.x) << ' ' << static_cast<double>(got.y) << ' '
        << static_cast<double>(got.z);
}

// The unit vector over the point p of the disk.
inline Vec3 lift(Vec3 p) {
    return {p.x, p.y, sqrtl(std::max(1 - p.x * p.x - p.y * p.y, 0.0L))};
}

// f(p) over points of the disk that crowd at the rim: the largest.
template <typename F>
long double disk_most(int rings, int spokes, F f) {
    long double most = 0;
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < spokes; ++j) {
            const long double r = 1 - powl((i + 0.5L) / rings, 4);
            const long double phi = 2 * kPi * j / spokes;
            most = std::max(most, f(Vec3{r * cosl(phi), r * sinl(phi), 0}));
        }
    }
    return most;
}

// f(p) over points evenly spread in area: the mean.
template <typename F>
long double disk_mean(int rings, int spokes, F f) {
    long double sum = 0;
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < spokes; ++j) {
            const long double r = sqrtl((i + 0.5L) / rings);
            const long double phi = 2 * kPi * (j + 0.5L) / spokes;
            sum += f(Vec3{r * cosl(phi), r * sinl(phi), 0});
        }
    }
    return sum / (rings * spokes);
}

inline std::vector<std::pair<Vec3, Vec3>> random_pairs(unsigned seed, int count) {
    std::mt19937_64 engine(seed);
    const auto unit = [&] { return static_cast<long double>(engine() >> 11) * 0x1p-53L; };
    std::vector<std::pair<Vec3, Vec3>> pairs;
    for (int k = 0; k < count; ++k) {
        const Vec3 n = tilted(85 * unit(), 360 * unit());
        const Vec3 h = tilted(89 * unit(), 360 * unit());
        pairs.emplace_back(n, h);
    }
    return pairs;
}

// det dq/dp = 1 / (1 - d.e) for linear, 1 + d.e / (2 sqrt(1-k) (1 - d.e)) for smooth.
inline long double deform_det(const std::string& method, Vec3 n, Vec3 h) {
    const Vec3 c{n.x, n.y, 0};
    const Vec3 q = transformed("deform-linear", n, h).v;
    const long double d_e = dot(c, normalize(Vec3{q.x, q.y, 0}));
    if (method == "deform-linear") return 1 / (1 - d_e);
    return 1 + d_e / (2 * sqrtl(deform_ratio(n, h)) * (1 - d_e));
}

}  // namespace burnish::oracle
