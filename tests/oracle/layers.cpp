#include "layers.hpp"

#include <algorithm>
#include <cmath>

namespace burnish::oracle {
namespace {

const long double kPiL = std::acos(-1.0L);

long double dot3(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vec3 half_of(Vec3 i, Vec3 o) {
    const Vec3 sum{i.x + o.x, i.y + o.y, i.z + o.z};
    const long double length = std::sqrt(dot3(sum, sum));
    return {sum.x / length, sum.y / length, sum.z / length};
}

Vec3 polar(long double cosine, long double azimuth) {
    const long double sine = std::sqrt(1 - cosine * cosine);
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

long double schlick(long double f0, long double f90, long double cosine) {
    return f0 + (f90 - f0) * std::pow(1 - cosine, 5.0L);
}

// Walter et al. 2007 Eq 33 and 34, through the angle.
long double ggx(long double alpha, long double cosine) {
    const long double theta = std::acos(std::min(cosine, 1.0L));
    const long double c = std::cos(theta), t = std::tan(theta);
    const long double part = alpha * alpha + t * t;
    return alpha * alpha / (kPiL * c * c * c * c * part * part);
}

long double lambda_of(long double alpha, long double cosine) {
    const long double t = std::tan(std::acos(std::min(cosine, 1.0L)));
    return (std::sqrt(1 + alpha * alpha * t * t) - 1) / 2;
}

// The curve of Estevez & Kulla, and Lambda from it.
long double l_of(long double x, long double alpha) {
    static constexpr long double kSharp[] = {25.3245L, 3.32435L, 0.16801L, -1.27393L, -4.85967L};
    static constexpr long double kWide[] = {21.5473L, 3.82987L, 0.19823L, -1.97760L, -4.32054L};
    long double p[5];
    const long double t = (1 - alpha) * (1 - alpha);
    for (int i = 0; i < 5; ++i) p[i] = t * kSharp[i] + (1 - t) * kWide[i];
    return p[0] / (1 + p[1] * std::pow(x, p[2])) + p[3] * x + p[4];
}

long double sheen_lambda(long double cosine, long double alpha) {
    return cosine < 0.5L ? std::exp(l_of(cosine, alpha))
                         : std::exp(2 * l_of(0.5L, alpha) - l_of(1 - cosine, alpha));
}

}  // namespace

long double coat_face(long double alpha, Vec3 n, Vec3 i, Vec3 o) {
    const long double ci = dot3(n, i), co = dot3(n, o);
    if (!(ci > 0) || !(co > 0)) return 0;
    const Vec3 h = half_of(i, o);
    const long double g = 1 / (1 + lambda_of(alpha, ci) + lambda_of(alpha, co));
    return ggx(alpha, dot3(n, h)) * g * schlick(0.04L, 1, dot3(i, h)) / (4 * ci * co);
}

// Over h instead of i: di = 4 (o.h) dh. With tan = alpha sqrt(u/(1 - u)), D cos dh = du dphi / (2 pi).
long double coat_albedo(long double alpha, long double cosine) {
    const Vec3 o = polar(cosine, 0), n{0, 0, 1};
    constexpr int kSteps = 160, kAngles = 64;
    long double sum = 0;
    for (int s = 0; s < kSteps; ++s) {
        const long double u = (s + 0.5L) / kSteps;
        const long double c = 1 / std::sqrt(1 + alpha * alpha * u / (1 - u));
        for (int a = 0; a < kAngles; ++a) {
            const Vec3 h = polar(c, 2 * kPiL * (a + 0.5L) / kAngles);
            const long double oh = dot3(o, h);
            if (oh <= 0) continue;
            const Vec3 i{2 * oh * h.x - o.x, 2 * oh * h.y - o.y, 2 * oh * h.z - o.z};
            if (i.z <= 0) continue;
            sum += coat_face(alpha, n, i, o) * i.z * 4 * oh / (ggx(alpha, c) * c);
        }
    }
    return sum / (kSteps * kAngles);
}

long double coat_absorption(long double tint, long double cosine) {
    const long double inside = std::asin(std::sin(std::acos(cosine)) / 1.5L);
    return std::pow(tint, 1 / (2 * std::cos(inside)));
}

long double to_and_fro(long double r, long double e, long double t_i, long double t_o) {
    long double sum = 0, power = r;
    for (int bounce = 0; bounce < 5000; ++bounce) {
        sum += t_i * power * t_o;
        power *= r * e;
    }
    return sum;
}

long double sheen(long double alpha, Vec3 n, Vec3 i, Vec3 o) {
    const long double ci = dot3(n, i), co = dot3(n, o);
    if (!(ci > 0) || !(co > 0)) return 0;
    const long double ch = dot3(n, half_of(i, o));
    const long double d =
        (2 + 1 / alpha) * std::pow(std::sin(std::acos(std::min(ch, 1.0L))), 1 / alpha) / (2 * kPiL);
    return d / ((1 + sheen_lambda(ci, alpha) + sheen_lambda(co, alpha)) * 4 * ci * co);
}

// Cosines as squares: sheen crowds towards the horizon.
long double sheen_albedo(long double alpha, long double cosine) {
    const Vec3 o = polar(cosine, 0), n{0, 0, 1};
    constexpr int kSteps = 160, kAngles = 80;
    long double sum = 0;
    for (int s = 0; s < kSteps; ++s) {
        const long double u = (s + 0.5L) / kSteps, z = u * u;
        for (int a = 0; a < kAngles; ++a) {
            const Vec3 i = polar(z, kPiL * (a + 0.5L) / kAngles);
            sum += sheen(alpha, n, i, o) * z * (2 * u / kSteps) * (2 * kPiL / kAngles);
        }
    }
    return sum;
}

long double dielectric_fresnel(long double ior, long double color, long double weight,
                               long double cosine) {
    const long double root = (ior - 1) / (ior + 1);
    const long double f0 = std::min(root * root * color, 1.0L);
    return weight * (f0 + (1 - f0) * std::pow(1 - cosine, 5.0L));
}

}  // namespace burnish::oracle
