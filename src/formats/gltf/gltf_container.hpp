// A .gltf or .glb file taken apart into JSON text and binary chunk.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "formats/gltf/gltf_report.hpp"

namespace burnish {

struct GltfContainer {
    std::filesystem::path folder;  // relative URIs start here
    std::vector<std::byte> bytes;  // the whole file; the next two point into it
    std::string_view json;
    std::span<const std::byte> binary;  // of a .glb; empty when there is none
};

// Tells the two kinds apart by content. Throws Error for truncated files, other versions of glTF
// and files that are neither.
GltfContainer open_gltf_container(const std::filesystem::path& path, GltfReport& report);

// The file behind a URI of a glTF file. Throws Error unless it is a relative path that stays inside
// `folder`; percent-encoding is undone.
std::filesystem::path resolve_gltf_uri(const std::filesystem::path& folder, std::string_view uri,
                                       std::string_view key, const GltfReport& report);

}  // namespace burnish
