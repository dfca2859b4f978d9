#include "surface.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "facet_maps.hpp"
#include "further_brdfs.hpp"

namespace burnish::oracle {
namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;

long double clamped(long double v) {
    return std::clamp(v, 0.0L, 1.0L);
}

Vec3 neutral(Vec3 c) {
    const long double x = std::min({c.x, c.y, c.z});
    const long double offset = x < 0.08L ? x - 6.25L * x * x : 0.04L;
    c = c - Vec3{offset, offset, offset};
    const long double peak = std::max({c.x, c.y, c.z}), start = 0.8L - 0.04L;
    if (peak < start) return c;
    const long double d = 1 - start, new_peak = 1 - d * d / (peak + d - start);
    c = (new_peak / peak) * c;
    const long double g = 1 - 1 / (0.15L * (peak - new_peak) + 1);
    return (1 - g) * c + g * Vec3{new_peak, new_peak, new_peak};
}

Vec3 normal_at(long double slope_x, long double slope_y) {
    return normalize({slope_x, slope_y, 1});
}

// The direction that masking sees, unit but for normal-map, rotate-approx, slope-shift and stretch.
Vec3 masked_direction(const std::string& mdf, const std::array<long double, 5>& p,
                      const std::string& method, Vec3 n, Vec3 w) {
    if (moves_facets(method)) return facets_seen(method, n, w);
    const bool deforms = method == "deform-linear" || method == "deform-smooth";
    return mdf_transform(mdf, p[0], p[1], deforms ? "rotate-arc" : method, n, w).v;
}

long double smith(const std::string& brdf, const std::string& mdf,
                  const std::array<long double, 5>& p, Vec3 i, Vec3 o) {
    if (i.z <= 0 || o.z <= 0) return 0;
    const long double gi = smith_G1_closed(mdf, p[0], p[1], i);
    const long double go = smith_G1_closed(mdf, p[0], p[1], o);
    return brdf == "ggx-separable" ? gi * go : 1 / (1 / gi + 1 / go - 1);
}

long double cosine_lobe(const std::string& brdf, const std::array<long double, 5>& p,
                        const std::string& method, Vec3 n, Vec3 i, Vec3 o) {
    if (brdf == "phong") {
        const Vec3 mirror = 2 * dot(n, i) * n - i;
        const long double c = dot(mirror, o);
        return c > 0 ? p[0] * std::pow(c, p[1]) / dot(n, i) : 0;
    }
    // A round lobe: follow-grain takes the grain along the tangent.
    const Vec3 a = mdf_transform("ggx", 0.3L, 0.3L, method, n, i).v;
    const Vec3 b = mdf_transform("ggx", 0.3L, 0.3L, method, n, o).v;
    const long double sum = p[1] * a.x * b.x + p[2] * a.y * b.y + p[3] * a.z * b.z;
    return sum > 0 ? p[0] * std::pow(sum, p[4]) : 0;
}

}  // namespace

long double srgb_encoded(long double linear) {
    return linear <= 0.0031308L ? 12.92L * linear : 1.055L * std::pow(linear, 1 / 2.4L) - 0.055L;
}

long double srgb_decoded(long double encoded) {
    return encoded <= 0.04045L ? encoded / 12.92L : std::pow((encoded + 0.055L) / 1.055L, 2.4L);
}

Vec3 tone_mapped(const std::string& name, Vec3 c) {
    if (name == "reinhard") {
        const long double y = 0.2126L * c.x + 0.7152L * c.y + 0.0722L * c.z;
        return (1 / (1 + y)) * c;
    }
    if (name == "aces") {
        const auto map = [](long double v) {
            return v * (2.51L * v + 0.03L) / (v * (2.43L * v + 0.59L) + 0.14L);
        };
        return {map(c.x), map(c.y), map(c.z)};
    }
    if (name == "khronos-neutral") return neutral(c);
    return c;
}

Vec3 normal_of_texel(Vec3 texel, long double scale_x, long double scale_y) {
    Vec3 v{2 * texel.x - 1, 2 * texel.y - 1, 2 * texel.z - 1};
    if (!(v.z > 0)) return {0, 0, 1};
    v.x *= scale_x;
    v.y *= scale_y;
    v.z = std::max({v.z, 0.03L * std::fabs(v.x), 0.03L * std::fabs(v.y)});
    return normalize(v);
}

std::array<long double, 2> normal_motion(long double slope_x, long double slope_y) {
    const long double e = 1e-6L;
    const Vec3 along = normal_at(slope_x + e, slope_y) - normal_at(slope_x - e, slope_y);
    const Vec3 across = normal_at(slope_x, slope_y + e) - normal_at(slope_x, slope_y - e);
    return {dot(along, along) / (4 * e * e), dot(across, across) / (4 * e * e)};
}

std::array<long double, 2> stretch(long double red, long double green, long double angle) {
    const long double sum = std::atan2(2 * green - 1, 2 * red - 1) + angle;
    return {std::cos(sum), std::sin(sum)};
}

