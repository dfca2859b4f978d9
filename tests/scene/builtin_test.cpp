#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/ext/vector_int3.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "burnish/builtin_meshes.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using std::numbers::pi;

struct Triangle {
    std::array<std::size_t, 3> i;
    glm::vec3 p[3];
    glm::vec2 uv[3];
    glm::vec3 cross() const { return glm::cross(p[1] - p[0], p[2] - p[0]); }
};

std::vector<Triangle> triangles_of(const Mesh& mesh) {
    std::vector<Triangle> out;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.i[k] = mesh.indices[t + k];
            triangle.p[k] = mesh.positions.at(triangle.i[k]);
            triangle.uv[k] = mesh.texcoord0.at(triangle.i[k]);
        }
        out.push_back(triangle);
    }
    return out;
}

double area_of(const Mesh& mesh) {
    double area = 0.0;
    for (const Triangle& t : triangles_of(mesh))
        area += 0.5 * static_cast<double>(glm::length(t.cross()));
    return area;
}

double volume_of(const Mesh& mesh) {
    double volume = 0.0;
    for (const Triangle& t : triangles_of(mesh))
        volume += static_cast<double>(glm::dot(t.p[0], glm::cross(t.p[1], t.p[2]))) / 6.0;
    return volume;
}

class BuiltIn : public testing::TestWithParam<std::string_view> {};

INSTANTIATE_TEST_SUITE_P(Meshes, BuiltIn,
                         testing::ValuesIn(builtin_names().begin(), builtin_names().end()),
                         [](const auto& mesh) { return std::string(mesh.param); });

TEST_P(BuiltIn, AttributesAreWholeUnitAndFinite) {
    const Mesh mesh = make_builtin_mesh(GetParam());
    const std::size_t n = mesh.positions.size();
    ASSERT_EQ(mesh.normals.size(), n);
    ASSERT_EQ(mesh.tangents.size(), n);
    ASSERT_EQ(mesh.texcoord0.size(), n);
    ASSERT_EQ(mesh.indices.size() % 3, 0u);
    EXPECT_EQ(mesh.name, GetParam());
    for (const std::uint32_t i : mesh.indices) ASSERT_LT(i, n);
    for (std::size_t i = 0; i < n; ++i) {
        const glm::vec3 t(mesh.tangents[i]);
        ASSERT_LE(glm::length(mesh.positions[i]), 1.1f);
        ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-5f);
        ASSERT_NEAR(glm::length(t), 1.0f, 1e-5f);
        ASSERT_NEAR(glm::dot(t, mesh.normals[i]), 0.0f, 1e-5f);
        ASSERT_EQ(mesh.tangents[i].w, 1.0f);
        ASSERT_TRUE(std::isfinite(mesh.texcoord0[i].x) && std::isfinite(mesh.texcoord0[i].y));
    }
}

TEST_P(BuiltIn, TrianglesFaceTheWayTheirNormalsDo) {
    const Mesh mesh = make_builtin_mesh(GetParam());
    for (const Triangle& t : triangles_of(mesh)) {
        ASSERT_GT(glm::length(t.cross()), 0.0f) << "a triangle without area";
        for (const std::size_t i : t.i) ASSERT_GT(glm::dot(t.cross(), mesh.normals[i]), 0.0f);
    }
}

// Tangents and bitangents against the derivatives of position by texture coordinates, per triangle:
// +u is along the tangent, and up in the picture, -v, is along cross(n, t).
TEST_P(BuiltIn, TangentsFollowTheTextureCoordinates) {
    const Mesh mesh = make_builtin_mesh(GetParam());
    double worst_u = 1.0, worst_v = 1.0, sum_u = 0.0;
    for (const Triangle& t : triangles_of(mesh)) {
        const glm::vec2 a = t.uv[1] - t.uv[0], b = t.uv[2] - t.uv[0];
        const float determinant = a.x * b.y - a.y * b.x;
        ASSERT_NE(determinant, 0.0f);
        const glm::vec3 p = t.p[1] - t.p[0], q = t.p[2] - t.p[0];
        const glm::vec3 du = glm::normalize((p * b.y - q * a.y) / determinant);
        const glm::vec3 dv = glm::normalize((q * a.x - p * b.x) / determinant);
        for (const std::size_t i : t.i) {
            const glm::vec3 tangent(mesh.tangents[i]);
            const glm::vec3 up = glm::cross(mesh.normals[i], tangent) * mesh.tangents[i].w;
            const auto along = static_cast<double>(glm::dot(du, tangent));
            worst_u = std::min(worst_u, along);
            sum_u += along;
            worst_v = std::min(worst_v, static_cast<double>(glm::dot(-dv, up)));
        }
    }
    // At a pole the tangents of a triangle's neighbors are rotated by half a segment. The cloth has
    // folds sharper than a triangle, and shear, so that warp and weft are not perpendicular.
    const bool cloth = GetParam() == "drape";
    EXPECT_GT(sum_u / static_cast<double>(mesh.indices.size()), cloth ? 0.995 : 0.999);
    EXPECT_GT(worst_u, cloth ? 0.8 : 0.97);
    EXPECT_GT(worst_v, cloth ? 0.3 : 0.97);
}

