// Scratch maps and weaves in their own size on a model in meters.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "burnish/image_io.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"
#include "scene/geometry/texture_scale.hpp"
#include "support/test_folder.hpp"

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
        EXPECT_NEAR(texture_square(scene, 0).value().side, side_of(scene), 1e-6 * side_of(scene));
    }
    EXPECT_FALSE(texture_square(plane(1.0f), 1)) << "no triangle of that material";
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
    EXPECT_NEAR(texture_square(scene, 0).value().side, 3.0, 1e-6);
}

TEST(PhysicalSize, AScratchTileHasItsMillimeters) {
    Scene scene = plane(0.05f);
    ParameterValues values;
    values.set("scratch", "brushed", "");
    values.set("physical_size", "true", "");
    const std::vector<std::string> notes =
        LayeredMaterials(scene.materials).apply(scene, values).notes;
    // Presets have a tile of 50 mm.
    const double wanted = side_of(scene) * 1000 / 50;
    EXPECT_NEAR(scene.materials.front().normal_texture.transform[0][0], wanted, 1e-4 * wanted);
    ASSERT_EQ(notes.size(), 2U) << "the repeats, and the size of the model";
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
    const std::vector<std::string> notes =
        LayeredMaterials(scene.materials).apply(scene, values).warnings;
    EXPECT_NE(notes.front().find("not drawn in its size"), std::string::npos) << notes.front();
}

// Two triangles of the same area whose texture squares are 1 m and 3 m wide: the quartiles.
TEST(PhysicalSize, AnUnevenTextureDensityIsSaid) {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {5, 0, 0}, {8, 0, 0}, {5, 3, 0}};
    mesh.texcoord0 = {{0, 0}, {3, 0}, {0, 3}, {0, 0}, {1, 0}, {0, 1}};
    mesh.indices = {0, 1, 2, 3, 4, 5};
    mesh.normals.resize(6, {0, 0, 1});
    mesh.tangents.resize(6, {1, 0, 0, 1});
    scene.materials.emplace_back();
    scene.instances.push_back({0, 0, glm::mat4(1.0f)});
    ParameterValues values;
    values.set("weave", "plain", "");
    values.set("weave_yarns_per_cm", "9", "");
    const Remarks uneven = LayeredMaterials(scene.materials).apply(scene, values);
    // The median is 1 m: 9 yarns a centimeter there are 3 where the square is three times as wide.
    EXPECT_NE(uneven.notes.front().find("3 to 9 yarns a centimeter"), std::string::npos)
        << uneven.notes.front();
    Scene even = plane(1.0f);
    EXPECT_EQ(LayeredMaterials(even.materials).apply(even, values).notes.front().find("on average"),
              std::string::npos);
}

TEST(PhysicalSize, MapsHaveTheWidthThatIsStated) {
    const test::ScratchFolder folder;
    write_image(folder / "x_color.png", Image(4, 4, 3, 0.5f), {});
    ParameterValues values;
    values.set("maps", (folder / "").string(), "");
    values.set("maps_tile_mm", "250", "");
    Scene scene = plane(1.0f);
    LayeredMaterials(scene.materials).apply(scene, values);
    EXPECT_NEAR(scene.materials.front().base_color_texture.transform[0][0],
                side_of(scene) * 1000 / 250, 1e-3);
    // A folder of Burnish's own states its size.
    values.erase("maps_tile_mm");
    values.set("physical_size", "true", "");
    scene = plane(1.0f);
    const Remarks silent = LayeredMaterials(scene.materials).apply(scene, values);
    EXPECT_NE(silent.warnings.at(0).find("--maps-tile-mm"), std::string::npos);
    folder.write("material.json",
                 R"({"format": "burnish-material", "version": 1, "tile_mm": [125, 250]})");
    scene = plane(1.0f);
    LayeredMaterials(scene.materials).apply(scene, values);
    EXPECT_NEAR(scene.materials.front().base_color_texture.transform[0][0],
                side_of(scene) * 1000 / 125, 1e-3);
}

TEST(PhysicalSize, ALongModelMayBeInMillimeters) {
    ParameterValues values;
    values.set("weave", "plain", "");
    values.set("weave_yarns_per_cm", "1", "");
    for (const float scale : {1.0f, 1000.0f}) {
        Scene scene = plane(scale);
        const Remarks remarks = LayeredMaterials(scene.materials).apply(scene, values);
        bool said = false;
        for (const std::string& line : remarks.warnings)
            said = said || line.find("millimeter") != std::string::npos;
        EXPECT_EQ(said, scale > 1.0f);
    }
}

// At most 1000 repeats can be drawn: a square of 1 km asks for 20,000 tiles of 50 mm.
TEST(PhysicalSize, WhatTheRangeCannotHoldIsSaid) {
    Scene scene = plane(1000.0f);
    ParameterValues values;
    values.set("scratch", "brushed", "");
    values.set("physical_size", "true", "");
    const Remarks remarks = LayeredMaterials(scene.materials).apply(scene, values);
    const double times = side_of(scene) * 1000 / 50 / 1000;
    EXPECT_NE(remarks.warnings.at(0).find(fmt::format("{:.3g} times as large", times)),
              std::string::npos)
        << remarks.warnings.at(0);
}

}  // namespace
}  // namespace burnish
