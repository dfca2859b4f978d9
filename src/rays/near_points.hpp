// Points near one another, whatever triangles lie between them: for means that do not depend on how a mesh is cut.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "rays/sample_mesh.hpp"

namespace burnish {

class NearPoints {
  public:
    // References stay the caller's.
    NearPoints(const SampleMesh& mesh, const SampleMesh::Fans& fans, float radius);

    // Other points within the radius, and those of the triangles about the point however far they are, whose normals
    // differ by less than about 25 degrees. At most 64, from all around, the same at every call.
    struct Near {
        std::uint32_t point = 0;
        float weight = 0.0f;  // above 0, 1 at the point, falling to 0 at the radius
    };
    void find(std::uint32_t point, std::vector<Near>& found) const;

  private:
    using Cell = std::array<std::int32_t, 3>;
    Cell cell_of(const glm::vec3& position) const;
    static std::uint64_t key_of(const Cell& cell);
    bool is_parallel(std::uint32_t a, std::uint32_t b) const;
    float distance2_between(std::uint32_t a,
                            std::uint32_t b) const;  // over the square of the radius
    void add_cell(std::uint32_t point, const Cell& cell, std::vector<Near>& found) const;
    void add_far_corners(std::uint32_t point, std::vector<Near>& found) const;

    const SampleMesh& mesh_;
    const SampleMesh::Fans& fans_;
    float radius_;
    std::vector<std::uint32_t> points_;  // by cell
    std::unordered_map<std::uint64_t, std::array<std::uint32_t, 2>>
        cells_;  // first and end in points_
};

}  // namespace burnish
