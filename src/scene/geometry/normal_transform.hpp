// How a transform of positions acts on normals.
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace burnish {

// Whether the transform reverses handedness.
inline bool is_mirrored(const glm::mat3& linear) {
    return glm::determinant(linear) < 0.0f;
}

// The inverse transpose times the absolute determinant, by cofactors, which exist for a singular scale too.
inline glm::mat3 normal_transform(const glm::mat3& linear) {
    const glm::mat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                              glm::cross(linear[0], linear[1]));
    return is_mirrored(linear) ? -1.0f * cofactors : cofactors;
}

}  // namespace burnish
