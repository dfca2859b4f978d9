// A point of a surface, as rays find it. World space, meters.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "reference/texture_pyramid.hpp"

namespace burnish {

struct SurfaceHit {
    int material = 0;  // index into the scene's
    glm::vec3 position{0.0f};
    // Where rays leave: on the curved surface that the normals of the vertices tell of (Hanika, "Hacking the Shadow
    // Terminator", 2021), so that triangles do not shade themselves.
    glm::vec3 smooth_position{0.0f};
    glm::vec3 to_eye{0.0f, 0.0f, 1.0f};  // unit, against the ray
    glm::vec3 side{0.0f, 0.0f, 1.0f};    // normal of the triangle on the side of the ray: unit
    glm::vec3 normal{0.0f, 0.0f, 1.0f};  // interpolated, towards the front
    glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f};  // interpolated; w < 0: mirrored bitangent
    bool front = true;                          // the ray sees the front
    glm::vec4 color{1.0f};                      // of the vertices, linear
    std::array<glm::vec2, 2> uv{};              // of the two sets; 0 where the mesh has none
    std::array<TextureFootprint, 2> footprint{};
};

}  // namespace burnish
