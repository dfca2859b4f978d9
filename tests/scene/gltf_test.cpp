// Geometry and structure of glTF files, written by the tests themselves.
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "burnish/error.hpp"
#include "glb_writer.hpp"
#include "scene/load.hpp"
#include "support.hpp"

namespace burnish {
namespace {

using nlohmann::json;
using test::error_line;

Scene load_bytes(const GlbWriter& writer) {
    const TemporaryFolder folder;
    return load_gltf(folder.write("model.glb", writer.glb()));
}

std::string error_of(const GlbWriter& writer) {
    return error_line([&] { load_bytes(writer); });
}

bool warns(const Scene& scene, std::string_view text) {
    for (const std::string& line : scene.warnings)
        if (line.find(text) != std::string::npos) return true;
    return false;
}

GlbWriter square_writer(const GlbPrimitive& primitive) {
    GlbWriter writer;
    writer.add_node(writer.add_mesh(primitive));
    return writer;
}

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
    const Scene scene = load_bytes(square_writer(square));
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
    const GlbWriter writer = square_writer(square);
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
    const GlbWriter writer = square_writer(unit_square(1, false));
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
    const Scene strip = load_bytes(square_writer(primitive));
    EXPECT_EQ(strip.meshes.at(0).indices, (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
    primitive.mode = 6;
    const Scene fan = load_bytes(square_writer(primitive));
    EXPECT_EQ(fan.meshes.at(0).indices, (Indices{1, 2, 0, 2, 3, 0, 3, 4, 0}));
    for (const int mode : {0, 1, 2, 3}) {
        primitive.mode = mode;
        const Scene lines = load_bytes(square_writer(primitive));
        EXPECT_TRUE(lines.instances.empty());
        EXPECT_TRUE(warns(lines, "points and lines are not drawn"));
    }
    primitive.mode = 7;
    EXPECT_NE(error_of(square_writer(primitive)).find("mode"), std::string::npos);
}

TEST(Gltf, MissingNormalsAreFlat) {
    GlbPrimitive primitive;
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    primitive.tangents.assign(4, {0, 1, 0, 1});  // without normals these are void
    primitive.indices = {0, 1, 2, 0, 3, 1};
    const Scene scene = load_bytes(square_writer(primitive));
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

// Every component type, normalised or not, with a stride.
template <class Component>
void expect_component(int code, bool normalized, float scale) {
    const std::array<Component, 12> raw = {0, 0, 1, 99, 2, 0, 1, 99, 0, 2, 100, 99};
    const std::size_t stride = (4 * sizeof(Component) + 3) / 4 * 4;
    std::vector<std::byte> bytes(3 * stride);
    for (std::size_t i = 0; i < 3; ++i)
        std::memcpy(bytes.data() + i * stride, raw.data() + 4 * i, 4 * sizeof(Component));
    GlbWriter writer;
    const int view = writer.add_view(bytes);
    writer.root["bufferViews"][0]["byteStride"] = stride;
    const int accessor = writer.add_accessor(view, code, 3, "VEC3");
    writer.root["accessors"][0]["normalized"] = normalized;
    writer.root["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", accessor}}}}}}});
    writer.add_node(0);
    const Scene scene = load_bytes(writer);
    for (std::size_t i = 0; i < 3; ++i) {
        for (int c = 0; c < 3; ++c)
            EXPECT_FLOAT_EQ(scene.meshes.at(0).positions[i][c],
                            scale * static_cast<float>(raw[4 * i + static_cast<std::size_t>(c)]))
                << code;
    }
}

TEST(GltfAccessors, ComponentTypes) {
    expect_component<float>(5126, false, 1.0f);
    expect_component<std::int8_t>(5120, false, 1.0f);
    expect_component<std::uint8_t>(5121, false, 1.0f);
    expect_component<std::int16_t>(5122, false, 1.0f);
    expect_component<std::uint16_t>(5123, false, 1.0f);
    expect_component<std::uint32_t>(5125, false, 1.0f);
    expect_component<std::int8_t>(5120, true, 1.0f / 127.0f);
    expect_component<std::uint8_t>(5121, true, 1.0f / 255.0f);
    expect_component<std::int16_t>(5122, true, 1.0f / 32767.0f);
    expect_component<std::uint16_t>(5123, true, 1.0f / 65535.0f);
}

TEST(GltfAccessors, MostNegativeIntegerIsMinusOne) {
    GlbWriter writer;
    const std::vector<std::int8_t> raw = {-128, -127, 0, 0, 127, 0, 0, 0, 0, 0, 127, 0};
    const int accessor =
        writer.add_accessor(writer.add_view(std::as_bytes(std::span(raw))), 5120, 3, "VEC3");
    writer.root["bufferViews"][0]["byteStride"] = 4;
    writer.root["accessors"][0]["normalized"] = true;
    writer.root["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", accessor}}}}}}});
    writer.add_node(0);
    const Scene scene = load_bytes(writer);
    EXPECT_EQ(scene.meshes.at(0).positions[0], glm::vec3(-1.0f, -1.0f, 0.0f));
}

