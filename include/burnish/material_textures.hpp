// Textures of a glTF 2.0 material with KHR_materials_anisotropy from a fitted one.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <array>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/image.hpp"
#include "burnish/lobe_fit.hpp"
#include "burnish/tabulated_material.hpp"

namespace BURNISH_API burnish {

// Whether a surface of this specular colour may be a dielectric: its luminance is at most 0.17 (diamond).
bool is_dielectric(const std::array<float, 3>& specular);

// The reflectance at normal incidence that one KHR_materials_ior gives all dielectrics of a material: the
// mean luminance of `specular` over the texels that may be dielectrics; 0.04, which is glTF's own, where
// there are none.
float dielectric_f0_of(const TabulatedMaterial& material);

// What glTF's metallic-roughness model says of a diffuse and a specular colour. A dielectric has
// the reflectance `f0`: base = diffuse. Else
//   diffuse = base (1 - metallic),  specular = f0 (1 - metallic) + base metallic
// solved for luminances, then base for each channel by least squares, clamped to 0..1. No metal
// reflects so little, and a mixture would take its color from the specular one.
struct MetallicColor {
    std::array<float, 3> base{};
    float metallic = 0.0f;
};
MetallicColor metallic_color(const std::array<float, 3>& diffuse,
                             const std::array<float, 3>& specular, float f0);

// KHR_materials_anisotropy: alpha along = roughness^2, alpha across = mix(alpha along, 1,
// strength^2).
struct AnisotropicRoughness {
    float roughness = 0.0f, strength = 0.0f;
};
AnisotropicRoughness anisotropic_roughness(const LobeFit& lobe);

// The groove of a texel in sample space, radians in [0, pi); the texel has an exemplar.
double groove_at(const TabulatedMaterial& material, const std::vector<LobeFit>& lobes,
                 std::size_t texel);

// Display values: base colour, with alpha where the material has a mask.
Image base_color_texture(const TabulatedMaterial& material, bool masked);
// Data: roughness in green, metallic in blue.
Image metallic_roughness_texture(const TabulatedMaterial& material,
                                 const std::vector<LobeFit>& lobes);
Image normal_texture(const TabulatedMaterial& material);
// Data: the direction of the stretch, a quarter turn from the groove, in red and green, its
// strength in blue. Of the two directions of a line that one which turns least from the texels to
// the left and above, so that filtering finds few seams.
Image anisotropy_texture(const TabulatedMaterial& material, const std::vector<LobeFit>& lobes);

}  // namespace burnish
