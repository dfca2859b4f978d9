// Random numbers, directions and lobes of which the generators of cases are made: for their
// sources.

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

#include "oracle.hpp"

namespace burnish::oracle {

// std::mt19937_64 is the same everywhere; the standard's distributions are not, hence these.
class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}

    long double unit() { return static_cast<long double>(engine_() >> 11) * 0x1p-53L; }  // [0, 1)
    long double range(long double a, long double b) { return a + (b - a) * unit(); }
    long double log_range(long double a, long double b) { return a * powl(b / a, unit()); }
    bool chance(long double p) { return unit() < p; }
    template <std::size_t N>
    long double pick(const std::array<long double, N>& values) {
        return values[static_cast<std::size_t>(engine_() % N)];
    }

  private:
    std::mt19937_64 engine_;
};

inline long double as_double(long double a) {
    return static_cast<long double>(static_cast<double>(a));
}
inline Vec3 as_double(Vec3 v) {
    return {as_double(v.x), as_double(v.y), as_double(v.z)};
}

inline Vec3 random_direction(Random& random) {
    const long double z = random.range(-1, 1);
    const long double phi = random.range(0, 2 * std::numbers::pi_v<long double>);
    const long double s = sqrtl(1 - z * z);
    return {s * cosl(phi), s * sinl(phi), z};
}

inline long double random_azimuth(Random& random) {
    constexpr std::array<long double, 4> kAxes{0, 90, 180, 270};
    return random.chance(0.2L) ? random.pick(kAxes) : random.range(0, 360);
}

// tilted(), but exact on the axes, where cos(90 degrees) should be 0 and not 1e-20.
inline Vec3 tilted_clean(long double tilt_deg, long double azimuth_deg) {
    Vec3 v = tilted(tilt_deg, azimuth_deg);
    if (fabsl(v.x) < 1e-17L * fabsl(v.y)) v.x = 0;
    if (fabsl(v.y) < 1e-17L * fabsl(v.x)) v.y = 0;
    return v;
}

// A direction with h_z = 1e-3 .. 1e-9.
inline Vec3 grazing_direction(Random& random) {
    const long double z = powl(10, -floorl(random.range(3, 10)));
    Vec3 v = tilted_clean(90, random_azimuth(random));
    v.z = 0;
    v = sqrtl(1 - z * z) * v;
    v.z = z;
    return v;
}

// Exponents or alphas: the ends of the range, equal ones, and anything in between.
inline std::array<long double, 2> random_lobe(Random& random, bool exponents) {
    constexpr std::array<long double, 6> kExponents{0, 1, 10, 200, 1000, 10000};
    constexpr std::array<long double, 5> kAlphas{0.01L, 0.1L, 0.3L, 0.5L, 1};
    std::array<long double, 2> p{};
    for (long double& value : p) {
        const bool listed = random.chance(0.2L);
        if (exponents) {
            value = listed ? random.pick(kExponents) : random.log_range(0.1L, 10000);
        } else {
            value = listed ? random.pick(kAlphas) : random.log_range(0.01L, 1);
        }
        value = as_double(value);
    }
    if (random.chance(0.1L)) p[1] = p[0];
    return p;
}

// A reflectance: the ends, a dielectric's, and anything in between.
inline long double random_share(Random& random) {
    constexpr std::array<long double, 3> kEnds{0, 0.04L, 1};
    return as_double(random.chance(0.2L) ? random.pick(kEnds) : random.range(0, 1));
}

// A half vector of the unperturbed lobe: slopes Gaussian, `spread` times as wide as p0 and p1 say.
inline Vec3 sample_lobe(Random& random, bool exponents, long double p0, long double p1,
                        long double spread) {
    const long double alpha_x = exponents ? sqrtl(2 / (p0 + 2)) : p0;
    const long double alpha_y = exponents ? sqrtl(2 / (p1 + 2)) : p1;
    const long double r = random.range(0.3L, 2) * spread * sqrtl(-logl(1 - random.unit()));
    const long double phi = random.range(0, 2 * std::numbers::pi_v<long double>);
    return normalize({alpha_x * r * cosl(phi), alpha_y * r * sinl(phi), 1});
}

inline Vec3 rescaled(Random& random, Vec3 v) {
    return random.chance(0.15L) ? random.log_range(0.01L, 100) * v : v;
}

}  // namespace burnish::oracle
