// The node tree of a glTF file: what stands where in the world.
#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "formats/gltf/gltf_report.hpp"

namespace tinygltf {
class Model;
}

namespace burnish {

// A node of the scene shown, with its transform to world space.
struct GltfPlacement {
    int node = 0;
    glm::mat4 world{1.0f};
};

// The nodes of the default scene, or of the first, or all roots where there is none; parents before
// children. Throws Error for indices out of range, nodes with two parents or in a cycle, and
// transforms that leave the range of floats.
std::vector<GltfPlacement> walk_gltf_nodes(const tinygltf::Model& model, const GltfReport& report);

}  // namespace burnish
