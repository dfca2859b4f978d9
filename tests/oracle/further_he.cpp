// The pieces of He et al. 1991: shadowing, effective roughness, the series of Eq 78.
#include <cmath>
#include <limits>
#include <numbers>

#include "further_brdfs.hpp"

namespace burnish::oracle {

namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;

long double tan_theta(Vec3 k) {
    return hypotl(k.x, k.y) / k.z;
}

// Eq 82-83.
long double he_k(long double sigma, long double tau, Vec3 k) {
    return tan_theta(k) * erfcl(he_slope_ratio(sigma, tau, k));
}

}  // namespace

long double he_slope_ratio(long double sigma, long double tau, Vec3 k) {
    return tau / (2 * sigma * tan_theta(k));  // infinite at the normal
}

long double he_shadowing(long double slope_ratio) {
    if (std::isinf(slope_ratio)) return 1;
    const long double a = slope_ratio;
    const long double lambda = (expl(-a * a) / (a * sqrtl(kPi)) - erfcl(a)) / 2;
    return (1 - erfcl(a) / 2) / (lambda + 1);
}

// Newton's method on the convex, growing x exp(x^2/2) - c, kept between bounds by bisection.
long double he_z0_over_sigma(long double k_sum) {
    const long double c = k_sum / sqrtl(8 * kPi);
    long double low = 0;
    long double high = c > 1 ? sqrtl(2 * logl(c)) + 1 : c;
    long double x = high;
    for (int iteration = 0; iteration < 200; ++iteration) {
        const long double grown = x * expl(x * x / 2);
        (grown > c ? high : low) = x;
        long double next = x - (grown - c) / ((1 + x * x) * expl(x * x / 2));
        if (!(next > low && next < high)) next = (low + high) / 2;
        const long double moved = fabsl(next - x);
        x = next;
        if (moved <= 2 * std::numeric_limits<long double>::epsilon() * x) break;
    }
    return x;
}

long double he_effective_sigma(long double sigma, long double tau, Vec3 i, Vec3 o) {
    const long double x = he_z0_over_sigma(he_k(sigma, tau, i) + he_k(sigma, tau, o));
    return sigma / sqrtl(1 + x * x);
}

// The ratio of term m+1 to term m, g m / (m+1)^2 exp(b / (m (m+1))), falls with m, so that the
// terms have one peak and beyond it fall faster than a geometric series. The sum starts at the
// peak.
long double he_log_series(long double g, long double b) {
    const auto ratio = [&](long double m) {
        return g * m / ((m + 1) * (m + 1)) * expl(b / (m * (m + 1)));
    };
    long double low = 0;   // the ratio is >= 1 at low, or low = 0
    long double high = 1;  // the ratio is < 1 at high
    while (ratio(high) >= 1) high *= 2;
    while (high - low > 1) {
        const long double middle = floorl((low + high) / 2);
        (ratio(middle) >= 1 ? low : high) = middle;
    }
    const long double peak = high;
    constexpr long double kNothing = 1e-24L;  // times the few thousand terms left: below rounding
    long double sum = 1;
    long double term = 1;
    for (long double m = peak; term > kNothing; ++m) {
        term *= ratio(m);
        sum += term;
    }
    term = 1;
    for (long double m = peak - 1; m >= 1 && term > kNothing; --m) {
        term /= ratio(m);
        sum += term;
    }
    return logl(sum) + peak * logl(g) - g - lgammal(peak + 1) - logl(peak) - b / peak;
}

}  // namespace burnish::oracle
