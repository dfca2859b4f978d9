// Materials, textures, lights, cameras and extensions of glTF files.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "gltf_support.hpp"

namespace burnish {
namespace {

using nlohmann::json;
using test::error_of;
using test::load_bytes;
using test::square_with;
using test::warns;

Material material_of(const json& material) {
    return load_bytes(square_with(material)).materials.at(0);
}

TEST(GltfMaterials, DefaultsAreThoseOfTheFormat) {
    const Material material = material_of(json::object());
    EXPECT_EQ(material.base_color, glm::vec4(1.0f));
    EXPECT_EQ(material.metallic, 1.0f);
    EXPECT_EQ(material.lobe, MaterialLobe(GltfLobe{1.0f, 0.0f}));
    EXPECT_EQ(material.emissive, glm::vec3(0.0f));
    EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(material.alpha_cutoff, 0.5f);
    EXPECT_FALSE(material.double_sided);
    EXPECT_FALSE(material.base_color_texture);
    EXPECT_FLOAT_EQ(material.dielectric_f0, 0.04f);
}

TEST(GltfMaterials, EveryFactorIsRead) {
    const Material material =
        material_of({{"name", "brushed"},
                     {"pbrMetallicRoughness",
                      {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                       {"metallicFactor", 0.25},
                       {"roughnessFactor", 0.75},
                       {"baseColorTexture", {{"index", 0}}},
                       {"metallicRoughnessTexture", {{"index", 0}}}}},
                     {"normalTexture", {{"index", 0}, {"scale", 0.5}}},
                     {"occlusionTexture", {{"index", 0}, {"strength", 0.7}}},
                     {"emissiveTexture", {{"index", 0}}},
                     {"emissiveFactor", {0.5, 0.25, 1}},
                     {"alphaMode", "MASK"},
                     {"alphaCutoff", 0.3},
                     {"doubleSided", true},
                     {"extensions",
                      {{"KHR_materials_anisotropy",
                        {{"anisotropyStrength", 0.6},
                         {"anisotropyRotation", 1.2},
                         {"anisotropyTexture", {{"index", 0}}}}},
                       {"KHR_materials_ior", {{"ior", 1.33}}},
                       {"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}});
    EXPECT_EQ(material.name, "brushed");
    EXPECT_EQ(material.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(material.metallic, 0.25f);
    EXPECT_EQ(material.lobe, MaterialLobe(GltfLobe{0.75f, 0.6f}));
    EXPECT_EQ(material.normal_scale, 0.5f);
    EXPECT_EQ(material.occlusion_strength, 0.7f);
    EXPECT_EQ(material.emissive, glm::vec3(2.0f, 1.0f, 4.0f));
    EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
    EXPECT_EQ(material.alpha_cutoff, 0.3f);
    EXPECT_TRUE(material.double_sided);
    EXPECT_EQ(material.anisotropy_rotation, 1.2f);
    EXPECT_NEAR(material.dielectric_f0, 0.0200593f, 1e-6f);  // (0.33 / 2.33)^2
    for (const TextureUse* use :
         {&material.base_color_texture, &material.metallic_roughness_texture,
          &material.normal_texture, &material.occlusion_texture, &material.emissive_texture,
          &material.anisotropy_texture})
        EXPECT_TRUE(*use);
}

json layer_extensions() {
    const json texture = {{"index", 0}};
    return {{"KHR_materials_clearcoat",
             {{"clearcoatFactor", 0.75},
              {"clearcoatRoughnessFactor", 0.25},
              {"clearcoatTexture", texture},
              {"clearcoatRoughnessTexture", texture},
              {"clearcoatNormalTexture", {{"index", 0}, {"scale", 0.5}}}}},
            {"KHR_materials_sheen",
             {{"sheenColorFactor", {0.5, 0.25, 1.0}},
              {"sheenRoughnessFactor", 0.375},
              {"sheenColorTexture", texture},
              {"sheenRoughnessTexture", texture}}},
            {"KHR_materials_specular",
             {{"specularFactor", 0.625},
              {"specularColorFactor", {0.25, 2.0, 0.5}},
              {"specularTexture", texture},
              {"specularColorTexture", texture}}}};
}

TEST(GltfMaterials, CoatSheenAndSpecularAreRead) {
    const Scene scene = load_bytes(square_with({{"extensions", layer_extensions()}}));
    EXPECT_TRUE(scene.warnings.empty());
    const Material& m = scene.materials.at(0);
    EXPECT_EQ(m.coat.strength, 0.75f);
    EXPECT_EQ(m.coat.roughness, 0.25f);
    EXPECT_EQ(m.coat.tint, glm::vec3(1.0f));
    EXPECT_EQ(m.coat.normal_scale, 0.5f);
    EXPECT_EQ(m.sheen.color, glm::vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(m.sheen.roughness, 0.375f);
    EXPECT_EQ(m.specular, 0.625f);
    EXPECT_EQ(m.specular_color, glm::vec3(0.25f, 2.0f, 0.5f));
    const auto space_of = [&](const TextureUse& use) {
        return scene.textures.at(static_cast<std::size_t>(use.texture)).color_space;
    };
    for (const TextureUse* use :
         {&m.coat.texture, &m.coat.roughness_texture, &m.coat.normal_texture,
          &m.sheen.roughness_texture, &m.specular_texture})
        EXPECT_EQ(space_of(*use), ColorSpace::linear);
    EXPECT_EQ(space_of(m.sheen.color_texture), ColorSpace::srgb);
    EXPECT_EQ(space_of(m.specular_color_texture), ColorSpace::srgb);
}

TEST(GltfMaterials, WithoutTheExtensionsThereAreNoLayers) {
    const Material m = material_of(json::object());
    EXPECT_FALSE(has_coat(m) || has_sheen(m) || has_specular_factors(m));
    // Their factors are 0 by default: textures alone make no layer.
    const Material empty = material_of({{"extensions",
                                         {{"KHR_materials_clearcoat", json::object()},
                                          {"KHR_materials_sheen", json::object()},
                                          {"KHR_materials_specular", json::object()}}}});
    EXPECT_FALSE(has_coat(empty) || has_sheen(empty) || has_specular_factors(empty));
}

TEST(GltfMaterials, FactorsThatNoCoatHasAreHeldToTheirRange) {
    json extensions = layer_extensions();
    extensions["KHR_materials_clearcoat"]["clearcoatFactor"] = 7;
    extensions["KHR_materials_clearcoat"]["clearcoatRoughnessFactor"] = -1;
    extensions["KHR_materials_sheen"]["sheenColorFactor"] = {3, 0, 0};
    extensions["KHR_materials_sheen"]["sheenRoughnessFactor"] = 2;
    extensions["KHR_materials_specular"]["specularFactor"] = -0.5;
    const Scene scene = load_bytes(square_with({{"extensions", extensions}}));
    const Material& m = scene.materials.at(0);
    EXPECT_EQ(m.coat.strength, 1.0f);
    EXPECT_EQ(m.coat.roughness, 0.0f);
    EXPECT_EQ(m.sheen.color, glm::vec3(1, 0, 0));
    EXPECT_EQ(m.sheen.roughness, 1.0f);
    EXPECT_EQ(m.specular, 0.0f);
    EXPECT_EQ(scene.warnings.size(), 5u);
    EXPECT_TRUE(warns(scene,
                      "materials[0].extensions.KHR_materials_clearcoat.clearcoatFactor: 7 is not "
                      "from 0 to 1: 1 is used"));
    for (const json& wrong : {json("much"), json::array({1}), json(nullptr)}) {
        extensions["KHR_materials_sheen"]["sheenColorFactor"] = wrong;
        EXPECT_NE(error_of(square_with({{"extensions", extensions}})).find("sheenColorFactor"),
                  std::string::npos);
    }
}

TEST(GltfMaterials, AnUnlitSurfaceHasNoLayers) {
    json extensions = layer_extensions();
    extensions["KHR_materials_unlit"] = json::object();
    const Material m = material_of({{"extensions", extensions}});
    EXPECT_FALSE(has_coat(m) || has_sheen(m) || has_specular_factors(m));
}

TEST(GltfMaterials, APictureIsDecodedOnceForEachWayItIsRead) {
    const Scene scene = load_bytes(square_with({{"normalTexture", {{"index", 0}}},
                                                {"occlusionTexture", {{"index", 0}}},
                                                {"emissiveTexture", {{"index", 0}}}}));
    ASSERT_EQ(scene.textures.size(), 2u);
    const Material& material = scene.materials[0];
    EXPECT_EQ(material.normal_texture.texture, material.occlusion_texture.texture);
    const auto& normal = scene.textures[static_cast<std::size_t>(material.normal_texture.texture)];
    const auto& glow = scene.textures[static_cast<std::size_t>(material.emissive_texture.texture)];
    EXPECT_EQ(normal.color_space, ColorSpace::linear);
    EXPECT_EQ(glow.color_space, ColorSpace::srgb);
    ASSERT_EQ(normal.width, 4);
    ASSERT_EQ(normal.height, 2);
    ASSERT_EQ(normal.channels, 3);
    ASSERT_EQ(normal.texels.size(), 24u);
    EXPECT_EQ(normal.texels, glow.texels);
    // Texel (3, 1) of the gradient, row 0 at the top.
    EXPECT_EQ(std::to_integer<int>(normal.texels[21]), 3);
    EXPECT_EQ(std::to_integer<int>(normal.texels[22]), 1);
    EXPECT_EQ(std::to_integer<int>(normal.texels[23]), 4);
}

TEST(GltfMaterials, Samplers) {
    GlbWriter writer = square_with({{"normalTexture", {{"index", 0}}}});
    writer.root["textures"][0]["sampler"] = 0;
    writer.root["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
    const TextureUse use = load_bytes(writer).materials[0].normal_texture;
    EXPECT_EQ(use.wrap_s, Wrap::clamp);
    EXPECT_EQ(use.wrap_t, Wrap::mirror);
    EXPECT_TRUE(use.nearest);
    writer.root["samplers"] = {json::object()};
    EXPECT_EQ(load_bytes(writer).materials[0].normal_texture.wrap_s, Wrap::repeat);
    writer.root["samplers"] = {{{"wrapS", 1}}};
    EXPECT_NE(error_of(writer).find("samplers[0].wrapS"), std::string::npos);
    writer.root["textures"][0]["sampler"] = 4;
    EXPECT_NE(error_of(writer).find("textures[0].sampler"), std::string::npos);
}

TEST(GltfMaterials, TextureTransform) {
    const double turn = std::acos(-1.0) / 2.0;
    const json transform = {
        {"offset", {0.25, 0.5}}, {"scale", {2, 4}}, {"rotation", turn}, {"texCoord", 1}};
    GlbWriter writer =
        square_with({{"normalTexture",
                      {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}});
    json& primitive = writer.root["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_1"] = primitive["attributes"]["TEXCOORD_0"];
    const TextureUse use = load_bytes(writer).materials[0].normal_texture;
    EXPECT_EQ(use.texcoord, 1);
    // Scaled to (2, 0), then rotated counter-clockwise in the picture, whose v runs down: from u
    // towards -v. Then translated.
    const glm::vec3 uv = use.transform * glm::vec3(1.0f, 0.0f, 1.0f);
    EXPECT_NEAR(uv.x, 0.25f, 1e-6f);
    EXPECT_NEAR(uv.y, 0.5f - 2.0f, 1e-6f);
    const glm::vec3 v = use.transform * glm::vec3(0.0f, 1.0f, 1.0f);
    EXPECT_NEAR(v.x, 0.25f + 4.0f, 1e-6f);
    EXPECT_NEAR(v.y, 0.5f, 1e-6f);
}

TEST(GltfMaterials, TexturesWithoutCoordinatesAreDropped) {
    GlbWriter writer = square_with(
        {{"normalTexture", {{"index", 0}}},
         {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}}});
    Scene scene = load_bytes(writer);  // the square has only TEXCOORD_0
    EXPECT_TRUE(warns(scene, "no TEXCOORD_1: not used: base color texture"));
    const auto used = [&] {
        return scene.materials[static_cast<std::size_t>(scene.instances.at(0).material)];
    };
    EXPECT_FALSE(used().base_color_texture);
    EXPECT_TRUE(used().normal_texture);
    EXPECT_TRUE(scene.materials[0].base_color_texture);  // the file's own material is unchanged

    writer.root["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_0");
    scene = load_bytes(writer);
    EXPECT_TRUE(warns(scene, "no TEXCOORD_0: not used: normal map"));
    EXPECT_FALSE(used().normal_texture);
}

TEST(GltfMaterials, TangentsFollowTheNormalMapsCoordinates) {
    GlbWriter writer = square_with({{"normalTexture", {{"index", 0}, {"texCoord", 1}}}});
    GlbPrimitive square = unit_square(1, false);
    square.material = 0;
    for (const glm::vec2 uv : square.texcoord0) square.texcoord1.emplace_back(-uv.x, -uv.y);
    writer.root["meshes"] = json::array();
    writer.add_mesh(square);
    const Scene scene = load_bytes(writer);
    EXPECT_NEAR(scene.meshes.at(0).tangents[0].x, -1.0f, 1e-6f);
    EXPECT_EQ(scene.meshes[0].texcoord0, square.texcoord0);
}

TEST(GltfMaterials, BrokenOnesAreErrors) {
    const auto broken = [](const json& material) { return error_of(square_with(material)); };
    EXPECT_NE(broken({{"normalTexture", {{"index", 1}}}}).find("materials[0].normalTexture.index"),
              std::string::npos);
    EXPECT_NE(broken({{"normalTexture", {{"index", "a"}}}}).find("whole number"),
              std::string::npos);
    EXPECT_NE(broken({{"normalTexture", json::object()}}).find("nothing"), std::string::npos);
    EXPECT_NE(broken({{"alphaMode", "SOLID"}}).find("alphaMode"), std::string::npos);
    EXPECT_NE(broken({{"emissiveFactor", {1, 2}}}).find("3 numbers"), std::string::npos);
    EXPECT_NE(broken({{"doubleSided", 1}}).find("true or false"), std::string::npos);
    EXPECT_NE(broken({{"pbrMetallicRoughness", {{"metallicFactor", 1e300}}}}).find("float"),
              std::string::npos);
    EXPECT_NE(broken({{"extensions", {{"KHR_materials_ior", {{"ior", 0.5}}}}}}).find("ior"),
              std::string::npos);
    const Scene scene =
        load_bytes(square_with({{"pbrMetallicRoughness", {{"metallicFactor", 1.5}}}}));
    EXPECT_EQ(scene.materials[0].metallic, 1.0f);
    EXPECT_TRUE(warns(scene, "metallicFactor"));
}

TEST(GltfMaterials, BrokenReferencesToPicturesAreErrorsThatNameThem) {
    GlbWriter writer = square_with({{"normalTexture", {{"index", 0}}}});
    writer.root["textures"][0]["source"] = 3;
    EXPECT_NE(error_of(writer).find("textures[0].source"), std::string::npos);
    writer.root["textures"][0]["source"] = 0;
    writer.root["images"][0] = {{"uri", "a.png"}, {"bufferView", 0}};
    EXPECT_NE(error_of(writer).find("either uri or bufferView"), std::string::npos);
    writer.root["textures"][0].erase("source");
    writer.root["images"] = json::array();
    EXPECT_TRUE(warns(load_bytes(writer), "textures[0]: no picture: materials[0].normalTexture"));
}

TEST(GltfMaterials, BrokenPicturesAreWarningsThatNameThem) {
    GlbWriter writer = square_with({{"normalTexture", {{"index", 0}}}});
    writer.root["bufferViews"][0]["byteLength"] = 40;  // shorter than the PNG
    Scene scene = load_bytes(writer);
    EXPECT_TRUE(warns(scene, "images[0]"));
    EXPECT_FALSE(scene.materials[0].normal_texture);
    writer.root["images"][0] = {{"uri", "gone.png"}};
    scene = load_bytes(writer);
    EXPECT_TRUE(warns(scene, "gone.png"));
    EXPECT_TRUE(warns(scene, "drawn without it: normal map of materials[0]"));
}

TEST(GltfExtensions, RequiredOnesWeLackAreErrorsOthersWarnings) {
    GlbWriter writer = square_with(json::object());
    writer.root["extensionsUsed"] = {"KHR_materials_transmission", "KHR_materials_anisotropy",
                                     "ACME_sparkle", "KHR_xmp_json_ld"};
    const Scene scene = load_bytes(writer);
    ASSERT_EQ(scene.warnings.size(), 2u);
    EXPECT_TRUE(warns(scene, "KHR_materials_transmission: the surface is drawn opaque"));
    EXPECT_TRUE(warns(scene, "ACME_sparkle"));
    for (const char* name : {"KHR_materials_transmission", "KHR_texture_basisu", "ACME_sparkle"}) {
        writer.root["extensionsRequired"] = {name};
        const std::string line = error_of(writer);
        EXPECT_NE(line.find(name), std::string::npos) << line;
    }
    writer.root["extensionsRequired"] = {"KHR_materials_anisotropy"};
    EXPECT_NO_THROW(load_bytes(writer));
}

GlbWriter writer_with_light(const json& light, const json& node) {
    GlbWriter writer = square_with(json::object());
    writer.root["extensions"]["KHR_lights_punctual"]["lights"] = {light};
    json placed = node;
    placed["extensions"]["KHR_lights_punctual"]["light"] = 0;
    writer.root["nodes"].push_back(placed);
    writer.root["scenes"][0]["nodes"].push_back(1);
    return writer;
}

TEST(GltfLights, ArePlacedInTheWorld) {
    const float h = std::sqrt(0.5f);
    // Rotated by -90 degrees about x: the direction -z becomes down.
    const json node = {
        {"translation", {1, 2, 3}}, {"rotation", {-h, 0, 0, h}}, {"scale", {5, 5, 5}}};
    const json light = {{"type", "spot"},
                        {"color", {1, 0.5, 0.25}},
                        {"intensity", 40},
                        {"range", 9},
                        {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}};
    const Scene scene = load_bytes(writer_with_light(light, node));
    ASSERT_EQ(scene.lights.size(), 1u);
    const Light& found = scene.lights[0];
    EXPECT_EQ(found.type, LightType::spot);
    EXPECT_EQ(found.color, glm::vec3(1.0f, 0.5f, 0.25f));
    EXPECT_EQ(found.intensity, 40.0f);
    EXPECT_EQ(found.range, 9.0f);
    EXPECT_EQ(found.position, glm::vec3(1.0f, 2.0f, 3.0f));
    EXPECT_NEAR(found.direction.y, -1.0f, 1e-6f);
    EXPECT_EQ(found.inner_cone, 0.2f);
    EXPECT_EQ(found.outer_cone, 0.4f);
    const auto error = [&](const char* key, const json& value) {
        json other = light;
        other[key] = value;
        return error_of(writer_with_light(other, node));
    };
    EXPECT_NE(error("type", "area").find("directional, point or spot"), std::string::npos);
    EXPECT_NE(error("intensity", -1).find("intensity"), std::string::npos);
    EXPECT_NE(error("intensity", 1e30).find("intensity"), std::string::npos);
    EXPECT_NE(error("spot", {{"outerConeAngle", 3}}).find("outerConeAngle"), std::string::npos);
    GlbWriter writer = writer_with_light(light, node);
    writer.root["extensions"].erase("KHR_lights_punctual");
    EXPECT_NE(error_of(writer).find("nodes[1]"), std::string::npos);
}

TEST(GltfCameras, LookAlongMinusZOfTheirNode) {
    GlbWriter writer = square_with(json::object());
    writer.root["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}},
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 2}, {"ymag", 3}, {"znear", 0}, {"zfar", 50}}}}};
    for (int i = 0; i < 2; ++i) {
        writer.root["nodes"].push_back({{"camera", i}, {"translation", {0.5, 0.5, 4}}});
        writer.root["scenes"][0]["nodes"].push_back(i + 1);
    }
    const Scene scene = load_bytes(writer);
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].position, glm::vec3(0.5f, 0.5f, 4.0f));
    EXPECT_EQ(scene.cameras[0].target, glm::vec3(0.5f, 0.5f, 0.0f));  // the center of the square
    EXPECT_EQ(scene.cameras[0].up, glm::vec3(0.0f, 1.0f, 0.0f));
    EXPECT_EQ(scene.cameras[0].yfov, 0.8f);
    EXPECT_EQ(scene.cameras[0].near_plane, 0.1f);
    EXPECT_FALSE(scene.cameras[0].orthographic);
    EXPECT_TRUE(scene.cameras[1].orthographic);
    EXPECT_EQ(scene.cameras[1].ymag, 3.0f);
    EXPECT_EQ(scene.cameras[1].far_plane, 50.0f);
    writer.root["cameras"][0]["perspective"]["yfov"] = 4;
    EXPECT_NE(error_of(writer).find("cameras[0].perspective.yfov"), std::string::npos);
    writer.root["cameras"][0].erase("perspective");
    EXPECT_FALSE(error_of(writer).empty());
}

}  // namespace
}  // namespace burnish
