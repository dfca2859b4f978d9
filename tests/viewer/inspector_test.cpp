// The lobe inspector: its values against SurfacePoint, its rows against `brdf eval` and `mdf eval`, its
// shapes and albedos against integrals.
#include "viewer/inspect/inspector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "burnish/brdf_models.hpp"
#include "burnish/draft.hpp"
#include "burnish/surface.hpp"
#include "core/even_points.hpp"
#include "gpu/tabulated_scenes.hpp"
#include "jobs/models/eval.hpp"
#include "models/albedo.hpp"
#include "support/test_folder.hpp"
#include "viewer/viewer_scenes.hpp"

namespace burnish::viewer {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kMethods = 9, kBrdfs = 9, kMdfs = 4;

std::vector<Method> all_methods() {
    std::vector<Method> methods;
    for (int i = 0; i < kMethods; ++i) methods.push_back(static_cast<Method>(i));
    return methods;
}

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
    const auto methods = all_methods();
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
    EXPECT_NEAR(r.tilt_deg, std::acos(n.z) * 180 / kPi, 1e-4);
    EXPECT_NEAR(r.alpha.x, 0.4, 1e-7);
    EXPECT_NEAR(r.alpha.y, 0.1, 1e-7);
    EXPECT_NEAR(r.stretch_deg, 0.5 * 180 / kPi, 1e-5);
    EXPECT_NEAR(*r.grain_deg, 0.5 * 180 / kPi + 90, 1e-5);
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

// ---- shapes -------------------------------------------------------------------------------------

LobeReport shaped_report(Mdf mdf, glm::vec2 alpha, std::span<const Method> methods) {
    Material m;
    m.mdf = mdf;
    m.lobe = AlphaLobe{alpha};
    m.anisotropy_rotation = 0.3f;
    m.base_color = {0.9f, 0.7f, 0.5f, 1.0f};
    const Scene scene = test::tilted_plane(m, {0.25, -0.15, 1.0});
    return inspect(scene, test::hit_at(scene, 0, 0), glm::normalize(glm::dvec3(0.3, 0.2, 1)),
                   glm::normalize(glm::dvec3(-0.5, 0.1, 1)), methods);
}

// Int D (n~.h) dw = 1 for rotations, which is Int D (n~.h)/h_z over the disk.
TEST(InspectorShapes, TheDiskHoldsTheDistribution) {
    const Method methods[] = {Method::rotate_exact, Method::follow_grain, Method::gram_schmidt};
    for (const Mdf mdf : {Mdf::ashikhmin_shirley, Mdf::ward, Mdf::beckmann}) {
        const LobeReport report = shaped_report(mdf, {0.2f, 0.3f}, methods);
        for (const MethodReport& m : report.methods) {
            const int side = m.disk.D.width;
            double sum = 0, most = 0;
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    const double hx = 2 * (x + 0.5) / side - 1, hy = 1 - 2 * (y + 0.5) / side;
                    const double r2 = hx * hx + hy * hy;
                    const float D = *m.disk.D.at(x, y);
                    ASSERT_EQ(std::isnan(D), !(r2 < 1));
                    if (!(r2 < 1)) continue;
                    const glm::dvec3 h(hx, hy, std::sqrt(1 - r2));
                    most = std::max(most, static_cast<double>(D));
                    sum += static_cast<double>(D) * glm::dot(m.normal, h) / h.z * 4 / (side * side);
                }
            }
            // One texel holds the peak itself: 1/65^2 of the square times a few.
            EXPECT_NEAR(sum, 1, 0.02) << name_of(m.method);
            EXPECT_NEAR(m.disk.most, most, 1e-6 * most);
            EXPECT_TRUE(m.disk.origin.empty());
        }
    }
}

TEST(InspectorShapes, ANarrowLobeIsNotLostBetweenTexels) {
    const Method methods[] = {Method::follow_grain, Method::none, Method::normal_map};
    const LobeReport report = shaped_report(Mdf::ggx, {0.002f, 0.004f}, methods);
    for (const MethodReport& m : report.methods) {
        float most = 0;
        for (const float D : m.disk.D.pixels) most = std::max(most, std::isnan(D) ? 0.0f : D);
        // 1/(pi ax ay) = 40,000; of normal-map at the geometric normal, n~z^-4 more.
        EXPECT_GT(most, 30000.0f) << name_of(m.method);
        EXPECT_NEAR(m.disk.most, static_cast<double>(most), 1e-3 * m.disk.most);
        EXPECT_GT(m.mesh.most, 100.0) << name_of(m.method);
        EXPECT_GT(m.cuts.most, 100.0);
    }
}

