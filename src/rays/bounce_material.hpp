// A material as it reflects light to other surfaces: by its mean colors.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "burnish/scene.hpp"

namespace burnish {

struct BounceMaterial {
    glm::vec3 diffuse{0.0f};  // of the base, under an interface: diffuse_albedo of these three
    int brdf = 0;
    float dielectric_f0 = 0.04f, dielectric_f90 = 1.0f;
    glm::vec3 specular{0.0f};  // reflectance at normal incidence
    float alpha = 1.0f;        // root of the product of the roughness pair
    glm::vec3 emitted{0.0f};   // radiance
};

// Linear red, green and blue, the mean over texels spread evenly.
glm::vec3 mean_color(const Texture& texture);

BounceMaterial bounce_material(const Material& material, std::span<const Texture> textures);

}  // namespace burnish
