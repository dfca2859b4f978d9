// Scenes of the viewer's tests.
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "burnish/scene.hpp"
#include "gpu/test_scene.hpp"
#include "viewer/inspect/pick.hpp"

namespace burnish::test {

// Unit, of the upper hemisphere of `up` (z), at least `least` above the horizon.
inline glm::dvec3 random_direction(std::mt19937& random, double least = 0.05) {
    std::uniform_real_distribution<double> height(least, 1.0), turn(0.0, 6.283185307179586);
    const double z = height(random), phi = turn(random), r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

// The hit of a ray along -z at (x, y) of a scene around the plane z = 0.
inline viewer::Hit hit_at(const Scene& scene, double x, double y) {
    viewer::Ray ray;
    ray.origin = {x, y, 10.0};
    ray.direction = {0, 0, -1};
    ray.to = 100;
    const auto hit = viewer::Picker(scene).pick(scene, ray);
    return hit ? *hit : viewer::Hit{};
}

inline std::vector<Method> all_methods() {
    std::vector<Method> methods;
    for (std::size_t i = 0; i < method_names().size(); ++i)
        methods.push_back(static_cast<Method>(i));
    return methods;
}

// A texture of one texel that holds a tilted normal.
inline Texture normal_texel(glm::dvec3 n) {
    return constant_texture(glm::vec3(0.5 * glm::normalize(n) + 0.5));
}

// The unit plane with a constant normal map.
inline Scene tilted_plane(Material material, glm::dvec3 n) {
    material.normal_texture.texture = 0;
    Scene scene = one_object(unit_plane(), std::move(material));
    scene.textures.push_back(normal_texel(n));
    return scene;
}

}  // namespace burnish::test
