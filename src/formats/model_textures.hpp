// What the readers of models do alike with textures: those that cannot be read, and normal maps
// without a z.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "burnish/scene.hpp"

namespace burnish {

// Whether the material reflects nothing, as KHR_materials_unlit asks: a phong lobe of scale 0.
bool emits_only(const Material& material);

// Takes the textures that could not be read out of the materials, which are then drawn by their
// factors: base color without a pattern, flat normals. Emission whose picture is lost is none, but
// for materials that do nothing else. `failures`: one a texture of the scene, why it could not be
// read, empty where it was. White stands in its place. Returns one warning a texture.
std::vector<std::string> leave_out_textures(Scene& scene, const std::vector<std::string>& failures);

// A warning for a gray picture in the place of a packed map, whose channels hold a property each;
// empty: it has red, green and blue. `role`: what it is drawn as, "metallic-roughness".
std::string gray_packed_warning(const Texture& texture, std::string_view role);

// The same for the packed maps that the materials of the scene have: one line a texture.
std::vector<std::string> gray_packed_warnings(const Scene& scene);

// Normal maps whose blue says nothing become two-channel ones, whose z is what is left of 1
// (normal_map_without_z). Returns one warning a map.
std::vector<std::string> complete_normal_maps(Scene& scene);

}  // namespace burnish
