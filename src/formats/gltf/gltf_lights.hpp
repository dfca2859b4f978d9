// Cameras and KHR_lights_punctual of a glTF file.
#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "burnish/scene.hpp"
#include "formats/gltf/gltf_nodes.hpp"

namespace burnish {

// Adds the lights and cameras of the placed nodes to `scene`, in the order of the nodes. Cameras
// look along -z of their node; the distance of their target is that of the center of the scene's
// bounds. Throws Error for indices out of range and values that the format does not allow.
void add_gltf_lights(const tinygltf::Model& model, const std::vector<GltfPlacement>& placements,
                     const GltfReport& report, Scene& scene);
void add_gltf_cameras(const tinygltf::Model& model, const std::vector<GltfPlacement>& placements,
                      const GltfReport& report, Scene& scene);

}  // namespace burnish
