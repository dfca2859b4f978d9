// The shadowing integral of Ashikhmin, Premoze & Shirley for the Ashikhmin-Shirley lobe.
//
// In polar angles h = (sin t cos phi, sin t sin phi, cos t) and with E(phi) = e_x cos^2 + e_y
// sin^2,
//   g(k) = sqrt((e_x+2)(e_y+2)) / (2 pi) Int dphi Int dt sin t cos^E t (k_z cos t + k_r c sin t)_+,
// k_r c = k_x cos phi + k_y sin phi. The inner integral is elementary but for an incomplete beta
// function, and tan(phi) = sqrt((e_x+2)/(e_y+2)) tan(u) gives
//   sqrt((e_x+2)(e_y+2)) dphi = (E+2) du,
// so that the azimuths are evenly lit whatever the exponents.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "further_brdfs.hpp"

namespace burnish::oracle {

namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;
constexpr long double kUlp = std::numeric_limits<long double>::epsilon();

// The continued fraction of the incomplete beta function (Abramowitz & Stegun 26.5.8) by Lentz's
// method; it converges fast for x < (a + 1) / (a + b + 2).
long double beta_fraction(long double a, long double b, long double x) {
    constexpr long double kTiny = 1e-4000L;  // stands for 0 in Lentz's denominators
    const auto not_zero = [](long double v) { return v == 0 ? kTiny : v; };
    long double c = 1;
    long double d = 1 / not_zero(1 - (a + b) * x / (a + 1));
    long double value = d;
    for (int m = 1; m < 10000; ++m) {
        const long double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        d = 1 / not_zero(1 + even * d);
        c = not_zero(1 + even / c);
        value *= c * d;
        const long double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        d = 1 / not_zero(1 + odd * d);
        c = not_zero(1 + odd / c);
        value *= c * d;
        if (fabsl(c * d - 1) < 2 * kUlp) break;
    }
    return value;
}

// Int_0^x s^(a-1) (1-s)^(b-1) ds, y = 1 - x.
long double incomplete_beta(long double a, long double b, long double x, long double y) {
    if (x <= 0) return 0;
    const long double whole = expl(lgammal(a) + lgammal(b) - lgammal(a + b));
    if (y <= 0) return whole;
    const long double front = powl(x, a) * powl(y, b);
    if (x < (a + 1) / (a + b + 2)) return front * beta_fraction(a, b, x) / a;
    return whole - front * beta_fraction(b, a, y) / b;
}

struct Azimuths {
    long double e_x, e_y;
    Vec3 k;

    // The integrand over u: (E+2) times the integral over t.
    long double operator()(long double u) const {
        const long double x = sqrtl(e_y + 2) * cosl(u);
        const long double y = sqrtl(e_x + 2) * sinl(u);
        const long double r = hypotl(x, y);
        const long double e = (e_x * x * x + e_y * y * y) / (r * r);
        const long double sideways = (k.x * x + k.y * y) / r;
        // k_z cos t + sideways sin t > 0 up to tan t = k_z / -sideways.
        const long double l = hypotl(k.z, sideways);
        const long double sin_end = sideways < 0 ? k.z / l : 1;
        const long double cos_end = sideways < 0 ? -sideways / l : 0;
        return k.z * (1 - powl(cos_end, e + 2)) +
               (e + 2) * sideways * sin2_cos_power_integral(e, sin_end, cos_end);
    }
};

// Double-exponential quadrature of f over [a, b].
long double integrate(const Azimuths& f, long double a, long double b, long double step) {
    constexpr long double kLast = 3.5L;  // the weight is 3e-21 there
    long double sum = 0;
    const int n = static_cast<int>(floorl(kLast / step));
    for (int k = -n; k <= n; ++k) {
        const long double t = k * step;
        const long double e = expl(-kPi * sinhl(fabsl(t)));
        const long double near_end = (b - a) * e / (1 + e);
        const long double weight = step * e / ((1 + e) * (1 + e)) * kPi * coshl(t);
        sum += weight * f(t < 0 ? a + near_end : b - near_end);
    }
    return sum * (b - a);
}

}  // namespace

long double sin2_cos_power_integral(long double e, long double sin_theta, long double cos_theta) {
    return incomplete_beta(1.5L, (e + 1) / 2, sin_theta * sin_theta, cos_theta * cos_theta) / 2;
}

long double aps_g(long double e_x, long double e_y, Vec3 k) {
    const Azimuths f{e_x, e_y, k};
    // Pieces end on the axes, where E turns fastest, and where h.k = 0 passes the horizon.
    const long double horizon = atan2l(sqrtl(e_y + 2) * k.x, -sqrtl(e_x + 2) * k.y);
    std::vector<long double> ends{-kPi, -kPi / 2, 0, kPi / 2, kPi};
    ends.push_back(horizon);
    ends.push_back(horizon > 0 ? horizon - kPi : horizon + kPi);
    std::sort(ends.begin(), ends.end());

    const auto whole = [&](long double step) {
        long double sum = 0;
        for (std::size_t j = 1; j < ends.size(); ++j) {
            if (ends[j] - ends[j - 1] > 8 * kUlp) {
                sum += integrate(f, ends[j - 1], ends[j], step);
            }
        }
        return sum / (2 * kPi);
    };
    long double value = whole(1.0L / 8);
    for (const long double step : {1.0L / 16, 1.0L / 32, 1.0L / 64, 1.0L / 128}) {
        const long double before = std::exchange(value, whole(step));
        if (fabsl(value - before) <= 1e-10L * value) break;  // the error is about its square
    }
    return value;
}

}  // namespace burnish::oracle
