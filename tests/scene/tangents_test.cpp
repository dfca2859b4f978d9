// Tangents against closed forms, against a slow second implementation, and against assets that
// store the results of MikkTSpace.
#include "scene/geometry/tangents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numeric>
#include <random>

#include "formats/gltf/gltf.hpp"
#include "support/glb_writer.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

Mesh mesh_of(const GlbPrimitive& from) {
    Mesh mesh;
    mesh.positions = from.positions;
    mesh.normals = from.normals;
    mesh.texcoord0 = from.texcoord0;
    mesh.indices = from.indices;
    return mesh;
}

double degrees_between(glm::vec3 a, glm::vec3 b) {
    const glm::dvec3 da(a);
    const glm::dvec3 db(b);
    return glm::degrees(std::atan2(glm::length(glm::cross(da, db)), glm::dot(da, db)));
}

void expect_sound(const Mesh& mesh) {
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-5f);
        EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[i])), 1.0f, 1e-5f);
        EXPECT_EQ(std::abs(mesh.tangents[i].w), 1.0f);
        EXPECT_LT(std::abs(glm::dot(mesh.normals[i], glm::vec3(mesh.tangents[i]))), 0.9999f);
    }
}

// A sphere by longitude (u) and latitude, without shared vertices across the seam.
Mesh globe(int rings) {
    Mesh mesh = mesh_of(unit_square(rings, false));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        // Both ends of a circle, and all points of a pole, must be identical to the last bit.
        const glm::vec3 p = mesh.positions[i];
        const float phi = p.x == 1.0f ? 0.0f : glm::two_pi<float>() * p.x;
        const float theta = glm::pi<float>() * (1.0f - p.y);
        const float radius = p.y == 0.0f || p.y == 1.0f ? 0.0f : std::sin(theta);
        mesh.positions[i] = {radius * std::sin(phi), std::cos(theta), radius * std::cos(phi)};
        mesh.normals[i] = mesh.positions[i];
    }
    return mesh;
}

TEST(MakeTangents, SquareWithUnmirroredCoordinates) {
    Mesh mesh = mesh_of(unit_square(3, false));
    make_tangents(mesh);
    ASSERT_EQ(mesh.tangents.size(), 16u);
    for (const glm::vec4 t : mesh.tangents) {
        EXPECT_NEAR(t.x, 1.0f, 1e-6f);
        EXPECT_EQ(t.w, 1.0f);
    }
}

TEST(MakeTangents, BitangentPointsUpInThePicture) {
    // Rotated by 90 degrees and compressed: u runs along +y, the picture's up along -x.
    Mesh mesh = mesh_of(unit_square(2, false));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        mesh.texcoord0[i] = {3.0f * mesh.positions[i].y, mesh.positions[i].x};
    make_tangents(mesh);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec4 t = mesh.tangents[i];
        const glm::vec3 b = t.w * glm::cross(mesh.normals[i], glm::vec3(t));
        EXPECT_NEAR(t.y, 1.0f, 1e-6f);
        EXPECT_NEAR(b.x, -1.0f, 1e-6f);
    }
}

TEST(MakeTangents, MirroredHalvesSplitTheirCommonVertices) {
    Mesh mesh = mesh_of(unit_square(2, false));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        mesh.texcoord0[i].x = std::abs(mesh.positions[i].x - 0.5f);
    make_tangents(mesh);
    EXPECT_EQ(mesh.positions.size(), 9u + 3u);
    for (std::size_t c = 0; c < mesh.indices.size(); c += 3) {
        float center = 0.0f;
        for (std::size_t k = c; k < c + 3; ++k) center += mesh.positions[mesh.indices[k]].x / 3.0f;
        const float side = center < 0.5f ? -1.0f : 1.0f;
        for (std::size_t k = c; k < c + 3; ++k) {
            EXPECT_NEAR(mesh.tangents[mesh.indices[k]].x, side, 1e-6f);
            EXPECT_EQ(mesh.tangents[mesh.indices[k]].w, side);
        }
    }
    expect_sound(mesh);
}

