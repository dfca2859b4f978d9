// What burnish writes of a material beside glTF's own words: extras.burnish.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "burnish/scene.hpp"
#include "formats/gltf/gltf_report.hpp"

namespace burnish {

// Restores what `burnish export material` says in `json` of a material: the distribution, the model,
// the method and the metal's refractive index over its maps; a weave or a measured material, whose
// file lies in `folder`, in place of its maps. Anything wrong is a warning that names `key`, and the
// maps are drawn.
void apply_gltf_extras(std::string_view json, const std::filesystem::path& folder,
                       const std::string& key, GltfReport& report, Material& material);

}  // namespace burnish
