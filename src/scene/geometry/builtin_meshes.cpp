// Built-in meshes: all about a meter across, centered on the origin (the drape hangs below it),
// with texture coordinates, normals and exact tangents. v runs down the surface as rows run down a
// picture, so that cross(normal, tangent) points up the picture and every tangent.w is +1.
#include "burnish/builtin_meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "burnish/error.hpp"
#include "burnish/shading_names.hpp"
#include "core/text.hpp"
#include "scene/geometry/drape.hpp"

namespace burnish {

namespace {

constexpr std::string_view kPrefix = "builtin:";
constexpr std::array<std::string_view, 6> kNames = {"sphere", "plane", "cylinder",
                                                    "torus",  "drape", "pot"};
// The limit of the parameter table: 32-bit indices and a few hundred megabytes at most.
constexpr int kMostTriangles = 4000000;

// A point of the curve that is turned around the y axis: distance from the axis, height, outward
// normal in the same plane, and v.
struct ProfilePoint {
    double radius, y, normal_radius, normal_y, v;
};

// Revolves the profile, traced from the top over the outside downwards, around +y. u runs to the
// right seen from outside, from 0 at the back (-z) to `repeats` at the back again; tangents run
// along it. A profile that ends on the axis gets one vertex per segment there, with the tangent of
// the segment's middle.
Mesh revolve(const std::vector<ProfilePoint>& profile, int segments, double repeats) {
    Mesh mesh;
    const auto on_axis = [](const ProfilePoint& p) { return p.radius <= 0.0; };
    const auto columns = static_cast<std::uint32_t>(segments) + 1;
    const std::size_t count = profile.size() * columns;
    mesh.positions.reserve(count);
    mesh.normals.reserve(count);
    mesh.tangents.reserve(count);
    mesh.texcoord0.reserve(count);
    for (const ProfilePoint& p : profile) {
        for (int i = 0; i <= segments; ++i) {
            const double turn = (on_axis(p) ? i + 0.5 : i) / segments;
            // The last column coincides with the first: the same angle gives the same bits.
            const double phi =
                2.0 * std::numbers::pi * (i == segments ? 0.0 : turn) - std::numbers::pi;
            const double s = std::sin(phi), c = std::cos(phi);
            mesh.positions.emplace_back(p.radius * s, p.y, p.radius * c);
            mesh.normals.emplace_back(p.normal_radius * s, p.normal_y, p.normal_radius * c);
            mesh.tangents.emplace_back(c, 0.0, -s, 1.0);
            mesh.texcoord0.emplace_back(repeats * turn, p.v);
        }
    }
    for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring) {
        for (std::uint32_t i = 0; i + 1 < columns; ++i) {
            const std::uint32_t a = static_cast<std::uint32_t>(ring) * columns + i;
            const std::uint32_t b = a + columns;
            if (!on_axis(profile[ring + 1])) mesh.indices.insert(mesh.indices.end(), {a, b, b + 1});
            if (!on_axis(profile[ring])) {
                const std::uint32_t below = on_axis(profile[ring + 1]) ? b : b + 1;
                mesh.indices.insert(mesh.indices.end(), {a, below, a + 1});
            }
        }
    }
    return mesh;
}

int rounded_root(double value, int least) {
    return std::max(least, static_cast<int>(std::lround(std::sqrt(value))));
}

// Two texture squares around and one from pole to pole, so that texels are square at the equator.
Mesh make_sphere(int triangles) {
    // `rings` rings of 2 `rings` quads, where those at the poles are triangles: 4 rings (rings - 1)
    // triangles, which is (2 rings - 1)^2 - 1.
    const int rings = (rounded_root((triangles > 0 ? triangles : 101760) + 1.0, 5) + 1) / 2;
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= rings; ++i) {
        const double v = static_cast<double>(i) / rings;
        const double theta = std::numbers::pi * v;
        const bool pole = i == 0 || i == rings;
        const double s = pole ? 0.0 : std::sin(theta), c = std::cos(theta);
        profile.push_back({0.5 * s, 0.5 * c, s, c, v});
    }
    return revolve(profile, 2 * rings, 2.0);
}

