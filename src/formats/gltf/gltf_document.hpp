// The JSON of a glTF file: checked, freed of what is not read, and put into tinygltf's structures.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "formats/gltf/gltf_report.hpp"

namespace tinygltf {
class Model;
}

namespace burnish {

struct GltfBuffer {
    std::string uri;
    std::uint64_t byte_length = 0;
    bool has_uri = false;
    bool fallback = false;  // EXT_meshopt_compression: stands in for data that is not there
};

struct GltfImage {
    std::string uri;  // empty: in `buffer_view`
    int buffer_view = -1;
};

// Buffers and images are ours to read (no copies, no paths out of the folder, no other decoder), so
// tinygltf never sees them: model->buffers and model->images are empty.
struct GltfDocument {
    std::shared_ptr<tinygltf::Model> model;
    std::vector<GltfBuffer> buffers;
    std::vector<GltfImage> images;
};

// Throws Error for JSON that is malformed, nested or populated beyond reason, of the wrong shape,
// of another version of glTF, or that requires an extension we do not have. Extensions and features
// that are left out become warnings.
GltfDocument parse_gltf_document(std::string_view json_text, GltfReport& report);

}  // namespace burnish
