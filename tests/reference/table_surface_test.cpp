// Measured materials: reflection by a second derivation of the tables, and draws by their density.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "gpu/tabulated_scenes.hpp"
#include "reference/chi_square.hpp"
#include "reference/material_reader.hpp"
#include "reference/surfaces.hpp"

namespace burnish {
namespace {

constexpr NdfGrid kGrid{24, 48};

// One texel with a tilt, a turn, a color and Fresnel.
TabulatedMaterial one_texel() {
    TabulatedMaterial m = test::blank_material(kGrid, 1, 1);
    test::add_exemplar(m, test::ggx_table(kGrid, 0.25, 0.5, 0.3), 0.3f);
    m.eta = 1.5;
    m.angle[0] = 0.7f;
    m.diffuse = Image(1, 1, 3, 0.2f);
    m.specular = Image(1, 1, 3, 0.6f);
    const glm::vec3 n = glm::normalize(glm::vec3(0.2f, -0.15f, 1.0f));
    m.normal.pixels = {n.x, n.y, n.z};
    return m;
}

class TableSurface : public testing::TestWithParam<Method> {
  protected:
    TableSurface() {
        described.method = GetParam();
        described.lobe = Tabulated{std::make_shared<const TabulatedMaterial>(one_texel()), ""};
        PyramidStore pyramids({});
        reader = std::make_unique<MaterialReader>(drawn_material(described), pyramids);
    }
    PointSurface seen_from(const glm::vec3& eye) const {
        SurfaceHit hit;
        hit.to_eye = glm::normalize(eye);
        return reader->at(hit, {0.3f, 0.6f});
    }
    Material described;
    std::unique_ptr<MaterialReader> reader;
};

TEST_P(TableSurface, ReflectsAsASecondDerivationDoes) {
    const TabulatedMaterial material = one_texel();
    const test::ReferenceTable table(kGrid, material.table(0));
    const glm::vec3 eye = glm::normalize(glm::vec3(0.4f, -0.3f, 1.0f));
    const PointSurface surface = seen_from(eye);
    for (std::uint32_t i = 0; i < 64; ++i) {
        const auto xi = owen_point(i, 3);
        const float r = std::sqrt(xi[0]), phi = 6.2831853f * xi[1];
        const glm::vec3 wi(r * std::cos(phi), r * std::sin(phi), std::sqrt(1.0f - xi[0]));
        const double expected = test::reflected_by_texel(
            material, table, 0, static_cast<int>(GetParam()), f64::vec3(wi), f64::vec3(eye));
        // 2 %: the areas that directions see come from a coarser table (tests/gpu/tabulated_test.cpp).
        EXPECT_NEAR(static_cast<double>(surface.eval_cos(wi).y), expected, 0.02 * expected + 1e-4);
    }
}

TEST_P(TableSurface, DrawsByItsDensity) {
    for (const glm::vec3 eye : {glm::vec3(0.3f, 0.1f, 1.0f), glm::vec3(-1.0f, 0.6f, 0.8f)})
        EXPECT_LT(std::abs(test::chi_square_sigmas(seen_from(eye))), 5.0);
}

INSTANTIATE_TEST_SUITE_P(Methods, TableSurface,
                         testing::Values(Method::none, Method::normal_map, Method::rotate_arc,
                                         Method::follow_grain, Method::deform_smooth));

}  // namespace
}  // namespace burnish
