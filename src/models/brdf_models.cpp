#include "burnish/brdf_models.hpp"

#include <array>
#include <cstddef>

#include "models/brdf_rows.hpp"

namespace burnish {
namespace {

constexpr ShapeParameter kShare{"ks", 0.0, 1.0};
constexpr ShapeParameter kF0{"F0", 0.0, 1.0};
constexpr ShapeParameter kAlphaX{"alpha_x", kLeastAlpha, kMostAlpha};
constexpr ShapeParameter kAlphaY{"alpha_y", kLeastAlpha, kMostAlpha};
// What scales a power of a cosine: an exponent n asks for up to (n + 2)/(2 pi).
constexpr ShapeParameter kScale{"ks", 0.0, kMostExponent};

constexpr std::array<ShapeParameter, 3> kExponentsAndF0 = {
    {{"e_x", 0.0, kMostExponent}, {"e_y", 0.0, kMostExponent}, kF0}};
constexpr std::array<ShapeParameter, 3> kAlphasAndF0 = {{kAlphaX, kAlphaY, kF0}};
constexpr std::array<ShapeParameter, 3> kStrengthAndAlphas = {{kShare, kAlphaX, kAlphaY}};
constexpr std::array<ShapeParameter, 3> kCookTorrance = {
    {kShare, {"m", kLeastAlpha, kMostAlpha}, kF0}};
constexpr std::array<ShapeParameter, 2> kPhong = {{kScale, {"n", 0.0, kMostExponent}}};
constexpr std::array<ShapeParameter, 5> kLafortune = {{kScale,
                                                       {"Cx", -10.0, 10.0},
                                                       {"Cy", -10.0, 10.0},
                                                       {"Cz", -10.0, 10.0},
                                                       {"n", 0.0, kMostExponent}}};
constexpr std::array<ShapeParameter, 3> kHe = {{{"sigma", 0.0, 5.0}, {"tau", 0.1, 1000.0}, kF0}};
constexpr std::array<ShapeParameter, 2> kDiffuse = {{{"Rd", 0.0, 1.0}, {"Rs", 0.0, 1.0}}};

constexpr std::array<std::string_view, 2> kSmithNames = {"correlated", "separable"};

// A function template of one precision, named once.
#define BURNISH_BOTH(...) __VA_ARGS__<float>, __VA_ARGS__<double>

template <Brdf brdf, Mdf mdf, std::size_t first, std::size_t second>
constexpr BrdfModel with_lobe_sampler(std::string_view name,
                                      std::span<const ShapeParameter> parameters,
                                      BrdfFunction<float> value_f32,
                                      BrdfFunction<double> value_f64) {
    return {name,
            parameters,
            value_f32,
            value_f64,
            {sample_lobe<float, brdf, mdf, first, second>,
             lobe_density<float, brdf, mdf, first, second>},
            {sample_lobe<double, brdf, mdf, first, second>,
             lobe_density<double, brdf, mdf, first, second>}};
}

template <Brdf brdf, Mdf mdf>
constexpr BrdfModel lobe_model(std::string_view name) {
    const bool exponents = mdf == Mdf::ashikhmin_shirley;
    return with_lobe_sampler<brdf, mdf, 0, 1>(name, exponents ? kExponentsAndF0 : kAlphasAndF0,
                                              lobe_and_schlick<float, brdf, mdf>,
                                              lobe_and_schlick<double, brdf, mdf>);
}

template <Brdf brdf>
constexpr BrdfModel ward_model(std::string_view name) {
    return with_lobe_sampler<brdf, Mdf::beckmann, 1, 2>(
        name, kStrengthAndAlphas, ward_family<float, brdf>, ward_family<double, brdf>);
}

constexpr std::array<BrdfModel, 13> kModels = {{
    lobe_model<Brdf::ashikhmin_shirley, Mdf::ashikhmin_shirley>("ashikhmin-shirley"),
    {"ashikhmin-shirley-diffuse",
     kDiffuse,
     BURNISH_BOTH(coupled_diffuse),
     {sample_cosine<float>, cosine_density<float>},
     {sample_cosine<double>, cosine_density<double>}},
    with_lobe_sampler<Brdf::ashikhmin_shirley, Mdf::ashikhmin_shirley, 0, 1>(
        "ashikhmin-premoze-shirley", kExponentsAndF0, BURNISH_BOTH(ashikhmin_premoze_shirley)),
    ward_model<Brdf::ward>("ward"),
    ward_model<Brdf::ward_duer>("ward-duer"),
    ward_model<Brdf::ward_gmd>("ward-gmd"),
    with_lobe_sampler<Brdf::cook_torrance, Mdf::beckmann, 1, 1>("cook-torrance", kCookTorrance,
                                                                BURNISH_BOTH(cook_torrance)),
    {"lafortune",
     kLafortune,
     BURNISH_BOTH(lafortune),
     {sample_lafortune<float>, lafortune_density<float>},
     {sample_lafortune<double>, lafortune_density<double>}},
    {"phong",
     kPhong,
     BURNISH_BOTH(phong),
     {sample_phong<float>, phong_density<float>},
     {sample_phong<double>, phong_density<double>}},
    {"he",
     kHe,
     BURNISH_BOTH(he),
     {sample_he<float>, he_density<float>},
     {sample_he<double>, he_density<double>}},
    lobe_model<Brdf::microfacet, Mdf::ggx>("ggx"),
    lobe_model<Brdf::microfacet_separable, Mdf::ggx>("ggx-separable"),
    lobe_model<Brdf::microfacet, Mdf::beckmann>("beckmann"),
}};
#undef BURNISH_BOTH

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
