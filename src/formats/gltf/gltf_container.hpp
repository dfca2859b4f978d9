// Splits a .gltf or .glb file into JSON text and binary chunk.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "formats/gltf/gltf_report.hpp"
#include "formats/model_files.hpp"

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

enum class GltfFile { picture, buffer };

// The path of the file that a URI of a glTF file names, with percent-encoding decoded; `folder` is
// that of the file, and of `files`. Paths of another machine are looked for in the folder
// (ModelFiles); a warning names what was found in their place. Throws Error for other schemes than
// file:, and for a path that leads outside and names nothing inside.
std::filesystem::path resolve_gltf_uri(ModelFiles& files, const std::filesystem::path& folder,
                                       GltfFile kind, std::string_view uri, std::string_view key,
                                       GltfReport& report);

}  // namespace burnish
