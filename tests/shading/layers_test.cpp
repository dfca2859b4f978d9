// Coat, sheen and the specular factors against tests/oracle/layers.hpp; their energy; their samples.
#include "oracle/layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "burnish/f32.hpp"
#include "surface_cases.hpp"

namespace burnish::test {
namespace {

using oracle::Vec3;

constexpr vec3 kUp{0, 0, 1};
constexpr std::array<double, 5> kLayerCosines = {0.05, 0.15, 0.4, 0.7, 1.0};

Vec3 wide_of(vec3 v) {
    return {v.x, v.y, v.z};
}

vec3 seen_at(double cosine, double azimuth = 0) {
    return direction(std::acos(cosine), azimuth);
}

f64::CoatLayer coat_of(double roughness, vec3 tint = {1, 1, 1}, vec3 n = kUp, double cover = 1) {
    const bool tinted = tint.x != 1 || tint.y != 1 || tint.z != 1;
    return f64::coat_make(cover, f64::lobe_of_roughness(f64::kMdfGgx, roughness, 0.0), n, tinted,
                          f64::coat_depth(tint));
}

f64::SurfaceLayers layers_of(const f64::CoatLayer& coat) {
    return {coat, f64::sheen_none()};
}

// Int f cos over directions of light, by the layers' own samples and a lattice.
vec3 albedo_by_samples(const f64::SurfaceMaterial& m, const f64::SurfaceLayers& l,
                       const f64::Perturbation& p, vec3 wo, int samples = 1 << 15) {
    vec3 sum{};
    for (int i = 0; i < samples; ++i) {
        double pdf = 0;
        const f64::vec2 xi((i + 0.5) / samples, std::fmod(0.5 + 0.7548776662466927 * i, 1.0));
        const double select = std::fmod(0.5 + 0.5698402909980532 * i, 1.0);
        const vec3 wi = f64::layered_sample(m, l, p, wo, xi, select, pdf);
        if (pdf > 0) sum = sum + f64::layered_eval(m, l, p, wi, wo) * (1 / pdf);
    }
    return sum * (1.0 / samples);
}

// The same by an even grid of the sphere: for lobes that are wide.
vec3 albedo_by_grid(const f64::SurfaceMaterial& m, const f64::SurfaceLayers& l,
                    const f64::Perturbation& p, vec3 wo) {
    constexpr int kRows = 500, kColumns = 500;
    vec3 sum{};
    for (int i = 0; i < kRows; ++i)
        for (int j = 0; j < kColumns; ++j) {
            const double z = 1 - 2 * (i + 0.5) / kRows;
            sum = sum + f64::layered_eval(
                            m, l, p, direction(std::acos(z), 2 * kPi * (j + 0.5) / kColumns), wo);
        }
    return sum * (4 * kPi / (kRows * kColumns));
}

f64::SurfaceMaterial white_paint() {
    f64::SurfaceMaterial m = f64::surface_material(
        f64::kBrdfMicrofacet, f64::lobe_make(f64::kMdfGgx, 0.5, 0.5), -1.0, {-1, -1, 1}, 0.0);
    m = f64::surface_dielectric(m, {0, 0, 0}, 0.0);  // no interface of its own
    m.has_diffuse = true;
    return f64::surface_colored(m, {1, 1, 1}, 0.0);
}

f64::SurfaceMaterial mirror(double alpha_x, double alpha_y, vec3 color = {1, 1, 1}) {
    return f64::surface_colored(
        f64::surface_material(f64::kBrdfMicrofacet, f64::lobe_make(f64::kMdfGgx, alpha_x, alpha_y),
                              -1.0, {-1, -1, 1}, 0.04),
        color, 1.0);
}

TEST(Coat, FaceIsThatOfTheExtension) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int k = 0; k < 500; ++k) {
        const double roughness = 0.1 + 0.9 * unit(random);
        const vec3 n = direction(0.4 * unit(random), 6 * unit(random));
        const vec3 wi = direction(1.4 * unit(random), 6 * unit(random));
        const vec3 wo = direction(1.2 * unit(random), 6 * unit(random));
        const double cos_i = f64::dot(n, wi);
        const double want = 0.75 * std::max(cos_i, 0.0) *
                            static_cast<double>(oracle::coat_face(roughness * roughness, wide_of(n),
                                                                  wide_of(wi), wide_of(wo)));
        const double got = f64::coat_eval(coat_of(roughness, {1, 1, 1}, n, 0.75), wi, wo);
        EXPECT_NEAR(got, want, 1e-9 * (1 + want));
    }
}

