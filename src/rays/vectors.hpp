// Between the vectors of glm and those of shading/.
#pragma once

#include <glm/vec3.hpp>

#include "burnish/f32.hpp"

namespace burnish {

inline glm::vec3 to_glm(const f32::vec3& v) {
    return {v.x, v.y, v.z};
}

inline f32::vec3 to_f32(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

}  // namespace burnish
