// The functions behind the rows of brdf_models.cpp, in either precision: values and sampling.
#pragma once

#include <array>

#include "burnish/brdf_models.hpp"
#include "burnish/f32.hpp"
#include "burnish/f64.hpp"
#include "models/he.hpp"
#include "models/projected_area.hpp"

namespace burnish {

template <typename Float>
using Parameters = std::span<const Float, kMostBrdfParameters>;
template <typename Float>
using Uniforms = std::span<const Float, 3>;

// What has to be named by precision; every other function is found through these types.
template <typename Float>
struct Maths;

#define BURNISH_MATHS_OF(ns, Float)                                                              \
    template <>                                                                                  \
    struct Maths<Float> {                                                                        \
        using Lobe = ns::Lobe;                                                                   \
        using Vec2 = ns::vec2;                                                                   \
        static constexpr auto lobe = ns::lobe_make;                                              \
        static ns::Perturbation unperturbed() {                                                  \
            return ns::perturb_make(ns::kMethodNone, {0, 0, 1}, true, false);                    \
        }                                                                                        \
        static Float schlick(Float f0, Float cosine) { return ns::fresnel_schlick(f0, cosine); } \
        static constexpr auto phong = ns::phong_eval;                                            \
        static constexpr auto phong_sample = ns::phong_sample;                                   \
        static constexpr auto phong_pdf = ns::phong_pdf;                                         \
        static constexpr auto lafortune = ns::lafortune_eval;                                    \
        static constexpr auto lafortune_sample = ns::lafortune_sample;                           \
        static constexpr auto lafortune_pdf = ns::lafortune_pdf;                                 \
        static constexpr auto of_areas = ns::area_brdf;                                          \
        static constexpr auto diffuse = ns::ashikhmin_shirley_diffuse;                           \
        static constexpr auto cosine_sample = ns::cosine_sample;                                 \
        static constexpr auto cosine_pdf = ns::cosine_pdf;                                       \
    };
// The members stand for functions.
// NOLINTBEGIN(readability-identifier-naming)
BURNISH_MATHS_OF(f32, float)
BURNISH_MATHS_OF(f64, double)
// NOLINTEND(readability-identifier-naming)
#undef BURNISH_MATHS_OF

template <typename Float>
Float half_vector_cosine(Direction<Float> wi, Direction<Float> wo) {
    return length(wi + wo) / Float(2);
}

// ---- models over a lobe -------------------------------------------------------------------------

// Which of a row's parameters are the lobe's two numbers: `second` may be `first` again.
template <typename Float, Mdf mdf, std::size_t first, std::size_t second>
typename Maths<Float>::Lobe lobe_at(Parameters<Float> p) {
    return Maths<Float>::lobe(static_cast<int>(mdf), p[first], p[second]);
}

template <typename Float, Brdf brdf, Mdf mdf, std::size_t first, std::size_t second>
Direction<Float> sample_lobe(Parameters<Float> p, Direction<Float> wo, Uniforms<Float> xi,
                             Float& density) {
    return brdf_sample(static_cast<int>(brdf), lobe_at<Float, mdf, first, second>(p),
                       Maths<Float>::unperturbed(), wo, typename Maths<Float>::Vec2(xi[0], xi[1]),
                       xi[2], density);
}

template <typename Float, Brdf brdf, Mdf mdf, std::size_t first, std::size_t second>
Float lobe_density(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    return brdf_pdf(static_cast<int>(brdf), lobe_at<Float, mdf, first, second>(p),
                    Maths<Float>::unperturbed(), wi, wo);
}

// p: the lobe's two numbers and F0.
template <typename Float, Brdf brdf, Mdf mdf>
Float lobe_and_schlick(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    const Float value = brdf_eval(static_cast<int>(brdf), lobe_at<Float, mdf, 0, 1>(p),
                                  Maths<Float>::unperturbed(), wi, wo);
    return value * Maths<Float>::schlick(p[2], half_vector_cosine(wi, wo));
}

// p: ks, alpha_x, alpha_y; no Fresnel of its own.
template <typename Float, Brdf brdf>
Float ward_family(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    return p[0] * brdf_eval(static_cast<int>(brdf), lobe_at<Float, Mdf::beckmann, 1, 2>(p),
                            Maths<Float>::unperturbed(), wi, wo);
}

// p: ks, m, F0.
template <typename Float>
Float cook_torrance(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    const int brdf = static_cast<int>(Brdf::cook_torrance);
    return p[0] * Maths<Float>::schlick(p[2], half_vector_cosine(wi, wo)) *
           brdf_eval(brdf, lobe_at<Float, Mdf::beckmann, 1, 1>(p), Maths<Float>::unperturbed(), wi,
                     wo);
}

// p: e_x, e_y, F0.
template <typename Float>
Float ashikhmin_premoze_shirley(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    if (!(wi.z > 0 && wo.z > 0)) return 0;
    const auto g = [&](Direction<Float> w) {
        return static_cast<Float>(projected_area_cached(p[0], p[1], {w.x, w.y, w.z}));
    };
    const Float D = lobe_D(lobe_at<Float, Mdf::ashikhmin_shirley, 0, 1>(p),
                           Maths<Float>::unperturbed(), normalize(wi + wo));
    return Maths<Float>::of_areas(D, g(wi), g(wo)) *
           Maths<Float>::schlick(p[2], half_vector_cosine(wi, wo));
}

// ---- lobes about a direction --------------------------------------------------------------------

// p: ks, n.
template <typename Float>
Float phong(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    return Maths<Float>::phong(p[0], p[1], wi, wo);
}

template <typename Float>
Direction<Float> sample_phong(Parameters<Float> p, Direction<Float> wo, Uniforms<Float> xi,
                              Float& density) {
    return Maths<Float>::phong_sample(p[1], wo, {xi[0], xi[1]}, density);
}

template <typename Float>
Float phong_density(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    return Maths<Float>::phong_pdf(p[1], wi, wo);
}

// p: ks, cx, cy, cz, n.
template <typename Float>
Float lafortune(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    return Maths<Float>::lafortune(p[0], {p[1], p[2], p[3]}, p[4], wi, wo);
}

template <typename Float>
Direction<Float> sample_lafortune(Parameters<Float> p, Direction<Float> wo, Uniforms<Float> xi,
                                  Float& density) {
    return Maths<Float>::lafortune_sample({p[1], p[2], p[3]}, p[4], wo, {xi[0], xi[1]}, density);
}

template <typename Float>
Float lafortune_density(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    return Maths<Float>::lafortune_pdf({p[1], p[2], p[3]}, p[4], wi, wo);
}

// ---- he: in double, whatever is asked -----------------------------------------------------------

template <typename Float>
Direction<double> in_double(Direction<Float> w) {
    return {w.x, w.y, w.z};
}

// p: sigma, tau, F0.
template <typename Float>
HeSurface he_surface(Parameters<Float> p) {
    return {p[0], p[1]};
}

template <typename Float>
Float he(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    const double value = he_value(he_surface(p), in_double(wi), in_double(wo));
    return static_cast<Float>(value) * Maths<Float>::schlick(p[2], half_vector_cosine(wi, wo));
}

template <typename Float>
Direction<Float> sample_he(Parameters<Float> p, Direction<Float> wo, Uniforms<Float> xi,
                           Float& density) {
    double found = 0;
    const Direction<double> wi =
        he_sample(he_surface(p), in_double(wo), {xi[0], xi[1], xi[2]}, found);
    density = static_cast<Float>(found);
    return {static_cast<Float>(wi.x), static_cast<Float>(wi.y), static_cast<Float>(wi.z)};
}

template <typename Float>
Float he_density(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    return static_cast<Float>(he_pdf(he_surface(p), in_double(wi), in_double(wo)));
}

// ---- the diffuse term of Ashikhmin and Shirley --------------------------------------------------

// p: Rd, Rs.
template <typename Float>
Float coupled_diffuse(Parameters<Float> p, Direction<Float> wi, Direction<Float> wo) {
    return Maths<Float>::diffuse(p[0], p[1], wi.z, wo.z);
}

template <typename Float>
Direction<Float> sample_cosine(Parameters<Float>, Direction<Float>, Uniforms<Float> xi,
                               Float& density) {
    const Direction<Float> wi = Maths<Float>::cosine_sample({xi[0], xi[1]});
    density = Maths<Float>::cosine_pdf(wi.z);
    return wi;
}

template <typename Float>
Float cosine_density(Parameters<Float>, Direction<Float> wi, Direction<Float>) {
    return Maths<Float>::cosine_pdf(wi.z);
}

}  // namespace burnish
