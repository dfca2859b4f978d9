// SurfacePoint: its values against surface_eval of values put together here, its samples and their
// density against quadrature of those values.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/surface.hpp"
#include "burnish/tabulated_material.hpp"
#include "shading/lobes_under_test.hpp"

namespace burnish {
namespace {

using f64::vec3;
using test::direction;

constexpr float kRotation = 0.6f;  // radians

glm::dvec3 of(vec3 v) {
    return {v.x, v.y, v.z};
}

vec3 of(glm::dvec3 v) {
    return {v.x, v.y, v.z};
}

// `v` against axes that are rotated by `angle` about z.
vec3 rotated(vec3 v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x + s * v.y, c * v.y - s * v.x, v.z};
}

// A material, and what it says to shading/.
struct PointCase {
    std::string name;
    Material material;
    f64::SurfaceMaterial surface;
    bool grooves_along_x;
};

Material base_material(Brdf brdf, Mdf mdf, MaterialLobe lobe) {
    Material m;
    m.base_color = {0.75f, 0.5f, 0.25f, 1.0f};
    m.metallic = 0.25f;
    m.dielectric_f0 = 0.0625f;
    m.brdf = brdf;
    m.mdf = mdf;
    m.lobe = std::move(lobe);
    m.anisotropy_rotation = kRotation;
    m.conserve = true;
    m.single_scattering = true;  // furnace_test.cpp has the light that is reflected more than once
    return m;
}

// A quarter metal of base color (3/4, 1/2, 1/4) over a dielectric of 1/16.
f64::SurfaceMaterial base_surface(int brdf, const f64::Lobe& lobe, double ks = -1.0,
                                  vec3 c = {-1, -1, 1}) {
    f64::SurfaceMaterial s = f64::surface_material(brdf, lobe, ks, c, 0.0625);
    s.specular = {0.75 * 0.0625 + 0.25 * 0.75, 0.75 * 0.0625 + 0.25 * 0.5,
                  0.75 * 0.0625 + 0.25 * 0.25};
    s.diffuse = {0.75 * 0.75, 0.75 * 0.5, 0.75 * 0.25};
    s.has_diffuse = true;
    return s;
}

// Numbers that a float holds, so that single precision adds nothing. Lobes are wide, so that
// quadrature on a fixed grid finds them.
std::vector<PointCase> point_cases() {
    std::vector<PointCase> cases;
    const AlphaLobe pair{{0.25f, 0.5f}};
    // Roughness 3/4 is an alpha of 9/16 across; strength 1/2: a quarter of the way to 1 along.
    cases.push_back({"gltf", base_material(Brdf::microfacet, Mdf::ggx, GltfLobe{0.75f, 0.5f}),
                     base_surface(f64::kBrdfMicrofacet,
                                  f64::lobe_make(f64::kMdfGgx, 0.75 * 0.5625 + 0.25, 0.5625)),
                     false});
    cases.push_back(
        {"pair", base_material(Brdf::microfacet_separable, Mdf::beckmann, pair),
         base_surface(f64::kBrdfMicrofacetSeparable, f64::lobe_make(f64::kMdfBeckmann, 0.25, 0.5)),
         true});
    // Exponents 2/alpha^2 - 2.
    cases.push_back(
        {"ashikhmin-shirley", base_material(Brdf::ashikhmin_shirley, Mdf::ggx, pair),
         base_surface(f64::kBrdfAshikhminShirley, f64::lobe_make(f64::kMdfAshikhminShirley, 30, 6)),
         true});
    cases.push_back({"ward-gmd", base_material(Brdf::ward_gmd, Mdf::ggx, pair),
                     base_surface(f64::kBrdfWardGmd, f64::lobe_make(f64::kMdfBeckmann, 0.25, 0.5)),
                     true});
    PointCase phong{"phong", base_material(Brdf::phong, Mdf::ggx, AlphaLobe{{0.5f, 0.5f}}),
                    base_surface(f64::kBrdfPhong, f64::lobe_make(f64::kMdfGgx, 0.5, 0.5), 0.375),
                    true};
    phong.material.ks = 0.375f;
    cases.push_back(phong);
    PointCase lafortune{"lafortune",
                        base_material(Brdf::lafortune, Mdf::ggx, AlphaLobe{{0.5f, 0.5f}}),
                        base_surface(f64::kBrdfLafortune, f64::lobe_make(f64::kMdfGgx, 0.5, 0.5),
                                     -1, {-1.125, -0.75, 0.875}),
                        true};
    lafortune.material.lafortune_c = {-1.125f, -0.75f, 0.875f};
    cases.push_back(lafortune);
    PointCase metal{"metal", base_material(Brdf::microfacet, Mdf::ggx, pair),
                    base_surface(f64::kBrdfMicrofacet, f64::lobe_make(f64::kMdfGgx, 0.25, 0.5)),
                    true};
    metal.material.conductor = Conductor{{0.25f, 0.875f, 1.5f}, {3.875f, 2.5f, 1.625f}};
    metal.surface.fresnel = f64::kFresnelConductor;
    metal.surface.eta = {0.25, 0.875, 1.5};
    metal.surface.k = {3.875, 2.5, 1.625};
    metal.surface.has_diffuse = false;
    cases.push_back(metal);
    PointCase film = metal;
    film.name = "film";
    film.material.conductor->oxide = OxideFilm{50.0f,
                                               {{{0.125f, 0.5f, 0.875f},
                                                 {0.25f, -0.25f, 0.125f},
                                                 {0.0f, 0.0f, 0.0f},
                                                 {0.5f, -1.5f, 0.125f},
                                                 {-2.0f, 3.0f, 0.25f},
                                                 {1.0f, -2.0f, -0.5f}}}};
    film.surface.fresnel = f64::kFresnelCurve;
    film.surface.curve.normal = {0.125, 0.5, 0.875};
    film.surface.curve.pole = {0.25, -0.25, 0.125};
    film.surface.curve.c0 = {0.5, -1.5, 0.125};
    film.surface.curve.c1 = {-2.0, 3.0, 0.25};
    film.surface.curve.c2 = {1.0, -2.0, -0.5};
    cases.push_back(film);
    return cases;
}

const vec3 kTilted = direction(25 * kPi / 180, 0.9);
const vec3 kView = direction(40 * kPi / 180, 2.2);

// Every case under every method that it takes.
template <typename Check>
void for_all(const Check& check) {
    for (PointCase c : point_cases()) {
        for (int method = 0; method < test::kMethods; ++method) {
            if (!f64::brdf_takes_method(c.surface.brdf, method)) continue;
            c.material.method = static_cast<Method>(method);
            SCOPED_TRACE(c.name + " " +
                         std::string(method_names()[static_cast<std::size_t>(method)]));
            check(c, SurfacePoint(c.material, of(kTilted)));
        }
    }
}

// To the normal of cosines: `none` ignores the perturbed one.
double cosine(const PointCase& c, vec3 wi) {
    return c.material.method == Method::none ? wi.z : f64::dot(kTilted, wi);
}

// The angle is a float: sin and cos of it differ by 6e-8 from those of 0.6.
constexpr double kRounding = 1e-6;

TEST(SurfacePoint, EvaluatesTheValuesThatTheMaterialStates) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for_all([&](const PointCase& c, const SurfacePoint& point) {
        int method = static_cast<int>(c.material.method);
        // normal-map stands for what engines do: where nothing is anisotropic, a rotated lobe.
        const bool isotropic = c.surface.lobe.p0 == c.surface.lobe.p1;
        if (method == f64::kMethodNormalMap && isotropic) method = f64::kMethodGramSchmidt;
        const f64::Perturbation p =
            f64::perturb_make(method, rotated(kTilted, kRotation), c.grooves_along_x,
                              method == f64::kMethodDeformSmooth);
        int bright = 0;
        for (int i = 0; i < 200; ++i) {
            // About the mirror direction of the normal, where every lobe has light.
            const vec3 wi = test::Axes(f64::reflect_about(kView, kTilted))
                                .at(uniform(generator), 2 * kPi * uniform(generator));
            const vec3 wanted =
                f64::surface_eval(c.surface, p, rotated(wi, kRotation), rotated(kView, kRotation));
            const glm::dvec3 found = point.eval(of(wi), of(kView));
            bright += wanted.x > 0.01 ? 1 : 0;
            EXPECT_NEAR(found.x, wanted.x, kRounding * (1 + wanted.x));
            EXPECT_NEAR(found.y, wanted.y, kRounding * (1 + wanted.y));
            EXPECT_NEAR(found.z, wanted.z, kRounding * (1 + wanted.z));
        }
        EXPECT_GT(bright, 100);
    });
}