TEST(MakeTangents, GlobePointsEast) {
    Mesh mesh = globe(64);
    make_tangents(mesh);
    expect_sound(mesh);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 p = mesh.positions[i];
        // East is the derivative by longitude. Triangles within a cell of the poles are degenerate.
        if (std::hypot(p.x, p.z) < 0.1f) continue;
        EXPECT_LT(degrees_between(mesh.tangents[i], glm::vec3(p.z, 0.0f, -p.x)), 3.0);
        EXPECT_EQ(mesh.tangents[i].w, 1.0f);
    }
}

TEST(MakeTangents, DoNotDependOnHowVerticesAreShared) {
    Mesh shared = globe(24);
    Mesh apart = shared;
    apart.indices.resize(shared.indices.size());
    std::iota(apart.indices.begin(), apart.indices.end(), 0u);
    apart.positions.clear();
    apart.normals.clear();
    apart.texcoord0.clear();
    for (const std::uint32_t i : shared.indices) {
        apart.positions.push_back(shared.positions[i]);
        apart.normals.push_back(shared.normals[i]);
        apart.texcoord0.push_back(shared.texcoord0[i]);
    }
    make_tangents(shared);
    make_tangents(apart);
    for (std::size_t c = 0; c < shared.indices.size(); ++c) {
        const glm::vec4 a = shared.tangents[shared.indices[c]];
        const glm::vec4 b = apart.tangents[apart.indices[c]];
        EXPECT_LT(degrees_between(a, b), 1e-3);
        EXPECT_EQ(a.w, b.w);
    }
}

// A direct implementation of the definition, for meshes without degenerate triangles: at every
// corner, gather the corners of equal orientation that are connected to it through edges.
class SlowTangents {
  public:
    explicit SlowTangents(const Mesh& mesh) : mesh_(mesh) {}

    glm::vec4 at(std::size_t corner) const {
        std::vector<std::size_t> fan = {corner};
        for (std::size_t k = 0; k < fan.size(); ++k) {
            for (std::size_t other = 0; other < mesh_.indices.size(); ++other) {
                if (std::find(fan.begin(), fan.end(), other) == fan.end() && joined(fan[k], other))
                    fan.push_back(other);
            }
        }
        glm::dvec3 sum(0.0);
        for (const std::size_t k : fan) sum += angle(k) * flat(along_u(k), corner);
        return {glm::vec3(glm::normalize(sum)), preserving(corner) ? 1.0f : -1.0f};
    }

  private:
    std::size_t around(std::size_t corner, std::size_t by) const {
        return corner / 3 * 3 + (corner + by) % 3;
    }
    glm::dvec3 p(std::size_t c) const { return mesh_.positions[mesh_.indices[c]]; }
    glm::dvec2 uv(std::size_t c) const { return mesh_.texcoord0[mesh_.indices[c]]; }
    bool same(std::size_t a, std::size_t b) const {
        const auto i = mesh_.indices[a];
        const auto j = mesh_.indices[b];
        return mesh_.positions[i] == mesh_.positions[j] && mesh_.normals[i] == mesh_.normals[j] &&
               mesh_.texcoord0[i] == mesh_.texcoord0[j];
    }
    bool joined(std::size_t a, std::size_t b) const {
        return same(a, b) && preserving(a) == preserving(b) &&
               (same(around(a, 1), around(b, 2)) || same(around(a, 2), around(b, 1)));
    }
    double area(std::size_t c) const {
        const glm::dvec2 a = uv(around(c, 1)) - uv(c);
        const glm::dvec2 b = uv(around(c, 2)) - uv(c);
        return a.x * b.y - a.y * b.x;
    }
    bool preserving(std::size_t c) const { return area(c) < 0.0; }  // v runs downwards
    glm::dvec3 along_u(std::size_t c) const {
        const glm::dvec2 a = uv(around(c, 1)) - uv(c);
        const glm::dvec2 b = uv(around(c, 2)) - uv(c);
        return (b.y * (p(around(c, 1)) - p(c)) - a.y * (p(around(c, 2)) - p(c))) / area(c);
    }
    glm::dvec3 flat(glm::dvec3 v, std::size_t corner) const {
        const glm::dvec3 n(mesh_.normals[mesh_.indices[corner]]);
        return glm::normalize(v - glm::dot(n, v) * n);
    }
    double angle(std::size_t c) const {
        return std::acos(
            glm::dot(flat(p(around(c, 1)) - p(c), c), flat(p(around(c, 2)) - p(c), c)));
    }

