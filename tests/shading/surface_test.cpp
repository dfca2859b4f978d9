// Whole surfaces (shading/surface): the diffuse and the specular term together. Samples follow
// their density, densities integrate to at most one, the estimate by samples is the integral by
// quadrature, and terms are what they are made of; for every kind of lobe under every method that
// it takes.
#include <gtest/gtest.h>

#include <random>

#include "chi_square.hpp"
#include "surface_cases.hpp"

namespace burnish::test {
namespace {

const vec3 kTiltedBy30 = direction(30 * kPi / 180, 0.9);
const vec3 kView = direction(40 * kPi / 180, 2.2);

f64::Perturbation perturbation_of(const SurfaceCase& c, int method, vec3 n) {
    return f64::perturb_make(method, n, c.grooves_along_x, true);
}

double density_at(const SurfaceCase& c, const f64::Perturbation& p, vec3 wi) {
    return f64::surface_pdf(c.material, p, looked_up(c, p, wi, kView), wi, kView);
}

double reflected_at(const SurfaceCase& c, const f64::Perturbation& p, vec3 wi) {
    const vec3 f = f64::surface_eval(c.material, p, looked_up(c, p, wi, kView), wi, kView);
    return f.y * std::max(f64::dot(p.n, wi), 0.0);
}

std::string named(const SurfaceCase& c, int method) {
    return c.name + " " + std::string(method_names()[static_cast<std::size_t>(method)]);
}

class EveryMethod : public testing::TestWithParam<int> {};

// The chance that any of the tests below fails by luck is 1 %.
TEST_P(EveryMethod, SamplesOfBothTermsFollowTheirDensity) {
    const int method = GetParam();
    const std::vector<SurfaceCase> cases = surface_cases();
    const double least = 0.01 / static_cast<double>(cases.size() * kMethods);
    unsigned seed = 100 * static_cast<unsigned>(method);
    for (const SurfaceCase& c : cases) {
        if (!f64::brdf_takes_method(c.material.brdf, method)) continue;
        const f64::Perturbation p = perturbation_of(c, method, kTiltedBy30);
        double integral = 0;
        const double p_value = sampler_p_value(
            [&](vec3 wi) { return density_at(c, p, wi); },
            [&](double a, double b, double s) { return surface_draw(c, p, kView, a, b, s); },
            Axes(f64::reflect_about(kView, p.n)), ++seed, integral);
        EXPECT_GT(p_value, least) << named(c, method);
        // What is missing was thrown away: half vectors that wo does not see.
        EXPECT_LT(integral, 1.003) << named(c, method);
        EXPECT_GT(integral, 0.8) << named(c, method);
    }
}

// E[f cos / pdf] against the midpoint rule on the cells of the chi-square test.
TEST_P(EveryMethod, TheEstimateIsTheIntegral) {
    const int method = GetParam();
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const SurfaceCase& c : surface_cases()) {
        if (!f64::brdf_takes_method(c.material.brdf, method)) continue;
        const f64::Perturbation p = perturbation_of(c, method, kTiltedBy30);
        const Axes axes(f64::reflect_about(kView, p.n));
        double exact = 0;
        for (const double part :
             expected_counts([&](vec3 wi) { return reflected_at(c, p, wi); }, axes, 1.0)) {
            exact += part;
        }
        double sum = 0, squares = 0;
        constexpr int kSamples = 40000;
        for (int i = 0; i < kSamples; ++i) {
            const vec3 wi = surface_draw(c, p, kView, uniform(generator), uniform(generator),
                                         uniform(generator));
            if (f64::dot(wi, wi) < 0.5) continue;
            const double density = density_at(c, p, wi);
            ASSERT_GT(density, 0) << named(c, method);
            const double weight = reflected_at(c, p, wi) / density;
            sum += weight;
            squares += weight * weight;
        }
        const double mean = sum / kSamples;
        const double error = std::sqrt(std::max(squares / kSamples - mean * mean, 0.0) / kSamples);
        // Five deviations, and what the midpoint rule misses at horizons: 0.2 %.
        EXPECT_NEAR(mean, exact, 5 * error + 2e-3 * exact) << named(c, method);
        EXPECT_GT(exact, 0.01) << named(c, method);
    }
}

std::string method_name(const testing::TestParamInfo<int>& info) {
    std::string name(method_names()[static_cast<std::size_t>(info.param)]);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(Surface, EveryMethod, testing::Range(0, kMethods), method_name);

// surface_sample is surface_direction with its density, for all that look nothing up.
TEST(Surface, SampleSaysItsDensity) {
    for (const SurfaceCase& c : surface_cases()) {
        if (c.material.brdf > f64::kBrdfLafortune) continue;
        const f64::Perturbation p = perturbation_of(c, f64::kMethodFollowGrain, kTiltedBy30);
        for (int i = 0; i < 200; ++i) {
            const double a = (i + 0.5) / 200, b = std::fmod(0.618034 * i, 1.0);
            const double select = std::fmod(0.754878 * i, 1.0);
            double pdf = 0;
            const vec3 wi = f64::surface_sample(c.material, p, kView, {a, b}, select, pdf);
            const vec3 draw = surface_draw(c, p, kView, a, b, select);
            if (f64::dot(draw, draw) < 0.5) {
                EXPECT_EQ(pdf, 0) << c.name;
                continue;
            }
            EXPECT_EQ(f64::length(wi - draw), 0) << c.name;
            EXPECT_EQ(pdf, density_at(c, p, wi)) << c.name;
        }
    }
}

// specular_sample takes the half vector that it has drawn, specular_pdf works it out from wi + wo.
// Not at the pole of the lobe, where the density of a deformation has no one value.
TEST(Surface, SpecularSampleAndDensityAgree) {
    for (const SurfaceCase& c : surface_cases()) {
        if (c.is_tabulated()) continue;
        for (int method = 0; method < kMethods; ++method) {
            if (!f64::brdf_takes_method(c.material.brdf, method)) continue;
            const f64::Perturbation p = perturbation_of(c, method, kTiltedBy30);
            for (int i = 0; i < 100; ++i) {
                double pdf = 0;
                const vec3 wi = f64::specular_sample(
                    c.material, p, kView, {(i + 0.5) / 100, std::fmod(0.618 * i + 0.3, 1.0)},
                    std::fmod(0.7549 * i + 0.2, 1.0), pdf);
                if (!(pdf > 0) || f64::dot(wi, kView) < -0.99) continue;
                EXPECT_NEAR(f64::specular_pdf(c.material, p, f64::no_lobe_values(), wi, kView), pdf,
                            1e-6 * pdf)
                    << named(c, method);
            }
        }
    }
}

TEST(Surface, TheTermsAddUp) {
    for (const SurfaceCase& c : surface_cases()) {
        const f64::Perturbation p = perturbation_of(c, f64::kMethodNone, kTiltedBy30);
        const vec3 wi = direction(0.7, 5.0);
        const f64::LobeValues v = looked_up(c, p, wi, kView);
        f64::SurfaceMaterial black = c.material;
        black.has_diffuse = false;
        const vec3 both = f64::surface_eval(c.material, p, v, wi, kView);
        const vec3 specular = f64::surface_eval(black, p, v, wi, kView);
        const double f = f64::specular_eval(c.material, p, v, wi, kView);
        const vec3 fresnel =
            f64::specular_fresnel(c.material, f64::dot(wi, f64::normalize(wi + kView)));
        EXPECT_NEAR(specular.x, fresnel.x * f, 1e-12 * specular.x) << c.name;
        const double diffuse = f64::diffuse_eval(c.material.brdf, 0.05, wi.z, kView.z);
        EXPECT_NEAR(both.z - specular.z,
                    c.material.has_diffuse ? c.material.diffuse.z * diffuse : 0, 1e-12)
            << c.name;
        EXPECT_GT(f, 0) << c.name;
        // Below a horizon there is nothing, whichever of the two it is.
        const vec3 below = direction(1.7, 5.0);
        for (const vec3 dark : {f64::surface_eval(c.material, p, v, below, kView),
                                f64::surface_eval(c.material, p, v, kView, below)}) {
            EXPECT_EQ(dark.x + dark.y + dark.z, 0) << c.name;
        }
    }
}

// A draw lies in the cell that it was drawn from, whose density is then its own.
TEST(Surface, TablesFindTheCellOfADraw) {
    constexpr int kRings = 12, kColumns = 40;
    for (const double groove : {0.0, 0.13, 0.9}) {
        for (int ring = 0; ring < kRings; ++ring) {
            for (int column = 0; column < kColumns; ++column) {
                for (const double part : {0.02, 0.5, 0.98}) {
                    f64::TableDraw draw;
                    draw.ring = ring;
                    draw.column = column;
                    draw.along = part;
                    draw.across = 1 - part;
                    const vec3 h = f64::tabulated_half_vector(draw, kColumns, kRings, groove);
                    EXPECT_NEAR(f64::length(h), 1, 1e-5);
                    const f64::TableDraw cell =
                        f64::tabulated_cell(f64::lobe_point_of(h), kColumns, kRings, groove);
                    EXPECT_EQ(cell.ring, ring);
                    EXPECT_EQ(cell.column, column);
                }
            }
        }
    }
}

// docs/theory/papers.md: deformations have nothing to act on where there are no half vectors; he knows one normal.
TEST(Surface, TheRuleOfModelsAndMethods) {
    for (int method = 0; method < kMethods; ++method) {
        const bool deforms = is_deformation(static_cast<Method>(method)) ||
                             method == f64::kMethodSlopeShift || method == f64::kMethodStretch;
        for (int brdf = 0; brdf <= f64::kBrdfHe; ++brdf) {
            const bool cosine =
                brdf == static_cast<int>(Brdf::phong) || brdf == static_cast<int>(Brdf::lafortune);
            const bool takes = brdf == f64::kBrdfHe ? method == 0 : !(cosine && deforms);
            EXPECT_EQ(f64::brdf_takes_method(brdf, method), takes) << brdf << " " << method;
            EXPECT_EQ(f64::brdf_is_cosine_lobe(brdf), cosine);
        }
    }
    // The numbers of names.glsl are those of the enumerations.
    EXPECT_EQ(f64::kBrdfLafortune, static_cast<int>(brdf_names().size()) - 1);
    EXPECT_EQ(f64::kMethodStretch, static_cast<int>(method_names().size()) - 1);
    EXPECT_EQ(f64::kMdfGgx, static_cast<int>(mdf_names().size()) - 1);
}

// A lobe widened after the material was made is the lobe of a material made with it.
TEST(Surface, AnotherLobeIsThatOfAnotherMaterial) {
    for (const SurfaceCase& c : surface_cases()) {
        if (c.material.brdf > f64::kBrdfLafortune) continue;
        const f64::Perturbation p = perturbation_of(c, f64::kMethodFollowGrain, kTiltedBy30);
        const f64::Lobe wide = f64::widen_lobe(c.material.lobe, 0.02, 0.05);
        const f64::SurfaceMaterial widened = f64::surface_with_lobe(c.material, wide);
        f64::SurfaceMaterial made = f64::surface_material(c.material.brdf, wide, c.material.ks,
                                                          c.material.c, c.material.dielectric_f0);
        made.specular = c.material.specular;
        const vec3 wi = direction(0.7, 5.5);
        const f64::LobeValues v = f64::no_lobe_values();
        EXPECT_EQ(f64::specular_eval(widened, p, v, wi, kView),
                  f64::specular_eval(made, p, v, wi, kView))
            << c.name;
        EXPECT_NE(f64::specular_eval(widened, p, v, wi, kView),
                  f64::specular_eval(c.material, p, v, wi, kView))
            << c.name;
    }
}

// Int f cos over wi of the diffuse term is diffuse_albedo.
TEST(Surface, DiffuseAlbedoIsTheIntegral) {
    for (const int brdf : {f64::kBrdfMicrofacet, f64::kBrdfAshikhminShirley, f64::kBrdfTabulated}) {
        for (const double f0 : {0.0, 0.04, 0.3}) {
            for (const double cos_o : {0.05, 0.4, 1.0}) {
                const double integral = integrate_cap(
                    [&](vec3 wi) {
                        return f64::diffuse_eval(brdf, f0, std::max(wi.z, 0.0), cos_o) *
                               std::max(wi.z, 0.0);
                    },
                    {0, 0, 1}, kPi / 2, 2000, 1);
                EXPECT_NEAR(integral, f64::diffuse_albedo(brdf, f0, cos_o), 1e-5) << brdf;
            }
        }
    }
}

// Under constant light a surface whose specular lobe keeps all that it reflects keeps no more than
// comes.
TEST(Surface, NoEnergyIsGained) {
    for (const SurfaceCase& c : surface_cases()) {
        // Their own papers' gains at grazing angles: docs/evidence/correctness.md; he's value is made up
        // here.
        const int brdf = c.material.brdf;
        if (brdf == f64::kBrdfWard || brdf == f64::kBrdfWardDuer || brdf == f64::kBrdfHe) continue;
        SurfaceCase white = c;
        white.material = f64::surface_colored(white.material, {1, 1, 1}, 0);
        if (c.is_tabulated()) continue;  // diffuse and specular of a table are fitted together
        const f64::Perturbation p = perturbation_of(c, f64::kMethodNone, kTiltedBy30);
        const double albedo = integrate_cap([&](vec3 wi) { return reflected_at(white, p, wi); },
                                            {0, 0, 1}, kPi / 2, 400, 400);
        EXPECT_LT(albedo, 1.0) << c.name;
        EXPECT_GT(albedo, 0.4) << c.name;
    }
}

// Woven cloth from afar is sampled as one wide lobe in the axes of its fibres.
TEST(Surface, ClothFollowsItsDensity) {
    const SurfaceCase c = surface_case("cloth", f64::kBrdfMicrofacet, f64::kMdfGgx, 0.3, 0.6, 0.1);
    const f64::vec2 twist{std::cos(0.6), std::sin(0.6)};
    double integral = 0, pdf = 0;
    const double p_value = sampler_p_value(
        [&](vec3 wi) { return f64::cloth_pdf(c.material, twist, wi, kView); },
        [&](double a, double b, double s) {
            const vec3 wi = f64::cloth_sample(c.material, twist, kView, {a, b}, s, pdf);
            if (!(pdf > 0)) return vec3{0, 0, 0};
            EXPECT_NEAR(pdf, f64::cloth_pdf(c.material, twist, wi, kView), 1e-9 * pdf);
            return wi;
        },
        Axes(f64::reflect_about(kView, {0, 0, 1})), 3, integral);
    EXPECT_GT(p_value, 1e-3);
    EXPECT_NEAR(integral, 1, 5e-3);
}

}  // namespace
}  // namespace burnish::test
