// The table of a measured material as a map over half vectors.
#include "viewer/inspect/table_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <random>
#include <set>
#include <utility>

#include "burnish/ndf_grid.hpp"
#include "core/constants.hpp"
#include "gpu/tabulated_scenes.hpp"
#include "viewer/inspect/inspector.hpp"
#include "viewer/viewer_scenes.hpp"

namespace burnish::viewer {
namespace {

constexpr int kRings = 12, kColumns = 40;

// Every cell has a value and an origin of its own.
std::shared_ptr<const TabulatedMaterial> numbered_material(float angle) {
    TabulatedMaterial t = test::blank_material({kRings, kColumns}, 1, 1);
    std::vector<float> table(static_cast<std::size_t>(kRings * kColumns));
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = 1.0f + static_cast<float>(i);
    test::add_exemplar(t, table, 0.4f);
    for (std::size_t i = 0; i < t.origin.size(); ++i) t.origin[i] = static_cast<NdfOrigin>(i % 3);
    t.angle = {angle};
    return std::make_shared<const TabulatedMaterial>(t);
}

LobeReport report_of(float angle, float rotation, Method method, glm::dvec3 eye, glm::dvec3 light) {
    Material m;
    m.lobe = Tabulated{numbered_material(angle), {}};
    m.anisotropy_rotation = rotation;
    const Scene scene = test::one_object(test::unit_plane(), m);
    const Method methods[] = {method};
    return inspect(scene, test::hit_at(scene, 0.1, 0.1), eye, light, methods, Shapes::none);
}

TEST(TableMap, EveryCellIsThereWithItsValue) {
    const LobeReport report = report_of(0.3f, 0.2f, Method::none, {0, 0, 1}, {0, 0, 1});
    std::set<std::pair<int, int>> seen;
    for (int ring = 0; ring < kRings; ++ring)
        for (int column = 0; column < kColumns; ++column) {
            // The center of the cell: rings are equal steps of the radius.
            const double u = (ring + 0.5) / kRings, phi = kTwoPi * column / kColumns + 0.5;
            const auto cell = table_cell(report.surface, {u * std::cos(phi), u * std::sin(phi)});
            ASSERT_TRUE(cell.has_value());
            const int i = ring * kColumns + column;
            EXPECT_EQ(cell->ring, ring);
            EXPECT_EQ(cell->column, column);
            EXPECT_EQ(cell->D, 1.0 + i);
            EXPECT_EQ(cell->origin, static_cast<NdfOrigin>(i % 3));
            // Angles of the grid and of the texel are floats.
            EXPECT_NEAR(cell->theta_deg, 90 * u * u, 1e-5);
            EXPECT_NEAR(std::remainder(cell->azimuth_deg - phi * kDegreesPerRadian, 360), 0, 1e-4);
            seen.insert({cell->ring, cell->column});
        }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(kRings * kColumns));
    EXPECT_FALSE(table_cell(report.surface, {0.8, 0.61}).has_value());
    EXPECT_FALSE(table_cell(report.surface, {std::nan(""), 0.0}).has_value());
}

// The map of half vectors is the way that reflection takes: through the lobe, without the map.
TEST(TableMap, HalfVectorsLieInTheCellsThatTheLobeReads) {
    std::mt19937 random(31);
    for (const Method method : {Method::none, Method::follow_grain, Method::gram_schmidt}) {
        int differ = 0;
        for (int i = 0; i < 300; ++i) {
            const glm::dvec3 h = test::random_direction(random, 0.02);
            const LobeReport report = report_of(0.3f, 0.2f, method, {0, 0, 1}, {0, 0, 1});
            const PointLobe& lobe = report.methods.front().lobe;
            const auto place = table_place(lobe, h, {0, 0, 1});
            ASSERT_TRUE(place.has_value());
            // Unperturbed, the table lies as the surface does.
            EXPECT_NEAR(
                std::remainder(std::atan2(place->y, place->x) - std::atan2(h.y, h.x), kTwoPi), 0,
                1e-6);
            EXPECT_NEAR(glm::length(*place), std::sqrt(2 * std::acos(h.z) / kPi), 1e-6);
            const auto cell = table_cell(report.surface, *place);
            ASSERT_TRUE(cell.has_value());
            if (cell->origin != lobe.origin(h, {0, 0, 1})) ++differ;
        }
        // Half vectors on the line between two cells.
        EXPECT_LE(differ, 1) << name_of(method);
    }
}

TEST(TableMap, ThePictureHasACellAtEachPixelOfTheDisk) {
    const LobeReport report = report_of(0.0f, 0.0f, Method::none, {0, 0, 1}, {0, 0, 1});
    constexpr int kSide = 101;
    const TableMap map = table_map(report.surface, kSide);
    EXPECT_EQ(map.most, static_cast<double>(kRings * kColumns));
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double px = 2 * (x + 0.5) / kSide - 1, py = 1 - 2 * (y + 0.5) / kSide;
            const float D = *map.D.at(x, y);
            const auto& origin = map.origin[static_cast<std::size_t>(y * kSide + x)];
            ASSERT_EQ(std::isfinite(D), px * px + py * py < 1);
            ASSERT_EQ(origin.has_value(), std::isfinite(D));
            if (!origin) continue;
            ASSERT_EQ(static_cast<double>(D), table_cell(report.surface, {px, py})->D);
        }
    // The first column of the table runs along the tangent, to the right.
    EXPECT_EQ(*map.D.at(kSide - 2, kSide / 2), 1.0f + (kRings - 1) * kColumns);
}

