// Split edges: the mesh stays what it was, no gap opens, and contact shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <set>
#include <tuple>

#include "core/constants.hpp"
#include "shapes.hpp"

namespace burnish::test {
namespace {

constexpr double kHalf = 1.0;  // of the table's width

struct Cylinder {
    glm::dvec3 foot{0.2, 0, -0.1};
    double radius = 0.1, height = 0.3;
};
constexpr int kSegments = 64;

// A table of two triangles under a small cylinder. A bottom lies in the table's own plane.
Scene table(bool bottom = false) {
    const Cylinder c;
    Mesh solid = cylinder(c.foot, c.radius, c.height, kSegments);
    if (bottom) solid = joined(solid, disc(c.foot, c.radius, {0, -1, 0}, kSegments));
    return scene_of({ground(kHalf, 1), solid});
}

// Whether a ray meets the cylinder's side or top; a point within sees none but those.
bool is_behind_cylinder(glm::dvec3 from, glm::dvec3 w) {
    const Cylinder c;
    const glm::dvec3 p = from - c.foot;
    const double a = w.x * w.x + w.z * w.z, b = p.x * w.x + p.z * w.z,
                 q = p.x * p.x + p.z * p.z - c.radius * c.radius;
    const double root = b * b - a * q;
    if (root > 0 && a > 0)
        for (const double t : {(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a}) {
            const double y = p.y + t * w.y;
            if (t > 1e-9 && y >= 0 && y <= c.height) return true;
        }
    if (w.y <= 0) return false;
    const glm::dvec3 top = p + w * ((c.height - p.y) / w.y);
    return std::hypot(top.x, top.z) < c.radius;
}

const Mesh& split_mesh_of(const Visibility& seen, std::size_t instance) {
    const std::shared_ptr<const Mesh>& mesh = seen.instances.at(instance).mesh;
    if (!mesh) throw std::runtime_error("the mesh is not split");
    return *mesh;
}

double area_of(const Mesh& mesh) {
    double area = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return glm::dvec3(mesh.positions[mesh.indices[i + k]]);
        };
        area += glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0))) / 2;
    }
    return area;
}

using PositionKey = std::tuple<float, float, float>;
using Edge = std::pair<PositionKey, PositionKey>;

// How often each edge is used, by position.
void count_edges(const Mesh& mesh, const glm::mat4& transform, std::map<Edge, int>& counts) {
    const auto key = [&](std::uint32_t vertex) {
        const glm::vec4 p = transform * glm::vec4(mesh.positions[vertex], 1.0f);
        // + 0: the keys of -0 and 0 are one.
        return PositionKey{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
    };
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const PositionKey a = key(mesh.indices[i]), b = key(mesh.indices[next]);
        ++counts[std::minmax(a, b)];
    }
}

// Edges within the square are those of two triangles, edges of its outline those of one.
void expect_no_gap(const std::map<Edge, int>& counts) {
    const auto is_outline = [](const Edge& edge) {
        const auto [ax, ay, az] = edge.first;
        const auto [bx, by, bz] = edge.second;
        const auto half = static_cast<float>(kHalf);
        return (ax == bx && std::abs(ax) == half) || (az == bz && std::abs(az) == half);
    };
    std::size_t wrong = 0;
    double outline = 0;
    for (const auto& [edge, count] : counts) {
        if (is_outline(edge)) {
            const auto [ax, ay, az] = edge.first;
            const auto [bx, by, bz] = edge.second;
            outline += std::hypot(static_cast<double>(ax) - static_cast<double>(bx),
                                  static_cast<double>(az) - static_cast<double>(bz));
        }
        if (count != (is_outline(edge) ? 1 : 2)) ++wrong;
    }
    EXPECT_EQ(wrong, 0u) << "of " << counts.size();
    // 1e-5: middles of edges are exact but for rounding of 6e-8, of some hundred edges.
    EXPECT_NEAR(outline, 8 * kHalf, 1e-5);
}

TEST(SplitEdges, KeepAreaPlaneAndTheFirstVertices) {
    const Scene scene = table();
    const auto found = VisibilityFinder(scene, {}).visibility();
    const InstanceVisibility& seen = found->instances.at(0);
    const Mesh &mesh = split_mesh_of(*found, 0), &before = scene.meshes[0];
    ASSERT_GT(mesh.positions.size(), before.positions.size());
    EXPECT_EQ(seen.vertices.size(), mesh.positions.size());
    for (std::size_t i = 0; i < before.positions.size(); ++i) {
        EXPECT_EQ(mesh.positions[i], before.positions[i]);
        EXPECT_EQ(mesh.normals[i], before.normals[i]);
        EXPECT_EQ(mesh.texcoord0[i], before.texcoord0[i]);
        EXPECT_EQ(mesh.tangents[i], before.tangents[i]);
    }
    for (const glm::vec3& position : mesh.positions) EXPECT_EQ(position.y, 0.0f);
    // 1e-6: rounding of positions, 6e-8, over the outline.
    EXPECT_NEAR(area_of(mesh), area_of(before), 1e-6);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return mesh.positions[mesh.indices[i + k]]; };
        EXPECT_GT(glm::cross(corner(1) - corner(0), corner(2) - corner(0)).y, 0.0f)
            << "triangle " << i / 3 << " faces down or has no area";
    }
}

