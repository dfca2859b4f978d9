// Triangle meshes in memory. Right-handed, metres, +y up, counter-clockwise front faces.
//
// Threads and lifetime: plain values; copies are independent, and any number of threads may read
// one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

// The texture coordinates that tangents were made of: a set, and how a texture's transform turns it.
struct TangentSource {
    int texcoord = 0;             // 0 or 1
    glm::vec2 along{1.0f, 0.0f};  // unit: the direction in (u, v) in which the transformed u grows
    bool mirrored = false;        // the transform mirrors
    bool operator==(const TangentSource&) const = default;
};

// Every attribute is empty or as long as `positions`. After loading, `normals` and `tangents` are
// always present, unit length and finite; `texcoord0` is empty when the file had none.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;  // xyz along increasing u, w = +-1: bitangent = w cross(n, t)
    // None: the tangents are the file's, and fit_tangents leaves them as they are.
    std::optional<TangentSource> tangent_source;
    std::vector<glm::vec2> texcoord0;
    std::vector<glm::vec2> texcoord1;
    std::vector<glm::vec4> colors;       // linear RGBA
    std::vector<std::uint32_t> indices;  // 3 a triangle
};

struct Bounds {
    glm::vec3 low{0.0f};
    glm::vec3 high{0.0f};
    // Halved first, so that the sum cannot overflow.
    glm::vec3 center() const { return 0.5f * low + 0.5f * high; }
    float radius() const;  // of the sphere around the box; finite for finite corners
};

// The box of all positions, those with a coordinate that is not finite left out; a point at the
// origin when none is left.
Bounds bounds_of(const Mesh& mesh);

// A coarse form of the mesh: about `triangles` triangles, as three indices each into its vertices, in an
// order that is quick to draw. There are more triangles where its topology allows no fewer. Edges are
// collapsed in the order of their quadric error (Garland and Heckbert 1997, by meshoptimizer); borders and
// seams of texture coordinates stay closed. Empty where the mesh has no more than `triangles`.
std::vector<std::uint32_t> coarse_indices(const Mesh& mesh, std::size_t triangles);

}  // namespace burnish
