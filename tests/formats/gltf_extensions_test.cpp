// Extensions of glTF: drafts, keys that no extension has, versions of textures, unlit surfaces,
// instances, and the table of the documentation.
#include "formats/gltf/gltf_extensions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <set>
#include <sstream>

#include "burnish/image_io.hpp"
#include "formats/gltf/gltf_materials.hpp"
#include "formats/model_textures.hpp"
#include "gltf_support.hpp"
#include "scene/material/texture_uses.hpp"
#include "support/paths.hpp"

namespace burnish {
namespace {

using nlohmann::json;
using test::error_of;
using test::load_bytes;
using test::square_with;
using test::warns;

json anisotropic(const json& extension) {
    return {{"extensions", {{"KHR_materials_anisotropy", extension}}}};
}

Scene load_anisotropic(const json& extension) {
    return load_bytes(square_with(anisotropic(extension)));
}

// --- the draft of KHR_materials_anisotropy ------------------------------------------------------

TEST(GltfDraft, AmountAndDirectionAreDrawnAsTodaysKeys) {
    const Scene draft = load_anisotropic({{"anisotropy", 0.9}, {"anisotropyDirection", {1, 0, 0}}});
    Scene final = load_anisotropic({{"anisotropyStrength", 0.9}});
    EXPECT_TRUE(final.warnings.empty());
    EXPECT_EQ(draft.materials, final.materials);
    ASSERT_EQ(draft.warnings.size(), 1u);
    EXPECT_TRUE(warns(draft,
                      "anisotropy, anisotropyDirection of the extension's draft: drawn as "
                      "anisotropyStrength 0.9, anisotropyRotation 0"))
        << draft.warnings[0];
    const float diagonal =
        load_anisotropic({{"anisotropyFactor", 0.5}, {"anisotropyDirection", {1, 1}}})
            .materials[0]
            .anisotropy_rotation;
    EXPECT_FLOAT_EQ(diagonal, 0.25f * std::acos(-1.0f));
}

// A negative amount stretched across the direction.
TEST(GltfDraft, ANegativeAmountIsStretchedAcross) {
    const Material material = load_anisotropic({{"anisotropy", -0.6}}).materials[0];
    EXPECT_EQ(gltf_lobe_of(material)->anisotropy_strength, 0.6f);
    EXPECT_FLOAT_EQ(std::abs(material.anisotropy_rotation), 0.5f * std::acos(-1.0f));
}

TEST(GltfDraft, ADirectionTexturesBlueIsNoStrength) {
    GlbWriter writer = square_with(
        anisotropic({{"anisotropy", 0.9}, {"anisotropyDirectionTexture", {{"index", 0}}}}));
    writer.root["materials"][0]["normalTexture"] = {{"index", 0}};
    const Scene scene = load_bytes(writer);
    const Material& material = scene.materials[0];
    ASSERT_TRUE(material.anisotropy_texture);
    EXPECT_NE(material.anisotropy_texture.texture, material.normal_texture.texture);
    const auto& directions =
        scene.textures[static_cast<std::size_t>(material.anisotropy_texture.texture)].texels;
    const auto& normals =
        scene.textures[static_cast<std::size_t>(material.normal_texture.texture)].texels;
    for (std::size_t i = 0; i < directions.size(); ++i)
        EXPECT_EQ(directions[i], i % 3 == 2 ? std::byte{0xFF} : normals[i]);
    EXPECT_TRUE(warns(scene, "and the directions of the texture"));
}

TEST(GltfDraft, WhatIsNotClearIsNotReadAndSaid) {
    Scene scene = load_anisotropic(
        {{"anisotropy", 0.5}, {"anisotropyDirection", 1.5}, {"anisotropyTexture", {{"index", 0}}}});
    EXPECT_TRUE(warns(scene, "; not read: anisotropyDirection, anisotropyTexture"));
    EXPECT_FALSE(scene.materials[0].anisotropy_texture);
    for (const json& direction : {json({0, 0, 1}), json({1}), json({"a", "b"}), json("x")})
        EXPECT_TRUE(
            warns(load_anisotropic({{"anisotropy", 0.5}, {"anisotropyDirection", direction}}),
                  "; not read: anisotropyDirection"));
    scene = load_anisotropic({{"anisotropy", 0.5}, {"anisotropyStrength", 0.2}});
    EXPECT_EQ(gltf_lobe_of(scene.materials[0])->anisotropy_strength, 0.2f);
    EXPECT_TRUE(warns(scene, "anisotropy of the extension's draft: not read"));
}

// --- keys ---------------------------------------------------------------------------------------

TEST(GltfKeys, UnknownOnesInsideExtensionsAreNamed) {
    GlbWriter writer =
        square_with({{"normalTexture",
                      {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"rotate", 1}}}}}}},
                     {"extensions",
                      {{"KHR_materials_anisotropy", {{"anisotropyStrenght", 0.5}}},
                       {"KHR_materials_ior", {{"ior", 1.4}, {"index", 2}}},
                       {"KHR_materials_unlit", {{"color", {1, 1, 1}}}}}}});
    writer.root["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"name", "lamp"}, {"spot", {{"outerConAngle", 0.5}}}}};
    writer.root["nodes"][0]["extensions"]["KHR_lights_punctual"] = {{"light", 0}, {"on", true}};
    const Scene scene = load_bytes(writer);
    for (const char* line :
         {"materials[0].normalTexture.extensions.KHR_texture_transform: the key \"rotate\" is not "
          "read",
          "materials[0].extensions.KHR_materials_anisotropy: the key \"anisotropyStrenght\" is not "
          "read (did you mean 'anisotropyStrength'?)",
          "KHR_materials_ior: the key \"index\" is not read",
          "KHR_materials_unlit: the key \"color\" is not read",
          "extensions.KHR_lights_punctual.lights[0].spot: the key \"outerConAngle\" is not read "
          "(did you mean 'outerConeAngle'?)",
          "nodes[0].extensions.KHR_lights_punctual: the key \"on\" is not read"})
        EXPECT_TRUE(warns(scene, line)) << line;
    EXPECT_EQ(scene.warnings.size(), 6u) << "known keys are not named";
}

