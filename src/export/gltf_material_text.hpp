// A baked material as an element of glTF's "materials".
#pragma once

#include <string>
#include <vector>

#include "burnish/gltf_material.hpp"
#include "export/quad_gltf.hpp"

namespace burnish {

// The files that hold the textures of a GltfMaterial, in their order.
std::vector<std::string> gltf_map_names(const GltfMaterial& baked);

// `source`: the material that was baked. What glTF does not say of it goes into extras.burnish, from
// which load_model restores it: mdf, brdf, method, the metal's refractive index. `table`: the file of
// the measured material beside the glTF; "": none.
QuadMaterial gltf_material_text(const GltfMaterial& baked, const Material& source,
                                const std::string& name, const std::string& table);

}  // namespace burnish