TEST(GltfAccessors, IndexTypes) {
    const std::vector<std::uint8_t> bytes = {0, 1, 2, 1, 3, 2};
    const std::vector<std::uint16_t> shorts(bytes.begin(), bytes.end());
    const std::vector<std::uint32_t> longs(bytes.begin(), bytes.end());
    GlbPrimitive square = unit_square(1, false);
    for (const int code : {5121, 5123, 5125}) {
        GlbWriter writer = square_writer(square);
        const int indices = code == 5121   ? writer.add_items(bytes, code, "SCALAR")
                            : code == 5123 ? writer.add_items(shorts, code, "SCALAR")
                                           : writer.add_items(longs, code, "SCALAR");
        writer.root["meshes"][0]["primitives"][0]["indices"] = indices;
        EXPECT_EQ(load_bytes(writer).meshes.at(0).indices, longs);
    }
    GlbWriter writer = square_writer(square);
    writer.root["meshes"][0]["primitives"][0]["indices"] = writer.add_items(shorts, 5122, "SCALAR");
    EXPECT_NE(error_of(writer).find("componentType"), std::string::npos);
}

TEST(GltfAccessors, SparseReplacesSomeElements) {
    GlbPrimitive square = unit_square(2, false);
    GlbWriter writer = square_writer(square);
    const std::vector<std::uint16_t> indices = {1, 8};
    const std::vector<glm::vec3> values = {{5, 6, 7}, {-1, -2, -3}};
    const int index_view = writer.add_view(std::as_bytes(std::span(indices)));
    const int value_view = writer.add_view(std::as_bytes(std::span(values)));
    json& accessor = writer.root["accessors"][0];
    accessor["sparse"] = {{"count", 2},
                          {"indices", {{"bufferView", index_view}, {"componentType", 5123}}},
                          {"values", {{"bufferView", value_view}}}};
    square.positions[1] = values[0];
    square.positions[8] = values[1];
    EXPECT_EQ(load_bytes(writer).meshes.at(0).positions, square.positions);

    accessor.erase("bufferView");  // zeros under the sparse ones
    std::vector<glm::vec3> zeros(9, glm::vec3(0.0f));
    zeros[1] = values[0];
    zeros[8] = values[1];
    EXPECT_EQ(load_bytes(writer).meshes.at(0).positions, zeros);

    accessor["sparse"]["count"] = 3;
    EXPECT_NE(error_of(writer).find("sparse"), std::string::npos);
    accessor["sparse"]["count"] = 2;
    accessor["count"] = 8;
    for (std::size_t i = 1; i < 3; ++i) writer.root["accessors"][i]["count"] = 8;
    EXPECT_NE(error_of(writer).find("indices below 8"), std::string::npos);
}

TEST(GltfAccessors, BrokenOnesAreErrors) {
    const GlbWriter good = square_writer(unit_square(1, false));
    const auto broken = [&](const char* pointer, const json& value) {
        GlbWriter writer = good;
        writer.root[json::json_pointer(pointer)] = value;
        return error_of(writer);
    };
    const std::uint64_t huge = 4000000000u;
    EXPECT_NE(broken("/accessors/0/count", huge).find("accessors[0]"), std::string::npos);
    EXPECT_NE(broken("/accessors/0/byteOffset", 8).find("accessors[0]"), std::string::npos);
    EXPECT_NE(broken("/accessors/0/byteOffset", ~std::uint64_t{0} >> 1).find("accessors[0]"),
              std::string::npos);
    EXPECT_NE(broken("/accessors/0/bufferView", 77).find("index below"), std::string::npos);
    EXPECT_NE(broken("/accessors/0/type", "VEC2").find("VEC3"), std::string::npos);
    EXPECT_NE(broken("/accessors/0/componentType", 5130).find("componentType"), std::string::npos);
    EXPECT_NE(broken("/bufferViews/0/byteLength", huge).find("bufferViews[0]"), std::string::npos);
    EXPECT_NE(broken("/bufferViews/0/byteOffset", ~std::uint64_t{0} >> 1).find("bufferViews[0]"),
              std::string::npos);
    EXPECT_NE(broken("/bufferViews/0/buffer", 1).find("buffer"), std::string::npos);
    EXPECT_NE(broken("/accessors/1/count", 3).find("as POSITION has"), std::string::npos);
    EXPECT_NE(broken("/meshes/0/primitives/0/indices", 9).find("accessor"), std::string::npos);
    EXPECT_NE(broken("/meshes/0/primitives/0/material", 0).find("material"), std::string::npos);
    // No bytes at all behind four billion zeros.
    GlbWriter writer = good;
    writer.root["accessors"][0].erase("bufferView");
    writer.root["accessors"][0]["count"] = huge;
    writer.root["meshes"][0]["primitives"][0].erase("indices");
    EXPECT_NE(error_of(writer).find("in proportion to the file"), std::string::npos);
}

