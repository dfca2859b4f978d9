// Geometry and structure of glTF files, written by the tests themselves.
#include "formats/gltf/gltf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "burnish/error.hpp"
#include "burnish/load_model.hpp"
#include "gltf_support.hpp"

namespace burnish {
namespace {

using nlohmann::json;
using test::error_line;
using test::error_of;
using test::load_bytes;
using test::warns;
using test::writer_of;

std::string base64(std::span<const std::byte> bytes) {
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? std::to_integer<unsigned>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

void expect_same_geometry(const Mesh& mesh, const GlbPrimitive& from) {
    EXPECT_EQ(mesh.positions, from.positions);
    EXPECT_EQ(mesh.normals, from.normals);
    EXPECT_EQ(mesh.texcoord0, from.texcoord0);
    EXPECT_EQ(mesh.indices, from.indices);
}

TEST(Gltf, BinaryRoundTrip) {
    GlbPrimitive square = unit_square(3, true);
    square.texcoord1 = square.texcoord0;
    square.colors.assign(square.positions.size(), {0.1f, 0.2f, 0.3f, 0.4f});
    const Scene scene = load_bytes(writer_of(square));
    ASSERT_EQ(scene.meshes.size(), 1u);
    expect_same_geometry(scene.meshes[0], square);
    EXPECT_EQ(scene.meshes[0].tangents, square.tangents);
    EXPECT_EQ(scene.meshes[0].texcoord1, square.texcoord1);
    EXPECT_EQ(scene.meshes[0].colors, square.colors);
    ASSERT_EQ(scene.instances.size(), 1u);
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_TRUE(scene.warnings.empty());
    const Bounds bounds = bounds_of(scene);
    EXPECT_EQ(bounds.low, glm::vec3(0.0f));
    EXPECT_EQ(bounds.high, glm::vec3(1.0f, 1.0f, 0.0f));
}

TEST(Gltf, ExternalAndEmbeddedBuffersGiveTheSame) {
    const GlbPrimitive square = unit_square(2, false);
    const GlbWriter writer = writer_of(square);
    const TemporaryFolder folder;
    folder.write("sub dir/data.bin", writer.binary());
    for (const std::string& uri :
         {std::string("sub%20dir/data.bin"), std::string("./sub dir/../sub%20dir/data.bin"),
          "data:application/octet-stream;base64," + base64(writer.binary())}) {
        const Scene scene = load_gltf(folder.write("model.gltf", writer.gltf(uri)));
        expect_same_geometry(scene.meshes.at(0), square);
    }
}

TEST(Gltf, UrisThatLeadElsewhereAreRefused) {
    const GlbWriter writer = writer_of(unit_square(1, false));
    const TemporaryFolder folder;
    folder.write("data.bin", writer.binary());
    folder.write("inner/unused", std::string_view());
    const std::string absolute = (folder.path() / "data.bin").string();
    for (const std::string& uri :
         {std::string("../data.bin"), std::string("a/../../data.bin"),
          std::string("%2e%2E/data.bin"), absolute, "file://" + absolute,
          std::string("http://example.org/data.bin"), std::string("..\\data.bin"),
          std::string("%00"), std::string("."), std::string("")}) {
        const auto path = folder.write("inner/model.gltf", writer.gltf(uri));
        const std::string line = error_line([&] { load_gltf(path); });
        EXPECT_NE(line.find("buffers[0].uri"), std::string::npos) << line;
        EXPECT_NE(line.find("model.gltf"), std::string::npos) << line;
    }
    const Scene moved = load_gltf(folder.write("model.gltf", writer.gltf("C:\\work\\DATA.bin")));
    EXPECT_EQ(moved.instances.size(), 1u);
    EXPECT_TRUE(test::warns(moved, "buffers[0].uri: "));
    const auto missing = folder.write("model.gltf", writer.gltf("gone.bin"));
    const std::string line = error_line([&] { load_gltf(missing); });
    EXPECT_NE(line.find("model.gltf"), std::string::npos) << line;
    EXPECT_NE(line.find("gone.bin"), std::string::npos) << line;
}

TEST(Gltf, StripsAndFansUnfold) {
    GlbPrimitive primitive;
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
    primitive.normals.assign(5, {0, 0, 1});
    primitive.mode = 5;
    using Indices = std::vector<std::uint32_t>;
    const Scene strip = load_bytes(writer_of(primitive));
    EXPECT_EQ(strip.meshes.at(0).indices, (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
    primitive.mode = 6;
    const Scene fan = load_bytes(writer_of(primitive));
    EXPECT_EQ(fan.meshes.at(0).indices, (Indices{1, 2, 0, 2, 3, 0, 3, 4, 0}));
    for (const int mode : {0, 1, 2, 3}) {
        primitive.mode = mode;
        const Scene lines = load_bytes(writer_of(primitive));
        EXPECT_TRUE(lines.instances.empty());
        EXPECT_TRUE(warns(lines, "points and lines are not drawn"));
    }
    primitive.mode = 7;
    EXPECT_NE(error_of(writer_of(primitive)).find("mode"), std::string::npos);
}

TEST(Gltf, MissingNormalsAreFlat) {
    GlbPrimitive primitive;
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    primitive.tangents.assign(4, {0, 1, 0, 1});  // tangents without normals are ignored
    primitive.indices = {0, 1, 2, 0, 3, 1};
    const Scene scene = load_bytes(writer_of(primitive));
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.positions.size(), 6u);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(mesh.normals[static_cast<std::size_t>(i)].z, 1.0f);
    for (int i = 3; i < 6; ++i) EXPECT_EQ(mesh.normals[static_cast<std::size_t>(i)].y, 1.0f);
    ASSERT_EQ(mesh.tangents.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[i]), mesh.normals[i]), 0.0f, 1e-6f);
}

TEST(Gltf, OnlyTheVerticesInUseAreTaken) {
    GlbWriter writer;
    const int mesh = writer.add_mesh(unit_square(20, true));
    const std::vector<std::uint32_t> indices = {210, 211, 231};
    writer.root["meshes"][0]["primitives"][0]["indices"] =
        writer.add_items(indices, 5125, "SCALAR");
    writer.add_node(mesh);
    const Scene scene = load_bytes(writer);
    const GlbPrimitive whole = unit_square(20, true);
    ASSERT_EQ(scene.meshes[0].positions.size(), 22u);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(scene.meshes[0].positions[scene.meshes[0].indices[c]],
                  whole.positions[indices[c]]);
}

TEST(Gltf, IndicesAndPositionsAreChecked) {
    GlbPrimitive square = unit_square(1, false);
    square.indices[3] = 4;
    EXPECT_NE(error_of(writer_of(square)).find("indices below 4"), std::string::npos);
    square = unit_square(1, false);
    for (const float bad : {std::nanf(""), INFINITY, 1e30f}) {
        square.positions[2].y = bad;
        EXPECT_NE(error_of(writer_of(square)).find("POSITION"), std::string::npos);
    }
    square = unit_square(1, true);
    square.normals[0] = glm::vec3(std::nanf(""));
    square.tangents[1] = glm::vec4(0.0f);
    square.texcoord0[2].x = std::nanf("");
    const Scene scene = load_bytes(writer_of(square));
    EXPECT_TRUE(warns(scene, "2 vertices had broken normals or tangents"));
    EXPECT_TRUE(warns(scene, "TEXCOORD_0"));
    EXPECT_EQ(scene.meshes[0].normals[0].z, 1.0f);
    EXPECT_EQ(scene.meshes[0].texcoord0[2].x, 0.0f);
}

TEST(Gltf, NodesCompose) {
    GlbWriter writer;
    const int mesh = writer.add_mesh(unit_square(1, true));
    // child (matrix: translated by x) of parent (rotated by 90 degrees about z, scaled,
    // translated).
    const float h = std::sqrt(0.5f);
    writer.root["nodes"] = {
        {{"translation", {0, 0, 5}},
         {"rotation", {0, 0, h, h}},
         {"scale", {2, 3, -1}},
         {"children", {1}}},
        {{"mesh", mesh}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 0, 0, 1}}}};
    writer.root["scenes"] = {{{"nodes", json::array()}}, {{"nodes", {0}}}};
    writer.root["scene"] = 1;
    const Scene scene = load_bytes(writer);
    ASSERT_EQ(scene.instances.size(), 1u);
    const glm::vec4 p = scene.instances[0].transform * glm::vec4(1.0f, 1.0f, 1.0f, 1.0f);
    // (11, 1, 1), scaled (22, 3, -1), rotated (-3, 22, -1), translated (-3, 22, 4).
    EXPECT_NEAR(p.x, -3.0f, 1e-4f);
    EXPECT_NEAR(p.y, 22.0f, 1e-4f);
    EXPECT_NEAR(p.z, 4.0f, 1e-4f);
    writer.root.erase("scene");  // selects the first scene, which is empty
    EXPECT_TRUE(warns(load_bytes(writer), "nothing to draw"));
    writer.root.erase("scenes");  // selects all roots
    EXPECT_EQ(load_bytes(writer).instances.size(), 1u);
}

