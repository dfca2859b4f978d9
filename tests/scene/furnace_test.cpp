// Energy: a metal that absorbs nothing, in a white furnace.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "burnish/surface.hpp"
#include "core/constants.hpp"

namespace burnish {
namespace {

Material white_metal(Brdf brdf, Mdf mdf, glm::vec2 alpha, Method method) {
    Material m;
    m.base_color = glm::vec4(1.0f);
    m.metallic = 1.0f;
    m.brdf = brdf;
    m.mdf = mdf;
    m.lobe = AlphaLobe{alpha};
    m.method = method;
    return m;
}

glm::dvec3 direction_of(double cosine, double azimuth) {
    const double sine = std::sqrt(1 - cosine * cosine);
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

// `v` in the frame whose z axis is `n`.
glm::dvec3 about(glm::dvec3 n, glm::dvec3 v) {
    const glm::dvec3 t = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), n));
    return t * v.x + glm::cross(n, t) * v.y + n * v.z;
}

// The share of white light from everywhere that leaves towards the eye, by the point's own samples.
glm::dvec3 albedo_of(const SurfacePoint& point, glm::dvec3 to_eye, int samples = 1 << 14) {
    glm::dvec3 sum(0.0);
    for (int i = 0; i < samples; ++i) {
        const auto s =
            point.sample(to_eye, {(i + 0.5) / samples, std::fmod(0.5 + 0.7548776662466927 * i, 1.0),
                                  std::fmod(0.5 + 0.5698402909980532 * i, 1.0)});
        if (s) sum += s->weight;
    }
    return sum / static_cast<double>(samples);
}

constexpr std::array<float, 4> kAlphas = {0.05f, 0.2f, 0.5f, 1.0f};
constexpr std::array<double, 5> kCosines = {0.05, 0.2, 0.5, 0.8, 1.0};

class Furnace : public testing::TestWithParam<Mdf> {};

// Every pair of roughnesses, seen from every side: all light leaves. Measured: 0.0061 GGX, 0.0064
// Beckmann; 0.0105 Ward, 0.0103 Ashikhmin-Shirley, 3 degrees above the horizon, where draws from D
// have large weights.
TEST_P(Furnace, AMetalThatAbsorbsNothingReflectsAllLight) {
    double worst = 0;
    for (const Brdf brdf : {Brdf::microfacet, Brdf::microfacet_separable}) {
        for (const float x : kAlphas) {
            for (const float y : kAlphas) {
                const SurfacePoint point(white_metal(brdf, GetParam(), {x, y}, Method::none));
                for (const double cosine : kCosines) {
                    for (const double azimuth : {0.0, 0.5, 1.1}) {
                        const double albedo = albedo_of(point, direction_of(cosine, azimuth)).x;
                        worst = std::max(worst, std::abs(albedo - 1));
                        EXPECT_NEAR(albedo, 1.0, 0.011)
                            << name_of(brdf) << " alphas " << x << " " << y << " cosine " << cosine
                            << " azimuth " << azimuth;
                    }
                }
            }
        }
    }
    if (std::getenv("BURNISH_PRINT_FURNACE"))
        std::printf("%s: %.4f\n", name_of(GetParam()).data(), worst);
}

// Under every rotation, whatever the tilt: the lobe keeps its energy.
TEST_P(Furnace, RotationsKeepItUnderAnyTilt) {
    for (const Method method :
         {Method::gram_schmidt, Method::rotate_exact, Method::rotate_arc, Method::follow_grain}) {
        for (const double tilt_deg : {20.0, 45.0, 70.0}) {
            const glm::dvec3 n = direction_of(std::cos(tilt_deg * kPi / 180), 0.9);
            const SurfacePoint point(
                white_metal(Brdf::microfacet, GetParam(), {0.15f, 0.6f}, method), n);
            for (const double cosine : {0.3, 0.7, 1.0}) {
                const glm::dvec3 eye = about(n, direction_of(cosine, 2.0));
                EXPECT_NEAR(albedo_of(point, eye).x, 1.0, 0.01)
                    << name_of(method) << " tilt " << tilt_deg << " cosine " << cosine;
            }
        }
    }
}