// The fit of the albedo, for every roughness. Measured: 0.0068 from cosine 0.1 on, 0.027 below; 0.0004 of the mean.
TEST(Coat, AlbedoIsTheIntegralOfItsFace) {
    for (int step = 1; step <= 10; ++step) {
        const double roughness = 0.1 * step;
        const f64::CoatLayer coat = coat_of(roughness);
        double mean = 0, mean_want = 0;
        for (int c = 1; c <= 20; ++c) {
            const double cosine = 0.05 * c - 0.025;
            const double want =
                static_cast<double>(oracle::coat_albedo(roughness * roughness, cosine));
            const double got = f64::coat_albedo(coat, cosine);
            EXPECT_NEAR(got, want, cosine < 0.1 ? 0.03 : 0.009) << roughness << " at " << cosine;
            mean += 0.1 * cosine * got;
            mean_want += 0.1 * cosine * want;
        }
        EXPECT_NEAR(coat.mean_albedo, mean_want, 0.002) << roughness;
        EXPECT_NEAR(mean, mean_want, 0.002) << roughness;
    }
}

TEST(Coat, TintIsWhatComesBackAlongTheNormalAndIsDarkerAtTheEdge) {
    const vec3 tint{0.8, 0.3, 0.05};
    const f64::CoatLayer coat = coat_of(0.1, tint);
    double before = 1;
    for (const double cosine : {1.0, 0.8, 0.5, 0.2, 0.05}) {
        const f64::CoatSeen seen = f64::coat_seen(coat, seen_at(cosine));
        EXPECT_NEAR(seen.tint.x * seen.tint.x,
                    std::pow(static_cast<double>(oracle::coat_absorption(0.8L, cosine)), 2), 1e-12);
        EXPECT_NEAR(seen.tint.z, static_cast<double>(oracle::coat_absorption(0.05L, cosine)),
                    1e-12);
        EXPECT_LE(seen.tint.y, before);
        before = seen.tint.y;
    }
    const f64::CoatSeen normal = f64::coat_seen(coat, kUp);
    EXPECT_NEAR(normal.tint.y * normal.tint.y, 0.3, 1e-12);
    const vec3 below = f64::coat_seen(coat, {0.6, 0, -0.8}).through;
    EXPECT_EQ(below.x, f64::coat_seen(coat, {1, 0, 0}).through.x) << "no cut at the horizon";
}

// Schlick's terms are those of a smooth coat: a mirror under it is a pile of two plates.
TEST(Coat, LightGoesToAndFroBetweenTheCoatAndItsBase) {
    for (const double color : {1.0, 0.7, 0.2}) {
        for (const double cosine : kLayerCosines) {
            const f64::CoatLayer coat = coat_of(0.3);
            const f64::CoatSeen seen = f64::coat_seen(coat, seen_at(cosine));
            const double left =
                f64::coat_over_specular(coat, {color, color, color}, seen, seen).x * color;
            const double pass = 1 - seen.albedo;
            EXPECT_NEAR(left,
                        static_cast<double>(oracle::to_and_fro(color, seen.albedo, pass, pass)),
                        1e-12);
        }
        const f64::CoatLayer coat = coat_of(0.0);
        EXPECT_NEAR(f64::coat_diffuse_gain(coat, {color, color, color}).x * color,
                    static_cast<double>(oracle::to_and_fro(color, coat.mean_albedo, 1, 1)), 1e-12);
    }
}

// A white base loses nothing: what is missing or gained is the error of the fit. Measured: 0.0076 at cosine 0.05,
// 0.0035 from 0.15 on.
TEST(Coat, OverWhitePaintReflectsAllLight) {
    const f64::Perturbation p = f64::perturb_make(f64::kMethodNone, kUp, true, false);
    for (const double roughness : {0.0, 0.2, 0.5, 1.0})
        for (const double cosine : kLayerCosines) {
            const vec3 albedo =
                albedo_by_samples(white_paint(), layers_of(coat_of(roughness)), p, seen_at(cosine));
            EXPECT_NEAR(albedo.x, 1, cosine < 0.1 ? 0.012 : 0.006) << roughness << " at " << cosine;
        }
}

