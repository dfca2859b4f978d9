#include "rays/vertex_rays.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "rays/vectors.hpp"

namespace burnish {
namespace {

// Rays start at this share of the way from the point to the middle of the triangle.
constexpr float kInset = 0.1f;
// Rays lower over their triangle than this start on another one.
constexpr float kLowest = 0.01f;
// A side of which this share is blocked lies within a body.
constexpr float kClosed = 0.97f;

// A hash of an integer in [0, 1) (Wellons, "Hash function prospecting", lowbias32).
float unit_hash(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352dU;
    x = (x ^ (x >> 15)) * 0x846ca68bU;
    x ^= x >> 16;
    return static_cast<float>(x >> 8) * 0x1p-24f;
}

}  // namespace

f32::Harmonics operator+(const f32::Harmonics& a, const f32::Harmonics& b) {
    f32::Harmonics c;
    c.mean = a.mean + b.mean;
    c.x1 = a.x1 + b.x1;
    c.x2 = a.x2 + b.x2;
    c.y2 = {a.y2.x + b.y2.x, a.y2.y + b.y2.y};
    c.x3 = a.x3 + b.x3;
    c.y3 = a.y3 + b.y3;
    c.z3 = a.z3 + b.z3;
    return c;
}

f32::Harmonics operator*(const f32::Harmonics& a, float factor) {
    f32::Harmonics c;
    c.mean = a.mean * factor;
    c.x1 = a.x1 * factor;
    c.x2 = a.x2 * factor;
    c.y2 = {a.y2.x * factor, a.y2.y * factor};
    c.x3 = a.x3 * factor;
    c.y3 = a.y3 * factor;
    c.z3 = a.z3 * factor;
    return c;
}

std::size_t HitTable::count() const {
    std::size_t sum = 0;
    for (const std::uint32_t word : bits_) sum += static_cast<std::size_t>(std::popcount(word));
    return sum;
}

RayOrigins::RayOrigins(const SampleMesh& mesh, std::span<const SampleMesh::Corner> fan,
                       std::uint32_t point, float side) {
    const glm::vec3 at = mesh.position(point);
    const glm::vec3 up = side * mesh.normal(point);
    for (const SampleMesh::Corner& corner : fan) {
        if (count_ == kMost) break;
        const auto [a, b, c] = mesh.corners_of(corner);
        glm::vec3 normal = glm::cross(b - a, c - a);
        const float area = glm::length(normal);
        if (!(area > 0.0f)) continue;
        normal = normal / area;
        if (glm::dot(normal, up) < 0.0f) normal = -1.0f * normal;
        const glm::vec3 inward = kInset * ((a + b + c) / 3.0f - at);
        const glm::vec3 size = glm::abs(at);
        // Off the triangle by more than the rounding of coordinates (2^-23) and of the intersection.
        const float off = 1e-3f * glm::length(inward) + 1e-6f * std::max({size.x, size.y, size.z});
        origins_[count_] = at + inward + off * normal;
        normals_[count_++] = normal;
    }
}

RayOrigins::Start RayOrigins::at(std::size_t index, const glm::vec3& direction) const {
    for (std::size_t k = 0; k < count_; ++k) {
        const std::size_t i = (index + k) % count_;
        if (glm::dot(normals_[i], direction) > kLowest) return {origins_[i], true};
    }
    return {};
}

std::vector<glm::vec3> even_hemisphere(int count) {
    constexpr double kStep = 2.0 * std::numbers::pi * (1.0 - 1.0 / std::numbers::phi);
    std::vector<glm::vec3> directions;
    for (int i = 0; i < count; ++i) {
        const double z = (i + 0.5) / count, r = std::sqrt(1.0 - z * z);
        directions.emplace_back(r * std::cos(kStep * i), r * std::sin(kStep * i), z);
    }
    return directions;
}

HemisphereAxes::HemisphereAxes(const glm::vec3& normal, std::uint32_t point) : normal_(normal) {
    const glm::vec3 axis =
        std::abs(normal.x) < 0.6f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    const glm::vec3 x = glm::normalize(glm::cross(axis, normal));
    const glm::vec3 y = glm::cross(normal, x);
    const float angle = 2.0f * std::numbers::pi_v<float> * unit_hash(point);
    tangent_ = std::cos(angle) * x + std::sin(angle) * y;
    bitangent_ = glm::cross(normal, tangent_);
}

namespace {

// Of one side: the function over its hemisphere, its mirror image, and the share that is blocked.
struct Side {
    f32::Harmonics own{}, mirrored{};
    float share = 0.0f;
};

Side side_of(const SampleMesh& mesh, std::span<const SampleMesh::Corner> fan, const RayScene& rays,
             std::uint32_t point, float side, std::span<const glm::vec3> directions,
             std::span<std::uint32_t> hits) {
    const glm::vec3 up = side * mesh.normal(point);
    const RayOrigins origins(mesh, fan, point, side);
    const HemisphereAxes axes(up, point);
    Side sum;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const glm::vec3 w = axes(directions[i]);
        const RayOrigins::Start start = origins.at(i, w);
        if (!start.found || !rays.is_blocked({start.origin, w, 0.0f, 0.0f})) continue;
        hits[i / 32] |= 1U << (i % 32);
        sum.own = sum.own + f32::harmonics_at(to_f32(w));
        sum.mirrored = sum.mirrored + f32::harmonics_at(to_f32(w - 2.0f * glm::dot(w, up) * up));
        sum.share += 1.0f;
    }
    // A mean over the sphere: each hemisphere is half of it.
    const float each = 1.0f / static_cast<float>(directions.size());
    sum.own = sum.own * (0.5f * each);
    sum.mirrored = sum.mirrored * (0.5f * each);
    sum.share *= each;
    return sum;
}

}  // namespace

f32::Harmonics blocked_at(const SampleMesh& mesh, const SampleMesh::Fans& fans,
                          const RayScene& rays, std::uint32_t point,
                          std::span<const glm::vec3> directions, HitTable& hits) {
    const std::span<const SampleMesh::Corner> fan = fans.of(point);
    const glm::vec3 normal = mesh.normal(point);
    if (fan.empty() || glm::dot(normal, normal) == 0.0f) return f32::Harmonics{};
    const Side front = side_of(mesh, fan, rays, point, 1.0f, directions, hits.of(point, 0));
    if (!mesh.is_double_sided(point)) return front.own + front.mirrored;
    const Side back = side_of(mesh, fan, rays, point, -1.0f, directions, hits.of(point, 1));
    if (back.share > kClosed) return front.own + front.mirrored;
    if (front.share > kClosed) return back.own + back.mirrored;
    return front.own + back.own;
}

}  // namespace burnish