TEST(InspectorShapes, TheMeshIsTheLobe) {
    const Method methods[] = {Method::follow_grain};
    const LobeReport report = shaped_report(Mdf::ggx, {0.2f, 0.3f}, methods);
    const MethodReport& m = report.methods[0];
    ASSERT_EQ(m.mesh.vertices.size(), 64u * 128u);
    double volume = 0;
    for (std::size_t i = 0; i < m.mesh.triangles.size(); i += 3) {
        const glm::dvec3 a(m.mesh.vertices[m.mesh.triangles[i]]);
        const glm::dvec3 b(m.mesh.vertices[m.mesh.triangles[i + 1]]);
        const glm::dvec3 c(m.mesh.vertices[m.mesh.triangles[i + 2]]);
        volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    // Int r^3/3 dw over the sphere of directions to the eye, by the midpoint rule.
    double wanted = 0;
    constexpr int kRows = 400, kColumns = 800;
    for (int i = 0; i < kRows; ++i) {
        for (int j = 0; j < kColumns; ++j) {
            const double z = (i + 0.5) / kRows, phi = 2 * kPi * j / kColumns;
            const double s = std::sqrt(1 - z * z);
            const glm::dvec3 f =
                m.lobe.eval_cos(report.to_light, {s * std::cos(phi), s * std::sin(phi), z});
            const double r = 0.2126 * f.x + 0.7152 * f.y + 0.0722 * f.z;
            wanted += r * r * r / 3 * 2 * kPi / (kRows * kColumns);
        }
    }
    // Flat triangles cut off up to 2 % of so pointed a shape.
    EXPECT_NEAR(volume, wanted, 0.03 * wanted);
    double most = 0;
    for (const glm::vec3& v : m.mesh.vertices)
        most = std::max(most, static_cast<double>(glm::length(v)));
    EXPECT_NEAR(m.mesh.most, most, 1e-5 * most);
}

TEST(InspectorShapes, CutsAreRadiiOfTheLobe) {
    const Method methods[] = {Method::follow_grain};
    const LobeReport report = shaped_report(Mdf::ggx, {0.1f, 0.3f}, methods);
    const MethodReport& m = report.methods[0];
    const glm::dvec3 n = m.normal;
    const glm::dvec3 beside = glm::normalize(report.to_light - n * glm::dot(n, report.to_light));
    double most = 0, angle_of_most = 0, last = -10;
    for (const PolarPoint& p : m.cuts.incidence) {
        ASSERT_GE(p.angle_rad, last);
        last = p.angle_rad;
        const glm::dvec3 d = n * std::cos(p.angle_rad) - beside * std::sin(p.angle_rad);
        const glm::dvec3 f = m.lobe.eval_cos(report.to_light, d);
        EXPECT_NEAR(p.radius, 0.2126 * f.x + 0.7152 * f.y + 0.0722 * f.z, 1e-4 * (p.radius + 1e-6));
        if (p.radius > most) {
            most = p.radius;
            angle_of_most = p.angle_rad;
        }
    }
    EXPECT_NEAR(m.cuts.light_angle_rad, -std::acos(glm::dot(n, report.to_light)), 1e-12);
    // The light is mirrored about n~; off-specular shift moves the peak outwards by less than a width.
    EXPECT_NEAR(angle_of_most, -m.cuts.light_angle_rad, 0.1);
    double across = 0;
    for (const PolarPoint& p : m.cuts.across) across = std::max(across, p.radius);
    EXPECT_NEAR(m.cuts.most, std::max(most, across), 1e-12);
}

// ---- albedo -------------------------------------------------------------------------------------

TEST(InspectorAlbedo, IsThatOfTheModelByQuadrature) {
    for (const double elevation : {80.0, 45.0, 20.0}) {
        Material m;
        m.lobe = AlphaLobe{{0.3f, 0.5f}};
        m.base_color = glm::vec4(1.0f);
        const Scene scene = test::one_object(test::unit_plane(), m);
        const double e = elevation * kPi / 180;
        const glm::dvec3 eye(std::cos(e), 0, std::sin(e));
        const PointLobe lobe(surface_at(scene, test::hit_at(scene, 0, 0), eye), Method::none);
        const LobeAlbedo albedo = lobe_albedo(lobe, eye);
        const double p[] = {double{0.3f}, double{0.5f}, 1.0, 0.0, 0.0};
        const double wanted = directional_albedo(microfacet_model(Mdf::ggx, Smith::correlated), p,
                                                 {eye.x, eye.y, eye.z});
        EXPECT_NEAR(albedo.specular.x, wanted, 0.003) << elevation;
        EXPECT_LT(albedo.error, 0.005);
        EXPECT_NEAR(albedo.whole.x, wanted, 3 * albedo.error + 0.002);
        EXPECT_FALSE(albedo.gains_energy);
    }
}

TEST(InspectorAlbedo, HoldsTheDiffuseTermAndFindsGains) {
    Material m;
    m.metallic = 0.0f;
    m.base_color = {0.5f, 0.25f, 1.0f, 1.0f};
    m.lobe = AlphaLobe{{0.6f, 0.6f}};
    const Scene scene = test::one_object(test::unit_plane(), m);
    const glm::dvec3 eye = glm::normalize(glm::dvec3(0.5, 0, 1));
    const Hit hit = test::hit_at(scene, 0, 0);
    const PointLobe lobe(surface_at(scene, hit, eye), Method::none);
    const LobeAlbedo albedo = lobe_albedo(lobe, eye);
    for (int c = 0; c < 3; ++c) {
        const double diffuse = m.base_color[c] * f64::diffuse_albedo(0, 0.04, eye.z);
        EXPECT_NEAR(albedo.whole[c], albedo.specular[c] + diffuse, 4 * albedo.error + 0.002);
    }
    EXPECT_FALSE(albedo.gains_energy);
    // Phong with ten times the scale that conserves its energy.
    m.brdf = Brdf::phong;
    m.metallic = 1.0f;
    m.ks = 10.0f;
    const Scene bright = test::one_object(test::unit_plane(), m);
    EXPECT_TRUE(
        lobe_albedo(PointLobe(surface_at(bright, hit, eye), Method::none), eye).gains_energy);
}

// ---- measured materials -------------------------------------------------------------------------

// One texel; ring 3 and beyond are not measured.
std::shared_ptr<const TabulatedMaterial> measured_material(float angle) {
    TabulatedMaterial t = test::blank_material({24, 80}, 2, 1);
    test::add_exemplar(t, test::ggx_table(t.grid, 0.4, 0.4), 0.2f);
    test::add_exemplar(t, test::ggx_table(t.grid, 0.2, 0.5, 0.7), 0.7f);
    for (std::size_t i = 80 * 24; i < t.origin.size(); ++i) {
        const std::size_t ring = (i - 80 * 24) / 80;
        if (ring >= 10) t.origin[i] = NdfOrigin::completed;
        if (ring >= 20) t.origin[i] = NdfOrigin::extrapolated;
    }
    t.eta = 1.5;
    t.exemplar = {TabulatedMaterial::kNoExemplar, 1};
    t.angle = {0.0f, angle};
    t.diffuse.pixels = {0, 0, 0, 0.25f, 0.125f, 0.5f};
    t.specular.pixels = {0, 0, 0, 0.5f, 0.25f, 0.75f};
    return std::make_shared<const TabulatedMaterial>(t);
}

TEST(InspectorTables, SayWhatASecondDerivationSays) {
    const auto table = measured_material(0.3f);
    const test::ReferenceTable reference(table->grid, table->table(1));
    Material m;
    m.lobe = Tabulated{table, {}};
    const Scene scene = test::one_object(test::unit_plane(), m);
    const Hit hit = test::hit_at(scene, 0.5, 0.1);  // the second texel
    std::mt19937 random(15);
    const auto methods = all_methods();
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 eye = test::random_direction(random, 0.3);
        const glm::dvec3 light = test::random_direction(random, 0.3);
        const LobeReport report = inspect(scene, hit, eye, light, methods, Shapes::none);
        for (const MethodReport& method : report.methods) {
            const double wanted =
                test::reflected_by_texel(*table, reference, 1, static_cast<int>(method.method),
                                         f64::vec3(light), f64::vec3(eye));
            // Areas are stored on 16 x 32 nodes: 0.003 (ndf_grid.hpp), times 1/g of both directions.
            EXPECT_NEAR(method.f_cos.y, wanted, 0.02 * wanted) << name_of(method.method);
            EXPECT_FALSE(csv_rows(report, method).has_value());
            EXPECT_FALSE(mdf_csv_row(report, method).has_value());
        }
        EXPECT_NEAR(*report.grain_deg, (0.3 + 0.7) * 180 / kPi, 1e-4);
        EXPECT_EQ(report.alpha, glm::dvec2(0.0));
    }
}

