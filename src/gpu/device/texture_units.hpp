// The texture unit of each texture, so that binding one never disturbs another.
#pragma once

#include <cstddef>

#include "gpu/device/gl.hpp"

namespace burnish::gpu {

// The first six textures of a material, in the order of MaterialTexture.
inline constexpr GLuint kMaterialUnits = 0;
inline constexpr std::size_t kFirstMaterialUnits = 6;
inline constexpr GLuint kEnvironmentUnit = 6;
inline constexpr GLuint kIrradianceUnit = 7;
inline constexpr GLuint kPackedUnit = 8;  // images of gbuffer.frag
inline constexpr GLuint kPositionUnit = 9;
inline constexpr GLuint kSumUnit = 10;
inline constexpr GLuint kLatestUnit = 11;
inline constexpr GLuint kLobeUnit = 12;
inline constexpr GLuint kAlbedoUnit = 13;
inline constexpr GLuint kShadowUnit = 14;
inline constexpr GLuint kScratchUnit = 15;  // for uploads
// Cloth. The unit numbers exceed 15, but no program has more than the 16 samplers it may have.
inline constexpr GLuint kWeaveCellsUnit = 16;
inline constexpr GLuint kWeaveWeftUnit = 17;
inline constexpr GLuint kWeaveWarpUnit = 18;
inline constexpr GLuint kWeaveLobesUnit = 19;
// Tabulated materials.
inline constexpr GLuint kTabulatedUnits = 20;  // and the next four
inline constexpr GLuint kShapeUnit = 25;       // also an image of gbuffer.frag
inline constexpr GLuint kSlopeCovarianceUnit = 26;
inline constexpr GLuint kWeightsUnit = 27;  // beside kSumUnit
inline constexpr GLuint kSeenUnits = 35;    // images of gbuffer.frag, and the next one
inline constexpr GLuint kLayerUnits = 28;   // of a material's further textures: and the next six

// The unit of a material's texture, by MaterialTexture.
constexpr GLuint material_unit(std::size_t texture) {
    const bool first = texture < kFirstMaterialUnits;
    return static_cast<GLuint>(first ? kMaterialUnits + texture
                                     : kLayerUnits + texture - kFirstMaterialUnits);
}
inline constexpr GLuint kAreaTextureUnit = 37;

}  // namespace burnish::gpu
