// Materials of a glTF file.
#pragma once

#include <array>
#include <vector>

#include "burnish/scene.hpp"
#include "formats/gltf/gltf_images.hpp"

namespace tinygltf {
class Model;
}

namespace burnish {

struct GltfMaterials {
    std::vector<Material> materials;
    // The sets TEXCOORD_n that each material reads as Mesh::texcoord0 and texcoord1.
    std::vector<std::array<int, 2>> sets;
};

// All materials in the file's order; `images` records their textures. Factors out of range are
// clamped with a warning. Textures of a third set of coordinates are left out with a warning. Throws
// Error for texture, sampler and image indices out of range and for unknown names.
GltfMaterials read_gltf_materials(const tinygltf::Model& model, GltfImages& images,
                                  GltfReport& report);

}  // namespace burnish
