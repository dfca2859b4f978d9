// The bytes of glTF files: accessors of every type, and EXT_meshopt_compression.
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "formats/gltf/gltf_meshopt.hpp"
#include "gltf_support.hpp"

namespace burnish {
namespace {

using nlohmann::json;
using test::error_of;
using test::load_bytes;
using test::writer_of;

// Every component type, normalized or not, with a stride.
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
        GlbWriter writer = writer_of(square);
        const int indices = code == 5121   ? writer.add_items(bytes, code, "SCALAR")
                            : code == 5123 ? writer.add_items(shorts, code, "SCALAR")
                                           : writer.add_items(longs, code, "SCALAR");
        writer.root["meshes"][0]["primitives"][0]["indices"] = indices;
        EXPECT_EQ(load_bytes(writer).meshes.at(0).indices, longs);
    }
    GlbWriter writer = writer_of(square);
    writer.root["meshes"][0]["primitives"][0]["indices"] = writer.add_items(shorts, 5122, "SCALAR");
    EXPECT_NE(error_of(writer).find("componentType"), std::string::npos);
}

TEST(GltfAccessors, SparseReplacesSomeElements) {
    GlbPrimitive square = unit_square(2, false);
    GlbWriter writer = writer_of(square);
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

    accessor.erase("bufferView");  // zeros, which the sparse values replace
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

TEST(GltfAccessors, SparseIndices) {
    GlbPrimitive square = unit_square(1, true);
    GlbWriter writer = writer_of(square);
    const std::vector<std::uint8_t> places = {5};
    const std::vector<std::uint32_t> values = {0};
    const int place_view = writer.add_view(std::as_bytes(std::span(places)));
    const int value_view = writer.add_view(std::as_bytes(std::span(values)));
    writer.root["accessors"][4]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", place_view}, {"componentType", 5121}}},
        {"values", {{"bufferView", value_view}}}};
    square.indices[5] = 0;
    EXPECT_EQ(load_bytes(writer).meshes.at(0).indices, square.indices);
}

TEST(GltfAccessors, BrokenOnesAreErrors) {
    const GlbWriter good = writer_of(unit_square(1, false));
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
    // Four billion zeros without any bytes.
    GlbWriter writer = good;
    writer.root["accessors"][0].erase("bufferView");
    writer.root["accessors"][0]["count"] = huge;
    writer.root["meshes"][0]["primitives"][0].erase("indices");
    EXPECT_NE(error_of(writer).find("in proportion to the file"), std::string::npos);
}

// Replaces the bytes of view `index` by a compressed copy; the buffer that it names is empty.
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
    GlbWriter writer = writer_of(square);
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
    // The codec may rotate the corners of a triangle but not reverse their order.
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

TEST(GltfMeshopt, Quaternions) {
    const std::vector<glm::vec4> rotations = {
        {0, 0, 0, 1}, {0.5f, 0.5f, -0.5f, 0.5f}, {0.6f, 0, 0, 0.8f}};
    std::vector<std::array<std::int16_t, 4>> packed(rotations.size());
    meshopt_encodeFilterQuat(packed.data(), packed.size(), 8, 16, &rotations.data()->x);
    const auto bytes = encoded(packed);
    GltfReport report("model.glb");
    MeshoptView view;
    view.bytes = std::as_bytes(std::span(bytes));
    view.count = rotations.size();
    view.stride = 8;
    view.mode = "ATTRIBUTES";
    view.filter = "QUATERNION";
    const auto out = decode_meshopt_view(view, "bufferViews[0]", report);
    ASSERT_EQ(out.size(), 24u);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        std::array<std::int16_t, 4> raw;
        std::memcpy(raw.data(), out.data() + 8 * i, 8);
        const glm::vec4 found = glm::vec4(raw[0], raw[1], raw[2], raw[3]) / 32767.0f;
        // Q and -q are the same rotation.
        EXPECT_NEAR(std::abs(glm::dot(found, rotations[i])), 1.0f, 1e-4f);
    }
}

}  // namespace
}  // namespace burnish