TEST(Gltf, BrokenNodesAreErrors) {
    GlbWriter writer = writer_of(unit_square(1, true));
    json& nodes = writer.root["nodes"];
    nodes[0]["children"] = {0};
    EXPECT_NE(error_of(writer).find("cycle"), std::string::npos);
    nodes = {{{"children", {1, 2}}}, {{"children", {2}}}, {{"mesh", 0}}};
    EXPECT_NE(error_of(writer).find("two parents"), std::string::npos);
    nodes = {{{"children", {7}}}};
    EXPECT_NE(error_of(writer).find("index below 1"), std::string::npos);
    nodes = {{{"mesh", 3}}};
    EXPECT_NE(error_of(writer).find("nodes[0].mesh"), std::string::npos);
    nodes = {{{"mesh", 0}, {"scale", {1e30, 1, 1}}}};
    EXPECT_NE(error_of(writer).find("transform"), std::string::npos);
    nodes = {{{"mesh", 0}, {"rotation", {0, 0, 0, 0}}}};
    EXPECT_NE(error_of(writer).find("unit quaternion"), std::string::npos);
    nodes = {{{"mesh", 0}, {"scale", {1, 0, 1}}}};
    EXPECT_TRUE(warns(load_bytes(writer), "flattens"));
    writer.root["scene"] = 5;
    EXPECT_NE(error_of(writer).find("scene"), std::string::npos);
}

