// Broken and malicious glTF files: every input gives either an Error of one line or a valid scene.
// These tests are useful under the address and undefined-behavior sanitizers too.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <glm/geometric.hpp>
#include <random>

#include "burnish/error.hpp"
#include "burnish/load_model.hpp"
#include "formats/gltf/gltf.hpp"
#include "support/glb_writer.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using nlohmann::json;
using test::error_line;

// Checks every property that a renderer relies on.
void expect_sound(const Scene& scene) {
    const auto inside = [](int index, std::size_t size) {
        return index >= 0 && static_cast<std::size_t>(index) < size;
    };
    for (const Mesh& mesh : scene.meshes) {
        const std::size_t vertices = mesh.positions.size();
        ASSERT_EQ(mesh.normals.size(), vertices);
        ASSERT_EQ(mesh.tangents.size(), vertices);
        ASSERT_EQ(mesh.indices.size() % 3, 0u);
        for (const std::uint32_t i : mesh.indices) ASSERT_LT(i, vertices);
        for (std::size_t i = 0; i < vertices; ++i) {
            ASSERT_LE(glm::length(mesh.positions[i]), 2e9f);
            ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-3f);
            ASSERT_NEAR(glm::length(glm::vec3(mesh.tangents[i])), 1.0f, 1e-3f);
            ASSERT_EQ(std::abs(mesh.tangents[i].w), 1.0f);
        }
        for (const glm::vec2 uv : mesh.texcoord0) ASSERT_TRUE(std::isfinite(uv.x + uv.y));
        for (const glm::vec4 c : mesh.colors) ASSERT_TRUE(std::isfinite(c.r + c.g + c.b + c.a));
    }
    for (const Instance& instance : scene.instances) {
        ASSERT_TRUE(inside(instance.mesh, scene.meshes.size()));
        ASSERT_TRUE(inside(instance.material, scene.materials.size()));
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) ASSERT_TRUE(std::isfinite(instance.transform[c][r]));
    }
    for (const Material& material : scene.materials) {
        ASSERT_LT(material.normal_texture.texture, static_cast<int>(scene.textures.size()));
        ASSERT_LT(material.base_color_texture.texture, static_cast<int>(scene.textures.size()));
        ASSERT_TRUE(std::isfinite(gltf_lobe_of(material)->roughness + material.metallic +
                                  material.emissive.r + material.anisotropy_rotation +
                                  material.dielectric_f0));
    }
    for (const Texture& texture : scene.textures) {
        const std::size_t bytes = texture.type == TexelType::u8    ? 1
                                  : texture.type == TexelType::u16 ? 2
                                                                   : 4;
        ASSERT_EQ(texture.texels.size(), bytes * static_cast<std::size_t>(texture.width) *
                                             static_cast<std::size_t>(texture.height) *
                                             static_cast<std::size_t>(texture.channels));
    }
}

// Returns whether the file was loaded.
bool attempt(const std::filesystem::path& path) {
    try {
        expect_sound(load_gltf(path));
        return true;
    } catch (const Error& error) {
        EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos)
            << error.what();
    }
    return false;
}

// A file with every kind of element.
GlbWriter rich_writer() {
    GlbWriter writer;
    const int texture = writer.add_png(png_gradient(3, 3));
    writer.root["textures"][0]["sampler"] = 0;
    writer.root["samplers"] = {{{"wrapS", 33071}}};
    GlbPrimitive square = unit_square(2, true);
    square.texcoord1 = square.texcoord0;
    square.colors.assign(square.positions.size(), glm::vec4(0.5f));
    square.material = writer.add_material(
        {{"name", "m"},
         {"normalTexture",
          {{"index", texture},
           {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}, {"rotation", 1}}}}}}},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {1, 1, 1, 1}}, {"baseColorTexture", {{"index", texture}}}}},
         {"extensions", {{"KHR_materials_anisotropy", {{"anisotropyStrength", 0.5}}}}}});
    writer.add_node(writer.add_mesh(square));
    writer.add_node(writer.add_mesh(unit_square(1, false)));
    const std::vector<std::uint16_t> indices = {0, 2};
    const std::vector<glm::vec3> values = {{1, 2, 3}, {4, 5, 6}};
    const int index_view = writer.add_view(std::as_bytes(std::span(indices)));
    const int value_view = writer.add_view(std::as_bytes(std::span(values)));
    writer.root["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", index_view}, {"componentType", 5123}}},
        {"values", {{"bufferView", value_view}}}};
    writer.root["nodes"][1]["translation"] = {1, 2, 3};
    writer.root["nodes"][1]["camera"] = 0;
    writer.root["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    writer.root["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    writer.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    return writer;
}

