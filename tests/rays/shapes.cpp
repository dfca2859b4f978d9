#include "shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <utility>

#include "core/constants.hpp"

namespace burnish::test {
namespace {

// Any unit vector across a unit vector.
glm::dvec3 across(glm::dvec3 n) {
    const glm::dvec3 side = std::abs(n.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    return glm::normalize(glm::cross(side, n));
}

void add_triangle(Mesh& mesh, std::array<std::uint32_t, 3> corners) {
    const glm::dvec3 a(mesh.positions[corners[0]]), b(mesh.positions[corners[1]]),
        c(mesh.positions[corners[2]]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    // 1e-10 of the sides: those at a pole have two equal corners, but for rounding.
    if (glm::length(normal) <= 1e-10 * glm::dot(c - a, c - a)) return;
    const glm::dvec3 wanted(mesh.normals[corners[0]] + mesh.normals[corners[1]] +
                            mesh.normals[corners[2]]);
    if (glm::dot(normal, wanted) < 0) std::swap(corners[1], corners[2]);
    mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
}

// Place on the unit sphere; the azimuth runs with u, the polar angle from `first` to `last` with v.
Place on_sphere(double u, double v, double first, double last) {
    const double theta = first + (last - first) * v;
    // Exactly 0 at the poles, so that all of their vertices are one point.
    const double sine = theta <= 0 || theta >= kPi ? 0.0 : std::sin(theta);
    const glm::dvec3 p(sine * std::sin(2 * kPi * u), std::cos(theta), sine * std::cos(2 * kPi * u));
    return {p, p};
}

// An even spiral over the whole sphere.
template <typename Visit>
void for_even_directions(const Visit& visit) {
    constexpr int kCount = 1 << 15;
    const double turn = kPi * (3 - std::sqrt(5.0));
    for (int i = 0; i < kCount; ++i) {
        const double z = 1 - (2 * i + 1.0) / kCount, sine = std::sqrt(1 - z * z);
        visit(glm::dvec3(sine * std::cos(turn * i), sine * std::sin(turn * i), z), 1.0 / kCount);
    }
}

glm::dvec3 mirrored_up(glm::dvec3 w, glm::dvec3 n) {
    return w + n * (std::abs(glm::dot(w, n)) - glm::dot(w, n));
}

std::array<double, 16> values_of(const f64::Harmonics& h) {
    return {h.mean, h.x1.x, h.x1.y, h.x1.z, h.x2.x, h.x2.y, h.x2.z, h.y2.x,
            h.y2.y, h.x3.x, h.x3.y, h.x3.z, h.y3.x, h.y3.y, h.y3.z, h.z3};
}

f64::Harmonics harmonics_of(const std::array<double, 16>& v) {
    return {v[0],         {v[1], v[2], v[3]},   {v[4], v[5], v[6]},
            {v[7], v[8]}, {v[9], v[10], v[11]}, {v[12], v[13], v[14]},
            v[15]};
}

}  // namespace

f64::vec3 to_f64(glm::dvec3 v) {
    return f64::vec3(v);
}

Mesh surface(int columns, int rows, bool closed,
             const std::function<Place(double u, double v)>& place) {
    Mesh mesh;
    mesh.name = "surface";
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const double u = static_cast<double>(i) / columns, v = static_cast<double>(j) / rows;
            const Place p = place(closed && i == columns ? 0.0 : u, v);
            mesh.positions.emplace_back(p.position);
            mesh.normals.emplace_back(p.normal);
            mesh.tangents.emplace_back(glm::vec3(across(p.normal)), 1.0f);
            mesh.texcoord0.emplace_back(u, v);
        }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            add_triangle(mesh, {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            add_triangle(mesh, {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

Mesh rectangle(glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v, int columns, int rows) {
    const glm::dvec3 normal = glm::normalize(glm::cross(u, v));
    Mesh mesh = surface(columns, rows, false, [&](double s, double t) {
        return Place{corner + u * s + v * t, normal};
    });
    for (glm::vec4& tangent : mesh.tangents)
        tangent = glm::vec4(glm::vec3(glm::normalize(u)), 1.0f);
    return mesh;
}

Mesh ground(double half, int cells) {
    return rectangle({-half, 0, half}, {2 * half, 0, 0}, {0, 0, -2 * half}, cells, cells);
}

Mesh disc(glm::dvec3 center, double radius, glm::dvec3 normal, int segments) {
    const glm::dvec3 n = glm::normalize(normal), t = across(n), b = glm::cross(n, t);
    return surface(segments, 1, true, [&](double u, double v) {
        const double phi = 2 * kPi * u;
        return Place{center + (t * std::cos(phi) + b * std::sin(phi)) * (v * radius), n};
    });
}

Mesh sphere(glm::dvec3 center, double radius, int rows, bool inwards) {
    return surface(2 * rows, rows, true, [&](double u, double v) {
        const Place p = on_sphere(u, v, 0, kPi);
        return Place{center + p.position * radius, inwards ? -p.normal : p.normal};
    });
}

Mesh box(glm::dvec3 low, glm::dvec3 high, int cells, bool inwards) {
    Mesh mesh;
    mesh.name = "box";
    for (int axis = 0; axis < 3; ++axis)
        for (const bool top : {false, true}) {
            glm::dvec3 u(0.0), v(0.0), corner = low;
            u[(axis + 1) % 3] = high[(axis + 1) % 3] - low[(axis + 1) % 3];
            v[(axis + 2) % 3] = high[(axis + 2) % 3] - low[(axis + 2) % 3];
            if (top) corner[axis] = high[axis];
            if (top == inwards) std::swap(u, v);
            mesh = joined(mesh, rectangle(corner, u, v, cells, cells));
        }
    return mesh;
}

Mesh bowl(int rows) {
    return surface(4 * rows, rows, true, [](double u, double v) {
        const Place p = on_sphere(u, v, kPi / 2, kPi);
        return Place{p.position, -p.normal};
    });
}

Mesh cylinder(glm::dvec3 foot, double radius, double height, int segments) {
    const Mesh side = surface(segments, 8, true, [&](double u, double v) {
        const glm::dvec3 out(std::sin(2 * kPi * u), 0, std::cos(2 * kPi * u));
        return Place{foot + out * radius + glm::dvec3(0, height * v, 0), out};
    });
    return joined(side, disc(foot + glm::dvec3(0, height, 0), radius, {0, 1, 0}, segments));
}

Mesh joined(const Mesh& a, const Mesh& b) {
    Mesh mesh = a;
    const auto first = static_cast<std::uint32_t>(a.positions.size());
    const auto append = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    append(mesh.positions, b.positions);
    append(mesh.normals, b.normals);
    append(mesh.tangents, b.tangents);
    append(mesh.texcoord0, b.texcoord0);
    for (const std::uint32_t index : b.indices) mesh.indices.push_back(first + index);
    return mesh;
}

Mesh transformed(const Mesh& mesh, const glm::dmat4& transform) {
    Mesh moved = mesh;
    const glm::dmat3 linear(transform), of_normals = glm::transpose(glm::inverse(linear));
    for (glm::vec3& p : moved.positions) p = glm::vec3(transform * glm::dvec4(p, 1.0));
    for (glm::vec3& n : moved.normals) n = glm::vec3(glm::normalize(of_normals * glm::dvec3(n)));
    if (glm::determinant(linear) < 0)
        for (std::size_t i = 0; i + 2 < moved.indices.size(); i += 3)
            std::swap(moved.indices[i + 1], moved.indices[i + 2]);
    return moved;
}

Material matt(glm::vec3 albedo) {
    Material material;
    material.base_color = glm::vec4(albedo, 1.0f);
    material.metallic = 0.0f;
    material.dielectric_f0 = 0.0f;
    return material;
}

Scene scene_of(std::vector<Mesh> meshes) {
    Scene scene;
    scene.meshes = std::move(meshes);
    scene.materials.push_back(matt());
    for (std::size_t i = 0; i < scene.meshes.size(); ++i)
        scene.instances.push_back({static_cast<int>(i), 0, glm::mat4(1.0f)});
    return scene;
}

f64::Harmonics blocked_of(const VertexVisibility& vertex) {
    std::array<double, 16> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = vertex.blocked[i] / 32767.0;
    return harmonics_of(values);
}

f64::Surroundings around_of(const VertexVisibility& vertex) {
    std::array<double, 7> v{};
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = glm::unpackHalf1x16(vertex.around[i]);
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6] + 1.0f};
}

Place place_of(const Scene& scene, std::size_t instance, std::size_t vertex) {
    const Instance& of = scene.instances[instance];
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(of.mesh)];
    const glm::dmat4 transform(of.transform);
    const glm::dmat3 of_normals = glm::transpose(glm::inverse(glm::dmat3(transform)));
    return {glm::dvec3(transform * glm::dvec4(mesh.positions[vertex], 1.0)),
            glm::normalize(of_normals * glm::dvec3(mesh.normals[vertex]))};
}

std::size_t vertex_at(const Mesh& mesh, glm::dvec3 position) {
    std::size_t found = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double d = glm::length(glm::dvec3(mesh.positions[i]) - position);
        if (d < least) {
            least = d;
            found = i;
        }
    }
    return found;
}

IsBlocked by_disc(glm::dvec3 center, double radius, glm::dvec3 normal) {
    return [=](glm::dvec3 from, glm::dvec3 w) {
        const double along = glm::dot(w, normal);
        if (along == 0) return false;
        const double t = glm::dot(center - from, normal) / along;
        return t > 0 && glm::length(from + w * t - center) < radius;
    };
}

IsBlocked by_sphere(glm::dvec3 center, double radius) {
    return [=](glm::dvec3 from, glm::dvec3 w) {
        const glm::dvec3 to = center - from;
        const double along = glm::dot(to, w);
        return along > 0 && glm::length(to - w * along) < radius;
    };
}

f64::Harmonics expected_at(const Place& place, const IsBlocked& is_blocked) {
    std::array<double, 16> sums{};
    for_even_directions([&](glm::dvec3 w, double weight) {
        if (!is_blocked(place.position, mirrored_up(w, place.normal))) return;
        const auto h = values_of(f64::harmonics_at(to_f64(w)));
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += h[i] * weight;
    });
    return harmonics_of(sums);
}

double expected_share(const Place& place, const IsBlocked& is_blocked) {
    double sum = 0;
    for_even_directions([&](glm::dvec3 w, double weight) {
        const double cosine = glm::dot(w, place.normal);
        if (cosine > 0 && is_blocked(place.position, w)) sum += 4 * cosine * weight;
    });
    return sum;
}

double difference(const f64::Harmonics& a, const f64::Harmonics& b) {
    const auto x = values_of(a), y = values_of(b);
    double most = 0;
    for (std::size_t i = 0; i < x.size(); ++i) most = std::max(most, std::abs(x[i] - y[i]));
    return most;
}

bool is_open(const VertexVisibility& vertex) {
    return std::ranges::all_of(vertex.blocked, [](std::int16_t value) { return value == 0; });
}

bool is_open(const InstanceVisibility& instance) {
    return !instance.vertices.empty() &&
           std::ranges::all_of(instance.vertices,
                               [](const VertexVisibility& vertex) { return is_open(vertex); });
}

}  // namespace burnish::test
