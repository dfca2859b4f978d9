#include "shading/brdf_models.hpp"

#include <array>
#include <cstddef>

#include "burnish/f32.hpp"
#include "burnish/f64.hpp"

namespace burnish {
namespace {

constexpr std::array<ShapeParameter, 3> kExponentsAndF0 = {
    {{"e_x", 0.0, kMostExponent}, {"e_y", 0.0, kMostExponent}, {"F0", 0.0, 1.0}}};
constexpr std::array<ShapeParameter, 3> kAlphasAndF0 = {
    {{"alpha_x", kLeastAlpha, kMostAlpha}, {"alpha_y", kLeastAlpha, kMostAlpha}, {"F0", 0.0, 1.0}}};
constexpr std::array<ShapeParameter, 3> kStrengthAndAlphas = {
    {{"ks", 0.0, 1.0}, {"alpha_x", kLeastAlpha, kMostAlpha}, {"alpha_y", kLeastAlpha, kMostAlpha}}};

constexpr std::array<std::string_view, 2> kSmithNames = {"correlated", "separable"};

// What has to be named by precision; every other function is found through these types.
template <typename Float>
struct Maths;

template <>
struct Maths<float> {
    static f32::Lobe lobe(int mdf, float p0, float p1) { return f32::lobe_make(mdf, p0, p1); }
    static f32::Perturbation unperturbed() {
        return f32::perturb_make(f32::kMethodNone, {0.0f, 0.0f, 1.0f}, true, false);
    }
    static float schlick(float f0, float cosine) { return f32::fresnel_schlick(f0, cosine); }
};

template <>
struct Maths<double> {
    static f64::Lobe lobe(int mdf, double p0, double p1) { return f64::lobe_make(mdf, p0, p1); }
    static f64::Perturbation unperturbed() {
        return f64::perturb_make(f64::kMethodNone, {0.0, 0.0, 1.0}, true, false);
    }
    static double schlick(double f0, double cosine) { return f64::fresnel_schlick(f0, cosine); }
};

template <typename Float>
using Parameters = std::span<const Float, kMostBrdfParameters>;

// p: the lobe's two numbers and F0.
template <typename Float, Brdf brdf, Mdf mdf>
Float lobe_and_schlick(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    const Float value =
        brdf_eval(static_cast<int>(brdf), Maths<Float>::lobe(static_cast<int>(mdf), p[0], p[1]),
                  Maths<Float>::unperturbed(), wi, wo);
    const Float wi_h = length(wi + wo) / Float(2);
    return value * Maths<Float>::schlick(p[2], wi_h);
}

// p: ks and the lobe's two numbers; no Fresnel of its own.
template <typename Float>
Float ward_gmd(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    const int brdf = static_cast<int>(Brdf::ward_gmd);
    const int mdf = static_cast<int>(Mdf::beckmann);  // brdf_mdf of brdf.glsl
    return p[0] * brdf_eval(brdf, Maths<Float>::lobe(mdf, p[1], p[2]), Maths<Float>::unperturbed(),
                            wi, wo);
}

template <Brdf brdf, Mdf mdf>
constexpr BrdfModel lobe_model(std::string_view name) {
    const bool exponents = mdf == Mdf::ashikhmin_shirley;
    return {name, exponents ? kExponentsAndF0 : kAlphasAndF0, lobe_and_schlick<float, brdf, mdf>,
            lobe_and_schlick<double, brdf, mdf>};
}

constexpr std::array<BrdfModel, 5> kModels = {{
    lobe_model<Brdf::ashikhmin_shirley, Mdf::ashikhmin_shirley>("ashikhmin-shirley"),
    {"ward-gmd", kStrengthAndAlphas, ward_gmd<float>, ward_gmd<double>},
    lobe_model<Brdf::microfacet, Mdf::ggx>("ggx"),
    lobe_model<Brdf::microfacet_separable, Mdf::ggx>("ggx-separable"),
    lobe_model<Brdf::microfacet, Mdf::beckmann>("beckmann"),
}};

// In the order of Mdf.
template <Brdf brdf>
constexpr std::array<BrdfModel, 4> kMicrofacetModels = {{
    lobe_model<brdf, Mdf::ashikhmin_shirley>("microfacet"),
    lobe_model<brdf, Mdf::ward>("microfacet"),
    lobe_model<brdf, Mdf::beckmann>("microfacet"),
    lobe_model<brdf, Mdf::ggx>("microfacet"),
}};

}  // namespace

std::span<const BrdfModel> brdf_models() {
    return kModels;
}

std::span<const std::string_view> smith_names() {
    return kSmithNames;
}

const BrdfModel& microfacet_model(Mdf mdf, Smith smith) {
    const auto& models = smith == Smith::correlated ? kMicrofacetModels<Brdf::microfacet>
                                                    : kMicrofacetModels<Brdf::microfacet_separable>;
    return models[static_cast<std::size_t>(mdf)];
}

}  // namespace burnish
