// A baked material as an element of glTF's "materials".
#pragma once

#include <string>
#include <vector>

#include "burnish/gltf_material.hpp"
#include "export/quad_gltf.hpp"

namespace burnish {

// The reflectance at normal incidence of glTF's dielectrics without KHR_materials_ior.
inline constexpr float kGltfF0 = 0.04f;

// The refractive index whose reflectance at normal incidence is f0, as KHR_materials_ior states it: 0
// where that is 1.
float ior_of(float f0);

// The files that hold the textures of a GltfMaterial, in their order.
std::vector<std::string> gltf_map_names(const GltfMaterial& baked);

// `source`: the material that was baked. What glTF does not say of it goes into extras.burnish, from
// which load_model restores it: mdf, brdf, method, the metal's refractive index, a weave, a measured
// material. `file`: the weave's draft or the measured material beside the glTF; "": neither.
QuadMaterial gltf_material_text(const GltfMaterial& baked, const Material& source,
                                const std::string& name, const std::string& file);

}  // namespace burnish