// --- versions of textures -----------------------------------------------------------------------

// A square whose texture has versions of different widths: 4 (PNG), 5 (WebP), 6 (AVIF). All bytes are
// PNG: what the pictures hold is the image layer's matter, which version is taken is ours.
GlbWriter square_with_versions() {
    GlbWriter writer =
        square_with({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    writer.add_png(png_gradient(5, 2));
    writer.add_png(png_gradient(6, 2));
    return writer;
}

int width_drawn(const Scene& scene) {
    const int texture = scene.materials.at(0).base_color_texture.texture;
    return texture < 0 ? -1 : scene.textures.at(static_cast<std::size_t>(texture)).width;
}

TEST(GltfTextures, TheBestVersionThatIsReadIsDrawn) {
    GlbWriter writer = square_with_versions();
    json& texture = writer.root["textures"][0];
    EXPECT_EQ(width_drawn(load_bytes(writer)), 4);
    texture["extensions"]["EXT_texture_webp"]["source"] = 1;
    EXPECT_EQ(width_drawn(load_bytes(writer)), 5);
    EXPECT_TRUE(load_bytes(writer).warnings.empty());
    texture["extensions"] = {{"EXT_texture_avif", {{"source", 2}}}};
    EXPECT_EQ(width_drawn(load_bytes(writer)), 6);
    writer.root["extensionsRequired"] = {"EXT_texture_avif"};
    texture.erase("source");
    EXPECT_EQ(width_drawn(load_bytes(writer)), 6);

    texture["source"] = 0;
    writer.root["images"][2] = {{"uri", "gone.avif"}};
    Scene scene = load_bytes(writer);
    EXPECT_EQ(width_drawn(scene), 4);
    EXPECT_TRUE(warns(scene, "gone.avif"));
    EXPECT_TRUE(warns(scene, "the texture's other version is used"));
    writer.root["images"][0] = {{"uri", "gone.png"}};
    scene = load_bytes(writer);
    EXPECT_EQ(width_drawn(scene), -1);
    EXPECT_TRUE(warns(scene, "drawn without it: base color texture of materials[0]"));
    texture["extensions"]["EXT_texture_avif"]["source"] = 9;
    EXPECT_NE(error_of(writer).find("textures[0].extensions.EXT_texture_avif.source"),
              std::string::npos);
}

TEST(GltfTextures, OfBasisUniversalAreConvertedByTheUser) {
    GlbWriter writer = square_with_versions();
    json& texture = writer.root["textures"][0];
    texture["extensions"]["KHR_texture_basisu"]["source"] = 1;
    writer.root["extensionsUsed"] = {"KHR_texture_basisu"};
    Scene scene = load_bytes(writer);
    EXPECT_EQ(width_drawn(scene), 4);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_TRUE(warns(scene,
                      "KHR_texture_basisu is not read: its other version is used; "
                      "gltf-transform ktxdecompress"));
    texture.erase("source");
    scene = load_bytes(writer);
    EXPECT_EQ(width_drawn(scene), -1);
    EXPECT_TRUE(warns(scene, "pbrMetallicRoughness.baseColorTexture is not used"));
    writer.root["extensionsRequired"] = {"KHR_texture_basisu"};
    EXPECT_NE(error_of(writer).find("gltf-transform ktxdecompress"), std::string::npos);
}

// Every way in which a picture can be missing or broken is a warning, and the rest is drawn.
TEST(GltfTextures, ThatCannotBeReadAreLeftOut) {
    GlbWriter writer = square_with(
        {{"name", "box"},
         {"normalTexture", {{"index", 0}}},
         {"emissiveTexture", {{"index", 0}}},
         {"emissiveFactor", {1, 1, 1}},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.5, 0.25, 0.125, 1}}, {"baseColorTexture", {{"index", 0}}}}}});
    const std::vector<json> broken = {
        {{"uri", "gone.png"}},       {{"uri", "http://example.org/x.png"}},
        {{"uri", "../outside.png"}}, {{"uri", "data:image/png;base64,AAAA"}},
        {{"bufferView", 77}},        json::object()};
    for (const json& image : broken) {
        writer.root["images"][0] = image;
        const Scene scene = load_bytes(writer);
        const Material& material = scene.materials.at(0);
        for (const TextureUse* use : texture_uses(material)) EXPECT_FALSE(*use);
        EXPECT_EQ(material.base_color, glm::vec4(0.5f, 0.25f, 0.125f, 1.0f));
        EXPECT_EQ(material.emissive, glm::vec3(0.0f)) << "a lamp whose picture is lost is dark";
        EXPECT_EQ(scene.instances.size(), 1u);
        EXPECT_TRUE(warns(scene, "images[0]") || warns(scene, "gone.png")) << image;
        EXPECT_TRUE(warns(scene, "drawn without it: ")) << image;
        for (const Texture& texture : scene.textures) EXPECT_FALSE(texture.empty());
    }
}