// A mirror of color 1 under every rotation: never more than 1 but for the error of the fit. What is missing is what its
// facets shade (single scattering) and, where light and eye differ, the smaller of the two that pass.
TEST(Coat, OverAMirrorGainsNothingUnderAnyMethod) {
    const vec3 n = direction(0.35, 0.8);
    for (int method = 0; method <= f64::kMethodFollowGrain; ++method) {
        if (method == f64::kMethodNormalMap) continue;  // it gains energy by itself
        const f64::Perturbation p = f64::perturb_make(method, n, true, false);
        for (const double roughness : {0.0, 0.4})
            for (const double cosine : {0.3, 0.6, 1.0}) {
                const vec3 wo = seen_at(cosine, 0.4);
                if (f64::dot(p.n, wo) < 0.1) continue;
                const auto bare = [&] {
                    return albedo_by_samples(mirror(0.1, 0.3), layers_of(f64::coat_none()), p, wo)
                        .x;
                };
                const double coated =
                    albedo_by_samples(mirror(0.1, 0.3), layers_of(coat_of(roughness)), p, wo).x;
                EXPECT_LE(coated, std::max(bare(), 1.0) + 0.005) << method << " " << cosine;
                EXPECT_GE(coated, bare() - 0.06) << method << " " << cosine;
            }
    }
}

// A smooth mirror under a smooth coat loses nothing but what the smaller of two nearly equal albedos leaves out:
// Fresnel's factor changes by 0.02 within the lobe at cosine 0.2. Measured: 0.021 there, 0.003 from 0.5 on.
TEST(Coat, OverASmoothMirrorReflectsAllLight) {
    const f64::Perturbation p = f64::perturb_make(f64::kMethodNone, kUp, true, false);
    for (const double cosine : {0.2, 0.5, 1.0}) {
        const vec3 wo = seen_at(cosine);
        EXPECT_NEAR(albedo_by_samples(mirror(0.01, 0.01), layers_of(coat_of(0.05)), p, wo).x, 1,
                    cosine < 0.5 ? 0.025 : 0.006)
            << cosine;
    }
}

TEST(Coat, IsReciprocal) {
    const f64::Perturbation p = f64::perturb_make(f64::kMethodNone, kUp, true, false);
    const f64::SurfaceMaterial m = f64::surface_colored(white_paint(), {0.7, 0.4, 0.2}, 0.5);
    f64::SurfaceLayers l = layers_of(coat_of(0.4, {0.9, 0.5, 0.2}, kUp, 0.6));
    l.sheen = f64::sheen_make({0.3, 0.2, 0.6}, 0.3);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int k = 0; k < 200; ++k) {
        const vec3 a = direction(1.5 * unit(random), 6 * unit(random));
        const vec3 b = direction(1.5 * unit(random), 6 * unit(random));
        const vec3 there = f64::layered_eval(m, l, p, a, b) * (1 / a.z);
        const vec3 back = f64::layered_eval(m, l, p, b, a) * (1 / b.z);
        EXPECT_NEAR(there.x, back.x, 1e-12 * (1 + back.x));
        EXPECT_NEAR(there.z, back.z, 1e-12 * (1 + back.z));
    }
}

TEST(Sheen, ValueIsThatOfThePaperAndAtMostWhatArrives) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int k = 0; k < 500; ++k) {
        const double roughness = 0.3 + 0.7 * unit(random);  // no albedo above 1
        const f64::SheenLayer sheen = f64::sheen_make({1, 0.5, 0.25}, roughness);
        const vec3 wi = direction(1.5 * unit(random), 6 * unit(random));
        const vec3 wo = direction(1.5 * unit(random), 6 * unit(random));
        const vec3 got = f64::sheen_eval(sheen, f64::sheen_seen(sheen, wi.z),
                                         f64::sheen_seen(sheen, wo.z), kUp, wi, wo);
        const double want = wi.z * static_cast<double>(oracle::sheen(
                                       roughness * roughness, {0, 0, 1}, wide_of(wi), wide_of(wo)));
        EXPECT_NEAR(got.x, want, 1e-9 * (1 + want));
        EXPECT_NEAR(got.z, 0.25 * want, 1e-9 * (1 + want));
    }
}

