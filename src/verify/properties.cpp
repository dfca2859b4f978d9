#include "verify/properties.hpp"

#include <fmt/format.h>

#include <random>

#include "verify/chi_square.hpp"

namespace burnish::verify {
namespace {

constexpr double kTiltsDeg[] = {15, 30, 45};
constexpr double kAzimuthsDeg[] = {0, 45, 90};  // along x, between, along y

vec3 at_degrees(double theta, double phi) {
    return direction(theta * kDegree, phi * kDegree);
}

std::vector<vec3> normals_of(const Subject& s) {
    if (s.method == f64::kMethodNone) return {{0, 0, 1}};
    std::vector<vec3> normals;
    for (const double tilt : kTiltsDeg)
        for (const double azimuth : kAzimuthsDeg) normals.push_back(at_degrees(tilt, azimuth));
    return normals;
}

// NaN-aware: the first value replaces kNoFigure.
void widen(double value, double& least, double& most) {
    least = std::isnan(least) ? value : std::min(least, value);
    most = std::isnan(most) ? value : std::max(most, value);
}

// Seen along the geometric normal. A lobe may be flat about its maximum: a direction in which the plate is as
// bright as it gets is right, wherever rounding puts the maximum.
double highlight_error(const Subject& s, const Reflection& r) {
    constexpr double kRounding = 1e-9;
    const vec3 wo{0, 0, 1};
    const Radiance plate = process_plate(s, r.n, wo);
    const vec3 found = brightest([&](vec3 wi) { return r.f(wi, wo) * f64::dot(r.n, wi); }, 60);
    const vec3 wanted = brightest(plate, 60);
    return plate(found) >= plate(wanted) * (1 - kRounding) ? 0 : angle_deg(found, wanted);
}

// Signed: facets of slope-shift may overhang.
double energy(const Reflection& r) {
    return integrate_cap([&](vec3 h) { return r.D(h) * f64::dot(r.n, h); }, r.peak, kPi, 300, 480);
}

// Over half vectors, where the lobe is: dwi = 4 (wo.h) dh.
double albedo(const Reflection& r, vec3 wo) {
    return integrate_cap(
        [&](vec3 h) {
            const double wo_h = f64::dot(wo, h);
            if (wo_h <= 0) return 0.0;
            const vec3 wi = f64::reflect_about(wo, h);
            return r.f(wi, wo) * std::max(f64::dot(r.n, wi), 0.0) * 4 * wo_h;
        },
        r.peak, kPi, 160, 160);
}

void widen_by_albedos(const Reflection& r, Figures& figures) {
    for (const double theta : {0.0, 25.0, 50.0, 75.0}) {
        for (int k = 0; k < (theta == 0 ? 1 : 4); ++k) {
            const vec3 wo = at_degrees(theta, 20.0 + 90 * k);
            // 0.1: nearer to the horizon of n~ the renderer turns n~ towards the eye (perturb/facing.glsl).
            if (f64::dot(r.n, wo) < 0.1) continue;
            widen(albedo(r, wo), figures.albedo_least, figures.albedo_most);
        }
    }
}

double asymmetry(const Reflection& r) {
    constexpr int kPairs = 4000;
    std::mt19937 generator(23);
    const auto uniform = [&] { return (static_cast<double>(generator()) + 0.5) / 4294967296.0; };
    const auto any = [&] { return direction(std::acos(uniform()), 2 * kPi * uniform()); };
    double worst = 0;
    for (int i = 0; i < kPairs; ++i) {
        const vec3 wi = any(), wo = any();
        const double there = r.f(wi, wo), back = r.f(wo, wi), most = std::max(there, back);
        // Below 1e-200 the digits of a double end.
        if (most > 1e-200) worst = std::max(worst, std::abs(there - back) / most);
    }
    return worst;
}

// On cells of half vectors, where densities of reflected directions have no pole: dwi = 4 (wo.h) dh.
double sampler(const Reflection& r) {
    const vec3 wo = at_degrees(40, 50);
    const auto density = [&](vec3 h) {
        const double wo_h = f64::dot(wo, h);
        return wo_h > 0 ? r.pdf(f64::reflect_about(wo, h), wo) * 4 * wo_h : 0.0;
    };
    const auto draw = [&](double xi0, double xi1, double select) {
        double pdf = 0;
        const vec3 wi = r.sample(wo, xi0, xi1, select, pdf);
        return pdf > 0 ? f64::normalize(wi + wo) : vec3{0, 0, 0};
    };
    double integral = 0;
    return sampler_p_value(density, draw, Axes(r.peak), 71, integral);
}

}  // namespace

Reflection reflection_of(const Subject& s, vec3 n) {
    const f64::SurfaceMaterial material = material_of(s);
    const f64::Perturbation p =
        f64::perturb_make(s.method, n, f64::lobe_grooves_along_x(s.mdf, s.p0, s.p1), false);
    Reflection r;
    r.n = p.n;
    r.peak = f64::lobe_peak(p);
    if (!f64::brdf_is_cosine_lobe(s.brdf))
        r.D = [=](vec3 h) { return f64::lobe_D(material.lobe, p, h); };
    r.f = [=](vec3 wi, vec3 wo) {
        return f64::specular_eval(material, p, f64::no_lobe_values(), wi, wo);
    };
    r.pdf = [=](vec3 wi, vec3 wo) {
        return f64::specular_pdf(material, p, f64::no_lobe_values(), wi, wo);
    };
    r.sample = [=](vec3 wo, double xi0, double xi1, double select, double& pdf) {
        return f64::specular_sample(material, p, wo, {xi0, xi1}, select, pdf);
    };
    return r;
}

Figures measure(const Subject& s, const MakeReflection& make) {
    Figures figures;
    double least = kNoFigure;
    for (const vec3& n : normals_of(s)) {
        const Reflection r = make(s, n);
        if (has_process_plate(s)) widen(highlight_error(s, r), least, figures.highlight_deg);
        if (r.D) widen(energy(r), figures.energy_least, figures.energy_most);
        widen_by_albedos(r, figures);
    }
    const Reflection tilted = make(s, at_degrees(s.method == f64::kMethodNone ? 0 : 30, 25));
    figures.reciprocity = asymmetry(tilted);
    figures.sampler_p = sampler(tilted);
    figures.hostile = hostile_counts(s.mdf, s.p0, s.p1, s.method);
    return figures;
}

bool is_judged(const Subject& s) {
    const bool kept = s.method != f64::kMethodNormalMap && s.method != f64::kMethodRotateApprox &&
                      s.method != f64::kMethodDeformLinear && s.method != f64::kMethodDeformSmooth;
    return kept && (s.brdf == f64::kBrdfMicrofacet || s.brdf == f64::kBrdfMicrofacetSeparable);
}

std::vector<std::string> broken_bounds(const Subject& s, const Figures& f) {
    std::vector<std::string> broken;
    // Negated, so that NaN breaks a bound.
    if (is_judged(s)) {
        if (!(f.highlight_deg < kMostHighlightDeg))
            broken.push_back(fmt::format("highlight {:.1f} degrees off, less than {:g} promised",
                                         f.highlight_deg, kMostHighlightDeg));
        if (!(f.energy_least >= 1 - kMostEnergyError && f.energy_most <= 1 + kMostEnergyError))
            broken.push_back(fmt::format("Int D (n~.h) dw {:.4f} to {:.4f}, 1 within {:g} promised",
                                         f.energy_least, f.energy_most, kMostEnergyError));
        if (!(f.albedo_most <= kMostAlbedo))
            broken.push_back(fmt::format("furnace reflects {:.4f}, at most {:g} promised",
                                         f.albedo_most, kMostAlbedo));
        if (!(f.reciprocity <= kMostAsymmetry))
            broken.push_back(fmt::format("not reciprocal by {:.2g}, at most {:g} promised",
                                         f.reciprocity, kMostAsymmetry));
    }
    if (!(f.sampler_p >= kLeastSamplerP))
        broken.push_back(
            fmt::format("the sampler does not follow its density, p = {:.1e}", f.sampler_p));
    if (f.hostile.broken_f32 + f.hostile.broken_f64 > 0)
        broken.push_back(fmt::format("{} values are NaN, infinite or negative on hostile frames",
                                     f.hostile.broken_f32 + f.hostile.broken_f64));
    return broken;
}

}  // namespace burnish::verify