TEST(InspectorTables, MarkTheMeasuredCells) {
    const auto table = measured_material(0.3f);
    Material m;
    m.lobe = Tabulated{table, {}};
    const Scene scene = test::one_object(test::unit_plane(), m);
    const Method methods[] = {Method::follow_grain};
    const LobeReport report =
        inspect(scene, test::hit_at(scene, 0.5, 0.1), {0, 0, 1}, {0, 0, 1}, methods);
    const ExemplarAt& at = report.surface.exemplar.value();
    EXPECT_EQ(at.exemplar, 1);
    EXPECT_EQ(at.texel, glm::ivec2(1, 0));
    EXPECT_EQ(at.table().data(), table->table(1));
    // Rings end at u = sqrt(2 theta/pi) = r/24.
    const auto cap = [](double u) { return 1 - std::cos(kPi / 2 * u * u); };
    EXPECT_NEAR(at.measured, cap(10.0 / 24), 1e-6);
    EXPECT_NEAR(at.completed, cap(20.0 / 24) - cap(10.0 / 24), 1e-6);
    EXPECT_NEAR(at.extrapolated, 1 - cap(20.0 / 24), 1e-6);
    const LobeDisk& disk = report.methods[0].disk;
    const int side = disk.D.width;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double hx = 2 * (x + 0.5) / side - 1, hy = 1 - 2 * (y + 0.5) / side;
            const double r2 = hx * hx + hy * hy;
            const auto& origin = disk.origin[static_cast<std::size_t>(y * side + x)];
            ASSERT_EQ(origin.has_value(), r2 < 1);
            if (!origin) continue;
            const double u = std::sqrt(2 / kPi * std::asin(std::sqrt(r2)));
            ASSERT_EQ(*origin, u < 10.0 / 24   ? NdfOrigin::measured
                               : u < 20.0 / 24 ? NdfOrigin::completed
                                               : NdfOrigin::extrapolated);
        }
    }
}