TEST(Gltf, DeepNestingOfNodesIsFine) {
    GlbWriter writer;
    writer.add_mesh(unit_square(1, true));
    constexpr int kDepth = 100000;
    for (int i = 0; i < kDepth; ++i) writer.root["nodes"].push_back({{"children", {i + 1}}});
    writer.root["nodes"].push_back({{"mesh", 0}});
    writer.root["scenes"][0]["nodes"] = {0};
    EXPECT_EQ(load_bytes(writer).instances.size(), 1u);
}

TEST(Gltf, OnePrimitiveUsedTwiceIsOneMesh) {
    GlbWriter writer;
    const int mesh = writer.add_mesh(unit_square(4, true));
    writer.root["meshes"].push_back(writer.root["meshes"][0]);
    writer.add_node(mesh);
    writer.add_node(mesh + 1);
    const Scene scene = load_bytes(writer);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.instances.size(), 2u);
}

TEST(Gltf, MotionIsLeftOutWithWarnings) {
    GlbWriter writer = writer_of(unit_square(1, true));
    writer.root["animations"] = json::array({json::object()});
    writer.root["skins"] = json::array({{{"joints", {0}}}});
    writer.root["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
    writer.root["meshes"][0]["weights"] = {1.0};
    const Scene scene = load_bytes(writer);
    EXPECT_TRUE(warns(scene, "animations"));
    EXPECT_TRUE(warns(scene, "skins"));
    EXPECT_TRUE(warns(scene, "morph targets"));
    expect_same_geometry(scene.meshes.at(0), unit_square(1, true));
}

TEST(Gltf, SampleModelsLoad) {
    const auto data = test::sample_data();
    if (data.empty()) GTEST_SKIP() << "no sample data (set BURNISH_DATA)";
    struct Expected {
        const char* path;
        std::size_t instances, triangles, textures;
    };
    // Triangles as drawn, counted from the files' accessors; textures by color space.
    const Expected expected[] = {
        {"models/AnisotropyRotationTest/glTF-Binary/AnisotropyRotationTest.glb", 11, 13876, 6},
        {"models/AnisotropyRotationTest/glTF/AnisotropyRotationTest.gltf", 11, 13876, 6},
        {"models/AnisotropyStrengthTest/glTF-Binary/AnisotropyStrengthTest.glb", 50, 97240, 1},
        {"models/ClearCoatTest/glTF-Binary/ClearCoatTest.glb", 27, 37116, 6},
        {"models/NormalTangentTest/glTF-Binary/NormalTangentTest.glb", 1, 7774, 3},
        {"models/Suzanne/glTF/Suzanne.gltf", 1, 3936, 2},
        {"meshes/materialx_shaderball.glb", 2, 88264, 0},
    };
    for (const Expected& model : expected) {
        const Scene scene = load_model((data / model.path).string());
        std::size_t triangles = 0;
        for (const Instance& instance : scene.instances)
            triangles += scene.meshes[static_cast<std::size_t>(instance.mesh)].indices.size() / 3;
        EXPECT_EQ(scene.instances.size(), model.instances) << model.path;
        EXPECT_EQ(triangles, model.triangles) << model.path;
        EXPECT_EQ(scene.textures.size(), model.textures) << model.path;
    }
}

}  // namespace
}  // namespace burnish