Mesh make_plane(int triangles) {
    // A flat plate needs two triangles only; more serve tests of cost.
    const int quads = rounded_root((triangles > 0 ? triangles : 2) / 2.0, 1);
    Mesh mesh;
    for (int j = 0; j <= quads; ++j) {
        for (int i = 0; i <= quads; ++i) {
            const float u = static_cast<float>(i) / static_cast<float>(quads);
            const float v = static_cast<float>(j) / static_cast<float>(quads);
            mesh.positions.emplace_back(u - 0.5f, 0.5f - v, 0.0f);
            mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
            mesh.tangents.emplace_back(1.0f, 0.0f, 0.0f, 1.0f);
            mesh.texcoord0.emplace_back(u, v);
        }
    }
    const auto columns = static_cast<std::uint32_t>(quads) + 1;
    for (std::uint32_t j = 0; j + 1 < columns; ++j) {
        for (std::uint32_t i = 0; i + 1 < columns; ++i) {
            const std::uint32_t a = j * columns + i, b = a + columns;
            mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    }
    return mesh;
}

// A quarter circle from the direction `from` (radians from +y towards the outside).
void add_fillet(std::vector<ProfilePoint>& profile, double radius, double y, double fillet,
                double from, int steps) {
    for (int i = 0; i <= steps; ++i) {
        const double angle = from + 0.5 * std::numbers::pi * i / steps;
        const double s = std::sin(angle), c = std::cos(angle);
        profile.push_back({radius + fillet * s, y + fillet * c, s, c, 0.0});
    }
}

// v as meters along the profile.
void measure_profile(std::vector<ProfilePoint>& profile) {
    for (std::size_t i = 1; i < profile.size(); ++i)
        profile[i].v = profile[i - 1].v + std::hypot(profile[i].radius - profile[i - 1].radius,
                                                     profile[i].y - profile[i - 1].y);
}

// A solid of revolution: one profile from the middle of the top over a rounded edge and the side to
// the middle of the bottom, so that the grain runs around everywhere. Texels are square on the
// side.
Mesh make_cylinder(int triangles) {
    constexpr double kRadius = std::numbers::inv_pi;  // circumference 2 m: two texture squares
    constexpr double kHalfHeight = 0.4, kFillet = 0.012;
    constexpr int kFilletSteps = 8, kCapSteps = 24, kSideSteps = 24;
    constexpr int kRings = 2 * kCapSteps + 2 * kFilletSteps + kSideSteps;
    const int segments = std::max(
        8, static_cast<int>(std::lround((triangles > 0 ? triangles : 50000) / (2.0 * kRings))));
    const double flat = kRadius - kFillet, straight = kHalfHeight - kFillet;
    std::vector<ProfilePoint> profile;
    profile.reserve(kRings + 1);
    for (int i = 0; i < kCapSteps; ++i)
        profile.push_back({flat * i / kCapSteps, kHalfHeight, 0.0, 1.0, 0.0});
    add_fillet(profile, flat, straight, kFillet, 0.0, kFilletSteps);
    for (int i = 1; i < kSideSteps; ++i)
        profile.push_back({kRadius, straight * (1.0 - 2.0 * i / kSideSteps), 1.0, 0.0, 0.0});
    add_fillet(profile, flat, -straight, kFillet, 0.5 * std::numbers::pi, kFilletSteps);
    for (int i = kCapSteps - 1; i >= 0; --i)
        profile.push_back({flat * i / kCapSteps, -kHalfHeight, 0.0, -1.0, 0.0});
    measure_profile(profile);
    return revolve(profile, segments, 2.0);
}

// An open vessel with a wall: the profile goes from the middle of the floor inside up the wall, over a round rim and
// down the outside to the middle below. The grain runs around.
Mesh make_pot(int triangles) {
    constexpr double kRadius = std::numbers::inv_pi;  // circumference 2 m: two texture squares
    constexpr double kHalfHeight = 0.23, kWall = 0.014, kFillet = 0.05;
    constexpr int kFilletSteps = 12, kRimSteps = 8, kFloorSteps = 14, kSideSteps = 20;
    constexpr int kRings = 2 * (kFloorSteps + kFilletSteps + kSideSteps) + kRimSteps;
    const int segments = std::max(
        8, static_cast<int>(std::lround((triangles > 0 ? triangles : 50000) / (2.0 * kRings))));
    const double inside = kRadius - kWall, floor = kWall - kHalfHeight, inner = kFillet - kWall;
    const double flat = kRadius - kFillet, rim = kHalfHeight - 0.5 * kWall;
    std::vector<ProfilePoint> profile;
    for (int i = 0; i < kFloorSteps; ++i)
        profile.push_back({flat * i / kFloorSteps, floor, 0.0, 1.0, 0.0});
    for (int i = 0; i <= kFilletSteps; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / kFilletSteps;
        const double s = std::sin(angle), c = std::cos(angle);
        profile.push_back({flat + inner * s, floor + inner * (1.0 - c), -s, c, 0.0});
    }
    const double low = floor + inner;
    for (int i = 1; i < kSideSteps; ++i)
        profile.push_back({inside, low + (rim - low) * i / kSideSteps, -1.0, 0.0, 0.0});
    for (int i = 0; i <= kRimSteps; ++i) {
        const double angle = std::numbers::pi * i / kRimSteps;
        const double s = std::sin(angle), c = std::cos(angle);
        profile.push_back({kRadius - 0.5 * kWall * (1.0 + c), rim + 0.5 * kWall * s, -c, s, 0.0});
    }
    const double edge = kFillet - kHalfHeight;
    for (int i = 1; i < kSideSteps; ++i)
        profile.push_back({kRadius, rim + (edge - rim) * i / kSideSteps, 1.0, 0.0, 0.0});
    add_fillet(profile, flat, edge, kFillet, 0.5 * std::numbers::pi, kFilletSteps);
    for (int i = kFloorSteps - 1; i >= 0; --i)
        profile.push_back({flat * i / kFloorSteps, -kHalfHeight, 0.0, -1.0, 0.0});
    measure_profile(profile);
    return revolve(profile, segments, 2.0);
}

// The ring lies flat; 2 x 1 texture squares measure 1.10 x 0.94 m on the tube's middle line.
Mesh make_torus(int triangles) {
    constexpr double kRing = 0.35, kTube = 0.15;
    // Segments in the ratio of the circumferences: 2 x steps x (7/3 steps) triangles.
    const int steps = rounded_root((triangles > 0 ? triangles : 100000) * 3.0 / 14.0, 3);
    const int segments = std::max(3, static_cast<int>(std::lround(steps * kRing / kTube)));
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= steps; ++i) {
        const double v = static_cast<double>(i) / steps;
        const double angle = 2.0 * std::numbers::pi * (i == steps ? 0.0 : v);
        const double s = std::sin(angle), c = std::cos(angle);
        profile.push_back({kRing + kTube * s, kTube * c, s, c, v});
    }
    return revolve(profile, segments, 2.0);
}

}  // namespace

bool is_builtin(std::string_view name) {
    return name.starts_with(kPrefix);
}

std::span<const std::string_view> builtin_names() {
    return kNames;
}

Mesh make_builtin_mesh(std::string_view name, int triangles) {
    const int which = index_of_name(kNames, name, "built-in mesh", "");
    if (triangles < 0 || triangles > kMostTriangles)
        throw UsageError("built-in mesh", "triangles", "0 to " + std::to_string(kMostTriangles),
                         shown(std::to_string(triangles)));
    Mesh mesh;
    switch (which) {
        case 0:
            mesh = make_sphere(triangles);
            break;
        case 1:
            mesh = make_plane(triangles);
            break;
        case 2:
            mesh = make_cylinder(triangles);
            break;
        case 3:
            mesh = make_torus(triangles);
            break;
        case 4:
            mesh = make_drape(triangles);
            break;
        default:
            mesh = make_pot(triangles);
            break;
    }
    mesh.name = std::string(name);
    return mesh;
}

}  // namespace burnish
