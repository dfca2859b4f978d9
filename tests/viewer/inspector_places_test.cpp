// The lobe inspector where reflection depends on the place: measured materials and cloth.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "burnish/draft.hpp"
#include "core/constants.hpp"
#include "core/even_points.hpp"
#include "gpu/tabulated_scenes.hpp"
#include "viewer/inspect/inspector.hpp"
#include "viewer/viewer_scenes.hpp"

namespace burnish::viewer {
namespace {

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
    const auto methods = test::all_methods();
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
    const auto methods = test::all_methods();
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