TEST(TableMap, APointWithoutATableHasNone) {
    const Scene scene = test::one_object(test::unit_plane(), Material{});
    const Method methods[] = {Method::none};
    const LobeReport report =
        inspect(scene, test::hit_at(scene, 0, 0), {0, 0, 1}, {0, 0, 1}, methods, Shapes::none);
    EXPECT_FALSE(table_cell(report.surface, {0, 0}).has_value());
    EXPECT_TRUE(table_map(report.surface, 9).origin.empty());
    EXPECT_FALSE(table_place(report.methods[0].lobe, {0, 0, 1}, {0, 0, 1}).has_value());
}

// Told without color: no line, lines one way, lines both ways.
TEST(TableMap, LinesTellHowACellIsKnown) {
    constexpr int kPeriod = 6;
    const auto share = [](NdfOrigin origin) {
        int on = 0;
        for (int y = -60; y < 60; ++y)
            for (int x = -60; x < 60; ++x) on += is_hatched(origin, x, y, kPeriod) ? 1 : 0;
        return on / (120.0 * 120.0);
    };
    EXPECT_EQ(share(NdfOrigin::measured), 0.0);
    EXPECT_NEAR(share(NdfOrigin::completed), 1.0 / 6, 1e-12);
    // Two families of lines, which meet in every third pixel of a line: x + y and x - y are both whole
    // periods, and both even or both odd.
    EXPECT_NEAR(share(NdfOrigin::extrapolated), 2.0 / 6 - 1.0 / 18, 1e-12);
}

// --- the grain that a method tilts ---------------------------------------------------------------

double folded(double degrees) {
    return std::abs(std::remainder(degrees, 180.0));
}

TEST(InspectorGrain, FollowsTheSurfaceUnderFollowGrainAndIsRotatedByTheOthers) {
    Material m;
    m.anisotropy_rotation = 0.5f;
    m.lobe = AlphaLobe{{0.1f, 0.4f}};  // grooves along the lobe's x axis
    const glm::dvec3 n = glm::normalize(glm::dvec3(0.4, -0.3, 0.8));
    const Scene scene = test::tilted_plane(m, n);
    const auto methods = test::all_methods();
    const LobeReport report =
        inspect(scene, test::hit_at(scene, 0.1, 0.1), {0, 0, 1}, {0, 0, 1}, methods, Shapes::none);
    const double stated = 0.5 * kDegreesPerRadian;
    ASSERT_TRUE(report.grain_deg.has_value());
    EXPECT_NEAR(*report.grain_deg, stated, 1e-4);
    for (const MethodReport& method : report.methods) {
        ASSERT_TRUE(method.grain_deg.has_value()) << name_of(method.method);
        EXPECT_GE(*method.grain_deg, 0.0);
        EXPECT_LT(*method.grain_deg, 180.0);
        // Follow-grain keeps the groove where it is, seen from above; without a perturbation it stays too.
        if (method.method == Method::follow_grain || method.method == Method::none) {
            EXPECT_NEAR(folded(*method.grain_deg - stated), 0, 1e-3) << name_of(method.method);
        }
    }
    // The tangent of Gram-Schmidt: x less its part along n~.
    const f64::vec3 t(std::cos(0.5), std::sin(0.5), 0);
    const f64::vec3 across = f64::vec3(report.normal);
    const f64::vec3 kept = t - across * f64::dot(t, across);
    const double kept_deg = std::atan2(kept.y, kept.x) * kDegreesPerRadian;
    const auto& rotated = report.methods[static_cast<std::size_t>(Method::gram_schmidt)];
    EXPECT_NEAR(folded(*rotated.grain_deg - kept_deg), 0, 1e-3);
    EXPECT_GT(folded(kept_deg - stated), 1.0) << "another direction than that of follow-grain";
    m.lobe = AlphaLobe{{0.2f, 0.2f}};
    const Scene isotropic = test::tilted_plane(m, n);
    const LobeReport round = inspect(isotropic, test::hit_at(isotropic, 0.1, 0.1), {0, 0, 1},
                                     {0, 0, 1}, methods, Shapes::none);
    for (const MethodReport& method : round.methods) EXPECT_FALSE(method.grain_deg.has_value());
}

}  // namespace
}  // namespace burnish::viewer
