// The surface at a hit, seen from where the ray came: its reflection by the maths of shading/, and how directions are
// drawn from it.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "burnish/f32.hpp"
#include "reference/table_lobes.hpp"

namespace burnish {

class PointSurface {
  public:
    // Directions are unit vectors of the world, `wi` away from the surface.

    // f times the cosine, RGB per steradian.
    glm::vec3 eval_cos(const glm::vec3& wi) const;
    // The part of it that a diffuse base reflects.
    glm::vec3 diffuse_cos(const glm::vec3& wi) const;
    // The density with which `sample` returns a direction, per steradian.
    float pdf(const glm::vec3& wi) const;

    struct Sample {
        glm::vec3 wi{0.0f};
        float pdf = 0.0f;
        glm::vec3 weight{0.0f};  // eval_cos over the density
    };
    // `xi`: three numbers in [0, 1). None: the draw counts as a weight of 0.
    std::optional<Sample> sample(const std::array<float, 3>& xi) const;

    glm::vec3 world_normal() const;  // n~, unit
    // Along the grooves of the lobe at n~, unit, either way; 0 where nothing is anisotropic.
    glm::vec3 grain() const;

    // Set by MaterialReader.
    f32::SurfaceMaterial material{};
    f32::SurfaceLayers layers;  // set where `layered`
    f32::LayersSeen seen;       // from the eye; likewise
    bool layered = false;
    f32::Frame axes{};  // of the lobe: x along the stretch, z the geometric normal
    f32::Perturbation p{};
    f32::vec3 wo{};  // against the axes
    bool grooves_along_x = true;
    const TableLobe* table = nullptr;  // of a tabulated material
    float table_groove = 0.0f;         // from the lobe's x axis to the table's, in turns
    bool reflects = true;              // false: a hole of a cloth, or a texel without measurement
    glm::vec3 emitted{0.0f};           // radiance towards the eye
    float occlusion = 1.0f;            // of the occlusion map

  private:
    glm::vec3 eval_cos(const f32::SurfaceMaterial& m, const f32::vec3& wi) const;
    f32::LobeValues values(const f32::vec3& wi, bool with_density) const;
    float pdf(const f32::vec3& wi) const;
    bool sees(const f32::vec3& wi) const;
    f32::vec3 draw(const std::array<float, 3>& xi, bool& drawn) const;
};

}  // namespace burnish
