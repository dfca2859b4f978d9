// An instance's triangles in world space.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "burnish/scene.hpp"

namespace burnish {

struct WorldMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  // unit, or 0
    std::vector<std::uint32_t> indices;
    int instance = 0;
    int material = 0;
    bool double_sided = false;
    bool blocks = true;     // false: it blends
    bool mirrored = false;  // the indices are in the other order than the mesh's
};

// Of the instances that are there and have triangles. Triangles with a position that is not finite are left out.
std::vector<WorldMesh> world_meshes(const Scene& scene);

}  // namespace burnish
