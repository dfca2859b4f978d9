// Scratch maps and weaves in their own size on a model in meters.
#include <gtest/gtest.h>

#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"
#include "scene/geometry/texture_scale.hpp"

namespace burnish {
namespace {

// The plane of side 2 m, as it is built, scaled by `scale`.
Scene plane(float scale) {
    Scene scene = load_model("builtin:plane", 0);
    scene.instances.front().transform = glm::mat4(glm::mat3(scale));
    scene.instances.front().transform[3][3] = 1.0f;
    return scene;
}

double side_of(const Scene& scene) {
    const Bounds bounds = bounds_of(scene);
    return static_cast<double>(bounds.high.x - bounds.low.x);
}

TEST(TextureSquare, IsTheSideOfAPlaneThatShowsItOnce) {
    for (const float scale : {1.0f, 0.02f}) {
        const Scene scene = plane(scale);
        EXPECT_NEAR(texture_square_side(scene, 0).value(), side_of(scene), 1e-6 * side_of(scene));
    }
    EXPECT_FALSE(texture_square_side(plane(1.0f), 1)) << "no triangle of that material";
}

// Half the area has the texture twice as large: the median by area is that of the larger share.
TEST(TextureSquare, IsAMedianByArea) {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {8, 0, 0}, {5, 3, 0}};
    mesh.texcoord0 = {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {1, 0}, {0, 1}};
    mesh.indices = {0, 1, 2, 3, 4, 5};
    scene.materials.emplace_back();
    scene.instances.push_back({0, 0, glm::mat4(1.0f)});
    EXPECT_NEAR(texture_square_side(scene, 0).value(), 3.0, 1e-6);
}

TEST(PhysicalSize, AScratchTileHasItsMillimeters) {
    Scene scene = plane(0.05f);
    ParameterValues values;
    values.set("scratch", "brushed", "");
    values.set("physical_size", "true", "");
    const std::vector<std::string> notes = LayeredMaterials(scene.materials).apply(scene, values);
    // Presets have a tile of 50 mm.
    const double wanted = side_of(scene) * 1000 / 50;
    EXPECT_NEAR(scene.materials.front().normal_texture.transform[0][0], wanted, 1e-4 * wanted);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes.front().find("--uv-scale"), std::string::npos) << notes.front();
}

TEST(PhysicalSize, AUvScaleHolds) {
    Scene scene = plane(0.05f);
    ParameterValues values;
    values.set("scratch", "brushed", "");
    values.set("physical_size", "true", "");
    values.set("uv_scale", "3", "");
    LayeredMaterials(scene.materials).apply(scene, values);
    EXPECT_EQ(scene.materials.front().normal_texture.transform[0][0], 3.0f);
}

TEST(PhysicalSize, YarnsAreCountedByTheCentimeter) {
    Scene scene = plane(0.1f);
    ParameterValues values;
    values.set("weave", "plain", "");
    values.set("weave_yarns_per_cm", "12", "");
    LayeredMaterials(scene.materials).apply(scene, values);
    const double wanted = side_of(scene) * 100 * 12;
    EXPECT_NEAR(cloth_of(scene.materials.front())->yarns, wanted, 1e-4 * wanted);
}

TEST(PhysicalSize, WithoutTextureCoordinatesItIsSaid) {
    Scene scene = plane(1.0f);
    scene.meshes.front().texcoord0.clear();
    ParameterValues values;
    values.set("weave", "plain", "");
    values.set("weave_yarns_per_cm", "12", "");
    const std::vector<std::string> notes = LayeredMaterials(scene.materials).apply(scene, values);
    EXPECT_NE(notes.front().find("not drawn in its size"), std::string::npos) << notes.front();
}

}  // namespace
}  // namespace burnish