TEST_P(BuiltIn, HasAboutTheTrianglesThatWereWished) {
    for (const int wish : {2000, 20000, 300000}) {
        const auto count = make_builtin_mesh(GetParam(), wish).indices.size() / 3;
        EXPECT_NEAR(static_cast<double>(count) / wish, 1.0, 0.05) << wish;
    }
    EXPECT_GT(make_builtin_mesh(GetParam(), 1).indices.size(), 0u);
    EXPECT_THROW(make_builtin_mesh(GetParam(), -1), UsageError);
    EXPECT_THROW(make_builtin_mesh(GetParam(), 2000000000), UsageError);
}

TEST(BuiltInSolid, AreasAndVolumesAreThoseOfTheSolids) {
    const Mesh sphere = make_builtin_mesh("sphere");
    EXPECT_NEAR(area_of(sphere) / pi, 1.0, 1e-3);
    EXPECT_NEAR(volume_of(sphere) / (pi / 6.0), 1.0, 1e-3);
    const Mesh torus = make_builtin_mesh("torus");
    EXPECT_NEAR(area_of(torus) / (4.0 * pi * pi * 0.35 * 0.15), 1.0, 1e-3);
    EXPECT_NEAR(volume_of(torus) / (2.0 * pi * pi * 0.35 * 0.15 * 0.15), 1.0, 1e-3);
    EXPECT_NEAR(area_of(make_builtin_mesh("plane")), 1.0, 1e-6);
    // The rounded edges reduce the volume pi r^2 h, r = 1/pi, by less than 0.2 %.
    EXPECT_NEAR(volume_of(make_builtin_mesh("cylinder")) / (0.8 / pi), 0.999, 2e-3);
    // The pot: the outer cylinder less the inner one, the round edges by Pappus' theorem (a corner of radius f
    // lacks (1 - pi/4) f^2 at about 0.223 f from its sides).
    const double r = 1.0 / pi, h = 0.46, w = 0.014, outer = 0.05, inner = outer - w;
    const auto corner = [](double f, double radius) {
        return (1.0 - pi / 4.0) * f * f * 2.0 * pi * (radius - 0.2234 * f);
    };
    const double rim = (0.5 - pi / 8.0) * w * w * 2.0 * pi * (r - 0.5 * w);
    const double volume = pi * r * r * h - pi * (r - w) * (r - w) * (h - w) - corner(outer, r) +
                          corner(inner, r - w) - rim;
    EXPECT_NEAR(volume_of(make_builtin_mesh("pot")) / volume, 1.0, 3e-3);
}

// By positions alone, every edge has two triangles: no gap at the seams, bit for bit.
TEST(BuiltInSolid, Closed) {
    for (const std::string_view name : {"sphere", "torus", "cylinder", "pot"}) {
        const Mesh mesh = make_builtin_mesh(name, 5000);
        std::map<std::tuple<float, float, float>, int> ids;
        const auto id = [&](const glm::vec3& p) {
            // The copies of the poles differ by the sign of zero, which a map treats as equal.
            return ids.try_emplace({p.x, p.y, p.z}, static_cast<int>(ids.size())).first->second;
        };
        std::map<std::pair<int, int>, int> edges;
        for (const Triangle& t : triangles_of(mesh))
            for (int k = 0; k < 3; ++k) ++edges[{id(t.p[k]), id(t.p[(k + 1) % 3])}];
        for (const auto& [edge, count] : edges) {
            ASSERT_EQ(count, 1) << name;
            const auto opposite = edges.find({edge.second, edge.first});
            ASSERT_NE(opposite, edges.end()) << name << ": an open edge";
        }
    }
}