// Linear maps of facets change the lobe: stretch to another lobe of its kind, whose albedo the table has; slope-shift
// to one that is none, and the table has that of the facets seen. BURNISH_PRINT_FURNACE prints what is measured: stretch
// 0.988 to 1.004 (the low ones are Ashikhmin-Shirley's, whose kind changes), slope-shift 0.853
// to 1.085 (GGX; the others 0.945 to 1.023).
TEST_P(Furnace, MovedFacetsKeepMostOfIt) {
    for (const Method method : {Method::stretch, Method::slope_shift}) {
        for (const double tilt_deg : {20.0, 45.0, 60.0}) {
            const glm::dvec3 n = direction_of(std::cos(tilt_deg * kPi / 180), 0.9);
            double least = 2, most = 0;
            for (const double cosine : {0.3, 0.7, 1.0}) {
                for (const double azimuth : {0.5, 2.0, 4.0}) {
                    const glm::dvec3 eye = about(n, direction_of(cosine, azimuth));
                    if (eye.z < 0.05) continue;
                    const SurfacePoint point(
                        white_metal(Brdf::microfacet, GetParam(), {0.15f, 0.6f}, method), n);
                    const double albedo = albedo_of(point, eye).x;
                    least = std::min(least, albedo);
                    most = std::max(most, albedo);
                }
            }
            if (std::getenv("BURNISH_PRINT_FURNACE"))
                std::printf("%s %s %.0f: %.4f to %.4f\n", name_of(GetParam()).data(),
                            name_of(method).data(), tilt_deg, least, most);
            const bool exact = method == Method::stretch;
            EXPECT_GT(least, exact ? 0.98 : 0.83) << name_of(method) << " " << tilt_deg;
            EXPECT_LT(most, exact ? 1.01 : 1.09) << name_of(method) << " " << tilt_deg;
        }
    }
}

// As published, rough lobes lose light. Of GGX at alpha 1, seen along the normal, 0.307 is left: by
// quadrature in slopes, apart from shading/.
TEST_P(Furnace, SingleScatteringLosesLight) {
    Material m = white_metal(Brdf::microfacet, GetParam(), {1.0f, 1.0f}, Method::none);
    m.single_scattering = true;
    const double albedo = albedo_of(SurfacePoint(m), {0, 0, 1}).x;
    EXPECT_LT(albedo, 0.75);
    if (GetParam() == Mdf::ggx) {
        EXPECT_NEAR(albedo, 0.307, 0.003);
    }
}

// Light that is reflected more than once meets the metal's color more than once: the lost share of a
// colored metal comes back darker and more saturated than that of a white one.
TEST_P(Furnace, TheLostLightComesBackInTheMetalsColor) {
    Material m = white_metal(Brdf::microfacet, GetParam(), {0.8f, 0.8f}, Method::none);
    m.base_color = {0.9f, 0.5f, 0.2f, 1.0f};
    const glm::dvec3 eye = direction_of(0.9, 0.3);
    const glm::dvec3 whole = albedo_of(SurfacePoint(m), eye);
    m.single_scattering = true;
    const glm::dvec3 once = albedo_of(SurfacePoint(m), eye);
    const glm::dvec3 gain = whole / once;
    EXPECT_GT(gain.x, gain.y);
    EXPECT_GT(gain.y, gain.z);
    EXPECT_GT(gain.z, 1.0);
    EXPECT_LE(whole.x, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Mdfs, Furnace,
                         testing::Values(Mdf::ashikhmin_shirley, Mdf::ward, Mdf::beckmann,
                                         Mdf::ggx),
                         [](const auto& mdf) {
                             std::string name(name_of(mdf.param));
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace burnish
