// The nearest triangle of a mesh that a ray meets: a tree of bounding boxes.
//
// Threads: a tree may be read from any number of threads. Lifetime: it keeps a copy of the positions.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "burnish/mesh.hpp"

namespace burnish::viewer {

// A ray in the space of the mesh; the direction need not be unit.
struct TreeRay {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0};
    double from = 0, to = 0;  // range of the parameter t
};

struct TreeHit {
    double t = 0;
    std::uint32_t triangle = 0;   // three of Mesh::indices
    glm::dvec3 barycentric{0.0};  // weights of the three corners
    bool front = true;
};

class TriangleTree {
  public:
    TriangleTree() = default;
    // Triangles with a position that is not finite are left out.
    explicit TriangleTree(const Mesh& mesh);

    // Which sides of the triangles count; the front shows its corners counter-clockwise.
    enum class Faces { front, both };
    std::optional<TreeHit> nearest(const TreeRay& ray, Faces faces) const;

    std::size_t triangles() const { return triangles_.size(); }

  private:
    struct Node {
        glm::vec3 low{0.0f}, high{0.0f};
        // Leaf: the first of `count` triangles. Else count is 0; the children are the next node and `first`.
        std::uint32_t first = 0, count = 0;
    };
    struct Triangle {
        std::array<glm::vec3, 3> corners;
        std::uint32_t index = 0;
    };
    struct Box;
    struct Build;

    std::uint32_t add_node(Build& build, std::uint32_t begin, std::uint32_t end);

    std::vector<Node> nodes_;
    std::vector<Triangle> triangles_;
};

}  // namespace burnish::viewer
