// Holds glTF's JSON against the tables of gltf_rules.hpp.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "formats/gltf/gltf_report.hpp"

namespace burnish {

// Throws Error naming the first key whose value is of the wrong type, missing, or out of the range
// of the type it is read into. Unknown keys are ignored. Afterwards the document is safe for
// tinygltf, which ignores wrong types and truncates large integers.
void check_gltf_schema(const nlohmann::json& root, const GltfReport& report);

// Warns of every key inside materials and extensions that is none of theirs, and names the nearest one
// that is. The document has passed check_gltf_schema.
void warn_of_unknown_gltf_keys(const nlohmann::json& root, GltfReport& report);

}  // namespace burnish