TEST(GltfHostile, TheUnbrokenFileLoads) {
    const TemporaryFolder folder;
    EXPECT_TRUE(attempt(folder.write("model.glb", rich_writer().glb())));
}

TEST(GltfHostile, TruncatedBinariesAreErrors) {
    const TemporaryFolder folder;
    const std::vector<std::byte> whole = rich_writer().glb();
    for (std::size_t length = 0; length < whole.size(); length += length < 40 ? 1 : 61)
        EXPECT_FALSE(attempt(folder.write("model.glb", std::span(whole).first(length)))) << length;
}

TEST(GltfHostile, TruncatedTextIsAnError) {
    const TemporaryFolder folder;
    const GlbWriter writer = rich_writer();
    folder.write("data.bin", writer.binary());
    const std::string whole = writer.gltf("data.bin");
    ASSERT_TRUE(attempt(folder.write("model.gltf", whole)));
    for (std::size_t length = 0; length + 2 < whole.size(); length += 53)
        EXPECT_FALSE(attempt(folder.write("model.gltf", whole.substr(0, length)))) << length;
    for (std::size_t length = 0; length < writer.binary().size(); length += 97) {
        folder.write("data.bin", std::span(writer.binary()).first(length));
        EXPECT_FALSE(attempt(folder.write("model.gltf", whole))) << length;
    }
}

TEST(GltfHostile, FlippedBytesNeverCrash) {
    const TemporaryFolder folder;
    const std::vector<std::byte> whole = rich_writer().glb();
    const std::size_t json_bytes = whole.size() - rich_writer().binary().size() - 8;
    for (unsigned seed = 0; seed < 300; ++seed) {
        std::mt19937 random(seed);
        std::vector<std::byte> bytes = whole;
        // Half of the changes are in header and JSON, half in the binary chunk.
        const std::size_t first = seed % 2 == 0 ? 0 : json_bytes;
        const std::size_t end = seed % 2 == 0 ? json_bytes : bytes.size();
        for (unsigned k = 0; k < 1 + seed % 5; ++k)
            bytes[first + random() % (end - first)] = static_cast<std::byte>(random());
        attempt(folder.write("model.glb", bytes));
    }
}

// Collects the pointers to all values of a document, leaves and containers.
void collect(const json& value, const json::json_pointer& here,
             std::vector<json::json_pointer>& out) {
    out.push_back(here);
    if (value.is_object())
        for (const auto& [key, item] : value.items()) collect(item, here / key, out);
    if (value.is_array())
        for (std::size_t i = 0; i < value.size(); ++i) collect(value[i], here / i, out);
}

TEST(GltfHostile, AnyValueAtAnyPlace) {
    const TemporaryFolder folder;
    const GlbWriter good = rich_writer();
    std::vector<json::json_pointer> places;
    collect(good.root, json::json_pointer(), places);
    ASSERT_GT(places.size(), 150u);
    const json values[] = {nullptr,
                           -1,
                           0,
                           4294967296,
                           1e39,
                           "text",
                           json::array(),
                           json::object(),
                           {1, 2, "x"},
                           true,
                           99999,
                           18446744073709551615u,
                           {{"index", 9}}};
    std::mt19937 random(7);
    for (const json::json_pointer& place : places) {
        for (int k = 0; k < 2; ++k) {
            GlbWriter writer = good;
            writer.root[place] = values[random() % std::size(values)];
            if (!writer.root.is_object()) continue;
            attempt(folder.write("model.glb", writer.glb()));
        }
    }
}

TEST(GltfHostile, EveryKeyMayBeMissing) {
    const TemporaryFolder folder;
    const GlbWriter good = rich_writer();
    std::vector<json::json_pointer> places;
    collect(good.root, json::json_pointer(), places);
    for (const json::json_pointer& place : places) {
        if (place.empty()) continue;
        GlbWriter writer = good;
        json& parent = writer.root[place.parent_pointer()];
        if (parent.is_array())
            parent.erase(static_cast<std::size_t>(std::stoul(place.back())));
        else
            parent.erase(place.back());
        attempt(folder.write("model.glb", writer.glb()));
    }
}

