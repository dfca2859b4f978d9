// Splits a .gltf or .glb file into JSON text and binary chunk.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "formats/gltf/gltf_report.hpp"

namespace burnish {

struct GltfContainer {
    std::filesystem::path folder;  // base of relative URIs
    std::vector<std::byte> bytes;  // the whole file; the next two point into it
    std::string_view json;
    std::span<const std::byte> binary;  // of a .glb; empty when there is none
};

// Distinguishes the two formats by content. Throws Error for truncated files, other versions of
// glTF and files of another format.
GltfContainer open_gltf_container(const std::filesystem::path& path, GltfReport& report);

// The path of the file that a URI of a glTF file names. Percent-encoding is decoded. Throws Error
// unless the URI is a relative path inside `folder`.
std::filesystem::path resolve_gltf_uri(const std::filesystem::path& folder, std::string_view uri,
                                       std::string_view key, const GltfReport& report);

}  // namespace burnish