long double attenuation(long double d, long double range) {
    const long double window = range > 0 ? clamped(1 - std::pow(d / range, 4)) : 1;
    return window / (d * d);
}

long double cone(long double angle, long double inner, long double outer) {
    const long double scale = 1 / std::max(0.001L, std::cos(inner) - std::cos(outer));
    const long double factor = clamped(std::cos(angle) * scale - std::cos(outer) * scale);
    return factor * factor;
}

long double conductor(long double eta, long double k, long double cosine) {
    using Complex = std::complex<long double>;
    const Complex m(eta, k);
    const Complex inside =
        std::sqrt(m * m - Complex(1 - cosine * cosine)) / m;  // cosine in the metal
    const Complex s = (cosine - m * inside) / (cosine + m * inside);
    const Complex t = (m * cosine - inside) / (m * cosine + inside);
    return (std::norm(s) + std::norm(t)) / 2;
}

long double fresnel_curve(std::array<long double, 6> terms, long double cosine) {
    const long double pole = cosine + 0.05L, rest = 1 - cosine;
    const long double inside = terms[1] / pole + terms[2] / std::pow(pole, 2) + terms[3] +
                               terms[4] * rest + terms[5] * std::pow(rest, 2);
    return clamped(1 - cosine + terms[0] * cosine + cosine * rest * inside);
}

long double specular_occlusion(long double occlusion, long double cos_o, long double alpha) {
    return clamped(std::pow(cos_o + occlusion, std::exp2(-16 * alpha - 1)) - 1 + occlusion);
}

long double diffuse(long double f0, long double cos_i, long double cos_o) {
    return (1 - schlick(f0, cos_i)) * (1 - schlick(f0, cos_o)) / kPi;
}

long double specular(const std::string& brdf, std::array<long double, 5> p,
                     const std::string& method, Vec3 n, Vec3 i, Vec3 o) {
    const Vec3 up = method == "none" ? Vec3{0, 0, 1} : n;
    const long double cos_i = dot(up, i), cos_o = dot(up, o);
    if (cos_i <= 0 || cos_o <= 0) return 0;
    if (brdf == "phong" || brdf == "lafortune") return cosine_lobe(brdf, p, method, up, i, o);
    const bool ggx = brdf == "ggx" || brdf == "ggx-separable";
    const std::string mdf = ggx                           ? "ggx"
                            : brdf == "ashikhmin-shirley" ? "ashikhmin-shirley"
                                                          : "beckmann";
    const Vec3 h = normalize(i + o);
    const MdfValue value = mdf_eval(mdf, p[0], p[1], method, n, h);
    const long double D = value.D_conserving, ih = dot(i, h);
    if (ggx || brdf == "beckmann") {
        const Vec3 a = masked_direction(mdf, p, method, n, i);
        const Vec3 b = masked_direction(mdf, p, method, n, o);
        return D * smith(brdf, mdf, p, a, b) / (4 * cos_i * cos_o);
    }
    if (brdf == "ashikhmin-shirley") {
        // The paper's own scale: sqrt((e_x + 1)(e_y + 1)) in place of sqrt((e_x + 2)(e_y + 2)).
        const long double scale = std::sqrt((p[0] + 1) * (p[1] + 1) / ((p[0] + 2) * (p[1] + 2)));
        return D * scale / (4 * ih * std::max(cos_i, cos_o));
    }
    if (brdf == "ward-gmd") return D / (4 * ih * ih);
    if (brdf == "cook-torrance") {
        const long double nh = dot(up, h);
        const long double g = std::min({1.0L, 2 * nh * cos_o / ih, 2 * nh * cos_i / ih});
        return D * std::max(g, 0.0L) / (4 * cos_i * cos_o);
    }
    // Ward's exponential: D without the 1/z^4 of solid angle, z being what D was read at.
    const long double z = mdf_transform(mdf, p[0], p[1], method, n, h).v.z;
    const long double exponential = D * z * z * z * z;
    if (brdf == "ward") return exponential / (4 * std::sqrt(cos_i * cos_o));
    if (brdf == "ward-duer") return exponential / (4 * cos_i * cos_o);
    throw std::invalid_argument(brdf);
}

long double table_value(const double* table, int rings, int columns, long double theta,
                        long double phi) {
    const long double u = std::sqrt(2 * theta / kPi);
    const long double row = std::clamp(u * rings - 0.5L, 0.0L, static_cast<long double>(rings - 1));
    long double column = std::fmod(phi / (2 * kPi), 1.0L) * columns;
    if (column < 0) column += columns;
    long double sum = 0;
    for (int r = 0; r < rings; ++r) {
        for (int a = 0; a < columns; ++a) {
            const long double away = std::fabs(column - a);
            const long double across = std::max(1 - std::min(away, columns - away), 0.0L);
            const long double along = std::max(1 - std::fabs(row - r), 0.0L);
            sum += across * along * static_cast<long double>(table[r * columns + a]);
        }
    }
    return sum;
}

}  // namespace burnish::oracle