TEST(BuiltInSolid, NoSeamInTheTangents) {
    for (const std::string_view name : {"sphere", "torus", "cylinder", "pot"}) {
        const Mesh mesh = make_builtin_mesh(name, 5000);
        std::map<std::tuple<float, float, float>, std::size_t> first;
        int shared = 0;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 p = mesh.positions[i];
            if (std::hypot(p.x, p.z) < 1e-6f) continue;  // every direction is a tangent at a pole
            const auto [found, is_new] = first.try_emplace({p.x, p.y, p.z}, i);
            if (is_new) continue;
            ++shared;
            ASSERT_GT(
                glm::dot(glm::vec3(mesh.tangents[i]), glm::vec3(mesh.tangents[found->second])),
                0.999999f);
            ASSERT_GT(glm::dot(mesh.normals[i], mesh.normals[found->second]), 0.999999f);
        }
        EXPECT_GT(shared, 10) << name;
    }
}

TEST(Drape, HangsInFoldsAndHardlyStretches) {
    const Mesh mesh = make_builtin_mesh("drape", 20000);
    const auto side = static_cast<std::size_t>(std::lround(std::sqrt(mesh.positions.size())));
    ASSERT_EQ(side * side, mesh.positions.size());
    const double rest = 1.0 / static_cast<double>(side - 1);
    double mean = 0.0, longest = 0.0;
    for (std::size_t row = 0; row < side; ++row) {
        double length = 0.0;
        for (std::size_t i = 0; i + 1 < side; ++i) {
            const double edge = static_cast<double>(
                glm::length(mesh.positions[row * side + i + 1] - mesh.positions[row * side + i]));
            longest = std::max(longest, edge / rest);
            length += edge;
        }
        mean += length / static_cast<double>(side);
    }
    EXPECT_NEAR(mean, 1.0, 0.05);
    EXPECT_LT(longest, 1.25);
    // Folds: the distance of the hem from the axis oscillates.
    int turns = 0;
    double last = 0.0, direction = 0.0;
    for (std::size_t i = 0; i < side; ++i) {
        const glm::vec3 p = mesh.positions[i];
        const double distance = static_cast<double>(std::hypot(p.x, p.z));
        if (i > 0 && (distance - last) * direction < 0.0) ++turns;
        if (i > 0 && distance != last) direction = distance - last;
        last = distance;
    }
    EXPECT_GE(turns, 3) << "along one of the four hems";
    // The cloth lies on the plinth and hangs over its side.
    float low = 0.0f, high = -1.0f;
    for (const glm::vec3& p : mesh.positions) {
        low = std::min(low, p.y);
        high = std::max(high, p.y);
    }
    EXPECT_NEAR(high, 0.0f, 0.01f);
    EXPECT_LT(low, -0.4f);
    EXPECT_GT(low, -0.75f);
}

// Does the segment from a to b go through the triangle?
bool crosses(const Triangle& t, glm::dvec3 a, glm::dvec3 b) {
    const glm::dvec3 p(t.p[0]), q(t.p[1]), r(t.p[2]);
    const auto volume = [](glm::dvec3 w, glm::dvec3 x, glm::dvec3 y, glm::dvec3 z) {
        return glm::dot(glm::cross(x - w, y - w), z - w);
    };
    if ((volume(p, q, r, a) > 0.0) == (volume(p, q, r, b) > 0.0)) return false;
    const bool first = volume(a, b, p, q) > 0.0;
    return first == (volume(a, b, q, r) > 0.0) && first == (volume(a, b, r, p) > 0.0);
}

bool cut_each_other(const Triangle& s, const Triangle& t) {
    for (int k = 0; k < 3; ++k) {
        if (crosses(t, glm::dvec3(s.p[k]), glm::dvec3(s.p[(k + 1) % 3]))) return true;
        if (crosses(s, glm::dvec3(t.p[k]), glm::dvec3(t.p[(k + 1) % 3]))) return true;
    }
    return false;
}