TEST(SurfacePoint, IsTheSameUnderEveryMethodWhereTheNormalIsTheGeometricOne) {
    Material m = base_material(Brdf::microfacet, Mdf::ggx, AlphaLobe{{0.25f, 0.5f}});
    m.method = Method::none;
    const glm::dvec3 wi = of(direction(0.5, 5.0)), wo = of(kView);
    const glm::dvec3 wanted = SurfacePoint(m).eval(wi, wo);
    EXPECT_GT(wanted.x, 0.05);
    for (int method = 1; method < test::kMethods; ++method) {
        m.method = static_cast<Method>(method);
        EXPECT_EQ(SurfacePoint(m).eval(wi, wo), wanted) << name_of(m.method);
    }
}

// The mean of the weights is the directional albedo, and the integral of the density over the whole
// sphere is the share of the samples that are accepted.
TEST(SurfacePoint, SamplesEstimateTheIntegral) {
    std::mt19937 generator(2);
    std::uniform_real_distribution<double> uniform(0, 1);
    constexpr int kSamples = 20000;
    for_all([&](const PointCase& c, const SurfacePoint& point) {
        const vec3 mirror = f64::reflect_about(kView, kTilted);
        const auto integral = [&](const auto& f) {
            return test::integrate_cap(f, mirror, kPi, 128, 192);
        };
        const double albedo = integral([&](vec3 wi) {
            return point.eval(of(wi), of(kView)).y * std::max(cosine(c, wi), 0.0);
        });
        const double mass = integral([&](vec3 wi) { return point.pdf(of(wi), of(kView)); });
        double sum = 0, squares = 0;
        int accepted = 0;
        for (int i = 0; i < kSamples; ++i) {
            const auto s = point.sample(
                of(kView), {uniform(generator), uniform(generator), uniform(generator)});
            if (!s) continue;
            ++accepted;
            sum += s->weight.y;
            squares += s->weight.y * s->weight.y;
        }
        const double mean = sum / kSamples, share = static_cast<double>(accepted) / kSamples;
        const double error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
        // Five deviations, and what midpoints miss at the horizon: 0.2 %.
        EXPECT_NEAR(mean, albedo, 5 * error + 2e-3 * albedo);
        EXPECT_GT(albedo, 0.05);
        EXPECT_NEAR(share, mass, 5 * std::sqrt(mass * std::abs(1 - mass) / kSamples) + 2e-3);
        EXPECT_GT(mass, 0.7);
    });
}

