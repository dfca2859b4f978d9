// The JSON of a glTF file: checked, stripped of unused values, and converted to tinygltf's
// structures.
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
    bool fallback = false;  // EXT_meshopt_compression: a placeholder without data
};

struct GltfImage {
    std::string uri;  // empty: the image is in `buffer_view`
    int buffer_view = -1;
};

// Buffers and images are read by our own code (no copies, no paths out of the folder, no other
// decoder). tinygltf never sees them: model->buffers and model->images are empty.
struct GltfDocument {
    std::shared_ptr<tinygltf::Model> model;
    std::vector<GltfBuffer> buffers;
    std::vector<GltfImage> images;
};

// Throws Error for JSON that is malformed, too deep, too large, of the wrong shape, of another
// version of glTF, or that requires an unsupported extension. Unsupported optional extensions and
// features become warnings.
GltfDocument parse_gltf_document(std::string_view json_text, GltfReport& report);

}  // namespace burnish
