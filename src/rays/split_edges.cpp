// Splitting edges: the triangles of an edge that is split get its middle as a corner, whichever instance they
// belong to.
#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "rays/sample_mesh.hpp"

namespace burnish {
namespace {

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
}

}  // namespace

class SampleMesh::Splitting {
  public:
    explicit Splitting(SampleMesh& mesh) : mesh_(mesh) {}

    // Finds the edges to split; each gets the place of its middle.
    void mark(const Wants& wants, std::size_t most) {
        for (std::size_t m = 0; m < mesh_.meshes_.size(); ++m) {
            const std::vector<std::uint32_t>& indices = mesh_.meshes_[m].indices;
            for (std::size_t c = 0; c < indices.size() && middles_.size() < most; ++c) {
                const std::uint32_t a = indices[c], b = indices[c - c % 3 + (c + 1) % 3];
                const std::uint64_t edge =
                    key_of(mesh_.vertex_places_[m][a], mesh_.vertex_places_[m][b]);
                if (a == b || middles_.contains(edge)) continue;
                if (wants(mesh_.vertex_points_[m][a], mesh_.vertex_points_[m][b]))
                    middles_.emplace(edge, mesh_.places_++);
            }
        }
    }

    std::size_t edges() const { return middles_.size(); }

    void split(std::size_t m) {
        std::unordered_map<std::uint64_t, std::uint32_t> vertices;  // of this mesh's edges
        std::vector<std::uint32_t> split;
        std::vector<std::uint32_t>& indices = mesh_.meshes_[m].indices;
        split.reserve(indices.size());
        for (std::size_t c = 0; c + 2 < indices.size(); c += 3) {
            const std::array<std::uint32_t, 3> corner = {indices[c], indices[c + 1],
                                                         indices[c + 2]};
            std::array<std::uint32_t, 3> middle{};
            int cut = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                middle[k] = middle_vertex(m, vertices, corner[k], corner[(k + 1) % 3]);
                cut += middle[k] != kNone ? 1 : 0;
            }
            add_parts(split, corner, middle, cut);
        }
        indices = std::move(split);
    }

  private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    // The vertex in the middle of an edge; kNone where it is not split.
    std::uint32_t middle_vertex(std::size_t m,
                                std::unordered_map<std::uint64_t, std::uint32_t>& vertices,
                                std::uint32_t a, std::uint32_t b) {
        if (a == b) return kNone;
        const auto found =
            middles_.find(key_of(mesh_.vertex_places_[m][a], mesh_.vertex_places_[m][b]));
        if (found == middles_.end()) return kNone;
        WorldMesh& mesh = mesh_.meshes_[m];
        const auto [at, fresh] = vertices.try_emplace(key_of(a, b), 0);
        if (!fresh) return at->second;
        at->second = static_cast<std::uint32_t>(mesh.positions.size());
        const glm::vec3 sum = mesh.normals[a] + mesh.normals[b];
        const float length = glm::length(sum);
        mesh.positions.push_back(0.5f * mesh.positions[a] + 0.5f * mesh.positions[b]);
        mesh.normals.push_back(length > 0.0f ? sum / length : glm::vec3(0.0f));
        mesh_.added_[m].push_back({a, b});
        mesh_.vertex_places_[m].push_back(found->second);
        mesh_.vertex_points_[m].push_back(
            middle_point(m, a, b, mesh.positions.back(), mesh.normals.back()));
        return at->second;
    }

    std::uint32_t middle_point(std::size_t m, std::uint32_t a, std::uint32_t b,
                               const glm::vec3& position, const glm::vec3& normal) {
        const std::uint32_t pa = mesh_.vertex_points_[m][a], pb = mesh_.vertex_points_[m][b];
        const auto [at, fresh] = points_.try_emplace(key_of(pa, pb), 0);
        if (!fresh) return at->second;
        at->second = static_cast<std::uint32_t>(mesh_.positions_.size());
        mesh_.positions_.push_back(position);
        mesh_.normals_.push_back(normal);
        mesh_.double_sided_.push_back(std::max(mesh_.double_sided_[pa], mesh_.double_sided_[pb]));
        return at->second;
    }

    // The parts of a triangle: `middle` k lies between the corners k and k + 1. Two middles that are not
    // opposite one another leave a quadrangle, which is cut by the same diagonal whatever the order.
    static void add_parts(std::vector<std::uint32_t>& out,
                          const std::array<std::uint32_t, 3>& corner,
                          const std::array<std::uint32_t, 3>& middle, int cut) {
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            out.insert(out.end(), {a, b, c});
        };
        if (cut == 0) return add(corner[0], corner[1], corner[2]);
        if (cut == 3) {
            for (std::size_t k = 0; k < 3; ++k) add(corner[k], middle[k], middle[(k + 2) % 3]);
            return add(middle[0], middle[1], middle[2]);
        }
        // Rotated until the first edge is cut and, of two, the second is not the last.
        std::size_t k = 0;
        while (middle[k] == kNone || (cut == 2 && middle[(k + 1) % 3] == kNone)) ++k;
        const std::uint32_t a = corner[k], b = corner[(k + 1) % 3], c = corner[(k + 2) % 3];
        const std::uint32_t ab = middle[k];
        if (cut == 1) {
            add(a, ab, c);
            return add(ab, b, c);
        }
        const std::uint32_t bc = middle[(k + 1) % 3];
        add(ab, b, bc);
        add(a, ab, bc);
        add(a, bc, c);
    }

    SampleMesh& mesh_;
    std::unordered_map<std::uint64_t, std::uint32_t>
        middles_;  // the place in the middle of an edge of places
    std::unordered_map<std::uint64_t, std::uint32_t>
        points_;  // the point in the middle of two points
};

std::size_t SampleMesh::split(const Wants& wants, std::size_t most) {
    Splitting splitting(*this);
    splitting.mark(wants, most);
    if (splitting.edges() == 0) return 0;
    for (std::size_t m = 0; m < meshes_.size(); ++m) splitting.split(m);
    return splitting.edges();
}

}  // namespace burnish
