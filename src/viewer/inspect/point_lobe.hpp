// The reflection of a surface point under one method: the maths of shading/ in double precision, with
// the tables of measured materials looked up.
//
// Directions are unit, in the tangent frame of the SurfaceAt: x tangent, y bitangent, z geometric normal.
//
// Threads: a PointLobe may be read from any number of threads. Lifetime: it shares the tables of a
// measured material.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "burnish/f64.hpp"
#include "viewer/inspect/surface_at.hpp"

namespace burnish::viewer {

class TableLobe;  // table_lobe.hpp

class PointLobe {
  public:
    PointLobe(const SurfaceAt& at, Method method);

    // The method by which the renderer draws: normal-map is gram-schmidt where nothing is anisotropic.
    Method drawn() const { return drawn_; }
    // False for deformations of phong and lafortune; then every value is 0.
    bool has_meaning() const { return has_meaning_; }
    bool has_half_vectors() const { return half_vectors_; }
    const f64::SurfaceMaterial& surface() const { return surface_; }
    // (cos, sin) from the tangent to the lobe's x axis.
    f64::vec2 stretch() const { return stretch_; }

    // The normal of cosines: the perturbed one, turned until it faces the eye; `none`: the geometric one.
    glm::dvec3 normal(glm::dvec3 to_eye) const;

    // D, Int D (n.h) dw = 1 of the unperturbed lobe, at a half vector; NaN for phong and lafortune.
    double D(glm::dvec3 half, glm::dvec3 to_eye) const;
    // How the cell of the table nearest to a half vector is known; none for other lobes, and where the
    // method says D = 0.
    std::optional<NdfOrigin> origin(glm::dvec3 half, glm::dvec3 to_eye) const;
    // The direction from the texel's normal at which the table is read for a half vector, unit, x along the
    // tangent; none for other lobes, and where the method says D = 0.
    std::optional<glm::dvec3> on_table(glm::dvec3 half, glm::dvec3 to_eye) const;
    // Masking and shadowing of the pair, including what the model has in its place: f_s 4 (n~.wi) (n~.wo) /
    // (F D) where it has no Smith term; NaN for phong and lafortune, and where that D is 0.
    double G(glm::dvec3 to_light, glm::dvec3 to_eye) const;
    glm::dvec3 F(glm::dvec3 to_light, glm::dvec3 to_eye) const;  // RGB
    // RGB per steradian, without the cosine. 0 where a direction is below the horizon of n~, or the eye
    // below the surface's.
    glm::dvec3 specular(glm::dvec3 to_light, glm::dvec3 to_eye) const;
    glm::dvec3 eval(glm::dvec3 to_light, glm::dvec3 to_eye) const;  // and the diffuse term
    // RGB factor of `specular` by the light that facets reflect more than once; 1 where the model has none.
    glm::dvec3 gain(glm::dvec3 to_eye) const;
    // eval times the cosine n~.wi: radiance under unit irradiance of a surface that faces the light.
    glm::dvec3 eval_cos(glm::dvec3 to_light, glm::dvec3 to_eye) const;
    struct Sample {
        glm::dvec3 to_light{0.0};
        double pdf = 0;  // per steradian
    };
    // `terms`: draws for the whole reflection, or for its specular term alone.
    enum class Terms { all, specular };
    std::optional<Sample> sample(glm::dvec3 to_eye, const std::array<double, 3>& uniform,
                                 Terms terms) const;
    // Its density, per steradian.
    double pdf(glm::dvec3 to_light, glm::dvec3 to_eye, Terms terms = Terms::all) const;

    // The half vector where D is highest, as this eye sees the surface: n~ for the rotations and the
    // deformations, the geometric normal for `none`; for normal-map found by search, to 1e-6; of a
    // table the center of its highest cell. A lobe so wide that its highest value is not at its center
    // (Beckmann of alpha above 0.7, GGX above 1) counts as highest at its center. phong, lafortune: the
    // half vector between the eye and the lobe's direction.
    glm::dvec3 peak(glm::dvec3 to_eye) const;
    // The direction of a light whose highlight is seen there: the eye mirrored about the peak; it may lie
    // below a horizon.
    glm::dvec3 peak_to_light(glm::dvec3 to_eye) const;

    // Direction in which the groove runs as the method tilts it, seen from above, in degrees from the tangent,
    // [0, 180): the one across the half vectors that its light is reflected by, at n~. None: isotropic.
    std::optional<double> grain_deg(glm::dvec3 to_eye) const;

    // Everything that evaluates against the lobe's own axes.
    f64::vec3 local(glm::dvec3 w) const;
    glm::dvec3 outer(f64::vec3 w) const;
    f64::Perturbation seen_from(glm::dvec3 to_eye) const;

  private:
    // The values of the three lines below are against the lobe's axes.
    bool sees(glm::dvec3 to_eye) const;
    f64::LobeValues values(const f64::Perturbation& p, f64::vec3 wi, f64::vec3 wo) const;
    // The surface with the light that facets reflect more than once towards wo.
    f64::SurfaceMaterial towards(const f64::SurfaceMaterial& surface, const f64::Perturbation& p,
                                 f64::vec3 wo) const;
    double lobe_at(const f64::Perturbation& p, f64::vec3 h) const;
    f64::vec3 highest(const f64::Perturbation& p) const;

    f64::SurfaceMaterial surface_, specular_surface_;  // the latter without a diffuse term
    f64::vec3 n_;
    f64::vec2 stretch_{1, 0};
    Method drawn_ = Method::none;
    bool grooves_along_x_ = true, conserve_ = false, perturbed_ = false;
    std::optional<double> groove_rad_;  // from the lobe's x axis; none: isotropic
    bool has_meaning_ = true, half_vectors_ = true, reflects_ = true;
    std::shared_ptr<const AlbedoTable> albedos_;  // none: the surface is not compensated
    std::shared_ptr<const TableLobe> table_;
    double table_turns_ = 0;  // from the lobe's x axis to the table's
};

}  // namespace burnish::viewer