TEST(SurfacePoint, ASampleSaysItsDensityAndItsWeight) {
    for_all([&](const PointCase& c, const SurfacePoint& point) {
        // From i = 1: 0 draws the pole of the lobe, where the Jacobian of a deformation depends on the
        // side from which it is approached.
        for (int i = 1; i <= 100; ++i) {
            const auto s = point.sample(of(kView), {(i - 0.5) / 100, std::fmod(0.618034 * i, 1.0),
                                                    std::fmod(0.754878 * i, 1.0)});
            if (!s) continue;
            const vec3 wi = of(s->to_light);
            EXPECT_NEAR(f64::length(wi), 1, 1e-12);
            EXPECT_NEAR(point.pdf(s->to_light, of(kView)) / s->pdf, 1, 1e-9);
            const double weight = point.eval(s->to_light, of(kView)).x * cosine(c, wi) / s->pdf;
            EXPECT_NEAR(s->weight.x, weight, 1e-9 * (1 + weight));
        }
    });
}

// A normal that is turned away from the eye is turned until the eye sees it.
TEST(SurfacePoint, ANormalThatFacesAwayIsTurnedToTheEye) {
    Material m = base_material(Brdf::microfacet, Mdf::ggx, AlphaLobe{{0.25f, 0.5f}});
    m.method = Method::rotate_arc;
    m.anisotropy_rotation = 0.0f;
    const vec3 n = direction(1.0, kPi), wo = direction(1.2, 0.0);
    ASSERT_LT(f64::dot(n, wo), 0);
    const f64::Perturbation turned =
        f64::perturb_make(f64::kMethodRotateArc, f64::normal_facing(n, wo), true, false);
    const f64::SurfaceMaterial surface =
        base_surface(f64::kBrdfMicrofacet, f64::lobe_make(f64::kMdfGgx, 0.25, 0.5));
    const vec3 wi = direction(0.2, kPi);
    const double wanted = f64::surface_eval(surface, turned, wi, wo).x;
    EXPECT_GT(wanted, 0.01);
    EXPECT_NEAR(SurfacePoint(m, of(n)).eval(of(wi), of(wo)).x, wanted, 1e-12);
}