// Measured: 0.0133, and 0.7 % where the albedo is above 1.
TEST(Sheen, AlbedoIsTheIntegral) {
    for (const double roughness : {0.1, 0.2, 0.35, 0.5, 0.7, 1.0}) {
        const f64::SheenLayer sheen = f64::sheen_make({1, 1, 1}, roughness);
        for (const double cosine : kLayerCosines) {
            const double want =
                static_cast<double>(oracle::sheen_albedo(roughness * roughness, cosine));
            EXPECT_NEAR(f64::sheen_albedo(sheen, cosine), want, 0.016 * std::max(want, 1.0))
                << roughness << " at " << cosine;
        }
    }
}

// The fit's error alone is above 1. Smooth sheens, which the paper has gain energy at grazing angles, too. Measured:
// 0.857 to 1.0049.
TEST(Sheen, OverWhitePaintGainsNothing) {
    const f64::Perturbation p = f64::perturb_make(f64::kMethodNone, kUp, true, false);
    for (const double roughness : {0.0, 0.1, 0.25, 0.5, 1.0})
        for (const double cosine : kLayerCosines) {
            f64::SurfaceLayers l = layers_of(f64::coat_none());
            l.sheen = f64::sheen_make({1, 1, 1}, roughness);
            const vec3 albedo = albedo_by_samples(white_paint(), l, p, seen_at(cosine), 1 << 16);
            EXPECT_LE(albedo.x, 1.008) << roughness << " at " << cosine;
            EXPECT_GE(albedo.x, 0.84) << roughness << " at " << cosine;
        }
}

// An anisotropic half metal under a bumped coat and sheen: the mean of samples is the integral over a grid.
TEST(Layers, SamplesHaveTheMeanOfTheIntegral) {
    f64::SurfaceMaterial m = f64::surface_material(
        f64::kBrdfMicrofacet, f64::lobe_make(f64::kMdfGgx, 0.2, 0.5), -1.0, {-1, -1, 1}, 0.04);
    m.has_diffuse = true;
    m = f64::surface_colored(m, {0.8, 0.5, 0.3}, 0.4);
    f64::SurfaceLayers l = layers_of(coat_of(0.5, {0.9, 0.6, 0.3}, direction(0.2, 2.0), 0.7));
    l.sheen = f64::sheen_make({0.2, 0.3, 0.4}, 0.4);
    for (int method = 0; method <= f64::kMethodStretch; ++method) {
        const f64::Perturbation p = f64::perturb_make(method, direction(0.3, 1.0), true, false);
        for (const double cosine : {0.4, 0.9}) {
            const vec3 wo = seen_at(cosine, 0.5);
            const vec3 sampled = albedo_by_samples(m, l, p, wo, 1 << 16);
            const vec3 summed = albedo_by_grid(m, l, p, wo);
            // Of 65,536 draws the standard error is below 0.002.
            EXPECT_NEAR(sampled.x, summed.x, 0.006) << method;
            EXPECT_NEAR(sampled.z, summed.z, 0.006) << method;
        }
    }
}

TEST(Layers, ASurfaceWithoutLayersIsTheSurface) {
    const f64::SurfaceLayers none = layers_of(f64::coat_none());
    const f64::Perturbation p =
        f64::perturb_make(f64::kMethodFollowGrain, direction(0.3, 1.0), true, false);
    f64::SurfaceMaterial m = mirror(0.2, 0.5, {0.9, 0.6, 0.3});
    m.has_diffuse = true;
    m.diffuse = {0.1, 0.2, 0.3};
    for (double azimuth = 0; azimuth < 6; azimuth += 0.7) {
        const vec3 wi = direction(0.9, azimuth), wo = direction(0.6, 2.0);
        const vec3 want = f64::surface_eval(m, p, wi, wo) * std::max(f64::dot(p.n, wi), 0.0);
        const vec3 got = f64::layered_eval(m, none, p, wi, wo);
        EXPECT_NEAR(got.x, want.x, 1e-15 + 1e-14 * want.x);
        EXPECT_NEAR(f64::layered_pdf(m, none, p, wi, wo), f64::surface_pdf(m, p, wi, wo), 1e-12);
    }
}

