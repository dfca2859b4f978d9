// Surfaces and small scenes for the tests of paths.
#pragma once

#include <glm/geometric.hpp>
#include <vector>

#include "gpu/test_scene.hpp"
#include "reference/material_reader.hpp"

namespace burnish::test {

// A surface of the plane z = 0 seen from `to_eye`, under a normal map of one tilt.
inline PointSurface surface_of(Material material, glm::vec3 to_eye,
                               glm::vec3 tilt = {0.3f, 0.2f, 1.0f}) {
    static std::vector<Texture> textures(1);
    material.normal_texture.texture = 0;
    textures[0] = constant_texture(0.5f * glm::normalize(tilt) + 0.5f);
    PyramidStore pyramids(textures);
    const MaterialReader reader(drawn_material(material), pyramids);
    SurfaceHit hit;
    hit.to_eye = glm::normalize(to_eye);
    return reader.at(hit, {0.3f, 0.6f});
}

inline Material rough_metal(glm::vec2 alpha = {0.3f, 0.6f}) {
    Material m;
    m.base_color = {0.9f, 0.7f, 0.5f, 1.0f};
    m.lobe = AlphaLobe{alpha};
    m.anisotropy_rotation = 0.4f;
    return m;
}

// Lambert's law alone.
inline Material matte(glm::vec3 albedo) {
    Material m;
    m.base_color = glm::vec4(albedo, 1.0f);
    m.metallic = 0.0f;
    m.specular = 0.0f;
    return m;
}

inline bool brdf_takes(Brdf brdf, Method method) {
    return has_half_vectors(brdf) || !is_deformation(method);
}

}  // namespace burnish::test