// Under normal-map an isotropic lobe is a rotated one and an anisotropic lobe is not: a texture that
// would make it anisotropic does not count.
TEST(SurfacePoint, AnAnisotropyTextureDoesNotChangeTheMethod) {
    Material m = base_material(Brdf::microfacet, Mdf::ggx, GltfLobe{0.75f, 0.0f});
    m.method = Method::normal_map;
    const SurfacePoint plain(m, of(kTilted));
    m.anisotropy_texture.texture = 0;
    const SurfacePoint textured(m, of(kTilted));
    const glm::dvec3 wi = of(f64::reflect_about(kView, kTilted));
    EXPECT_GT(plain.eval(wi, of(kView)).x, 0.05);
    EXPECT_EQ(textured.eval(wi, of(kView)), plain.eval(wi, of(kView)));
}

TEST(SurfacePoint, RefusesWhatHasNoMeaningAtAPoint) {
    Material m = base_material(Brdf::phong, Mdf::ggx, AlphaLobe{{0.5f, 0.5f}});
    m.method = Method::deform_smooth;
    EXPECT_THROW(SurfacePoint{m}, UsageError);
    m.method = Method::follow_grain;
    EXPECT_NO_THROW(SurfacePoint{m});
    m.lobe = Cloth{};
    EXPECT_THROW(SurfacePoint{m}, UsageError);
    m.lobe = Tabulated{std::make_shared<const TabulatedMaterial>(), {}};
    EXPECT_THROW(SurfacePoint{m}, UsageError);
}

TEST(SurfacePoint, FindsEnumerationsByName) {
    EXPECT_EQ(mdf_named("beckmann"), Mdf::beckmann);
    EXPECT_EQ(brdf_named("ward-gmd"), Brdf::ward_gmd);
    EXPECT_EQ(method_named("follow-grain"), Method::follow_grain);
    EXPECT_THROW(mdf_named("ggz"), UsageError);
    EXPECT_THROW(brdf_named(""), UsageError);
    EXPECT_THROW(method_named("followgrain"), UsageError);
}

// A brushed half metal, bumped, under a tinted coat and sheen: values, samples and their density say the same.
TEST(SurfacePointUnderLayers, ValuesSamplesAndDensityAgree) {
    Material m = base_material(Brdf::microfacet, Mdf::ggx, AlphaLobe{{0.25f, 0.5f}});
    m.method = Method::follow_grain;
    m.coat.strength = 0.75f;
    m.coat.roughness = 0.6f;
    m.coat.tint = {0.75f, 0.5f, 0.25f};
    m.sheen.color = {0.25f, 0.5f, 0.125f};
    m.sheen.roughness = 0.5f;
    m.specular = 0.5f;
    const SurfacePoint point(m, of(direction(0.3, 0.7)));
    const glm::dvec3 to_eye = of(direction(0.6, 2.0));
    glm::dvec3 integral(0.0);
    double density = 0;
    constexpr int kRows = 400, kColumns = 400;
    for (int i = 0; i < kRows; ++i)
        for (int j = 0; j < kColumns; ++j) {
            const vec3 wi =
                direction(std::acos(1 - 2 * (i + 0.5) / kRows), 2 * kPi * (j + 0.5) / kColumns);
            const double area = 4 * kPi / (kRows * kColumns);
            const glm::dvec3 f_cos = point.eval_cos(of(wi), to_eye);
            integral += f_cos * area;
            density += point.pdf(of(wi), to_eye) * area;
            const double cosine = f64::dot(direction(0.3, 0.7), wi);
            if (cosine > 0.05) {
                EXPECT_NEAR(point.eval(of(wi), to_eye).y * cosine, f_cos.y, 1e-9);
            }
        }
    constexpr int kDraws = 1 << 16;
    glm::dvec3 mean(0.0);
    int returned = 0;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < kDraws; ++i) {
        const auto s = point.sample(to_eye, {unit(random), unit(random), unit(random)});
        if (!s) continue;
        ++returned;
        mean += s->weight / static_cast<double>(kDraws);
        if (i < 100) {
            EXPECT_NEAR(point.pdf(s->to_light, to_eye), s->pdf, 1e-9 * s->pdf);
        }
    }
    // Of 65,536 draws the standard errors are below 0.003.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], integral[c], 0.01) << c;
    EXPECT_NEAR(static_cast<double>(returned) / kDraws, density, 0.01);
}

}  // namespace
}  // namespace burnish
