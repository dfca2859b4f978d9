#include "verify/slips.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

namespace burnish::verify {
namespace {

constexpr std::array<std::string_view, 11> kMethodWords = {
    "the mapped normal is not used at all",
    "the lobe is in the unperturbed frame, and only the cosines see the mapped normal: tangent and "
    "bitangent have to be turned with it",
    "the tangent is made perpendicular to the mapped normal, the bitangent follows",
    "the bitangent is made perpendicular to the mapped normal, the tangent follows",
    "the bitangent is made perpendicular to the mapped normal, and the frame is not normalized",
    "the frame is turned to the mapped normal the shortest way, as on a bent sheet",
    "grooves keep the shadow that they throw on the plate, as on an embossed one",
    "half vectors are moved over the disk linearly",
    "half vectors are moved over the disk smoothly",
    "the slope of the bump is added to that of every facet, as where the plate is brushed after",
    "the lobe is stretched with the surface, as on a stamped plate"};

constexpr std::array<std::string_view, 4> kAlphaWords = {
    "", "alpha_x and alpha_y are exchanged", "both alphas are squared",
    "both alphas are square roots: the perceptual roughness, or the squared one of somebody who "
    "squares again"};

constexpr std::array<std::string_view, 6> kValueWords = {
    "",
    "the cosine of the light is multiplied in",
    "1/(4 cos cos) is missing",
    "the visibility term G/(4 cos cos) is cut off at 1",
    "masking and shadowing are missing",
    "Fresnel is missing"};

constexpr std::array<std::pair<double, std::string_view>, 10> kKnownScales = {
    {{kPi, "pi"},
     {1 / kPi, "1/pi"},
     {4, "4: the 4 of the denominator"},
     {0.25, "1/4: the 4 of the denominator twice"},
     {2, "2"},
     {0.5, "1/2"},
     {4 / kPi, "4/pi"},
     {4 * kPi, "4 pi"},
     {2 * kPi, "2 pi"},
     {1 / (2 * kPi), "1/(2 pi)"}}};

double slipped_alpha(double alpha, AlphaSlip slip) {
    if (slip == AlphaSlip::squared) return alpha * alpha;
    if (slip == AlphaSlip::rooted) return std::sqrt(alpha);
    return alpha;
}

}  // namespace

Subject slipped(const Subject& subject, AlphaSlip slip) {
    Subject s = subject;
    if (slip == AlphaSlip::none) return s;
    if (slip == AlphaSlip::swapped) {
        std::swap(s.p0, s.p1);
        return s;
    }
    const f64::Lobe lobe = f64::lobe_make(s.mdf, s.p0, s.p1);
    const f64::Lobe other =
        f64::lobe_from_alpha(s.mdf, slipped_alpha(f64::lobe_alpha_x(lobe), slip),
                             slipped_alpha(f64::lobe_alpha_y(lobe), slip));
    s.p0 = other.p0;
    s.p1 = other.p1;
    return s;
}

GuessValues values_of(const Subject& s, const Sightings& at) {
    const f64::SurfaceMaterial material = material_of(s);
    const f64::Perturbation p =
        f64::perturb_make(s.method, at.n, f64::lobe_grooves_along_x(s.mdf, s.p0, s.p1), false);
    const bool has_facets = !f64::brdf_is_cosine_lobe(s.brdf);
    const std::size_t count = at.wi.size();
    GuessValues v{std::vector<double>(count), std::vector<double>(count),
                  std::vector<double>(count)};
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 wi = at.wi[i], wo = at.wo[i];
        const double f = f64::specular_eval(material, p, f64::no_lobe_values(), wi, wo);
        v.fresnel[i] = at.f0 + (1 - at.f0) * std::pow(1 - f64::half_angle_cosine(wi, wo), 5.0);
        v.f[i] = f * v.fresnel[i];
        if (!has_facets) continue;
        const double D = f64::lobe_D(material.lobe, p, f64::half_vector(wi + wo, p.n));
        // 1e-200: a tail of no weight, whose quotient has no digits.
        v.visibility[i] = D > 1e-200 ? f / D : 0;
    }
    return v;
}

std::vector<double> GuessValues::of(ValueSlip slip, const Sightings& at) const {
    std::vector<double> values = f;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double cos_i = std::max(f64::dot(at.n, at.wi[i]), 0.0);
        const double cos_o = std::max(f64::dot(at.n, at.wo[i]), 0.0);
        const double v = visibility[i];
        if (slip == ValueSlip::cosine) values[i] *= cos_i;
        if (slip == ValueSlip::no_denominator) values[i] *= 4 * cos_i * cos_o;
        if (slip == ValueSlip::clamped_visibility && v > 1) values[i] /= v;
        if (slip == ValueSlip::no_masking && v > 0)
            values[i] *= 1 / (v * 4 * std::max(cos_i * cos_o, f64::kTiny));
        if (slip == ValueSlip::no_fresnel) values[i] /= std::max(fresnel[i], f64::kTiny);
    }
    return values;
}

std::string words_of_method(int method) {
    return std::string(kMethodWords[static_cast<std::size_t>(method)]);
}
std::string words_of_slip(AlphaSlip slip) {
    return std::string(kAlphaWords[static_cast<std::size_t>(slip)]);
}
std::string words_of_slip(ValueSlip slip) {
    return std::string(kValueWords[static_cast<std::size_t>(slip)]);
}

std::string words_of_scale(double scale) {
    std::string words = fmt::format("all values are {:.4g} times ours", scale);
    for (const auto& [known, name] : kKnownScales) {
        if (std::abs(scale / known - 1) < 0.005) return words + fmt::format(", which is {}", name);
    }
    return words;
}

}  // namespace burnish::verify
