// The environment of a scene for paths: its radiance, and directions drawn by it. docs/theory/tracer.md.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "burnish/render_settings.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// Threads: immutable. Lifetime: keeps nothing of what it was made of.
class Sky {
  public:
    Sky(const Environment& environment, const RenderSettings& settings);

    bool lights() const { return !rows_.empty(); }
    // Between texels of the lat-long map. Directions: unit, world.
    glm::vec3 radiance(const glm::vec3& direction) const;
    // The density of `sample`, per steradian.
    float pdf(const glm::vec3& direction) const;
    struct Sample {
        glm::vec3 direction{0.0f}, radiance{0.0f};
        float pdf = 0.0f;
    };
    Sample sample(const glm::vec2& xi) const;

    // What is seen behind the scene. `xi`: two numbers in [0, 1), for the blur of the background.
    glm::vec3 background(const glm::vec3& direction, const glm::vec2& xi) const;
    bool is_transparent() const { return transparent_; }
    // Irradiance of the plane y = 0 from above.
    glm::vec3 irradiance_of_ground() const { return ground_; }

  private:
    glm::vec2 place_of(const glm::vec3& direction) const;  // (u, v) in the map
    glm::vec3 direction_of_place(const glm::vec2& uv) const;
    float density_at(int row, int column) const;  // of draws, per unit of (u, v)
    void make_distribution();

    Image radiance_, backdrop_;  // RGB, sound; times the intensity
    float cos_ = 1.0f, sin_ = 0.0f;
    std::vector<float> rows_;     // cumulative shares; empty: no light
    std::vector<float> columns_;  // of each row, cumulative shares
    bool shows_environment_ = false, transparent_ = false;
    glm::vec3 color_{0.0f};  // of the background
    float blur_ = 0.0f;      // radians: half the width of the blur
    glm::vec3 ground_{0.0f};
};

}  // namespace burnish
