#include "further_brdfs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace burnish::oracle {

namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;
constexpr Vec3 kNormal{0, 0, 1};

// As printed on the slides of B12: not reciprocal, without bound at grazing i.
long double phong(long double ks, long double alpha, Vec3 i, Vec3 o) {
    const Vec3 r = 2 * dot(kNormal, i) * kNormal - i;
    const long double cosine = dot(o, r);
    return cosine > 0 ? ks * powl(cosine, alpha) / dot(kNormal, i) : 0;
}

// Ward 1992, Eq 5a: theta and phi of the half vector. `power` of (n.i)(n.o) is 1/2; 1 for Duer.
long double ward(long double ks, long double alpha_x, long double alpha_y, long double power,
                 Vec3 i, Vec3 o) {
    const Vec3 h = normalize(i + o);
    const long double tan_theta = sqrtl(h.x * h.x + h.y * h.y) / h.z;
    const long double phi = atan2l(h.y, h.x);
    const long double a = cosl(phi) / alpha_x;
    const long double b = sinl(phi) / alpha_y;
    return ks * expl(-tan_theta * tan_theta * (a * a + b * b)) /
           (4 * kPi * alpha_x * alpha_y * powl(dot(kNormal, i) * dot(kNormal, o), power));
}

long double lafortune(const std::array<long double, 5>& p, Vec3 i, Vec3 o) {
    const long double bracket = p[1] * i.x * o.x + p[2] * i.y * o.y + p[3] * i.z * o.z;
    return bracket > 0 ? p[0] * powl(bracket, p[4]) : 0;
}

// Cook & Torrance 1982 with Beckmann's D normalised to Int D (n.h) dw = 1 and hence 4 for pi.
long double cook_torrance(long double ks, long double m, long double f0, Vec3 i, Vec3 o) {
    const Vec3 h = normalize(i + o);
    const long double nh = dot(kNormal, h);
    const long double no = dot(kNormal, o);
    const long double ni = dot(kNormal, i);
    const long double oh = dot(o, h);
    const long double tan2 = (h.x * h.x + h.y * h.y) / (nh * nh);
    const long double d = expl(-tan2 / (m * m)) / (kPi * m * m * powl(nh, 4));
    const long double g = std::min({1.0L, 2 * nh * no / oh, 2 * nh * ni / oh});
    return ks * schlick(f0, oh) * d * g / (4 * ni * no);
}

// Ashikhmin, Premoze & Shirley 2000, Eq 7, with the lobe of Ashikhmin & Shirley scaled to
// Int D (n.h) dw = 1, which takes the place of the paper's factor <(h.n)>.
long double ashikhmin_premoze_shirley(long double e_x, long double e_y, long double f0, Vec3 i,
                                      Vec3 o) {
    const Vec3 h = normalize(i + o);
    const long double phi = atan2l(h.y, h.x);
    const long double e = e_x * cosl(phi) * cosl(phi) + e_y * sinl(phi) * sinl(phi);
    const long double d = sqrtl((e_x + 2) * (e_y + 2)) / (2 * kPi) * powl(h.z, e);
    return d * schlick(f0, dot(i, h)) / (4 * aps_g(e_x, e_y, i) * aps_g(e_x, e_y, o));
}

// He et al. 1991, Eq 75-79, lambda = 1. Their Eq 76 for G is (v.v / v_z)^2 in units of the
// wavenumber: the rest of it is |k_o x k_i|^4 over itself, s, p and k being orthonormal.
long double he(long double sigma, long double tau, long double f0, Vec3 i, Vec3 o) {
    if (sigma == 0) return 0;
    const Vec3 v = i + o;
    const Vec3 h = normalize(v);
    const long double geometry = powl(dot(v, v) / v.z, 2);
    const long double wave = 2 * kPi;
    const long double sigma_e = he_effective_sigma(sigma, tau, i, o);
    const long double g = powl(wave * sigma_e * v.z, 2);
    const long double b = wave * wave * (v.x * v.x + v.y * v.y) * tau * tau / 4;
    const long double d = kPi * kPi * tau * tau / 4 * expl(he_log_series(g, b));
    const long double s =
        he_shadowing(he_slope_ratio(sigma, tau, i)) * he_shadowing(he_slope_ratio(sigma, tau, o));
    return schlick(f0, dot(i, h)) * geometry * s * d / (kPi * i.z * o.z);
}

}  // namespace

const std::vector<std::string>& further_brdf_names() {
    static const std::vector<std::string> names{"phong",
                                                "ward",
                                                "ward-duer",
                                                "lafortune",
                                                "cook-torrance",
                                                "ashikhmin-premoze-shirley",
                                                "he",
                                                "ashikhmin-shirley-diffuse"};
    return names;
}

long double further_brdf_eval(const std::string& brdf, const std::array<long double, 5>& p, Vec3 i,
                              Vec3 o) {
    if (brdf == "phong") return phong(p[0], p[1], i, o);
    if (brdf == "ward") return ward(p[0], p[1], p[2], 0.5L, i, o);
    if (brdf == "ward-duer") return ward(p[0], p[1], p[2], 1, i, o);
    if (brdf == "lafortune") return lafortune(p, i, o);
    if (brdf == "cook-torrance") return cook_torrance(p[0], p[1], p[2], i, o);
    if (brdf == "ashikhmin-premoze-shirley") {
        return ashikhmin_premoze_shirley(p[0], p[1], p[2], i, o);
    }
    if (brdf == "ashikhmin-shirley-diffuse") return ashikhmin_shirley_diffuse(p[0], p[1], i, o);
    if (brdf == "he") return he(p[0], p[1], p[2], i, o);
    throw std::invalid_argument("oracle: unknown brdf '" + brdf + "'");
}

long double schlick(long double f0, long double cosine) {
    return f0 + (1 - f0) * powl(std::max(1 - cosine, 0.0L), 5);  // rounding: cosine may exceed 1
}

long double ashikhmin_shirley_diffuse(long double diffuse, long double specular, Vec3 i, Vec3 o) {
    const auto one_side = [](long double cosine) { return 1 - powl(1 - cosine / 2, 5); };
    return 28 * diffuse / (23 * kPi) * (1 - specular) * one_side(i.z) * one_side(o.z);
}

}  // namespace burnish::oracle
