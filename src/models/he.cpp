#include "models/he.hpp"

#include <algorithm>
#include <cmath>

#include "burnish/f64.hpp"
#include "core/constants.hpp"

namespace burnish {
namespace {

// What the equations ask of a direction at angle theta to the normal.
struct Incidence {
    double u;  // tau cot(theta) / (2 sigma)
    double k;  // tan(theta) erfc(u)
};

Incidence incidence_of(HeSurface surface, Direction<double> w) {
    const double sine = std::hypot(w.x, w.y);
    if (!(sine > 0)) return {HUGE_VAL, 0};
    const double cotangent = w.z / sine;
    const double u = surface.tau * cotangent / (2 * surface.sigma);
    return {u, std::erfc(u) / cotangent};
}

// S(theta): Sancer's shadowing.
double shadowing(const Incidence& w) {
    // Beyond 26 both terms of Lambda are below 1e-290.
    if (w.u > 26) return 1;
    const double hidden = std::erfc(w.u);
    const double lambda = 0.5 * (std::exp(-w.u * w.u) / (w.u * std::sqrt(kPi)) - hidden);
    return (1 - 0.5 * hidden) / (std::max(lambda, 0.0) + 1);
}

// z with sqrt(pi/2) z = (k/4) exp(-z^2/2), z in units of sigma. For q = k / (4 sqrt(pi/2)) it is
// the root of ln z + z^2/2 = ln q, which rises everywhere; Newton's steps in ln z see a convex
// function and come down on the root from above.
double effective_height(double k) {
    const double q = std::min(k / (4 * std::sqrt(kPi / 2)), 1e300);  // tan at the very horizon
    if (!(q > 0)) return 0;
    const double target = std::log(q);
    // Above the root: z <= q always, and z^2/2 <= ln q where z >= 1.
    double l = std::min(target, q > 1 ? 0.5 * std::log(2 * target + 1) : target);
    for (int step = 0; step < 40; ++step) {
        const double z2 = std::exp(2 * l);
        const double change = (l + 0.5 * z2 - target) / (1 + z2);
        l -= change;
        if (std::fabs(change) < 1e-15) break;
    }
    return std::exp(l);
}

double log_term(double g, double x, double m) {
    return m * std::log(g) - g - std::lgamma(m + 1) - std::log(m) - x / m;
}

// t(m+1) / t(m): falls as m rises, so that terms climb to one mode and fall ever faster beyond it.
double ratio(double g, double x, double m) {
    return g * m / ((m + 1) * (m + 1)) * std::exp(x / (m * (m + 1)));
}

// The largest m whose term is no smaller than the one before: by bisection on the ratio.
double mode_of(double g, double x) {
    double low = 1, high = 2;
    while (ratio(g, x, high) >= 1) {
        low = high;
        high *= 2;
    }
    while (high - low > 1) {
        const double middle = std::floor(0.5 * (low + high));
        (ratio(g, x, middle) >= 1 ? low : high) = middle;
    }
    return ratio(g, x, low) >= 1 ? low + 1 : low;
}

}  // namespace

HeSeries he_series(double g, double x, double remainder) {
    if (!(g > 0)) return {0, 0};
    const double mode = mode_of(g, x);
    double sum = 1, last = mode;  // in units of the largest term
    double term = 1;
    for (double m = mode; m > 1; --m) {
        const double back = 1 / ratio(g, x, m - 1);
        term *= back;
        sum += term;
        if (back < 1 && term * back < remainder * 1e-2 * (1 - back) * sum) break;
    }
    term = 1;
    for (double r = ratio(g, x, last);; r = ratio(g, x, last)) {
        // Every further ratio is below r: what is left is at most a geometric series.
        if (r < 1 && term * r < remainder * (1 - r) * sum) break;
        term *= r;
        sum += term;
        ++last;
    }
    return {std::exp(log_term(g, x, mode)) * sum, static_cast<int>(last)};
}

double he_value(HeSurface surface, Direction<double> wi, Direction<double> wo) {
    if (!(wi.z > 0 && wo.z > 0 && surface.sigma > 0)) return 0;
    const Incidence in = incidence_of(surface, wi), out = incidence_of(surface, wo);
    const double z = effective_height(in.k + out.k);
    const double sigma_e = surface.sigma / std::sqrt(1 + z * z);
    const Direction<double> v = wi + wo;
    const double height = 2 * kPi * sigma_e * v.z;
    // v_xy^2 tau^2 / 4 with v in radians a wavelength.
    const double x = kPi * kPi * surface.tau * surface.tau * (v.x * v.x + v.y * v.y);
    const double series = he_series(height * height, x, kHeRemainder).sum;
    const double D = 0.25 * kPi * kPi * surface.tau * surface.tau * series;
    // The printed quotient over |k_o x k_i|^4 is 1: its numerator is that cross product's square,
    // twice, because s, p and k are orthonormal.
    const double geometric = dot(v, v) / v.z;
    return geometric * geometric * (shadowing(in) / wi.z) * (shadowing(out) / wo.z) * D / kPi;
}

namespace {

f64::Lobe slopes_of(HeSurface surface) {
    const double m = std::clamp(2 * surface.sigma / surface.tau, kLeastAlpha, kMostAlpha);
    return f64::lobe_make(f64::kMdfBeckmann, m, m);
}

f64::Perturbation unperturbed() {
    return f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
}

}  // namespace

Direction<double> he_sample(HeSurface surface, Direction<double> wo, std::array<double, 3> xi,
                            double& pdf) {
    Direction<double> wi;
    if (xi[2] < 0.5) {
        wi = brdf_sample(f64::kBrdfWardGmd, slopes_of(surface), unperturbed(), wo, {xi[0], xi[1]},
                         0.0, pdf);
        if (!(pdf > 0)) return wi;
    } else {
        wi = f64::cosine_sample({xi[0], xi[1]});
    }
    pdf = he_pdf(surface, wi, wo);
    return wi;
}

double he_pdf(HeSurface surface, Direction<double> wi, Direction<double> wo) {
    return 0.5 * brdf_pdf(f64::kBrdfWardGmd, slopes_of(surface), unperturbed(), wi, wo) +
           0.5 * f64::cosine_pdf(wi.z);
}

}  // namespace burnish