// The resolver of OBJ (core/find_file.hpp), and nothing outside the folder.
TEST(GltfTextures, OfOtherNamesAreFoundAndNamed) {
    const TemporaryFolder folder;
    folder.write("outside.png", png_gradient(4, 2));
    folder.write("inner/textures/Wood.PNG", png_gradient(4, 2));
    GlbWriter writer =
        square_with({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    const struct {
        const char *uri, *says;
    } cases[] = {{"textures/Wood.PNG", ""},
                 {"textures\\Wood.PNG", ""},
                 {"textures/wood.png", "other letter case"},
                 {"wood.png", "another folder and other letter case"},
                 {"textures/Wood.jpg", "another ending"},
                 {"C:/Users/me/textures/Wood.PNG", "another folder"},
                 {"C:%5CUsers%5Cme%5CWood.PNG", "another folder"},
                 {"file:///home/me/Wood.PNG", "another folder"},
                 {"../textures/Wood.PNG", "another folder"}};
    for (const auto& c : cases) {
        writer.root["images"][0] = {{"uri", c.uri}};
        const Scene scene = load_gltf(folder.write("inner/model.glb", writer.glb()));
        EXPECT_TRUE(scene.materials.at(0).base_color_texture) << c.uri;
        EXPECT_EQ(scene.warnings.size(), *c.says ? 1u : 0u) << c.uri;
        EXPECT_TRUE(!*c.says || warns(scene, c.says)) << c.uri;
        EXPECT_TRUE(!*c.says || warns(scene, "images[0].uri: ")) << c.uri;
    }
    const std::string absolute = (folder.path() / "outside.png").string();
    for (const std::string& uri : {std::string("../outside.png"), absolute, "file://" + absolute,
                                   "C:" + absolute, std::string("https://example.org/Wood.PNG")}) {
        writer.root["images"][0] = {{"uri", uri}};
        const Scene scene = load_gltf(folder.write("inner/model.glb", writer.glb()));
        EXPECT_FALSE(scene.materials.at(0).base_color_texture) << uri;
        EXPECT_TRUE(warns(scene, "a relative path inside the model's folder")) << uri;
    }
}

TEST(GltfMaterialKeys, ThatTheSpecificationLacksAreNamed) {
    GlbWriter writer = square_with({{"name", "m"},
                                    {"doubleSide", true},
                                    {"extras", {{"roughness", 1}}},
                                    {"pbrMetallicRoughness", {{"roughness", 0.2}}},
                                    {"normalTexture", {{"index", 0}, {"strength", 2}}}});
    const Scene scene = load_bytes(writer);
    EXPECT_TRUE(warns(scene,
                      "materials[0]: the key \"doubleSide\" is not read (did you mean "
                      "'doubleSided'?)"));
    EXPECT_TRUE(warns(scene,
                      "materials[0].pbrMetallicRoughness: the key \"roughness\" is not read "
                      "(did you mean 'roughnessFactor'?)"));
    EXPECT_TRUE(warns(scene, "materials[0].normalTexture: the key \"strength\" is not read"));
    EXPECT_EQ(scene.warnings.size(), 3u);
    writer.root["materials"][0]["alphaMode"] = 3;
    EXPECT_NE(error_of(writer).find("alphaMode: expected a text, found \"3\""), std::string::npos);
    writer.root["materials"][0] = {{"alphaCutoff", "0.1"}};
    EXPECT_NE(error_of(writer).find("found \"0.1\""), std::string::npos) << "quoted once";
}

TEST(GltfTextures, GrayPicturesOfPackedMapsAreNamed) {
    const TemporaryFolder folder;
    Image gray(4, 2, 1);
    write_image(folder.path() / "gray.png", gray, {});
    GlbWriter writer =
        square_with({{"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", 0}}}}},
                     {"occlusionTexture", {{"index", 0}}}});
    EXPECT_FALSE(warns(load_gltf(folder.write("model.glb", writer.glb())), "gray"));
    writer.root["images"][0] = {{"uri", "gray.png"}};
    const Scene scene = load_gltf(folder.write("model.glb", writer.glb()));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_TRUE(warns(scene,
                      "gray.png: expected a metallic-roughness map with red, green and blue, "
                      "found a gray picture: every property is drawn from its gray"));
    EXPECT_TRUE(scene.materials.at(0).metallic_roughness_texture);
}

