// Materials of a glTF file.
#pragma once

#include <vector>

#include "burnish/scene.hpp"
#include "formats/gltf/gltf_images.hpp"

namespace tinygltf {
class Model;
}

namespace burnish {

// All materials in the file's order; `images` records their textures. Factors out of range are
// clamped with a warning. Throws Error for texture, sampler and image indices out of range and for
// unknown names.
std::vector<Material> read_gltf_materials(const tinygltf::Model& model, GltfImages& images,
                                          GltfReport& report);

// The texture uses of a material, with their names in messages.
struct NamedTextureUse {
    TextureUse Material::*use;
    const char* name;
};
inline constexpr NamedTextureUse kTextureUses[] = {
    {&Material::base_color_texture, "base colour texture"},
    {&Material::metallic_roughness_texture, "metallic-roughness texture"},
    {&Material::normal_texture, "normal map"},
    {&Material::occlusion_texture, "occlusion texture"},
    {&Material::emissive_texture, "emissive texture"},
    {&Material::anisotropy_texture, "anisotropy texture"},
};

}  // namespace burnish
