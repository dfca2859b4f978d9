// The glTF text of a material by the formulas of the specifications.
#include "export/gltf_material_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace burnish {
namespace {

GltfMaterial with_transform(const glm::mat3& transform) {
    GltfMaterial baked;
    baked.tile = transform;
    baked.textures.resize(4);
    int index = 0;
    for (TextureUse* use :
         {&baked.material.base_color_texture, &baked.material.metallic_roughness_texture,
          &baked.material.normal_texture, &baked.material.anisotropy_texture}) {
        use->texture = index++;
        use->transform = transform;
    }
    return baked;
}

// KHR_texture_transform: uv' = offset + rotation (scale uv), v running down.
TEST(GltfMaterialText, ATransformComesBack) {
    const float c = std::cos(0.7f), s = std::sin(0.7f);
    const glm::mat3 wanted(c * 3, -s * 3, 0, s * -2, c * -2, 0, 0.25f, -0.5f, 1);
    const auto json = gltf_material_text(with_transform(wanted), Material{}, "m", "")
                          .json["normalTexture"]["extensions"]["KHR_texture_transform"];
    EXPECT_NEAR(json["rotation"].get<double>(), 0.7, 1e-6);
    EXPECT_NEAR(json["scale"][0].get<double>(), 3, 1e-5);
    EXPECT_NEAR(json["scale"][1].get<double>(), -2, 1e-5);
    EXPECT_EQ(json["offset"][0].get<double>(), 0.25);
    EXPECT_EQ(json["offset"][1].get<double>(), -0.5);
}

TEST(GltfMaterialText, StatesTheIndexOfTheInterface) {
    GltfMaterial baked = with_transform(glm::mat3(1.0f));
    // (n-1)^2/(n+1)^2 of n = 2 is 1/9.
    baked.material.dielectric_f0 = 1.0f / 9.0f;
    const QuadMaterial text = gltf_material_text(baked, Material{}, "m", "");
    EXPECT_NEAR(text.json["extensions"]["KHR_materials_ior"]["ior"].get<double>(), 2.0, 1e-5);
    EXPECT_NE(std::find(text.extensions.begin(), text.extensions.end(), "KHR_materials_ior"),
              text.extensions.end());
}

TEST(GltfMaterialText, StatesCoatSheenAndSpecular) {
    GltfMaterial baked = with_transform(glm::mat3(1.0f));
    Material& m = baked.material;
    m.coat.strength = 0.5f;
    m.coat.roughness = 0.25f;
    m.coat.tint = {0.5f, 0.25f, 1.0f};
    m.sheen.color = {0.25f, 0.5f, 0.75f};
    m.sheen.roughness = 0.375f;
    m.specular = 0.5f;
    const QuadMaterial text = gltf_material_text(baked, m, "m", "");
    const auto& extensions = text.json["extensions"];
    EXPECT_EQ(extensions["KHR_materials_clearcoat"]["clearcoatFactor"], 0.5f);
    EXPECT_EQ(extensions["KHR_materials_clearcoat"]["clearcoatRoughnessFactor"], 0.25f);
    EXPECT_EQ(extensions["KHR_materials_sheen"]["sheenColorFactor"][2], 0.75f);
    EXPECT_EQ(extensions["KHR_materials_sheen"]["sheenRoughnessFactor"], 0.375f);
    EXPECT_EQ(extensions["KHR_materials_specular"]["specularFactor"], 0.5f);
    EXPECT_EQ(text.json["extras"]["burnish"]["coat_tint"][1], 0.25f);
    for (const char* name :
         {"KHR_materials_clearcoat", "KHR_materials_sheen", "KHR_materials_specular"})
        EXPECT_NE(std::find(text.extensions.begin(), text.extensions.end(), name),
                  text.extensions.end());
    const QuadMaterial bare =
        gltf_material_text(with_transform(glm::mat3(1.0f)), Material{}, "m", "");
    EXPECT_FALSE(bare.json["extensions"].contains("KHR_materials_clearcoat"));
    EXPECT_FALSE(bare.json["extras"]["burnish"].contains("coat_tint"));
}

}  // namespace
}  // namespace burnish