TEST(SplitEdges, InterpolateEveryAttribute) {
    Scene scene = table();
    Mesh& before = scene.meshes[0];
    // Functions of the position, linear over the whole square.
    const auto coordinate = [](const glm::vec3& p) {
        return glm::vec2(0.3f + 0.2f * p.x - 0.5f * p.z, 2.0f - p.x);
    };
    const auto color = [](const glm::vec3& p) {
        return glm::vec4(0.5f + 0.5f * p.x, 0.5f - 0.25f * p.z, 0.125f, 1.0f);
    };
    for (const glm::vec3& p : before.positions) {
        before.texcoord1.push_back(coordinate(p));
        before.colors.push_back(color(p));
    }
    const auto found = VisibilityFinder(scene, {}).visibility();
    const Mesh& mesh = split_mesh_of(*found, 0);
    ASSERT_EQ(mesh.texcoord0.size(), mesh.positions.size());
    ASSERT_EQ(mesh.texcoord1.size(), mesh.positions.size());
    ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    const auto half = static_cast<float>(kHalf);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3& p = mesh.positions[i];
        // 1e-6: rounding of some halvings of numbers of about 1.
        const glm::vec2 wanted((p.x + half) / (2 * half), (half - p.z) / (2 * half));
        EXPECT_LT(glm::length(mesh.texcoord0[i] - wanted), 1e-6f);
        EXPECT_LT(glm::length(mesh.texcoord1[i] - coordinate(p)), 1e-6f);
        EXPECT_LT(glm::length(mesh.colors[i] - color(p)), 1e-6f);
        EXPECT_LT(glm::length(mesh.normals[i] - glm::vec3(0, 1, 0)), 1e-6f);
        EXPECT_LT(glm::length(glm::vec3(mesh.tangents[i]) - glm::vec3(1, 0, 0)), 1e-6f);
        EXPECT_EQ(mesh.tangents[i].w, 1.0f);
    }
    EXPECT_EQ(mesh.tangent_source, before.tangent_source);
}

// On a curved surface normals and tangents are of unit length again.
TEST(SplitEdges, KeepNormalsAndTangentsUnit) {
    const Scene scene =
        scene_of({sphere({0, 1, 0}, 1.0, 4), disc({0, 2.1, 0}, 0.3, {0, -1, 0}, 32)});
    const auto found = VisibilityFinder(scene, {}).visibility();
    const Mesh& mesh = split_mesh_of(*found, 0);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-5f);
        EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[i])), 1.0f, 1e-5f);
        EXPECT_EQ(std::abs(mesh.tangents[i].w), 1.0f);
    }
}

TEST(SplitEdges, OpenNoGap) {
    const auto found = VisibilityFinder(table(), {}).visibility();
    std::map<Edge, int> counts;
    count_edges(split_mesh_of(*found, 0), glm::mat4(1.0f), counts);
    expect_no_gap(counts);
}

Mesh half_of_table(bool first) {
    return rectangle({first ? -kHalf : 0.0, 0, kHalf}, {kHalf, 0, 0}, {0, 0, -2 * kHalf}, 1, 1);
}

// The halves of a table are two meshes, of two materials; the cylinder stands beside their common edge.
TEST(SplitEdges, OpenNoGapBetweenMeshes) {
    const Cylinder c;
    Scene scene = scene_of({half_of_table(true), half_of_table(false),
                            cylinder(c.foot, c.radius, c.height, kSegments)});
    scene.materials.push_back(matt(glm::vec3(0.5f)));
    scene.instances[1].material = 1;
    const auto found = VisibilityFinder(scene, {}).visibility();
    std::map<Edge, int> counts;
    for (const std::size_t half : {std::size_t{0}, std::size_t{1}})
        count_edges(split_mesh_of(*found, half), glm::mat4(1.0f), counts);
    expect_no_gap(counts);
}

// They are two instances of one mesh, one of them mirrored.
TEST(SplitEdges, OpenNoGapBetweenInstances) {
    const Cylinder c;
    Scene scene = scene_of({half_of_table(false), cylinder(c.foot, c.radius, c.height, kSegments)});
    scene.instances.push_back({0, 0, glm::scale(glm::mat4(1.0f), {-1, 1, 1})});
    const auto found = VisibilityFinder(scene, {}).visibility();
    std::map<Edge, int> counts;
    for (const std::size_t instance : {std::size_t{0}, std::size_t{2}}) {
        count_edges(split_mesh_of(*found, instance), scene.instances[instance].transform, counts);
        const Mesh& mesh = split_mesh_of(*found, instance);
        // In the mesh's own space the corners still turn about its normals.
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) { return mesh.positions[mesh.indices[i + k]]; };
            ASSERT_GT(glm::cross(corner(1) - corner(0), corner(2) - corner(0)).y, 0.0f);
        }
    }
    expect_no_gap(counts);
}

