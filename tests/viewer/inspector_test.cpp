// The lobe inspector: its values against SurfacePoint, its rows against `brdf eval` and `mdf eval`.
#include "viewer/inspect/inspector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "burnish/surface.hpp"
#include "jobs/models/eval.hpp"
#include "support/test_folder.hpp"
#include "viewer/viewer_scenes.hpp"

namespace burnish::viewer {
namespace {

constexpr int kBrdfs = 9, kMdfs = 4;

Material random_material(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    Material m;
    m.base_color = {unit(random), unit(random), unit(random), 1.0f};
    m.metallic = unit(random) < 0.3f ? 1.0f : unit(random);
    m.dielectric_f0 = 0.1f * unit(random);
    m.mdf = static_cast<Mdf>(random() % kMdfs);
    m.brdf = static_cast<Brdf>(random() % kBrdfs);
    if (unit(random) < 0.5f) {
        m.lobe = AlphaLobe{{0.1f + 0.6f * unit(random), 0.1f + 0.6f * unit(random)}};
    } else {
        m.lobe = GltfLobe{0.3f + 0.6f * unit(random), unit(random)};
    }
    m.anisotropy_rotation = 6.0f * unit(random);
    m.lafortune_c = {-0.5f - unit(random), -0.5f - unit(random), 0.5f + unit(random)};
    m.conserve = unit(random) < 0.5f;
    if (unit(random) < 0.3f) m.conductor = Conductor{{0.2f, 0.9f, 1.5f}, {3.5f, 2.4f, 1.9f}};
    return m;
}

struct Case {
    Material material;
    LobeReport report;
};

// A material on a plane whose map holds a tilt of up to 45 degrees, under every method.
Case random_case(std::mt19937& random) {
    Case c;
    c.material = random_material(random);
    const Scene scene = test::tilted_plane(c.material, test::random_direction(random, 0.7));
    const glm::dvec3 eye = test::random_direction(random), light = test::random_direction(random);
    const auto methods = test::all_methods();
    c.report = inspect(scene, test::hit_at(scene, 0.3, -0.4), eye, light, methods, Shapes::none);
    return c;
}

// Relative to the larger of both, where that is not tiny beside the values that a picture shows.
void expect_close(glm::dvec3 a, glm::dvec3 b, double bound, const std::string& what) {
    for (int i = 0; i < 3; ++i)
        EXPECT_LE(std::abs(a[i] - b[i]), bound * std::max(std::abs(b[i]), 1e-12)) << what;
}

TEST(Inspector, SaysWhatSurfacePointSays) {
    std::mt19937 random(11);
    for (int i = 0; i < 300; ++i) {
        const Case c = random_case(random);
        for (const MethodReport& m : c.report.methods) {
            Material material = c.material;
            material.method = m.method;
            const std::string what =
                std::string(name_of(material.brdf)) + " under " + std::string(name_of(m.method));
            if (!m.lobe.has_meaning()) {
                EXPECT_THROW(SurfacePoint(material, c.report.normal), UsageError) << what;
                EXPECT_EQ(m.f, glm::dvec3(0.0));
                continue;
            }
            const SurfacePoint point(material, c.report.normal);
            // The axes of the plane are exact but for a rounding.
            expect_close(m.f, point.eval(c.report.to_light, c.report.to_eye), 1e-9, what);
            const double pdf = point.pdf(c.report.to_light, c.report.to_eye);
            EXPECT_NEAR(m.pdf, pdf, 1e-9 * pdf) << what;
        }
    }
}

// The factors multiply to the specular term where the model is one of half vectors.
TEST(Inspector, FactorsMultiplyToTheSpecularTerm) {
    std::mt19937 random(12);
    for (int i = 0; i < 200; ++i) {
        const Case c = random_case(random);
        for (const MethodReport& m : c.report.methods) {
            if (!m.lobe.has_meaning() || !m.lobe.has_half_vectors()) continue;
            const double cosines =
                glm::dot(m.normal, c.report.to_light) * glm::dot(m.normal, c.report.to_eye);
            // Below 1e-3 the denominators are guarded.
            if (!(cosines > 1e-3) || !(m.D > 0)) continue;
            expect_close(m.F * (m.D * m.G / (4 * cosines)), m.f_specular, 1e-9,
                         std::string(name_of(c.material.brdf)));
            expect_close(m.f_cos, m.f * glm::dot(m.normal, c.report.to_light), 1e-12, "cosine");
        }
    }
}

TEST(Inspector, StatesTheNormalTheAlphasAndTheGrain) {
    Material m;
    m.lobe = AlphaLobe{{0.4f, 0.1f}};
    m.anisotropy_rotation = 0.5f;
    const glm::dvec3 n = glm::normalize(glm::dvec3(0.3, -0.4, 1.2));
    const Scene scene = test::tilted_plane(m, n);
    const Method methods[] = {Method::follow_grain};
    const LobeReport r =
        inspect(scene, test::hit_at(scene, 0, 0), {0, 0, 1}, {0, 0.6, 0.8}, methods, Shapes::none);
    EXPECT_LT(glm::distance(r.normal, n), 1e-6);
    EXPECT_LT(glm::distance(r.normal_world, n), 1e-6);
    EXPECT_NEAR(r.tilt, std::hypot(n.x, n.y), 1e-6);
    EXPECT_NEAR(r.tilt_deg, std::acos(n.z) * 180 / std::numbers::pi, 1e-4);
    EXPECT_NEAR(r.alpha.x, 0.4, 1e-7);
    EXPECT_NEAR(r.alpha.y, 0.1, 1e-7);
    EXPECT_NEAR(r.stretch_deg, 0.5 * 180 / std::numbers::pi, 1e-5);
    EXPECT_NEAR(*r.grain_deg, 0.5 * 180 / std::numbers::pi + 90, 1e-5);
    Material round = m;
    round.lobe = AlphaLobe{{0.2f, 0.2f}};
    const Scene other = test::tilted_plane(round, n);
    EXPECT_FALSE(inspect(other, test::hit_at(other, 0, 0), {0, 0, 1}, {0, 0, 1}, methods)
                     .grain_deg.has_value());
}

TEST(Inspector, RefusesAHitOfAnotherScene) {
    Hit hit;
    hit.material = 3;
    const Method methods[] = {Method::none};
    const std::string line = test::error_line([&] {
        inspect(Scene{}, hit, {0, 0, 1}, {0, 0, 1}, methods);
    });
    EXPECT_NE(line.find("material"), std::string::npos);
}

// ---- rows of tables -----------------------------------------------------------------------------

// The last columns of the rows that a job writes.
std::vector<std::vector<double>> evaluated(const std::string& table, std::size_t columns,
                                           void (*job)(const EvalRequest&, const Progress&)) {
    const test::ScratchFolder folder;
    EvalRequest request;
    request.input = folder.write("in.csv", table);
    request.output = folder / "out.csv";
    job(request, {});
    std::ifstream in(request.output);
    std::vector<std::vector<double>> values;
    std::string line;
    std::getline(in, line);  // names
    while (std::getline(in, line)) {
        std::vector<std::string> fields;
        std::istringstream text(line);
        for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
        std::vector<double> last;
        for (std::size_t i = fields.size() - columns; i < fields.size(); ++i)
            last.push_back(std::stod(fields[i]));
        values.push_back(last);
    }
    return values;
}

TEST(InspectorRows, OfBrdfEvalGiveTheSpecularTerm) {
    std::mt19937 random(13);
    std::string table = csv_header() + "\n";
    std::vector<double> wanted;
    int by_model[kBrdfs] = {};
    for (int i = 0; i < 300; ++i) {
        const Case c = random_case(random);
        for (const MethodReport& m : c.report.methods) {
            const auto rows = csv_rows(c.report, m);
            if (!rows) continue;
            ++by_model[static_cast<int>(c.material.brdf)];
            table += *rows;
            for (int channel = 0; channel < 3; ++channel) wanted.push_back(m.f_specular[channel]);
        }
    }
    for (int brdf = 0; brdf < kBrdfs; ++brdf) {
        // Cook and Torrance's row has one m; these materials have two alphas.
        if (static_cast<Brdf>(brdf) == Brdf::cook_torrance) continue;
        EXPECT_GT(by_model[brdf], 30) << name_of(static_cast<Brdf>(brdf));
    }
    const auto values = evaluated(table, 2, eval_brdf_table);
    ASSERT_EQ(values.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_EQ(values[i][0], wanted[i]);
        // 1e-9 absolute: below any picture. Rotations and F0 round in the 15th digit, which narrow
        // lobes at grazing angles make the 9th.
        EXPECT_NEAR(values[i][1], wanted[i], 1e-7 * wanted[i] + 1e-9) << i;
    }
}

TEST(InspectorRows, OfCookTorranceNeedOneAlpha) {
    Material m;
    m.brdf = Brdf::cook_torrance;
    m.lobe = AlphaLobe{{0.3f, 0.3f}};
    const Scene scene = test::tilted_plane(m, {0.2, 0.1, 1.0});
    const Method methods[] = {Method::follow_grain};
    const LobeReport report =
        inspect(scene, test::hit_at(scene, 0, 0), glm::normalize(glm::dvec3(0.4, 0, 1)),
                glm::normalize(glm::dvec3(0.1, 0.3, 1)), methods, Shapes::none);
    const auto rows = csv_rows(report, report.methods[0]);
    ASSERT_TRUE(rows.has_value());
    const auto values = evaluated(csv_header() + "\n" + *rows, 1, eval_brdf_table);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(values[static_cast<std::size_t>(c)][0], report.methods[0].f_specular[c], 1e-9);
}

TEST(InspectorRows, OfMdfEvalGiveDUnderEveryMethod) {
    std::mt19937 random(14);
    std::string table = mdf_csv_header() + "\n";
    std::vector<std::pair<double, bool>> wanted;  // D, of the conserving deformation
    for (int i = 0; i < 100; ++i) {
        const Case c = random_case(random);
        for (const MethodReport& m : c.report.methods) {
            const auto row = mdf_csv_row(c.report, m);
            EXPECT_EQ(row.has_value(), has_half_vectors(c.material.brdf));
            if (!row) continue;
            table += *row;
            wanted.emplace_back(m.D, c.material.conserve);
        }
    }
    ASSERT_GT(wanted.size(), 500u);
    const auto values = evaluated(table, 4, eval_mdf_table);  // the row's own D, then three
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_EQ(values[i][0], wanted[i].first);
        EXPECT_NEAR(values[i][wanted[i].second ? 3 : 2], wanted[i].first,
                    1e-7 * wanted[i].first + 1e-9);
    }
}

}  // namespace
}  // namespace burnish::viewer