// The cells of a grid that the triangle's box touches.
template <typename Visit>
void for_each_cell(const Triangle& t, float cell, const Visit& visit) {
    const glm::ivec3 low(glm::floor(glm::min(t.p[0], glm::min(t.p[1], t.p[2])) / cell));
    const glm::ivec3 high(glm::floor(glm::max(t.p[0], glm::max(t.p[1], t.p[2])) / cell));
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) visit(std::tuple(x, y, z));
}

std::size_t cuts_in(const Mesh& mesh) {
    constexpr float kCell = 0.02f;  // a few triangles wide; any size gives the same answer
    const std::vector<Triangle> all = triangles_of(mesh);
    std::map<std::tuple<int, int, int>, std::vector<std::size_t>> cells;
    for (std::size_t i = 0; i < all.size(); ++i)
        for_each_cell(all[i], kCell, [&](const auto& cell) { cells[cell].push_back(i); });
    std::set<std::pair<std::size_t, std::size_t>> cuts;
    for (const auto& [cell, inside] : cells)
        for (std::size_t a = 0; a < inside.size(); ++a)
            for (std::size_t b = a + 1; b < inside.size(); ++b) {
                const Triangle &s = all[inside[a]], &t = all[inside[b]];
                const bool neighbors = std::any_of(s.i.begin(), s.i.end(), [&](std::size_t i) {
                    return std::find(t.i.begin(), t.i.end(), i) != t.i.end();
                });
                if (!neighbors && cut_each_other(s, t)) cuts.insert({inside[a], inside[b]});
            }
    return cuts.size();
}

// Two crossed squares, as a check of the check, and the cloth.
TEST(Drape, DoesNotGoThroughItself) {
    Mesh crossed = make_builtin_mesh("plane", 2);
    const std::size_t count = crossed.positions.size();
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 p = crossed.positions[i];
        crossed.positions.emplace_back(p.x, p.z, p.y + 0.1f);
        crossed.texcoord0.push_back(crossed.texcoord0[i]);
    }
    for (std::size_t i = 0, end = crossed.indices.size(); i < end; ++i)
        crossed.indices.push_back(crossed.indices[i] + static_cast<std::uint32_t>(count));
    EXPECT_GT(cuts_in(crossed), 0u);
    for (const int triangles : {5000, 40000})
        EXPECT_EQ(cuts_in(make_builtin_mesh("drape", triangles)), 0u) << triangles;
}

// Layers of cloth lie on one another, they do not merge: points of the cloth that are more than 6 cm
// apart on it are more than 4 mm apart in space. The solver keeps nodes 12 mm apart; the surface
// between nodes may come closer.
TEST(Drape, LayersKeepADistance) {
    const Mesh mesh = make_builtin_mesh("drape", 20000);
    constexpr float kNear = 0.004f, kCell = 0.01f;
    std::map<std::tuple<int, int, int>, std::vector<std::size_t>> cells;
    const auto cell_of = [&](glm::vec3 p) { return glm::ivec3(glm::floor(p / kCell)); };
    float nearest = 1.0f;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 p = mesh.positions[i];
        const glm::ivec3 cell = cell_of(p);
        for (int k = 0; k < 27; ++k) {
            const auto found =
                cells.find({cell.x + k % 3 - 1, cell.y + k / 3 % 3 - 1, cell.z + k / 9 - 1});
            if (found == cells.end()) continue;
            for (const std::size_t j : found->second)
                if (glm::length(mesh.texcoord0[i] - mesh.texcoord0[j]) > 0.06f)
                    nearest = std::min(nearest, glm::length(p - mesh.positions[j]));
        }
        cells[{cell.x, cell.y, cell.z}].push_back(i);
    }
    EXPECT_GT(nearest, kNear);
}

TEST(BuiltInNames, AreToldFromFiles) {
    EXPECT_TRUE(is_builtin("builtin:sphere"));
    EXPECT_FALSE(is_builtin("sphere"));
    EXPECT_FALSE(is_builtin("./builtin.glb"));
    EXPECT_NE(test::error_line<UsageError>([] { make_builtin_mesh("tours"); }).find("'torus'"),
              std::string::npos);
}

}  // namespace
}  // namespace burnish
