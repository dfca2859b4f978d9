// The node tree of a glTF file: transforms of all nodes to world space.
#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "formats/gltf/gltf_report.hpp"

namespace tinygltf {
class Model;
}

namespace burnish {

// A node of the displayed scene with its transform to world space.
struct GltfPlacement {
    int node = 0;
    glm::dmat4 world{1.0};
};

// Whether all numbers of a transform are finite and at most kFarthest.
bool in_reach(const glm::dmat4& matrix);

// The nodes of the default scene; without a default, of the first scene; without scenes, of all
// roots. Parents precede children. Throws Error for indices out of range, nodes with two parents or
// in a cycle, and transforms out of the range of floats.
std::vector<GltfPlacement> walk_gltf_nodes(const tinygltf::Model& model, const GltfReport& report);

}  // namespace burnish
