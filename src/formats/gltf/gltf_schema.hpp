// The keys of glTF that are read, and the type and range of each.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "formats/gltf/gltf_report.hpp"

namespace burnish {

// Throws Error naming the first key whose value is of the wrong type, missing, or out of the range
// of the type it is read into. Unknown keys are ignored. Afterwards the document is safe for
// tinygltf, which ignores wrong types and truncates large integers.
void check_gltf_schema(const nlohmann::json& root, const GltfReport& report);

}  // namespace burnish
