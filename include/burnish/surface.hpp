// Reflection of a material at a point, by value: the maths of shading/ in double precision.
//
// Threads: a SurfacePoint may be read from any number of threads. Lifetime: it keeps nothing of the
// material.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string_view>

#include "burnish/api.hpp"
#include "burnish/f64.hpp"
#include "burnish/scene.hpp"

namespace burnish {
class AlbedoTable;
}

namespace BURNISH_API burnish {

// By name, as flags and files spell them: "ggx", "microfacet", "follow-grain". Throw UsageError with
// the nearest name for an unknown one.
Mdf mdf_named(std::string_view name);
Brdf brdf_named(std::string_view name);
Method method_named(std::string_view name);

// A material without its textures where the perturbed normal is `normal`, diffuse and specular term
// together. Directions are unit vectors in tangent space: x along the tangent, z the geometric
// normal. They point away from the surface.
class SurfacePoint {
  public:
    // `normal`: unit, z > 0. Throws UsageError where the model has no meaning under the method, and
    // for cloth and tabulated materials, whose reflection depends on the place.
    explicit SurfacePoint(const Material& material, glm::dvec3 normal = {0.0, 0.0, 1.0});

    // RGB per steradian, without the cosine. 0 where a direction is below the perturbed horizon. Under a
    // coat or sheen: eval_cos over the cosine of the perturbed normal.
    glm::dvec3 eval(glm::dvec3 to_light, glm::dvec3 to_eye) const;
    // Times the cosine, each layer by its own normal: the coat, which has the geometric one, also
    // reflects light from below the perturbed horizon.
    glm::dvec3 eval_cos(glm::dvec3 to_light, glm::dvec3 to_eye) const;

    struct Sample {
        glm::dvec3 to_light{0.0};
        double pdf = 0.0;        // per steradian, of the direction
        glm::dvec3 weight{0.0};  // eval_cos over the density
    };
    // A direction drawn by three uniform numbers of [0, 1); none: the draw is discarded, and counts
    // as a weight of 0 in a mean.
    std::optional<Sample> sample(glm::dvec3 to_eye, const std::array<double, 3>& uniform) const;
    // The density with which `sample` returns a direction, per steradian; 0 below the perturbed horizon
    // (under a coat: below both horizons).
    // Its integral over the sphere is the probability that `sample` returns one.
    double pdf(glm::dvec3 to_light, glm::dvec3 to_eye) const;

  private:
    // Directions against the lobe's axes, and the perturbation that a view from there sees: a normal
    // that a strong map turns away from the eye faces it.
    f64::vec3 local(glm::dvec3 w) const;
    f64::Perturbation seen_from(f64::vec3 to_eye) const;
    // With the light that facets reflect more than once towards the eye.
    f64::SurfaceMaterial material_towards(const f64::Perturbation& p, f64::vec3 to_eye) const;

    // Whether light from there is reflected at all.
    bool sees(const f64::Perturbation& p, f64::vec3 to_light) const;
    f64::vec3 eval_cos(const f64::SurfaceMaterial& material, const f64::Perturbation& p,
                       f64::vec3 to_light, f64::vec3 to_eye) const;

    f64::SurfaceMaterial material_;
    f64::SurfaceLayers layers_;
    bool layered_ = false;
    f64::vec3 normal_;
    f64::vec2 stretch_;  // (cos, sin) from the tangent to the lobe's x axis
    int method_ = 0;
    bool grooves_along_x_ = true;
    bool conserve_ = false;
    std::shared_ptr<const AlbedoTable> albedos_;  // none: single_scattering
};

}  // namespace burnish
