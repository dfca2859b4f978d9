// KHR_draco_mesh_compression: the attributes and triangles of one primitive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/gltf/gltf_report.hpp"

namespace burnish {

struct DracoAttribute {
    int components = 0;
    std::vector<float> values;  // `components` for each vertex
};

struct DracoMesh {
    std::size_t vertices = 0;
    std::map<int, DracoAttribute> attributes;  // by the id that was asked for
    std::vector<std::uint32_t> indices;        // three a triangle, each below `vertices`
};

// What the primitive's accessors say of the compressed data.
struct DracoExpected {
    std::size_t vertices = 0;
    std::size_t corners = 0;  // 0: the primitive has no indices to compare with
    std::map<int, bool> ids;  // attributes to read -> whether their integers are normalized
};

// Throws Error for data of another version than 2.2, that is corrupt, that disagrees with the
// accessors, or that expands to more memory than the file may.
DracoMesh decode_draco_mesh(std::span<const std::byte> bytes, const DracoExpected& expected,
                            std::string_view key, GltfReport& report);

}  // namespace burnish