TEST(Gltf, IndicesAndPositionsAreChecked) {
    GlbPrimitive square = unit_square(1, false);
    square.indices[3] = 4;
    EXPECT_NE(error_of(square_writer(square)).find("indices below 4"), std::string::npos);
    square = unit_square(1, false);
    for (const float bad : {std::nanf(""), INFINITY, 1e30f}) {
        square.positions[2].y = bad;
        EXPECT_NE(error_of(square_writer(square)).find("POSITION"), std::string::npos);
    }
    square = unit_square(1, true);
    square.normals[0] = glm::vec3(std::nanf(""));
    square.tangents[1] = glm::vec4(0.0f);
    square.texcoord0[2].x = std::nanf("");
    const Scene scene = load_bytes(square_writer(square));
    EXPECT_TRUE(warns(scene, "2 vertices had broken normals or tangents"));
    EXPECT_TRUE(warns(scene, "TEXCOORD_0"));
    EXPECT_EQ(scene.meshes[0].normals[0].z, 1.0f);
    EXPECT_EQ(scene.meshes[0].texcoord0[2].x, 0.0f);
}

TEST(Gltf, NodesCompose) {
    GlbWriter writer;
    const int mesh = writer.add_mesh(unit_square(1, true));
    // child (matrix: moved by x) of parent (turned by 90 degrees about z, scaled, moved).
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
    // (11, 1, 1) scaled (22, 3, -1), turned (-3, 22, -1), moved (-3, 22, 4).
    EXPECT_NEAR(p.x, -3.0f, 1e-4f);
    EXPECT_NEAR(p.y, 22.0f, 1e-4f);
    EXPECT_NEAR(p.z, 4.0f, 1e-4f);
    writer.root.erase("scene");  // then the first one, which is empty
    EXPECT_TRUE(warns(load_bytes(writer), "nothing to draw"));
    writer.root.erase("scenes");  // then all roots
    EXPECT_EQ(load_bytes(writer).instances.size(), 1u);
}

TEST(Gltf, BrokenNodesAreErrors) {
    GlbWriter writer = square_writer(unit_square(1, true));
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
    GlbWriter writer = square_writer(unit_square(1, true));
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

// Puts a compressed copy of view `index` in place of its bytes; the buffer it names holds nothing.
void compress_view(GlbWriter& writer, int index, std::span<const unsigned char> bytes,
                   std::size_t stride, std::size_t count, const char* mode, const char* filter) {
    const int copy = writer.add_view(std::as_bytes(bytes));
    const auto i = static_cast<std::size_t>(index);
    json source = writer.root["bufferViews"][static_cast<std::size_t>(copy)];
    source["byteStride"] = stride;
    source["count"] = count;
    source["mode"] = mode;
    source["filter"] = filter;
    writer.root["bufferViews"][i]["buffer"] = 1;
    writer.root["bufferViews"][i]["byteOffset"] = 0;
    writer.root["bufferViews"][i]["byteLength"] = stride * count;
    writer.root["bufferViews"][i]["extensions"]["EXT_meshopt_compression"] = source;
}

template <class Item>
std::vector<unsigned char> encoded(const std::vector<Item>& items) {
    std::vector<unsigned char> out(meshopt_encodeVertexBufferBound(items.size(), sizeof(Item)));
    out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), items.data(), items.size(),
                                          sizeof(Item)));
    return out;
}

