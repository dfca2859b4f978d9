// EXT_meshopt_compression: one compressed buffer view.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/gltf/gltf_report.hpp"

namespace burnish {

inline constexpr const char* kMeshoptExtension = "EXT_meshopt_compression";

struct MeshoptView {
    std::span<const std::byte> bytes;
    std::size_t count = 0;
    std::size_t stride = 0;
    std::string mode;             // ATTRIBUTES, TRIANGLES, INDICES
    std::string filter = "NONE";  // OCTAHEDRAL, QUATERNION, EXPONENTIAL
};

// Returns count x stride bytes. Throws Error for layouts that the extension does not allow, for
// counts that the compressed bytes cannot encode, and for corrupt data.
std::vector<std::byte> decode_meshopt_view(const MeshoptView& view, std::string_view key,
                                           GltfReport& report);

}  // namespace burnish
