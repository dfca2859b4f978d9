// The points of a scene at which visibility is found: its vertices, equal ones of all instances as one, so that
// seams of texture coordinates and borders of materials do not show. Splitting an edge adds its middle to every
// instance that has it, so that no gap opens.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "rays/world_mesh.hpp"

namespace burnish {

class SampleMesh {
  public:
    explicit SampleMesh(std::vector<WorldMesh> meshes);

    const std::vector<WorldMesh>& meshes() const { return meshes_; }
    std::size_t points() const { return positions_.size(); }
    glm::vec3 position(std::uint32_t point) const { return positions_[point]; }
    glm::vec3 normal(std::uint32_t point) const { return normals_[point]; }
    bool is_double_sided(std::uint32_t point) const { return double_sided_[point] != 0; }
    // The point of each vertex of a mesh.
    std::span<const std::uint32_t> points_of(std::size_t mesh) const {
        return vertex_points_[mesh];
    }
    // Of the vertices that splitting has added, the two between which each lies.
    using Parents = std::array<std::uint32_t, 2>;
    std::span<const Parents> added(std::size_t mesh) const { return added_[mesh]; }

    // Splits every edge of which `wants(a, b)` is true of the points at its ends in some triangle, at most
    // `most` edges in all. Returns their number.
    using Wants = std::function<bool(std::uint32_t a, std::uint32_t b)>;
    std::size_t split(const Wants& wants, std::size_t most);

    // The triangles about every point.
    struct Corner {
        std::uint32_t mesh = 0;
        std::uint32_t triangle = 0;
    };
    struct Fans {
        std::vector<std::uint32_t> first;  // of each point, and the end
        std::vector<Corner> corners;
        std::span<const Corner> of(std::uint32_t point) const {
            return std::span(corners).subspan(first[point], first[point + 1] - first[point]);
        }
    };
    Fans fans() const;
    std::array<glm::vec3, 3> corners_of(const Corner& corner) const;

  private:
    class Splitting;
    void weld_points();

    std::vector<WorldMesh> meshes_;
    std::vector<std::vector<std::uint32_t>> vertex_points_, vertex_places_;  // by mesh and vertex
    std::vector<std::vector<Parents>> added_;
    std::vector<glm::vec3> positions_, normals_;  // of points
    std::vector<std::uint8_t> double_sided_;
    std::uint32_t places_ = 0;  // distinct positions: an edge is two of them
};

}  // namespace burnish