TEST(InspectorTables, ATexelWithoutMeasurementReflectsNothing) {
    Material m;
    m.lobe = Tabulated{measured_material(0.3f), {}};
    const Scene scene = test::one_object(test::unit_plane(), m);
    const auto methods = all_methods();
    const LobeReport report =
        inspect(scene, test::hit_at(scene, -0.5, 0.1), {0, 0, 1}, {0, 0, 1}, methods);
    EXPECT_EQ(report.surface.exemplar->exemplar, -1);
    EXPECT_FALSE(report.surface.reflects());
    for (const MethodReport& method : report.methods) {
        EXPECT_EQ(method.f, glm::dvec3(0.0));
        EXPECT_EQ(method.D, 0.0);
    }
}

// The mean over draws against the mean over a grid of directions.
TEST(InspectorTables, DrawsAreThoseOfTheirDensity) {
    Material m;
    m.lobe = Tabulated{measured_material(0.3f), {}};
    m.normal_texture.texture = 0;
    Scene scene = test::one_object(test::unit_plane(), m);
    scene.textures.push_back(test::normal_texel({0.3, 0.2, 1.0}));
    const glm::dvec3 eye = glm::normalize(glm::dvec3(0.3, -0.2, 1.0));
    const Hit hit = test::hit_at(scene, 0.5, 0.1);
    for (const Method method :
         {Method::follow_grain, Method::normal_map, Method::rotate_approx, Method::deform_linear}) {
        const PointLobe lobe(surface_at(scene, hit, eye), method);
        glm::dvec3 sum(0.0), specular(0.0);
        double mass = 0;
        constexpr int kRows = 300, kColumns = 600;
        const glm::dvec3 n = lobe.normal(eye);
        for (int i = 0; i < 2 * kRows; ++i) {
            for (int j = 0; j < kColumns; ++j) {
                const double z = (i + 0.5) / kRows - 1, phi = 2 * kPi * j / kColumns;
                const double s = std::sqrt(1 - z * z);
                const glm::dvec3 w(s * std::cos(phi), s * std::sin(phi), z);
                const double cell = 2 * kPi / (kRows * kColumns);
                sum += lobe.eval_cos(w, eye) * cell;
                specular += lobe.specular(w, eye) * (std::max(glm::dot(n, w), 0.0) * cell);
                mass += lobe.pdf(w, eye) * cell;
            }
        }
        const LobeAlbedo albedo = lobe_albedo(lobe, eye, 1 << 15);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(albedo.whole[c], sum[c], 4 * albedo.error + 0.003) << name_of(method);
            EXPECT_NEAR(albedo.specular[c], specular[c], 4 * albedo.error + 0.003);
        }
        // The integral of the density is the share of draws that are kept.
        int kept = 0;
        constexpr int kDraws = 1 << 15;
        for (int k = 0; k < kDraws; ++k)
            kept += lobe.sample(eye, even_point(k), PointLobe::Terms::all).has_value() ? 1 : 0;
        EXPECT_NEAR(mass, static_cast<double>(kept) / kDraws, 0.005) << name_of(method);
    }
}

