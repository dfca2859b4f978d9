// KHR_draco_mesh_compression: against the same mesh uncompressed, and broken.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "burnish/error.hpp"
#include "gltf_support.hpp"
#include "support/draco_writer.hpp"

namespace burnish {
namespace {

using nlohmann::json;
using test::error_of;
using test::load_bytes;
using test::warns;

// A bent sheet: normals and coordinates are functions of the position, so that vertices in any order
// can be checked.
GlbPrimitive sheet(int cells) {
    GlbPrimitive primitive = unit_square(cells, false);
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
        glm::vec3& p = primitive.positions[i];
        p.z = 0.5f * p.x * p.x;
        primitive.normals[i] = glm::normalize(glm::vec3(-p.x, 0.0f, 1.0f));
    }
    return primitive;
}

GlbWriter compressed(const DracoOptions& options, int cells = 8) {
    GlbWriter writer;
    writer.add_node(add_draco_mesh(writer, sheet(cells), options));
    writer.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return writer;
}

double area_of_sheet(const Mesh& mesh) {
    double area = 0.0;
    for (std::size_t c = 0; c < mesh.indices.size(); c += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[c]];
        const glm::vec3 normal = glm::cross(mesh.positions[mesh.indices[c + 1]] - a,
                                            mesh.positions[mesh.indices[c + 2]] - a);
        area += 0.5 * glm::length(normal);
        EXPECT_GT(normal.z, 0.0f) << "counter-clockwise seen from +z";
    }
    return area;
}

TEST(GltfDraco, IsTheUncompressedMesh) {
    const Mesh plain = load_bytes(test::writer_of(sheet(8))).meshes.at(0);
    for (const DracoOptions& options : {DracoOptions{true, 16}, DracoOptions{false, 16},
                                        DracoOptions{true, 0}, DracoOptions{false, 0}}) {
        const Scene scene = load_bytes(compressed(options));
        EXPECT_TRUE(scene.warnings.empty());
        const Mesh& mesh = scene.meshes.at(0);
        ASSERT_EQ(mesh.positions.size(), plain.positions.size());
        ASSERT_EQ(mesh.indices.size(), plain.indices.size());
        // Steps: positions 2^-16, coordinates 2^-14, normals 2^-9 on the octahedron.
        EXPECT_NEAR(area_of_sheet(mesh), area_of_sheet(plain), 1e-4);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 p = mesh.positions[i];
            EXPECT_NEAR(p.z, 0.5f * p.x * p.x, 5e-5f);
            EXPECT_LT(glm::distance(mesh.texcoord0[i], {p.x, 1.0f - p.y}), 2e-4f);
            EXPECT_LT(glm::distance(mesh.normals[i], glm::normalize(glm::vec3(-p.x, 0, 1))), 5e-3f);
        }
    }
}

TEST(GltfDraco, CountsThatDisagreeAreNamed) {
    GlbWriter writer = compressed({});
    writer.root["accessors"][0]["count"] = 80;
    for (const int i : {1, 2}) writer.root["accessors"][i]["count"] = 80;
    EXPECT_NE(error_of(writer).find("80 vertices, as the accessors have, found 81"),
              std::string::npos)
        << error_of(writer);
    writer = compressed({});
    writer.root["accessors"][3]["count"] = 12;
    EXPECT_NE(error_of(writer).find("12 indices, as the accessor has, found 384"),
              std::string::npos);
    writer = compressed({});
    json& draco =
        writer.root["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
    draco["attributes"]["NORMAL"] = 77;
    EXPECT_NE(error_of(writer).find("an attribute of id 77"), std::string::npos);
    draco["attributes"]["NORMAL"] = draco["attributes"]["TEXCOORD_0"];
    EXPECT_NE(error_of(writer).find("components"), std::string::npos);
    draco["bufferView"] = 9;
    EXPECT_NE(error_of(writer).find("bufferView"), std::string::npos);
}

TEST(GltfDraco, ABrokenOneIsDrawnFromItsUncompressedData) {
    GlbWriter writer = test::writer_of(sheet(2));
    const std::vector<std::byte> noise(64, std::byte{0x5A});
    const int view = writer.add_view(noise);
    writer.root["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", {{"POSITION", 0}}}};
    const Scene scene = load_bytes(writer);
    EXPECT_EQ(scene.meshes.at(0).positions.size(), 9u);
    EXPECT_TRUE(warns(scene, "the uncompressed data are used"));
}

// Headers that ask for memory: each is refused before libdraco allocates.
TEST(GltfDraco, HeadersAreHeldAgainstTheAccessors) {
    const auto refused = [](std::vector<std::uint8_t> bytes, const json& count) {
        GlbWriter writer = compressed({});
        const int view = writer.add_view(std::as_bytes(std::span(bytes)));
        writer.root["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]
                   ["bufferView"] = view;
        if (!count.is_null()) writer.root["accessors"][3]["count"] = count;
        return error_of(writer);
    };
    const std::vector<std::uint8_t> start = {'D', 'R', 'A', 'C', 'O', 2, 2, 1, 1, 0, 0};
    const auto with = [&](std::initializer_list<std::uint8_t> more) {
        std::vector<std::uint8_t> bytes = start;
        bytes.insert(bytes.end(), more);
        return bytes;
    };
    EXPECT_NE(refused({'D', 'R'}, {}).find("Draco data"), std::string::npos);
    std::vector<std::uint8_t> other = with({0, 1, 1});
    other[6] = 1;
    EXPECT_NE(refused(other, {}).find("2.2"), std::string::npos);
    other = with({0, 1, 1});
    other[7] = 0;
    EXPECT_NE(refused(other, {}).find("point cloud"), std::string::npos);
    other = with({0, 1, 1});
    other[10] = 0x80;
    EXPECT_NE(refused(other, {}).find("metadata"), std::string::npos);
    // 2^31 triangles where the accessor has 128, and where it has as many.
    const auto many = with({0, 3, 0x80, 0x80, 0x80, 0x80, 0x08});
    EXPECT_NE(refused(many, {}).find("384 indices"), std::string::npos);
    EXPECT_NE(refused(many, 3ull << 31).find("MiB"), std::string::npos)
        << refused(many, 3ull << 31);
}

// Changed bytes give a scene or one line; the fuzzer goes further (tests/fuzz).
TEST(GltfDraco, ChangedBytesGiveASceneOrOneLine) {
    std::mt19937 random(7);
    for (const bool edgebreaker : {true, false}) {
        const std::vector<std::byte> whole = compressed({edgebreaker, 11}, 3).glb();
        const TemporaryFolder folder;
        for (int round = 0; round < 300; ++round) {
            std::vector<std::byte> bytes = whole;
            for (int i = 0; i < 3; ++i) {
                // The compressed data are the last part of the file.
                const std::size_t at = bytes.size() - 1 - random() % 200;
                bytes[at] = static_cast<std::byte>(random() & 0xFF);
            }
            const auto path = folder.write("m.glb", bytes);
            try {
                const Scene scene = load_gltf(path);
                for (const Mesh& mesh : scene.meshes)
                    for (const std::uint32_t i : mesh.indices) ASSERT_LT(i, mesh.positions.size());
            } catch (const Error& error) {
                EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            }
        }
    }
}

}  // namespace
}  // namespace burnish
