// Supported extensions of glTF, and the effect on the picture of each unsupported one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/gltf/gltf_report.hpp"

namespace burnish {

bool is_gltf_extension_read(std::string_view name);

// Throws Error for an unsupported required extension; warns once for each other unsupported one.
void check_gltf_extensions(const std::vector<std::string>& used,
                           const std::vector<std::string>& required, GltfReport& report);

}  // namespace burnish
