// Rays from the points of a scene: the share of every direction that is blocked.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "burnish/f32.hpp"
#include "rays/ray_scene.hpp"
#include "rays/sample_mesh.hpp"

namespace burnish {

// Where rays leave a point: near its place on one of the triangles about it, so that a point in a corner does
// not look past the wall that it lies on.
class RayOrigins {
  public:
    // `side`: 1 for the side that the normal points to, -1 for the other.
    RayOrigins(const SampleMesh& mesh, std::span<const SampleMesh::Corner> fan, std::uint32_t point,
               float side);

    // The start of the ray of number `index` along `direction`; none where every triangle about the point faces
    // away.
    struct Start {
        glm::vec3 origin{0.0f};
        bool found = false;
    };
    Start at(std::size_t index, const glm::vec3& direction) const;

  private:
    static constexpr std::size_t kMost = 8;  // triangles that are taken
    std::array<glm::vec3, kMost> origins_{}, normals_{};
    std::size_t count_ = 0;
};

// Unit directions spread evenly over a hemisphere about +z: a spiral of even area, each step the golden angle
// (Swinbank and Purser 2006).
std::vector<glm::vec3> even_hemisphere(int count);

// The axes of a hemisphere about a unit normal, turned about it by an angle that differs from point to point, so
// that no pattern repeats over a surface.
class HemisphereAxes {
  public:
    HemisphereAxes(const glm::vec3& normal, std::uint32_t point);
    glm::vec3 operator()(const glm::vec3& local) const {
        return local.x * tangent_ + local.y * bitangent_ + local.z * normal_;
    }

  private:
    glm::vec3 tangent_{1.0f, 0.0f, 0.0f}, bitangent_{0.0f, 1.0f, 0.0f}, normal_;
};

// Which rays of the points are blocked, a bit each: on the side of the normal, and of double-sided points on the
// other side too.
class HitTable {
  public:
    HitTable() = default;
    // `sides`: 1, or 2 where any point is double-sided.
    HitTable(int rays, int sides)
        : words_((static_cast<std::size_t>(rays) + 31) / 32),
          sides_(static_cast<std::size_t>(sides)) {}
    void resize(std::size_t points) { bits_.resize(points * sides_ * words_, 0); }
    std::span<std::uint32_t> of(std::uint32_t point, std::size_t side) {
        return std::span(bits_).subspan((point * sides_ + side) * words_, words_);
    }
    std::span<const std::uint32_t> of(std::uint32_t point, std::size_t side) const {
        return std::span(bits_).subspan((point * sides_ + side) * words_, words_);
    }
    std::size_t count() const;  // of blocked rays

  private:
    std::size_t words_ = 0, sides_ = 1;
    std::vector<std::uint32_t> bits_;
};

// The blocked share of the directions about a point. Directions below the surface get the value of their mirror
// image above it: a perturbed lobe that reaches there sees no edge. A double-sided point has two sides of its
// own, unless one of them is closed in. `directions`: of even_hemisphere. `hits`: has room for the point, and
// receives its blocked rays.
f32::Harmonics blocked_at(const SampleMesh& mesh, const SampleMesh::Fans& fans,
                          const RayScene& rays, std::uint32_t point,
                          std::span<const glm::vec3> directions, HitTable& hits);

// Sums and multiples of functions.
f32::Harmonics operator+(const f32::Harmonics& a, const f32::Harmonics& b);
f32::Harmonics operator*(const f32::Harmonics& a, float factor);

}  // namespace burnish
