// All uses of textures by a material, in one order: the one list that readers, renderers and writers walk.
//
// Threads: functions of their arguments. Lifetime: pointers into the material.
#pragma once

#include <array>

#include "burnish/scene.hpp"

namespace burnish {

enum class MaterialTexture {
    base_color,
    metallic_roughness,
    normal,
    occlusion,
    emissive,
    anisotropy,
    specular,
    specular_color,
    coat,
    coat_roughness,
    coat_normal,
    sheen_color,
    sheen_roughness
};
inline constexpr int kMaterialTextures = 13;

// In messages.
inline constexpr std::array<const char*, kMaterialTextures> kTextureNames = {
    "base color texture",
    "metallic-roughness texture",
    "normal map",
    "occlusion texture",
    "emissive texture",
    "anisotropy texture",
    "specular texture",
    "specular color texture",
    "coat texture",
    "coat roughness texture",
    "coat normal map",
    "sheen color texture",
    "sheen roughness texture"};

// By MaterialTexture. `M`: Material or const Material.
template <typename M>
auto texture_uses(M& m) {
    return std::array{
        &m.base_color_texture,     &m.metallic_roughness_texture, &m.normal_texture,
        &m.occlusion_texture,      &m.emissive_texture,           &m.anisotropy_texture,
        &m.specular_texture,       &m.specular_color_texture,     &m.coat.texture,
        &m.coat.roughness_texture, &m.coat.normal_texture,        &m.sheen.color_texture,
        &m.sheen.roughness_texture};
}

template <typename M>
auto& texture_use(M& m, MaterialTexture which) {
    return *texture_uses(m)[static_cast<std::size_t>(which)];
}

// Whether a cloth that has the texture reads it (Material in burnish/scene.hpp).
inline bool cloth_reads(const Material& m, const TextureUse& use) {
    return use && &use != &m.normal_texture && &use != &m.metallic_roughness_texture &&
           &use != &m.anisotropy_texture;
}

}  // namespace burnish