TEST(SpecularFactors, FresnelIsThatOfTheExtensions) {
    for (const double ior : {1.0, 1.33, 1.5, 2.4}) {
        const double root = (ior - 1) / (ior + 1);
        for (const double color : {0.0, 0.5, 1.0, 8.0})
            for (const double weight : {0.0, 0.3, 1.0})
                for (const double cosine : {0.0, 0.2, 0.7, 1.0}) {
                    f64::SurfaceMaterial m = f64::surface_material(
                        f64::kBrdfMicrofacet, f64::lobe_make(f64::kMdfGgx, 0.3, 0.3), -1.0,
                        {-1, -1, 1}, root * root);
                    const double f0 = root * root * color;
                    m = f64::surface_colored(f64::surface_dielectric(m, {f0, 0, 0}, weight),
                                             {0.5, 0.5, 0.5}, 0.0);
                    const double want =
                        static_cast<double>(oracle::dielectric_fresnel(ior, color, weight, cosine));
                    EXPECT_NEAR(f64::specular_fresnel(m, cosine).x, want, 1e-14);
                    // The diffuse term gets the rest of the largest channel, on both ways.
                    EXPECT_NEAR(
                        f64::diffuse_eval(m.brdf, m.dielectric_f0, m.dielectric_f90, cosine, 1.0) *
                            kPi,
                        (1 - want) * (1 - static_cast<double>(
                                              oracle::dielectric_fresnel(ior, color, weight, 1))),
                        1e-14);
                    // A metal has none of it.
                    m = f64::surface_colored(m, {0.5, 0.5, 0.5}, 1.0);
                    EXPECT_NEAR(
                        f64::specular_fresnel(m, cosine).x,
                        static_cast<double>(oracle::dielectric_fresnel(1e18L, 0.5L, 1, cosine)),
                        1e-12);
                }
    }
}

// The diffuse albedo under a weighted interface is the integral, by Gauss's points being needless for a polynomial
// of this degree on 2000 steps.
TEST(SpecularFactors, DiffuseAlbedoIsTheIntegral) {
    for (const double f0 : {0.0, 0.04, 0.4})
        for (const double f90 : {0.4, 1.0})
            for (const double cos_o : {0.1, 0.6, 1.0}) {
                double sum = 0;
                for (int i = 0; i < 2000; ++i) {
                    const double c = (i + 0.5) / 2000;
                    sum += f64::diffuse_eval(f64::kBrdfMicrofacet, f0, f90, c, cos_o) * c * 2 *
                           kPi / 2000;
                }
                EXPECT_NEAR(f64::diffuse_albedo(f64::kBrdfMicrofacet, f0, f90, cos_o), sum, 1e-6);
            }
}

// Single against double precision over hostile inputs: nothing is infinite or negative.
TEST(Layers, HostileInputsStayFinite) {
    std::mt19937 random(8);
    std::uniform_real_distribution<float> unit(0, 1);
    const float edges[] = {0.0f, 1e-6f, 0.5f, 1.0f};
    for (const float roughness : edges)
        for (const float tint : edges)
            for (int k = 0; k < 50; ++k) {
                const f32::CoatLayer coat = f32::coat_make(
                    unit(random), f32::lobe_of_roughness(f32::kMdfGgx, roughness, 0.0f), {0, 0, 1},
                    true, f32::coat_depth({tint, tint, 1.0f}));
                const f32::SurfaceLayers l{coat, f32::sheen_make({1, 1, 1}, roughness)};
                const float z = k % 5 == 0 ? edges[k % 4] : unit(random);
                const f32::vec3 wo{std::sqrt(1 - z * z), 0, z};
                const float y = k % 7 == 0 ? edges[k % 4] : unit(random);
                const f32::vec3 wi{-std::sqrt(1 - y * y), 0, y};
                const f32::SurfaceMaterial m = f32::surface_colored(
                    f32::surface_material(f32::kBrdfMicrofacet,
                                          f32::lobe_make(f32::kMdfGgx, 0.1f, 0.5f), -1.0f,
                                          {-1, -1, 1}, 1.0f),
                    {1, 1, 1}, unit(random));
                const f32::Perturbation p =
                    f32::perturb_make(f32::kMethodNone, {0, 0, 1}, true, false);
                const f32::vec3 f = f32::layered_eval(m, l, p, wi, wo);
                EXPECT_TRUE(f.x >= 0 && f.x < 1e31f && f.z >= 0 && f.z < 1e31f)
                    << roughness << " " << z;
            }
}

}  // namespace
}  // namespace burnish::test
