// shading/surface and shading/display against the second derivation of tests/oracle/surface.hpp, in
// double, and single against double precision.
#include <gtest/gtest.h>

#include <random>

#include "oracle/further_brdfs.hpp"
#include "oracle/surface.hpp"
#include "surface_cases.hpp"

namespace burnish::test {
namespace {

using oracle::Vec3;

Vec3 wide(vec3 v) {
    return {v.x, v.y, v.z};
}

void expect_near(vec3 got, Vec3 want, double bound, const std::string& what) {
    EXPECT_NEAR(got.x, static_cast<double>(want.x), bound) << what;
    EXPECT_NEAR(got.y, static_cast<double>(want.y), bound) << what;
    EXPECT_NEAR(got.z, static_cast<double>(want.z), bound) << what;
}

double narrow(long double v) {
    return static_cast<double>(v);
}

class Numbers {
  public:
    double at(double low, double high) {
        return low + (high - low) * std::uniform_real_distribution<double>(0, 1)(random_);
    }
    vec3 direction_above(double least_z) {
        return direction(std::acos(at(least_z, 1)), at(0, 2 * kPi));
    }

  private:
    std::mt19937 random_{2024};
};

TEST(SurfaceOracle, DisplayIsThatOfTheStandards) {
    Numbers numbers;
    const std::string names[] = {"linear", "reinhard", "aces", "khronos-neutral"};
    for (int i = 0; i < 2000; ++i) {
        // To 0.05, where the neutral map's offset bends, to 1 and far beyond.
        const double most = i % 3 == 0 ? 0.05 : i % 3 == 1 ? 1.0 : 20.0;
        const vec3 c{numbers.at(0, most), numbers.at(0, most), numbers.at(0, most)};
        for (int kind = 0; kind < 4; ++kind) {
            expect_near(f64::tone_map(kind, c),
                        oracle::tone_mapped(names[static_cast<std::size_t>(kind)], wide(c)), 1e-12,
                        names[static_cast<std::size_t>(kind)]);
        }
        EXPECT_NEAR(f64::srgb_from_linear(c.x), narrow(oracle::srgb_encoded(c.x)), 1e-12);
        EXPECT_NEAR(f64::linear_from_srgb(c.y), narrow(oracle::srgb_decoded(c.y)),
                    1e-12 + 1e-13 * most * most);
        const double shown = f64::display_color(f64::kToneMapAces, c).z;
        EXPECT_NEAR(shown,
                    narrow(oracle::srgb_encoded(
                        std::clamp(oracle::tone_mapped("aces", wide(c)).z, 0.0L, 1.0L))),
                    1e-12);
    }
}

TEST(SurfaceOracle, TexelsAreNormals) {
    Numbers numbers;
    for (int i = 0; i < 4000; ++i) {
        const vec3 texel{numbers.at(0, 1), numbers.at(0, 1),
                         numbers.at(i % 2 ? 0.45 : 0.5, i % 3 ? 1 : 0.52)};
        const f64::vec2 scale{numbers.at(0, 3), numbers.at(-3, 3)};
        expect_near(f64::normal_of_vector(f64::vector_of_texel(texel), scale),
                    oracle::normal_of_texel(wide(texel), scale.x, scale.y), 1e-13, "texel");
        // Two channels: the same as three whose third is what is left of 1.
        const double x = 2 * texel.x - 1, y = 2 * texel.y - 1;
        const double z = std::sqrt(std::max(1 - x * x - y * y, 0.0));
        if (z > 1e-6) {
            expect_near(
                f64::normal_of_vector(f64::vector_of_texel(f64::vec2(texel.x, texel.y)), scale),
                oracle::normal_of_texel({texel.x, texel.y, 0.5L + 0.5L * z}, scale.x, scale.y),
                1e-9, "two channels");
        }
        // Slopes and back.
        const vec3 n = f64::normal_of_vector(f64::vector_of_texel(texel), {1, 1});
        const f64::vec2 slopes = f64::slopes_of_normal(n);
        expect_near(f64::normal_of_slopes(slopes.x, slopes.y), wide(n), 1e-13, "slopes");
    }
    // The steepest tilt along an axis is the one angle that normal.glsl states.
    EXPECT_NEAR(std::acos(f64::normal_of_slopes(1e6, 0).z) * 180 / kPi, 88.28, 0.01);
    EXPECT_NEAR(std::acos(f64::normalize(f64::vector_of_disk(0, -1)).z) * 180 / kPi, 88.28, 0.01);
}

TEST(SurfaceOracle, VariancesAreThoseOfTheNormal) {
    Numbers numbers;
    for (int i = 0; i < 1000; ++i) {
        const double x = numbers.at(-4, 4), y = numbers.at(-4, 4);
        const f64::vec2 scale{numbers.at(0.1, 2), -numbers.at(0.1, 2)};
        const f64::vec2 variance{numbers.at(0, 0.1), numbers.at(0, 0.1)};
        const f64::vec2 got = f64::variance_about(f64::normal_of_slopes(x, y), variance, scale);
        const auto motion = oracle::normal_motion(x, y);
        EXPECT_NEAR(got.x, narrow(motion[0]) * variance.x * scale.x * scale.x, 1e-9);
        EXPECT_NEAR(got.y, narrow(motion[1]) * variance.y * scale.y * scale.y, 1e-9);
    }
    // Along and across a direction: that of the two coordinates' sum.
    const f64::vec2 along = f64::variance_along({0.3, 0.1}, {0.6, 0.8});
    EXPECT_NEAR(along.x, 0.36 * 0.3 + 0.64 * 0.1, 1e-15);
    EXPECT_NEAR(along.y, 0.64 * 0.3 + 0.36 * 0.1, 1e-15);
}

TEST(SurfaceOracle, DirectionsAddUp) {
    Numbers numbers;
    for (int i = 0; i < 1000; ++i) {
        const double red = numbers.at(0, 1), green = numbers.at(0, 1), angle = numbers.at(-4, 4);
        if (std::hypot(2 * red - 1, 2 * green - 1) < 0.011)
            continue;  // no direction: kLeastDirection2
        const f64::vec2 got =
            f64::stretch_direction({red, green}, {std::cos(angle), std::sin(angle)});
        const auto want = oracle::stretch(red, green, angle);
        EXPECT_NEAR(got.x, narrow(want[0]), 1e-13);
        EXPECT_NEAR(got.y, narrow(want[1]), 1e-13);
    }
    EXPECT_EQ(f64::stretch_direction({0.5, 0.501}, {0, 1}).y, 1.0);
}

// Right-handed, orthonormal, about the normal; mirrored by a handedness below 0, and turned over on
// back faces.
TEST(SurfaceOracle, FramesAreRightHanded) {
    Numbers numbers;
    for (int i = 0; i < 1000; ++i) {
        const vec3 n = numbers.direction_above(-1), t = numbers.direction_above(-1);
        vec3 eye = numbers.direction_above(-1);
        for (const double side : {1.0, -1.0}) {
            if (f64::dot(n, eye) * side < 0.01) continue;
            for (const double handedness : {1.0, -1.0}) {
                const f64::Frame f = f64::surface_frame(n * 3.0, t, handedness, side, eye);
                const vec3 across = t * side - n * f64::dot(n, t * side);
                expect_near(f.n, wide(n * side), 1e-13, "normal");
                expect_near(f.t, wide(f64::normalize(across)), 1e-12, "tangent");
                expect_near(f.b, wide(f64::cross(f.n, f.t) * (handedness * side)), 1e-12,
                            "bitangent");
                // A direction seen from axes that are rotated is that of the rotated frame.
                const f64::vec2 d{0.6, 0.8};
                expect_near(f64::frame_to_local(f64::frame_rotated(f, d), eye),
                            wide(f64::seen_from_rotated(f64::frame_to_local(f, eye), d)), 1e-13,
                            "rotated");
            }
        }
        const vec3 missing = f64::tangent_or_any(n, {0, 0, 0});
        EXPECT_NEAR(f64::dot(missing, n), 0, 1e-13);
        EXPECT_GT(f64::length(missing), 0.5);
        EXPECT_EQ(f64::length(f64::tangent_or_any(n, t) - t), 0.0);
    }
    // The eye behind the interpolated normal: the frame is bent until it is above.
    const vec3 n = direction(1.0, 0), eye = direction(2.7, 0);
    EXPECT_GT(f64::dot(f64::surface_frame(n, {0, 1, 0}, 1.0, 1.0, eye).n, eye), 0);
}

TEST(SurfaceOracle, LightsFallOffAsTheExtensionSays) {
    Numbers numbers;
    for (int i = 0; i < 1000; ++i) {
        const vec3 place = numbers.direction_above(-1) * numbers.at(0.1, 10);
        const vec3 position{numbers.at(-1, 1), numbers.at(-1, 1), numbers.at(-1, 1)};
        const double range = i % 3 == 0 ? 0 : numbers.at(0.5, 12);
        const double inner = numbers.at(0, 0.7), outer = inner + numbers.at(0.01, 0.7);
        const vec3 axis = f64::normalize(position - place + numbers.direction_above(-1) * 2.0);
        const f64::vec2 cone = f64::spot_cone(std::cos(inner), std::cos(outer));
        const f64::LightAtPoint l =
            f64::light_at(place, 1.0, axis, cone, range > 0 ? 1 / (range * range) : 0, position);
        const vec3 away = place - position;
        const double d = f64::length(away);
        const double angle = std::acos(std::clamp(f64::dot(axis, away) / -d, -1.0, 1.0));
        EXPECT_NEAR(l.falloff,
                    narrow(oracle::attenuation(d, range) * oracle::cone(angle, inner, outer)),
                    1e-11 / (d * d));
        expect_near(l.wi, wide(away * (1 / d)), 1e-13, "towards");
    }
    const f64::LightAtPoint sun = f64::light_at({0, 0, 1}, 0.0, {0, 0, -1}, {0, 1}, 0.0, {9, 8, 7});
    EXPECT_EQ(sun.wi.z, 1.0);
    EXPECT_EQ(sun.falloff, 1.0);
}

TEST(SurfaceOracle, FresnelDiffuseAndOcclusion) {
    Numbers numbers;
    for (int i = 0; i < 1000; ++i) {
        const double c = numbers.at(0, 1), o = numbers.at(0, 1), f0 = numbers.at(0, 1);
        const double eta = numbers.at(0.1, 3), k = numbers.at(0, 6);
        EXPECT_NEAR(f64::fresnel_conductor(eta, k, c), narrow(oracle::conductor(eta, k, c)), 1e-11);
        const double n = 1 + eta;
        EXPECT_NEAR(f64::fresnel_rise(n, f64::fresnel_inverse_at_normal(n), c),
                    narrow(oracle::conductor(n, 0, c)) / std::pow((n - 1) / (n + 1), 2), 1e-10);
        EXPECT_EQ(f64::fresnel_rise(0, 1, c), 1.0);
        const double pole = numbers.at(-1, 1), pole2 = numbers.at(-0.1, 0.1);
        EXPECT_NEAR(f64::fresnel_curve(f0, pole, pole2, eta, -k, k, c),
                    narrow(oracle::fresnel_curve({f0, pole, pole2, eta, -k, k}, c)), 1e-13);
        EXPECT_NEAR(f64::diffuse_eval(f64::kBrdfMicrofacet, f0, c, o),
                    narrow(oracle::diffuse(f0, c, o)), 1e-14);
        const Vec3 wi{sqrtl(1 - static_cast<long double>(c) * c), 0, c},
            wo{0, sqrtl(1 - static_cast<long double>(o) * o), o};
        EXPECT_NEAR(f64::diffuse_eval(f64::kBrdfAshikhminShirley, f0, c, o),
                    narrow(oracle::ashikhmin_shirley_diffuse(1, f0, wi, wo)), 1e-13);
        const double ax = numbers.at(0.01, 1), ay = numbers.at(0.01, 1);
        const f64::Lobe lobe = f64::lobe_from_alpha(f64::kMdfGgx, ax, ay);
        EXPECT_NEAR(f64::specular_occlusion(c, o, lobe),
                    narrow(oracle::specular_occlusion(c, o, std::sqrt(ax * ay))), 1e-12);
        const f64::vec2 alpha = f64::alpha_of_roughness(c, o);
        EXPECT_NEAR(alpha.y, std::max(c * c, 1e-3), 1e-15);
        EXPECT_NEAR(alpha.x, alpha.y + (1 - alpha.y) * o * o, 1e-15);
    }
}

// Any direction, tables of random values: the places and the mixture of four.
TEST(SurfaceOracle, TablesAreReadBilinearly) {
    Numbers numbers;
    constexpr int kRings = 7, kColumns = 11;
    std::vector<double> table;
    for (int i = 0; i < kRings * kColumns; ++i) table.push_back(numbers.at(0, 1));
    for (int i = 0; i < 3000; ++i) {
        const double theta = numbers.at(0, kPi / 2), phi = numbers.at(-kPi, kPi);
        const vec3 w = direction(theta, phi);
        const f64::LobePoint q = f64::lobe_point_of(w);
        const f64::TablePlace p = f64::table_place(kColumns, kRings, f64::tabulated_row(q, kRings),
                                                   f64::tabulated_turns(q.x, q.y) + 3.2);
        const auto at = [&](int r, int c) {
            return table[static_cast<std::size_t>(r * kColumns + c % kColumns)];
        };
        const double got = f64::table_value(p, at(p.row, p.column), at(p.row, p.column + 1),
                                            at(p.row + 1, p.column), at(p.row + 1, p.column + 1));
        // 3e-5: 7e-7 of a turn (quarter_turns) times 11 columns, and as much along u near the pole.
        EXPECT_NEAR(got,
                    narrow(oracle::table_value(table.data(), kRings, kColumns, theta,
                                               phi + 0.2L * 2 * 3.14159265358979323846L)),
                    3e-5);
    }
}

// ---- whole surfaces
// ------------------------------------------------------------------------------------

struct OracleModel {
    std::string name;
    int brdf;
    int mdf;
    std::array<long double, 5> p;
};

std::vector<OracleModel> oracle_models() {
    const std::array<long double, 5> alphas = {0.25L, 0.5L};
    const auto e = [](long double a) { return 2 / (a * a) - 2; };
    return {{"ggx", f64::kBrdfMicrofacet, f64::kMdfGgx, alphas},
            {"ggx-separable", f64::kBrdfMicrofacetSeparable, f64::kMdfGgx, alphas},
            {"beckmann", f64::kBrdfMicrofacet, f64::kMdfBeckmann, alphas},
            {"ashikhmin-shirley", f64::kBrdfAshikhminShirley, 0, {e(0.25L), e(0.5L)}},
            {"ward-gmd", f64::kBrdfWardGmd, 0, alphas},
            {"ward", f64::kBrdfWard, 0, alphas},
            {"ward-duer", f64::kBrdfWardDuer, 0, alphas},
            {"cook-torrance", f64::kBrdfCookTorrance, 0, alphas},
            // ks and n of surface_material: unit ks, 1/(2 alpha^2) - 1/2 for alpha^2 = 0.25 0.5.
            {"phong", f64::kBrdfPhong, 0, {4.5L / (2 * 3.14159265358979323846L), 3.5L}},
            {"lafortune",
             f64::kBrdfLafortune,
             0,
             {5.5L / (2 * 3.14159265358979323846L), -1, -0.9L / 1.1L, 0.8L / 1.1L, 3.5L}}};
}

TEST(SurfaceOracle, EveryModelUnderEveryMethod) {
    Numbers numbers;
    for (const OracleModel& model : oracle_models()) {
        for (int method = 0; method < kMethods; ++method) {
            if (!f64::brdf_takes_method(model.brdf, method)) continue;
            const std::string named(method_names()[static_cast<std::size_t>(method)]);
            SurfaceCase c = surface_case(model.name, model.brdf, model.mdf, 0.25, 0.5, 0.25);
            for (int i = 0; i < 400; ++i) {
                const vec3 n = numbers.direction_above(0.5);
                const vec3 wi = numbers.direction_above(0.05), wo = numbers.direction_above(0.05);
                const f64::Perturbation p = f64::perturb_make(method, n, c.grooves_along_x, true);
                const double got = f64::surface_eval(c.material, p, wi, wo).x;
                const Vec3 up = method == 0 ? Vec3{0, 0, 1} : wide(n);
                const long double cos_i = dot(up, wide(wi)), cos_o = dot(up, wide(wo));
                const long double cos_h = dot(wide(wi), normalize(wide(wi) + wide(wo)));
                long double want =
                    oracle::schlick(0.05L * 0.75L + 0.7L * 0.25L, cos_h) *
                    oracle::specular(model.name, model.p, named, wide(n), wide(wi), wide(wo));
                const bool coupled = model.name == "ashikhmin-shirley";
                if (cos_i > 0 && cos_o > 0) {
                    const Vec3 a{sqrtl(1 - cos_i * cos_i), 0, cos_i},
                        b{sqrtl(1 - cos_o * cos_o), 0, cos_o};
                    want += 0.7L * 0.75L *
                            (coupled ? oracle::ashikhmin_shirley_diffuse(1, 0.05L, a, b)
                                     : oracle::diffuse(0.05L, cos_i, cos_o));
                }
                // Where the half vector leaves the lobe's hemisphere D ends: either side of it is
                // right.
                const long double z = mdf_transform("ggx", 0.25L, 0.5L, named, wide(n),
                                                    normalize(wide(wi) + wide(wo)))
                                          .v.z;
                if (std::fabs(z) < 1e-6L) continue;
                EXPECT_NEAR(got, narrow(want), 1e-9 * (1 + narrow(want)))
                    << model.name << " " << named;
            }
        }
    }
}

// Areas and D are given: F D / (4 g g) + diffuse.
TEST(SurfaceOracle, ModelsOfAreas) {
    for (const SurfaceCase& c : surface_cases()) {
        if (!f64::brdf_takes_areas(c.material.brdf)) continue;
        for (int method = 0; method < kMethods; ++method) {
            const vec3 n = direction(0.5, 1.0), wi = direction(0.4, 2.0), wo = direction(0.9, 0.1);
            const f64::Perturbation p = f64::perturb_make(method, n, true, false);
            f64::LobeValues v = f64::no_lobe_values();
            v.D = 0.7;
            v.area_i = 0.9;
            v.area_o = 0.6;
            const long double cos_h = dot(wide(wi), normalize(wide(wi) + wide(wo)));
            const Vec3 up = method == 0 ? Vec3{0, 0, 1} : wide(n);
            long double want = 0;
            if (c.is_tabulated()) {
                const long double rise = oracle::conductor(1.5L, 0, cos_h) / 0.04L;
                want = 0.3L * rise * 0.7L / (4 * 0.9L * 0.6L) + 0.7L / 3.14159265358979323846L;
            } else {
                const long double e_x = c.material.lobe.p0, e_y = c.material.lobe.p1;
                const long double D =
                    mdf_eval("ashikhmin-shirley", e_x, e_y,
                             std::string(method_names()[static_cast<std::size_t>(method)]), wide(n),
                             normalize(wide(wi) + wide(wo)))
                        .D_proj;
                want = oracle::schlick(0.05L * 0.6L + 0.7L * 0.4L, cos_h) * D / (4 * 0.9L * 0.6L) +
                       0.7L * 0.6L * oracle::diffuse(0.05L, dot(up, wide(wi)), dot(up, wide(wo)));
            }
            EXPECT_NEAR(f64::surface_eval(c.material, p, v, wi, wo).x, narrow(want),
                        1e-9 * narrow(want))
                << c.name << " " << method;
        }
    }
}

// The nodes of cloth have the moments that they are given, and stand for tilts spread evenly
// across.
TEST(SurfaceOracle, ClothNodesHaveTheirMoments) {
    const vec3 moments{0.2, 0.3, 0.9};
    double one = 0, xx = 0, yy = 0, y4 = 0, y = 0;
    for (int i = 0; i < f64::kClothNodes; ++i) {
        const vec3 n = f64::cloth_node(moments, i);
        const double w = f64::cloth_node_weight(i);
        one += w;
        xx += w * n.x * n.x;
        y += w * n.y;
        yy += w * n.y * n.y;
        y4 += w * std::pow(n.y, 4);
    }
    EXPECT_NEAR(one, 1, 1e-12);
    EXPECT_NEAR(xx, 0.04, 1e-12);
    EXPECT_NEAR(y, 0, 1e-12);
    EXPECT_NEAR(yy, 0.09, 1e-8);
    EXPECT_NEAR(y4, 1.8 * 0.0081, 1e-8);  // of an even spread: 9/5 of the variance squared
    // The mean over an even spread, by the midpoint rule.
    const SurfaceCase c = surface_case("cloth", f64::kBrdfMicrofacet, f64::kMdfGgx, 0.4, 0.4, 0);
    const vec3 wi = direction(0.5, 1), wo = direction(0.6, 4);
    double mean = 0;
    for (int i = 0; i < 400; ++i) {
        for (const double x : {-0.2, 0.2}) {
            const vec3 n{x, 0.3 * std::sqrt(3.0) * ((i + 0.5) / 200 - 1), 0.9};
            const double cos_i = f64::dot(n, wi), cos_o = f64::dot(n, wo);
            mean += narrow(oracle::diffuse(0.05L, cos_i, cos_o)) * cos_i / 800;
        }
    }
    EXPECT_NEAR(f64::cloth_diffuse(c.material, moments, wi, wo), mean, 1e-4 * mean);
}

}  // namespace
}  // namespace burnish::test