    const Mesh& mesh_;
};

TEST(MakeTangents, AgreeWithTheDefinitionOnRandomSurfaces) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> jitter(-0.05f, 0.05f);
        Mesh mesh = mesh_of(unit_square(6, false));
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            mesh.positions[i] += glm::vec3(jitter(random), jitter(random), 3.0f * jitter(random));
            mesh.normals[i] =
                glm::normalize(glm::vec3(4.0f * jitter(random), 4.0f * jitter(random), 1.0f));
            // Some vertices move to the other side of their neighbors: mirrored triangles.
            mesh.texcoord0[i] += 3.0f * glm::vec2(jitter(random), jitter(random));
        }
        const Mesh before = mesh;
        make_tangents(mesh);
        const SlowTangents slow(before);
        for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
            const glm::vec4 found = mesh.tangents[mesh.indices[c]];
            const glm::vec4 expected = slow.at(c);
            EXPECT_LT(degrees_between(found, expected), 0.02) << "seed " << seed << " corner " << c;
            EXPECT_EQ(found.w, expected.w);
            EXPECT_EQ(mesh.positions[mesh.indices[c]], before.positions[before.indices[c]]);
        }
    }
}

TEST(MakeTangents, DegenerateInputGivesSoundFrames) {
    Mesh mesh = globe(8);  // with triangles without area at the poles
    for (std::size_t i = 0; i < mesh.texcoord0.size(); i += 3) mesh.texcoord0[i] = glm::vec2(0.5f);
    mesh.texcoord0[1] = glm::vec2(kNaN, 1.0f);
    mesh.texcoord0[2] = glm::vec2(1e38f, -1e38f);
    mesh.positions.emplace_back(9.0f);  // an unused vertex
    mesh.normals.emplace_back(0.0f, 1.0f, 0.0f);
    mesh.texcoord0.emplace_back(0.0f);
    make_tangents(mesh);
    expect_sound(mesh);

    Mesh bare = globe(8);
    bare.texcoord0.clear();
    make_tangents(bare);
    expect_sound(bare);
    Mesh flat = globe(8);
    flat.texcoord0.assign(flat.positions.size(), glm::vec2(0.0f));
    make_tangents(flat);
    expect_sound(flat);
    Mesh empty;
    make_tangents(empty);
    EXPECT_TRUE(empty.tangents.empty());
}

TEST(MakeTangents, ManyTrianglesAtOneEdgeOrVertexTakeNoLonger) {
    Mesh mesh;
    const std::uint32_t count = 200000;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}};
    for (std::uint32_t i = 0; i < count; ++i) {
        mesh.positions.emplace_back(0.0f, 1.0f + static_cast<float>(i), 0.0f);
        for (const std::uint32_t k : {0u, 1u, i + 2}) mesh.indices.push_back(k);
    }
    mesh.normals.assign(mesh.positions.size(), {0.0f, 0.0f, 1.0f});
    for (const glm::vec3 p : mesh.positions) mesh.texcoord0.emplace_back(p.x, p.y);
    const auto start = std::chrono::steady_clock::now();
    make_tangents(mesh);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
    expect_sound(mesh);
}

