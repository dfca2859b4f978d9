// The JSON of a glTF file: checked, stripped of unused values, and converted to tinygltf's
// structures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
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

// A texture's versions of one picture, the preferred one first: indices of images, each with the key
// that names it.
struct GltfTexture {
    struct Version {
        int image = -1;
        std::string key;
    };
    std::vector<Version> versions;
    std::string unread;  // an extension with a further version that is not read; empty: none
};

// KHR_draco_mesh_compression of one primitive.
struct GltfDraco {
    int buffer_view = -1;
    int indices = -1;                       // the primitive's accessor; the model has none
    std::map<std::string, int> attributes;  // ids in the compressed data, by attribute
};

// Buffers and images are read by our own code (no copies, no paths out of the folder, no other
// decoder). tinygltf never sees them: model->buffers and model->images are empty.
struct GltfDocument {
    std::shared_ptr<tinygltf::Model> model;
    std::vector<GltfBuffer> buffers;
    std::vector<GltfImage> images;
    std::vector<GltfTexture> textures;
    std::map<std::pair<std::size_t, std::size_t>, GltfDraco> draco;  // by (mesh, primitive)
    std::map<std::size_t, std::string> extras;  // by material: extras.burnish, as JSON
};

// Throws Error for JSON that is malformed, too deep, too large, of the wrong shape, of another
// version of glTF, or that requires an unsupported extension. Unsupported optional extensions and
// features become warnings.
GltfDocument parse_gltf_document(std::string_view json_text, GltfReport& report);

}  // namespace burnish
