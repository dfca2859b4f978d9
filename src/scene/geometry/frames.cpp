// Normals, and repair of normals and tangents.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/geometry/tangents.hpp"
#include "scene/geometry/weld.hpp"

namespace burnish {
namespace {

// Attributes stored in 8 bits are up to 1 % short; 5 % leaves room for half floats and careless
// interpolation.
constexpr double kLengthTolerance = 0.05;

// A tangent within 1.8 degrees of the normal defines no direction in the plane.
constexpr float kParallel = 0.9995f;

// Twice the area times the unit normal. In double: edges may be anything from 1e-30 to 1e9.
glm::dvec3 area_vector(const Mesh& mesh, std::size_t triangle) {
    const glm::dvec3 a(mesh.positions[mesh.indices[3 * triangle]]);
    const glm::dvec3 b(mesh.positions[mesh.indices[3 * triangle + 1]]);
    const glm::dvec3 c(mesh.positions[mesh.indices[3 * triangle + 2]]);
    return glm::cross(b - a, c - a);
}

// Makes `v` a unit vector. Returns false and leaves `v` when it has no direction.
template <class Vec>
bool make_unit(Vec& v) {
    const double length = glm::length(glm::dvec3(v));
    // Squares of components below 1e-154 vanish even in double.
    if (!(length > 1e-150) || !std::isfinite(length)) return false;
    v = Vec(glm::dvec3(v) / length);
    return true;
}

glm::vec3 face_normal(const Mesh& mesh, std::size_t triangle) {
    glm::dvec3 normal = area_vector(mesh, triangle);
    return make_unit(normal) ? glm::vec3(normal) : glm::vec3(0.0f, 1.0f, 0.0f);
}

double angle_at(const Mesh& mesh, std::size_t triangle, std::size_t corner) {
    const auto position = [&](std::size_t i) {
        return glm::dvec3(mesh.positions[mesh.indices[3 * triangle + (corner + i) % 3]]);
    };
    glm::dvec3 a = position(1) - position(0);
    glm::dvec3 b = position(2) - position(0);
    if (!make_unit(a) || !make_unit(b)) return 0.0;
    return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

// Sum of the weighted face normals (corner_normal) at the position of each vertex; zero for a
// vertex of no triangle.
std::vector<glm::dvec3> summed_normals(const Mesh& mesh) {
    const Welding welding =
        weld<3>(mesh.positions.size(), [&](std::size_t i, std::uint32_t* words) {
            for (int c = 0; c < 3; ++c) words[c] = weld_bits(mesh.positions[i][c]);
        });
    std::vector<glm::dvec3> sums(welding.classes, glm::dvec3(0.0));
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        for (std::size_t c = 3 * t; c < 3 * t + 3; ++c)
            sums[welding.ids[mesh.indices[c]]] += corner_normal(mesh, c);
    }
    std::vector<glm::dvec3> normals(mesh.positions.size());
    for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = sums[welding.ids[i]];
    return normals;
}

template <class Item>
void unshare(std::vector<Item>& items, const std::vector<std::uint32_t>& indices) {
    if (items.empty()) return;
    std::vector<Item> copies(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) copies[i] = items[indices[i]];
    items = std::move(copies);
}

void make_flat(Mesh& mesh) {
    unshare(mesh.positions, mesh.indices);
    unshare(mesh.tangents, mesh.indices);
    unshare(mesh.texcoord0, mesh.indices);
    unshare(mesh.texcoord1, mesh.indices);
    unshare(mesh.colors, mesh.indices);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        mesh.indices[i] = static_cast<std::uint32_t>(i);
    mesh.normals.resize(mesh.positions.size());
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t)
        std::fill_n(mesh.normals.begin() + static_cast<std::ptrdiff_t>(3 * t), 3,
                    face_normal(mesh, t));
}

// True when the length is 1 within the tolerance; false for NaN.
template <class Vec>
bool is_about_unit(const Vec& v) {
    return std::abs(glm::length(glm::dvec3(v)) - 1.0) <= kLengthTolerance;
}

// Replaces the normals marked in `broken` by the mean face normal, or by +y where there is none.
void replace_normals(Mesh& mesh, const std::vector<char>& broken) {
    const std::vector<glm::dvec3> sums = summed_normals(mesh);
    for (std::size_t i = 0; i < broken.size(); ++i) {
        if (!broken[i]) continue;
        glm::dvec3 normal = sums[i];
        mesh.normals[i] = make_unit(normal) ? glm::vec3(normal) : glm::vec3(0.0f, 1.0f, 0.0f);
    }
}

// Returns true when the tangent needed no repair.
bool mend_tangent(glm::vec4& tangent, glm::vec3 normal) {
    glm::vec3 direction(tangent);
    bool sound = is_about_unit(direction) && std::abs(std::abs(tangent.w) - 1.0f) <= 0.05f;
    if (!make_unit(direction) || !(std::abs(glm::dot(direction, normal)) < kParallel)) {
        direction = tangent_of_normal(normal);
        sound = false;
    }
    tangent = glm::vec4(direction, tangent.w < 0.0f ? -1.0f : 1.0f);
    return sound;
}

}  // namespace

glm::dvec3 corner_normal(const Mesh& mesh, std::size_t corner) {
    return angle_at(mesh, corner / 3, corner % 3) * area_vector(mesh, corner / 3);
}

glm::vec3 tangent_of_normal(glm::vec3 normal) {
    // cross(+y, normal); +x at the poles, where it vanishes.
    const float length = std::hypot(normal.x, normal.z);
    if (!(length > 1e-6f)) return {1.0f, 0.0f, 0.0f};
    return {normal.z / length, 0.0f, -normal.x / length};
}

void make_normals(Mesh& mesh, bool flat) {
    if (flat) {
        make_flat(mesh);
        return;
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0f));
    replace_normals(mesh, std::vector<char>(mesh.positions.size(), 1));
}

std::size_t repair_frames(Mesh& mesh) {
    if (mesh.normals.size() != mesh.positions.size()) make_normals(mesh, false);
    std::vector<char> broken(mesh.positions.size(), 0);
    bool any = false;
    std::size_t mended = 0;
    for (std::size_t i = 0; i < broken.size(); ++i) {
        const bool sound = is_about_unit(mesh.normals[i]);
        const bool usable = make_unit(mesh.normals[i]);
        broken[i] = !usable;
        any = any || !usable;
        mended += !sound;
    }
    if (any) replace_normals(mesh, broken);
    if (mesh.tangents.size() != mesh.positions.size()) {
        mesh.tangents.clear();
        return mended;
    }
    for (std::size_t i = 0; i < broken.size(); ++i) {
        if (!mend_tangent(mesh.tangents[i], mesh.normals[i]) && !broken[i]) ++mended;
    }
    return mended;
}

}  // namespace burnish
