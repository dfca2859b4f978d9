// The anisotropic GGX that three.js and Filament ship, written down from their documentation and not with our
// maths: the normal is mapped, tangent and bitangent are those of the mesh.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace burnish::test {

using Vector = std::array<double, 3>;

inline double dot3(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector unit3(Vector v) {
    const double l = std::sqrt(dot3(v, v));
    return {v[0] / l, v[1] / l, v[2] / l};
}
inline Vector cross3(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector polar3(double theta_deg, double phi_deg) {
    const double t = theta_deg * std::numbers::pi / 180, p = phi_deg * std::numbers::pi / 180;
    return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

// What a shader has at a pixel.
struct ShaderFrame {
    Vector T{1, 0, 0}, B{0, 1, 0}, N{0, 0, 1};
};

struct Terms {
    double D = 0, V = 0, VoH = 0, NoL = 0, NoV = 0;
};

inline Terms ggx_terms(const ShaderFrame& frame, double at, double ab, const Vector& l,
                       const Vector& v) {
    const Vector h = unit3({l[0] + v[0], l[1] + v[1], l[2] + v[2]});
    Terms t;
    t.NoL = std::clamp(dot3(frame.N, l), 0.0, 1.0);
    t.NoV = std::clamp(dot3(frame.N, v), 0.0, 1.0);
    const double NoH = std::clamp(dot3(frame.N, h), 0.0, 1.0);
    t.VoH = std::clamp(dot3(v, h), 0.0, 1.0);
    const double a2 = at * ab;
    const Vector d{ab * dot3(frame.T, h), at * dot3(frame.B, h), a2 * NoH};
    const double w2 = a2 / dot3(d, d);
    t.D = a2 * w2 * w2 / std::numbers::pi;
    const double lv = t.NoL * std::hypot(at * dot3(frame.T, v), ab * dot3(frame.B, v), t.NoV);
    const double ll = t.NoV * std::hypot(at * dot3(frame.T, l), ab * dot3(frame.B, l), t.NoL);
    t.V = lv + ll > 0 ? 0.5 / (lv + ll) : 0;
    return t;
}

// KHR_materials_anisotropy in three.js: alphaT = mix(alpha, 1, anisotropy^2), Fresnel by Epic's exponential.
inline double three_brdf(const ShaderFrame& frame, double roughness, double anisotropy, double f0,
                         const Vector& l, const Vector& v) {
    const double alpha = roughness * roughness;
    const double at = alpha + (1 - alpha) * anisotropy * anisotropy;
    const Terms t = ggx_terms(frame, at, alpha, l, v);
    if (!(t.NoL > 0 && t.NoV > 0)) return 0;
    const double rise = std::exp2((-5.55473 * t.VoH - 6.98316) * t.VoH);
    return (f0 * (1 - rise) + rise) * t.V * t.D;
}

// Filament: at = alpha (1 + anisotropy), ab = alpha (1 - anisotropy).
inline double filament_brdf(const ShaderFrame& frame, double perceptual_roughness,
                            double anisotropy, double f0, const Vector& l, const Vector& v) {
    const double alpha = perceptual_roughness * perceptual_roughness;
    const Terms t = ggx_terms(frame, std::max(alpha * (1 + anisotropy), 0.001),
                              std::max(alpha * (1 - anisotropy), 0.001), l, v);
    if (!(t.NoL > 0 && t.NoV > 0)) return 0;
    return (f0 + (1 - f0) * std::pow(1 - t.VoH, 5)) * t.V * t.D;
}

// The frame that the engines need: the groove, which runs along B, keeps its shadow on the plate.
inline ShaderFrame mended_frame(const Vector& n) {
    ShaderFrame frame;
    frame.N = n;
    const double along = n[0];
    frame.T = unit3({1 - along * n[0], -along * n[1], -along * n[2]});
    frame.B = cross3(n, frame.T);
    return frame;
}

struct Sight {
    Vector l, v;
};

// Lights over the hemisphere, some views; none at the horizon of the plate.
inline std::vector<Sight> sights() {
    std::vector<Sight> all;
    for (const Vector& v : {polar3(0, 0), polar3(35, 20), polar3(50, 130), polar3(40, 260)}) {
        for (int theta = 2; theta < 90; theta += 4)
            for (int phi = 0; phi < 360; phi += 10) all.push_back({polar3(theta, phi), v});
    }
    return all;
}

// A table for verify --csv. `f(l, v)`.
template <typename F>
std::string value_table(const F& f) {
    std::string text = "# made by a test\nix,iy,iz,ox,oy,oz,f\n";
    for (const auto& [l, v] : sights())
        text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.6g}\n", l[0], l[1], l[2],
                            v[0], v[1], v[2], f(l, v));
    return text;
}

}  // namespace burnish::test