// --- sets of texture coordinates ----------------------------------------------------------------

// TEXCOORD_n of the square is n + uv.
GlbWriter square_with_sets(const json& material, int sets) {
    GlbWriter writer = square_with(material);
    GlbPrimitive square = unit_square(1, false);
    json& attributes = writer.root["meshes"][0]["primitives"][0]["attributes"];
    attributes.erase("TANGENT");
    for (int n = 0; n < sets; ++n) {
        std::vector<glm::vec2> uv = square.texcoord0;
        for (glm::vec2& place : uv) place += glm::vec2(static_cast<float>(n));
        attributes["TEXCOORD_" + std::to_string(n)] = writer.add_items(uv, 5126, "VEC2");
    }
    return writer;
}

int set_read(const Scene& scene, const TextureUse& use) {
    const Mesh& mesh = scene.meshes.at(0);
    const auto& set = use.texcoord == 0 ? mesh.texcoord0 : mesh.texcoord1;
    return static_cast<int>(
        std::min_element(set.begin(), set.end(), [](auto a, auto b) { return a.x < b.x; })->x);
}

TEST(GltfSets, AnyTwoAreDrawn) {
    const auto texture = [](int set) { return json{{"index", 0}, {"texCoord", set}}; };
    for (const auto& [normal, occlusion] :
         {std::pair(2, 2), std::pair(0, 2), std::pair(3, 0), std::pair(1, 2), std::pair(5, 3),
          std::pair(0, 0), std::pair(1, 1), std::pair(0, 1)}) {
        const Scene scene = load_bytes(square_with_sets(
            {{"normalTexture", texture(normal)}, {"occlusionTexture", texture(occlusion)}}, 6));
        EXPECT_TRUE(scene.warnings.empty());
        const Material& material = scene.materials.at(0);
        EXPECT_EQ(set_read(scene, material.normal_texture), normal);
        EXPECT_EQ(set_read(scene, material.occlusion_texture), occlusion);
    }
}

