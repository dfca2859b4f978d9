#include "formats/gltf/gltf_triangles.hpp"

#include <tiny_gltf.h>

namespace burnish {
namespace {

void drop_collapsed(std::vector<std::uint32_t>& indices) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const std::uint32_t a = indices[i];
        const std::uint32_t b = indices[i + 1];
        const std::uint32_t c = indices[i + 2];
        if (a == b || b == c || c == a) continue;
        indices[kept++] = a;
        indices[kept++] = b;
        indices[kept++] = c;
    }
    indices.resize(kept);
}

}  // namespace

std::vector<std::uint32_t> triangle_list(std::vector<std::uint32_t> indices, int mode) {
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        drop_collapsed(indices);
        return indices;
    }
    std::vector<std::uint32_t> triangles;
    if (indices.size() < 3) return triangles;
    triangles.reserve(3 * (indices.size() - 2));
    for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
        if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
            // Every second triangle of a strip has the opposite orientation.
            triangles.push_back(indices[i]);
            triangles.push_back(indices[i + 1 + i % 2]);
            triangles.push_back(indices[i + 2 - i % 2]);
        } else {
            triangles.push_back(indices[i + 1]);
            triangles.push_back(indices[i + 2]);
            triangles.push_back(indices[0]);
        }
    }
    drop_collapsed(triangles);
    return triangles;
}

}  // namespace burnish
