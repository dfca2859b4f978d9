// EXT_mesh_gpu_instancing: the transforms of a node's copies.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "formats/gltf/gltf_accessors.hpp"

namespace tinygltf {
class Node;
}

namespace burnish {

// One transform a copy, in the space of the node; nothing for a node without the extension. Throws
// Error for attributes of different lengths, for more copies than kMostInstances, for rotations
// without a direction and numbers that are not finite.
std::optional<std::vector<glm::dmat4>> read_gltf_instances(const tinygltf::Node& node,
                                                           const std::string& key,
                                                           GltfAccessors& accessors,
                                                           GltfReport& report);

}  // namespace burnish