TEST(GltfSets, AThirdIsNamedAndLeftOut) {
    const auto texture = [](int set) { return json{{"index", 0}, {"texCoord", set}}; };
    const json material = {{"normalTexture", texture(3)},
                           {"occlusionTexture", texture(0)},
                           {"emissiveTexture", texture(1)},
                           {"pbrMetallicRoughness", {{"baseColorTexture", texture(0)}}}};
    const Scene scene = load_bytes(square_with_sets(material, 4));
    EXPECT_TRUE(warns(scene, "its emissive texture is not drawn: TEXCOORD_1 is a third set"));
    EXPECT_EQ(scene.warnings.size(), 1u);
    EXPECT_FALSE(scene.materials[0].emissive_texture);
    EXPECT_EQ(set_read(scene, scene.materials[0].normal_texture), 3);
    EXPECT_EQ(set_read(scene, scene.materials[0].occlusion_texture), 0);
    EXPECT_TRUE(warns(load_bytes(square_with_sets({{"normalTexture", texture(3)}}, 2)),
                      "no TEXCOORD_3: not used: normal map"));
}

// --- unlit --------------------------------------------------------------------------------------

TEST(GltfUnlit, EmitsItsBaseColorAndReflectsNothing) {
    GlbWriter writer = square_with(
        {{"normalTexture", {{"index", 0}}},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.5, 0.25, 0.125, 0.75}}, {"baseColorTexture", {{"index", 0}}}}},
         {"extensions", {{"KHR_materials_unlit", json::object()}}}});
    writer.root["extensionsRequired"] = {"KHR_materials_unlit"};
    Scene scene = load_bytes(writer);
    EXPECT_TRUE(scene.warnings.empty());
    Material material = scene.materials.at(0);
    EXPECT_EQ(material.emissive, glm::vec3(0.5f, 0.25f, 0.125f));
    EXPECT_TRUE(material.emissive_texture);
    EXPECT_EQ(glm::vec3(material.base_color), glm::vec3(0.0f));
    EXPECT_EQ(material.ks, 0.0f);
    EXPECT_FALSE(material.normal_texture);
    EXPECT_FALSE(material.base_color_texture);
    writer.root["materials"][0]["alphaMode"] = "BLEND";
    material = load_bytes(writer).materials.at(0);
    EXPECT_TRUE(material.base_color_texture) << "its alpha is drawn";
    EXPECT_EQ(material.base_color.a, 0.75f);
    writer.root["images"][0] = {{"uri", "gone.png"}};
    EXPECT_EQ(load_bytes(writer).materials.at(0).emissive, glm::vec3(0.5f, 0.25f, 0.125f))
        << "the factor alone";
}

// --- instances ----------------------------------------------------------------------------------

