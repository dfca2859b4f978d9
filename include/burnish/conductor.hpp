// The optical constants of a metal.
//
// Threads and lifetime: plain values; copies are independent, and any number of threads may read
// one.
#pragma once

#include <glm/vec3.hpp>

namespace burnish {

// Complex index of refraction eta + i k at R, G, B.
struct Conductor {
    glm::vec3 eta{1.0f};
    glm::vec3 k{0.0f};
    bool operator==(const Conductor&) const = default;
};

}  // namespace burnish