GlbWriter meshopt_writer(const GlbPrimitive& square) {
    GlbWriter writer = square_writer(square);
    const std::size_t vertices = square.positions.size();
    const std::size_t corners = square.indices.size();
    compress_view(writer, 0, encoded(square.positions), 12, vertices, "ATTRIBUTES", "NONE");
    std::vector<std::array<std::int8_t, 4>> octahedral(vertices);
    std::vector<glm::vec4> normals;
    for (const glm::vec3 n : square.normals) normals.emplace_back(n, 0.0f);
    meshopt_encodeFilterOct(octahedral.data(), vertices, 4, 8, &normals.data()->x);
    compress_view(writer, 1, encoded(octahedral), 4, vertices, "ATTRIBUTES", "OCTAHEDRAL");
    writer.root["accessors"][1]["componentType"] = 5120;
    writer.root["accessors"][1]["normalized"] = true;
    writer.root["bufferViews"][1]["byteStride"] = 4;
    std::vector<std::array<std::uint32_t, 2>> exponential(vertices);
    meshopt_encodeFilterExp(exponential.data(), vertices, 8, 20, &square.texcoord0.data()->x);
    compress_view(writer, 2, encoded(exponential), 8, vertices, "ATTRIBUTES", "EXPONENTIAL");
    std::vector<unsigned char> indices(meshopt_encodeIndexBufferBound(corners, vertices));
    indices.resize(
        meshopt_encodeIndexBuffer(indices.data(), indices.size(), square.indices.data(), corners));
    compress_view(writer, 3, indices, 4, corners, "TRIANGLES", "NONE");
    writer.root["buffers"] = {
        {{"byteLength", writer.binary().size()}},
        {{"byteLength", 100000},
         {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
    writer.root["extensionsUsed"] = {"EXT_meshopt_compression", "KHR_mesh_quantization"};
    writer.root["extensionsRequired"] = writer.root["extensionsUsed"];
    return writer;
}

TEST(GltfMeshopt, AttributesTrianglesAndFilters) {
    const GlbPrimitive square = unit_square(15, false);
    GlbWriter writer = meshopt_writer(square);
    const Scene scene = load_bytes(writer);
    const Mesh& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.positions, square.positions);
    ASSERT_EQ(mesh.texcoord0.size(), square.texcoord0.size());
    for (std::size_t i = 0; i < mesh.texcoord0.size(); ++i) {
        EXPECT_NEAR(mesh.texcoord0[i].x, square.texcoord0[i].x, 1e-5f);
        EXPECT_NEAR(mesh.texcoord0[i].y, square.texcoord0[i].y, 1e-5f);
        EXPECT_NEAR(mesh.normals[i].z, 1.0f, 1e-4f);
    }
    // The codec may turn triangles round but not over.
    ASSERT_EQ(mesh.indices.size(), square.indices.size());
    for (std::size_t c = 0; c < mesh.indices.size(); c += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[c]];
        const glm::vec3 b = mesh.positions[mesh.indices[c + 1]];
        EXPECT_GT(glm::cross(b - a, mesh.positions[mesh.indices[c + 2]] - a).z, 0.0f);
    }
}

TEST(GltfMeshopt, IndexSequences) {
    const GlbPrimitive square = unit_square(6, false);
    GlbWriter writer = meshopt_writer(square);
    std::vector<unsigned char> bytes(
        meshopt_encodeIndexSequenceBound(square.indices.size(), square.positions.size()));
    bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), square.indices.data(),
                                             square.indices.size()));
    compress_view(writer, 3, bytes, 4, square.indices.size(), "INDICES", "NONE");
    writer.root["buffers"][0]["byteLength"] = writer.binary().size();
    EXPECT_EQ(load_bytes(writer).meshes.at(0).indices, square.indices);
}

TEST(GltfMeshopt, BrokenViewsAreErrors) {
    const GlbWriter good = meshopt_writer(unit_square(15, false));
    const auto broken = [&](const char* key, const json& value) {
        GlbWriter writer = good;
        writer.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][key] = value;
        return error_of(writer);
    };
    EXPECT_NE(broken("count", 2000000000).find("compressed bytes can hold"), std::string::npos);
    EXPECT_NE(broken("byteStride", 7).find("byteStride"), std::string::npos);
    EXPECT_NE(broken("mode", "OTHER").find("mode"), std::string::npos);
    EXPECT_NE(broken("filter", "QUATERNION").find("filter"), std::string::npos);
    EXPECT_NE(broken("buffer", 1).find("bytes inside"), std::string::npos);
    EXPECT_NE(broken("byteLength", 40).find("bufferViews[0]"), std::string::npos);
    EXPECT_NE(broken("byteOffset", 2000000000).find("bytes inside"), std::string::npos);
    EXPECT_NE(broken("byteLength", "x").find("whole number"), std::string::npos);
}

TEST(Gltf, SampleModelsLoad) {
    const auto data = test::sample_data();
    if (data.empty()) GTEST_SKIP() << "no sample data (set BURNISH_DATA)";
    struct Expected {
        const char* path;
        std::size_t instances, triangles, textures;
    };
    // Triangles as drawn, counted from the files' accessors; textures by colour space.
    const Expected expected[] = {
        {"models/AnisotropyRotationTest/glTF-Binary/AnisotropyRotationTest.glb", 11, 13876, 6},
        {"models/AnisotropyRotationTest/glTF/AnisotropyRotationTest.gltf", 11, 13876, 6},
        {"models/AnisotropyStrengthTest/glTF-Binary/AnisotropyStrengthTest.glb", 50, 97240, 1},
        {"models/ClearCoatTest/glTF-Binary/ClearCoatTest.glb", 27, 37116, 5},
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
