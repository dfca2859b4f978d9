// The keys of glTF that are read, and what each must be.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "formats/gltf/gltf_report.hpp"

namespace burnish {

// Throws Error naming the first key whose value is of the wrong kind, missing, or out of the range
// of the type it is read into. Keys that are not read are not looked at. Afterwards every known key
// can be handed to tinygltf, which ignores wrong kinds and cuts large integers.
void check_gltf_schema(const nlohmann::json& root, const GltfReport& report);

}  // namespace burnish
