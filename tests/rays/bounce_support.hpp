// Skies, and what vertices see of the light of surroundings.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "burnish/prepared_environment.hpp"
#include "core/constants.hpp"
#include "shapes.hpp"

namespace burnish::test {

// `radiance` of the direction at the middle of every texel.
inline SceneLight sky_of(const std::function<double(glm::dvec3)>& radiance) {
    Environment environment;
    constexpr int kWidth = 128, kHeight = 64;
    environment.radiance = Image(kWidth, kHeight, 3);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double theta = kPi * (y + 0.5) / kHeight,
                         phi = 2 * kPi * ((x + 0.5) / kWidth - 0.5);
            const glm::dvec3 w(std::sin(theta) * std::sin(phi), std::cos(theta),
                               -std::sin(theta) * std::cos(phi));
            std::fill_n(environment.radiance.at(x, y), 3, static_cast<float>(radiance(w)));
        }
    SceneLight light;
    light.environment = prepare_environment(std::move(environment));
    return light;
}

inline SceneLight white_sky() {
    return sky_of([](glm::dvec3) { return 1.0; });
}

inline f64::Surroundings around(const Visibility& seen, std::size_t instance, std::size_t vertex) {
    return around_of(seen.instances.at(instance).vertices.at(vertex));
}

// Radiance towards a direction of what blocks the view there.
inline f64::vec3 radiance(const f64::Surroundings& s, glm::dvec3 w) {
    return f64::surroundings_towards(s, to_f64(glm::normalize(w)));
}

inline bool is_dark(const Visibility& seen, std::size_t instance) {
    return std::ranges::all_of(seen.instances.at(instance).vertices,
                               [](const VertexVisibility& vertex) {
                                   const auto color = around_of(vertex).color;
                                   return f64::length(color) < 1e-6;
                               });
}

// A large plate and, before it, a small receiver that faces it: it sees the plate's radiance.
struct Facing {
    Scene scene;
    glm::dvec3 to_plate;
};

inline Facing facing(glm::dvec3 normal) {
    Facing f{scene_of({disc(normal * 0.5, 0.02, -normal, 16), disc(glm::dvec3(0.0), 2, normal)}),
             -normal};
    // Rings near the middle, where the receiver looks.
    f.scene.meshes[1] = surface(64, 16, true, [&](double u, double v) {
        const glm::dvec3 t = glm::normalize(glm::cross(normal, glm::dvec3(0.3, 0.5, 0.8))),
                         b = glm::cross(normal, t);
        return Place{(t * std::cos(2 * kPi * u) + b * std::sin(2 * kPi * u)) * (2 * v), normal};
    });
    return f;
}

inline double plate_radiance(const Facing& f, const SceneLight& light) {
    VisibilityFinder finder(f.scene, kWhole);
    return radiance(around(*finder.lit(light, 1), 0, 0), f.to_plate).x;
}

}  // namespace burnish::test