// Fraction of corners within a degree of the stored tangent and of equal handedness.
void expect_close_to_stored(const std::filesystem::path& path) {
    const Scene scene = load_gltf(path);
    for (const Mesh& stored : scene.meshes) {
        Mesh made = stored;
        make_tangents(made);
        std::vector<double> angles;
        std::size_t other_hand = 0;
        for (std::size_t c = 0; c < stored.indices.size(); ++c) {
            const glm::vec4 a = stored.tangents[stored.indices[c]];
            const glm::vec4 b = made.tangents[made.indices[c]];
            angles.push_back(degrees_between(a, b));
            other_hand += a.w != b.w;
        }
        std::sort(angles.begin(), angles.end());
        EXPECT_LT(angles[angles.size() / 2], 0.1) << stored.name;
        EXPECT_LT(angles[angles.size() * 99 / 100], 1.0) << stored.name;
        EXPECT_EQ(other_hand, 0u) << stored.name;
    }
}

// Blender's exporter stores the results of MikkTSpace. (Suzanne of the same collection is not a
// reference: it stores one tangent per face, not perpendicular to the normals, with w = 1
// throughout.)
TEST(MakeTangents, AgreeWithAssetsThatStoreTheirs) {
    const auto data = test::sample_data();
    if (data.empty()) GTEST_SKIP() << "no sample data (set BURNISH_DATA)";
    for (const char* name : {"AnisotropyRotationTest", "AnisotropyStrengthTest"})
        expect_close_to_stored(data / "models" / name / "glTF-Binary" /
                               (std::string(name) + ".glb"));
}

TEST(RepairFrames, ReplacesWhatHasNoDirection) {
    Mesh mesh = mesh_of(unit_square(1, false));
    make_tangents(mesh);
    mesh.normals[0] = glm::vec3(0.0f);
    mesh.normals[1] = {kNaN, 0.0f, 1.0f};
    mesh.tangents[2] = {0.0f, 0.0f, 5.0f, 1.0f};  // parallel to the normal
    mesh.tangents[3] = {1.0f, 0.0f, 0.0f, kNaN};
    EXPECT_EQ(repair_frames(mesh), 4u);
    expect_sound(mesh);
    for (const glm::vec3 n : mesh.normals) EXPECT_NEAR(n.z, 1.0f, 1e-6f);  // face normals
    EXPECT_EQ(repair_frames(mesh), 0u);
}

TEST(RepairFrames, QuantisedLengthsAreNotCounted) {
    Mesh mesh = mesh_of(unit_square(1, true));
    mesh.normals[0] *= 0.99f;
    mesh.tangents.assign(4, {1.01f, 0.0f, 0.0f, -1.0f});
    EXPECT_EQ(repair_frames(mesh), 0u);
    expect_sound(mesh);
    EXPECT_EQ(mesh.tangents[0].w, -1.0f);
    mesh.normals[0] *= 2.0f;
    EXPECT_EQ(repair_frames(mesh), 1u);
    expect_sound(mesh);
}

TEST(MakeNormals, FlatGivesEachTriangleItsOwn) {
    Mesh mesh = globe(8);
    make_normals(mesh, true);
    ASSERT_EQ(mesh.positions.size(), mesh.indices.size());
    for (std::size_t c = 0; c < mesh.indices.size(); c += 3) {
        const glm::vec3 a = mesh.positions[c];
        const glm::vec3 area = glm::cross(mesh.positions[c + 1] - a, mesh.positions[c + 2] - a);
        if (glm::length(area) < 1e-6f) continue;
        for (std::size_t k = c; k < c + 3; ++k)
            EXPECT_LT(degrees_between(mesh.normals[k], area), 0.1);
    }
}

TEST(MakeNormals, SmoothJoinsAcrossTheSeam) {
    Mesh mesh = globe(32);
    make_normals(mesh, false);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        EXPECT_LT(degrees_between(mesh.normals[i], mesh.positions[i]), 3.0);
}

TEST(MakeNormals, TinyTrianglesHaveNormals) {
    Mesh mesh = mesh_of(unit_square(1, false));
    for (glm::vec3& p : mesh.positions) p *= 1e-25f;
    make_normals(mesh, false);
    for (const glm::vec3 n : mesh.normals) EXPECT_NEAR(n.z, 1.0f, 1e-6f);
}

}  // namespace
}  // namespace burnish