// The table's corners see nothing of the cylinder; what its split vertices see is what analytic rays see, but
// for noise.
TEST(SplitEdges, VerticesSeeWhatAnalyticRaysSee) {
    for (const bool bottom : {false, true}) {
        const auto found = VisibilityFinder(table(bottom), {}).visibility();
        const Mesh& mesh = split_mesh_of(*found, 0);
        const auto& vertices = found->instances[0].vertices;
        const Cylinder c;
        double most = 0;
        int beside = 0, under = 0;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const Place place{glm::dvec3(mesh.positions[i]), {0, 1, 0}};
            const double distance = glm::length(place.position - c.foot) - c.radius;
            const f64::Harmonics blocked = blocked_of(vertices[i]);
            if (distance < -0.02) {
                EXPECT_NEAR(f64::blocked_about(blocked, {0, 1, 0}), 1.0, 0.01);
                ++under;
            }
            if (distance < 0.02 || i % 5 != 0)
                continue;  // rays start beside a vertex, on the triangles about it
            most = std::max(most, difference(blocked, expected_at(place, is_behind_cylinder)));
            ++beside;
        }
        EXPECT_GT(beside, 50);
        EXPECT_GT(under, 0);
        EXPECT_LT(most, 0.03);  // measured 0.0175
    }
}

// The share between vertices, as it is drawn.
double drawn_share(const Mesh& mesh, const std::vector<VertexVisibility>& vertices, glm::dvec3 p) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return glm::dvec3(mesh.positions[mesh.indices[i + k]]);
        };
        const glm::dvec3 a = corner(0), b = corner(1), c = corner(2);
        const double area = glm::cross(b - a, c - a).y;
        const std::array<double, 3> weights = {glm::cross(b - p, c - p).y / area,
                                               glm::cross(c - p, a - p).y / area,
                                               glm::cross(a - p, b - p).y / area};
        // 1e-9: points on an edge belong to a triangle.
        if (*std::ranges::min_element(weights) < -1e-9) continue;
        double share = 0;
        for (std::size_t k = 0; k < 3; ++k)
            share += weights[k] *
                     f64::blocked_about(blocked_of(vertices[mesh.indices[i + k]]), {0, 1, 0});
        return share;
    }
    return -1;
}

TEST(SplitEdges, ShowContact) {
    const Scene scene = table();
    const auto found = VisibilityFinder(scene, {}).visibility();
    const Mesh& mesh = split_mesh_of(*found, 0);
    const auto& vertices = found->instances[0].vertices;
    const Cylinder c;
    for (const double distance : {0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.6}) {
        double mean = 0, most = 0, wanted = 0;
        constexpr int kTurns = 24;
        for (int i = 0; i < kTurns; ++i) {
            const double phi = 2 * kPi * (i + 0.3) / kTurns;
            const glm::dvec3 p =
                c.foot + glm::dvec3(std::cos(phi), 0, std::sin(phi)) * (c.radius + distance);
            wanted = f64::blocked_about(expected_at({p, {0, 1, 0}}, is_behind_cylinder), {0, 1, 0});
            const double share = drawn_share(mesh, vertices, p);
            ASSERT_GE(share, 0.0) << "the table covers its square";
            mean += share / kTurns;
            most = std::max(most, std::abs(share - wanted));
        }
        // Measured: 0.002 and 0.0098, of 256 rays and of what is not linear between vertices.
        EXPECT_NEAR(mean, wanted, 0.008) << distance;
        EXPECT_LT(most, 0.02) << distance;
    }
}

TEST(SplitEdges, AreNotSplitWithoutBeingAsked) {
    const auto found = VisibilityFinder(table(), kWhole).visibility();
    for (const InstanceVisibility& instance : found->instances) EXPECT_FALSE(instance.mesh);
    EXPECT_EQ(found->instances.at(0).vertices.size(), 4u);
}

// Edges of more than 1/64 of a square's side are split to look for contact between their ends; finer meshes stay
// as they are where nothing changes.
TEST(SplitEdges, AreFewWhereNothingChanges) {
    for (const int cells : {1, 4, 16, 32, 64}) {
        const Scene scene = scene_of({ground(1.0, cells)});
        const auto found = VisibilityFinder(scene, {}).visibility();
        EXPECT_TRUE(is_open(found->instances.at(0)));
        if (cells >= 64) {
            EXPECT_FALSE(found->instances[0].mesh) << cells;
        } else {
            EXPECT_LE(split_mesh_of(*found, 0).positions.size(), 65u * 65) << cells;
        }
    }
}

}  // namespace
}  // namespace burnish::test
