#include <meshoptimizer.h>

#include <algorithm>

#include "burnish/mesh.hpp"

namespace burnish {

std::vector<std::uint32_t> coarse_indices(const Mesh& mesh, std::size_t triangles) {
    const std::size_t vertices = mesh.positions.size();
    if (mesh.indices.size() <= 3 * triangles || vertices == 0) return {};
    std::vector<std::uint32_t> coarse(mesh.indices.size());
    // No bound of the error: the number of triangles is what is asked for.
    constexpr float kAnyError = 1e9f;
    const std::size_t count = meshopt_simplify(
        coarse.data(), mesh.indices.data(), mesh.indices.size(), &mesh.positions[0].x, vertices,
        sizeof(mesh.positions[0]), 3 * triangles, kAnyError, 0, nullptr);
    coarse.resize(count);
    meshopt_optimizeVertexCache(coarse.data(), coarse.data(), count, vertices);
    return coarse;
}

}  // namespace burnish
