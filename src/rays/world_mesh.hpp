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

// Of the instances that can be drawn and have triangles. Left out: those of a mesh or material that does not exist, or
// of a mesh with attributes of another length than its positions. Triangles with a position that is not finite have
// no area.
std::vector<WorldMesh> world_meshes(const Scene& scene);

}  // namespace burnish