std::string error_of_text(const std::string& text) {
    const TemporaryFolder folder;
    const auto path = folder.write("model.gltf", text);
    return error_line([&] { load_gltf(path); });
}

TEST(GltfHostile, DeepAndEndlessJson) {
    const std::string head = R"({"asset":{"version":"2.0"},"extras":)";
    for (const int depth : {100, 1000000}) {
        const auto count = static_cast<std::size_t>(depth);
        EXPECT_NE(error_of_text(head + std::string(count, '[')).find("levels"), std::string::npos);
        EXPECT_NE(error_of_text(head + std::string(count, '[') + std::string(count, ']') + "}")
                      .find("levels"),
                  std::string::npos);
        std::string objects;
        for (int i = 0; i < depth; ++i) objects += "{\"a\":";
        EXPECT_NE(error_of_text(head + objects).find("levels"), std::string::npos);
    }
    std::string many = head + "[0";
    for (int i = 0; i < 5000000; ++i) many += ",0";
    EXPECT_NE(error_of_text(many + "]}").find("values"), std::string::npos);
    // Brackets inside strings do not count.
    const TemporaryFolder folder;
    EXPECT_NO_THROW(
        load_gltf(folder.write("model.gltf", head + "\"" + std::string(1000, '[') + "\\\"" +
                                                 std::string(1000, '{') + "\"}")));
}

TEST(GltfHostile, OtherFilesAndVersions) {
    EXPECT_NE(error_of_text("").find("an empty file"), std::string::npos);
    EXPECT_NE(error_of_text("v 0 0 0\n").find("expected glTF"), std::string::npos);
    EXPECT_NE(error_of_text("{\"asset\":{}}").find("asset.version"), std::string::npos);
    EXPECT_NE(error_of_text("{}").find("asset"), std::string::npos);
    EXPECT_NE(error_of_text("{\"asset\":{\"version\":\"1.0\"}}").find("expected 2.0"),
              std::string::npos);
    EXPECT_NE(error_of_text("{\"asset\":{\"version\":\"2.0\",\"minVersion\":\"2.1\"}}")
                  .find("minVersion"),
              std::string::npos);
    EXPECT_NE(error_of_text("{\"a\": \xFF\xFE}").find("well-formed"), std::string::npos);
    EXPECT_NE(error_of_text("{\"a\": 1e999}").find("well-formed"), std::string::npos);
    const TemporaryFolder folder;
    const auto none = folder.path() / "none.glb";
    EXPECT_NE(error_line([&] { load_model(none.string()); }).find("none.glb"), std::string::npos);
    EXPECT_NE(error_line([&] { load_model(folder.path().string()); }).find("a model"),
              std::string::npos);
    std::vector<std::byte> bytes = rich_writer().glb();
    bytes[4] = std::byte{1};
    const auto old = folder.write("old.glb", bytes);
    EXPECT_NE(error_line([&] { load_gltf(old); }).find("version 2"), std::string::npos);
}

TEST(GltfHostile, SmallFilesCannotUnfoldWithoutEnd) {
    // Many primitives, each with its own accessor of the same bytes.
    GlbWriter writer;
    GlbPrimitive square = unit_square(400, false);
    writer.add_mesh(square);
    json& primitives = writer.root["meshes"][0]["primitives"];
    for (int i = 0; i < 20000; ++i) {
        json accessor = writer.root["accessors"][0];
        writer.root["accessors"].push_back(accessor);
        json primitive = primitives[0];
        primitive["attributes"] = {{"POSITION", writer.root["accessors"].size() - 1}};
        primitives.push_back(primitive);
    }
    writer.add_node(0);
    const TemporaryFolder folder;
    const auto path = folder.write("model.glb", writer.glb());
    EXPECT_NE(error_line([&] { load_gltf(path); }).find("in proportion to the file"),
              std::string::npos);

    // Many nodes, each with a mesh of many primitives.
    GlbWriter crowd;
    crowd.add_mesh(unit_square(1, true));
    json& parts = crowd.root["meshes"][0]["primitives"];
    const json part = parts[0];
    for (int i = 0; i < 3000; ++i) parts.push_back(part);
    for (int i = 0; i < 3000; ++i) crowd.add_node(0);
    const auto second = folder.write("crowd.glb", crowd.glb());
    EXPECT_NE(error_line([&] { load_gltf(second); }).find("meshes drawn"), std::string::npos);
}

}  // namespace
}  // namespace burnish