// ---- cloth --------------------------------------------------------------------------------------

TEST(InspectorCloth, IsTheYarnAtThePlace) {
    Material m;
    Cloth cloth;
    cloth.draft = std::make_shared<Draft>(builtin_draft("plain"));
    cloth.yarns = 4.0f;
    cloth.gap = 0.2f;
    cloth.warp_color = glm::vec3(0.6f, 0.5f, 0.3f);
    cloth.weft_color = glm::vec3(0.05f, 0.1f, 0.3f);
    m.lobe = cloth;
    const Scene scene = test::one_object(test::unit_plane(), m);
    const Method methods[] = {Method::follow_grain};
    // Four yarns over [-1, 1]: the middle of cell (i, j) is at -3/4 + i/2.
    for (int end = 0; end < 4; ++end) {
        for (int pick = 0; pick < 4; ++pick) {
            const LobeReport r =
                inspect(scene, test::hit_at(scene, -0.75 + 0.5 * end, -0.75 + 0.5 * pick),
                        {0, 0, 1}, {0, 0, 1}, methods, Shapes::none);
            const YarnAt& yarn = r.surface.yarn.value();
            EXPECT_EQ(yarn.end, end % 2);
            EXPECT_EQ(yarn.pick, pick % 2);
            EXPECT_EQ(yarn.warp, cloth.draft->is_warp_up(end % 2, pick % 2));
            EXPECT_TRUE(yarn.covered);
            const glm::dvec3 color(yarn.warp ? *cloth.warp_color : *cloth.weft_color);
            EXPECT_LT(glm::distance(r.surface.base_color, color), 1e-6);
            // The top of a yarn is level.
            EXPECT_LT(r.tilt, 1e-4);
            const double fiber = 20.0 + (yarn.warp ? 90.0 : 0.0);
            EXPECT_NEAR(r.stretch_deg, fiber, 1e-3);
            EXPECT_GT(r.alpha.x, 0.2);  // widened by the fuzz
        }
    }
    // Where four cells meet, both yarns have gaps.
    const LobeReport hole =
        inspect(scene, test::hit_at(scene, 0.001, 0.001), {0, 0, 1}, {0, 0, 1}, methods);
    EXPECT_FALSE(hole.surface.yarn->covered);
    EXPECT_EQ(hole.methods[0].f, glm::dvec3(0.0));
}

}  // namespace
}  // namespace burnish::viewer
