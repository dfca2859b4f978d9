// Which extensions of glTF are read, and what the absence of the others does to the picture.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/gltf/gltf_report.hpp"

namespace burnish {

bool is_gltf_extension_read(std::string_view name);

// Throws Error for a required extension we do not have; warns once for each other one.
void check_gltf_extensions(const std::vector<std::string>& used,
                           const std::vector<std::string>& required, GltfReport& report);

}  // namespace burnish