GlbWriter squares_placed(const json& attributes, GlbWriter writer = square_with(json::object())) {
    writer.root["nodes"][0]["translation"] = {10, 0, 0};
    writer.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
    writer.root["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    return writer;
}

TEST(GltfInstances, ArePlacedByTheNodeAndTheirAttributes) {
    GlbWriter writer = square_with(json::object());
    const std::vector<glm::vec3> places = {{1, 2, 3}, {0, 0, -1}};
    // A quarter turn about z, and none, as normalized 16-bit integers.
    const std::vector<std::array<std::int16_t, 4>> turns = {{0, 0, 23170, 23170}, {0, 0, 0, 32767}};
    const std::vector<glm::vec3> scales = {{2, 1, 1}, {1, 1, 1}};
    json attributes;
    attributes["TRANSLATION"] = writer.add_items(places, 5126, "VEC3");
    attributes["ROTATION"] = writer.add_items(turns, 5122, "VEC4");
    attributes["SCALE"] = writer.add_items(scales, 5126, "VEC3");
    writer.root["accessors"][attributes["ROTATION"].get<std::size_t>()]["normalized"] = true;
    const Scene scene = load_bytes(squares_placed(attributes, writer));
    EXPECT_TRUE(scene.warnings.empty());
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    const auto at = [&](std::size_t i, glm::vec3 p) {
        return glm::vec3(scene.instances[i].transform * glm::vec4(p, 1.0f));
    };
    // (1, 0, 0) is scaled to (2, 0, 0), turned to (0, 2, 0), moved by (1, 2, 3), then by the node.
    EXPECT_LT(glm::distance(at(0, {1, 0, 0}), {11, 4, 3}), 1e-4f);
    EXPECT_LT(glm::distance(at(1, {1, 0, 0}), {11, 0, -1}), 1e-4f);
}

TEST(GltfInstances, BrokenOnesAreNamed) {
    GlbWriter writer = square_with(json::object());
    const std::vector<glm::vec3> two = {{1, 2, 3}, {0, 0, 0}}, three(3, glm::vec3(1.0f));
    const std::vector<glm::vec4> still(2, glm::vec4(0.0f));
    json attributes;
    attributes["SCALE"] = writer.add_items(two, 5126, "VEC3");
    EXPECT_TRUE(
        warns(load_bytes(squares_placed(attributes, writer)), "1 instances have no volume"));
    attributes["TRANSLATION"] = writer.add_items(three, 5126, "VEC3");
    EXPECT_NE(error_of(squares_placed(attributes, writer)).find("2 elements, as SCALE has"),
              std::string::npos);
    attributes.erase("TRANSLATION");
    attributes["ROTATION"] = writer.add_items(still, 5126, "VEC4");
    EXPECT_NE(error_of(squares_placed(attributes, writer)).find("unit quaternions"),
              std::string::npos);
    attributes.erase("ROTATION");
    attributes["_COLOR"] = attributes["SCALE"];
    EXPECT_TRUE(warns(load_bytes(squares_placed(attributes, writer)), "_COLOR\": not read"));
    // Without bytes of its own, an accessor may have any count.
    GlbWriter many = square_with(json::object());
    many.root["accessors"].push_back(
        {{"componentType", 5126}, {"count", 2'000'000'000}, {"type", "VEC3"}});
    const std::string line =
        error_of(squares_placed({{"TRANSLATION", many.root["accessors"].size() - 1}}, many));
    EXPECT_NE(line.find("at most 4194304 instances"), std::string::npos) << line;
}

// --- documentation ------------------------------------------------------------------------------

// The cells of the rows of the page's tables whose first cell is the name of an extension.
std::set<std::vector<std::string>> rows_of(const std::filesystem::path& page) {
    std::ifstream file(page);
    std::set<std::vector<std::string>> rows;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("| `")) continue;
        std::vector<std::string> cells;
        std::istringstream text(line.substr(2));
        for (std::string cell; std::getline(text, cell, '|');) {
            cell = cell.substr(std::min(cell.find_first_not_of(' '), cell.size()));
            while (!cell.empty() && cell.back() == ' ') cell.pop_back();
            cells.push_back(cell);
        }
        rows.insert(cells);
    }
    return rows;
}

TEST(GltfExtensionsPage, SaysWhatTheReaderDoes) {
    std::set<std::vector<std::string>> expected;
    for (const GltfExtension& one : gltf_extensions()) {
        static constexpr const char* kWords[] = {"drawn", "approximated", "ignored, warned",
                                                 "nothing to draw"};
        expected.insert({"`" + std::string(one.name) + "`", kWords[static_cast<int>(one.support)],
                         std::string(one.effect)});
    }
    EXPECT_EQ(rows_of(test::source_folder() / "docs/reference/gltf.md"), expected);
}

}  // namespace
}  // namespace burnish
