// A material as textures of glTF 2.0 with KHR_materials_anisotropy: any lobe, weave, scratch map or
// measured material in the terms that other programs draw.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>
#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/image.hpp"
#include "burnish/progress.hpp"
#include "burnish/scene.hpp"

namespace BURNISH_API burnish {

struct GltfBakeSettings {
    int width = 2048, height = 2048;  // texels of the tile, 16 to 16384
    int bits = 16;                    // of all maps but colors, which have 8: 8 or 16
};

struct GltfMaterial {
    // Metallic-roughness with a GltfLobe. Its textures are those below: base color, occlusion with
    // roughness and metallic (ORM), normal, anisotropy and, where it glows, emission. They share one
    // transform. Factors are 1, so that each map holds absolute values.
    Material material;
    std::vector<Texture> textures;
    // From texture coordinates to the tile that the maps show: (u', v', 1) = tile (u, v, 1).
    glm::mat3 tile{1.0f};
    // What glTF does not say, and what stands in its place: one line each.
    std::vector<std::string> losses;
};

// The repeating part of the material: of textures that share one transform their square, of a weave
// a whole number of its repeats, else the unit square of the texture coordinates. Detail smaller
// than a texel widens the lobe (docs/theory/normal-filtering.md). Color of vertices is no part of a
// material. `textures`: the scene's. Throws UsageError for settings out of range, and Error when more
// than `memory_limit` bytes would be needed.
GltfMaterial bake_gltf_material(const Material& material, std::span<const Texture> textures,
                                const GltfBakeSettings& settings, std::uint64_t memory_limit,
                                const Progress& progress = {});

// Width by height of the tile: 1 unless the material is a weave or measured.
double gltf_tile_aspect(const Material& material);

}  // namespace burnish
