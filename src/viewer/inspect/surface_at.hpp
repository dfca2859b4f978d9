// The material of a scene at a hit, read on the CPU from the finest level of its textures.
//
// It follows the renderer: the same transforms, filters and factors (shaders/lib/material.glsl,
// cloth.glsl, tabulated_texels.glsl), without a footprint: no mips, so that nothing widens the lobe;
// cloth is the yarn at the place; a tabulated material is the nearest texel, where the renderer
// blends four.
//
// Threads: functions of their arguments.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>

#include "burnish/f64.hpp"
#include "burnish/scene.hpp"
#include "burnish/tabulated_material.hpp"
#include "models/albedo_table.hpp"
#include "viewer/inspect/pick.hpp"

namespace burnish::viewer {

struct YarnAt {
    bool warp = false;
    int end = 0, pick = 0;  // of the draft, from 0
    bool covered = true;    // false: the hole between the yarns, which reflects nothing
};

struct ExemplarAt {
    std::shared_ptr<const TabulatedMaterial> material;
    int exemplar = -1;      // -1: the texel has no measurement, and reflects nothing
    glm::ivec2 texel{0};    // column and row, row 0 at the top
    double angle_rad = 0;   // the table is rotated by this, counter-clockwise
    double groove_rad = 0;  // azimuth of the groove in the table
    // Shares of the hemisphere's solid angle by how the cells are known; the sum is 1.
    double measured = 0, completed = 0, extrapolated = 0;

    // rings x azimuths; empty without an exemplar.
    std::span<const float> table() const;
    std::span<const NdfOrigin> origin() const;
};

// The surface at a point, before a method acts. Directions and normals are against `axes` where they
// are not world.
struct SurfaceAt {
    f64::SurfaceMaterial surface;  // colored, with the lobe at the point
    f64::Frame axes;          // world: tangent, bitangent, geometric normal on the side of the eye
    f64::vec3 n{0, 0, 1};     // perturbed normal, unit
    f64::vec2 stretch{1, 0};  // (cos, sin) from the tangent to the lobe's x axis (not of tables)
    bool grooves_along_x = true;
    bool under_coat = false, under_sheen = false;  // layers that are no part of `surface`
    bool perturbed = false;                        // a map, a weave or a measurement states n
    bool conserve = false;
    std::shared_ptr<const AlbedoTable> albedos;  // none: the surface is not compensated
    bool isotropic =
        false;  // nothing is anisotropic: the renderer draws normal-map as gram-schmidt
    bool half_vectors = true;             // the lobe is a distribution of half vectors
    Method method = Method::none;         // of the material
    Method right = Method::follow_grain;  // of its process, what highlight errors are against
    glm::dvec3 base_color{1.0};           // linear
    double metallic = 0;
    std::optional<YarnAt> yarn;
    std::optional<ExemplarAt> exemplar;

    bool reflects() const;  // neither a hole nor a texel without measurement
};

// `to_eye`: unit, world, above the geometric plane of the side that the hit saw. Throws Error when the
// hit does not belong to the scene.
SurfaceAt surface_at(const Scene& scene, const Hit& hit, glm::dvec3 to_eye);

// Directions between world and the axes of the surface.
glm::dvec3 to_tangent_frame(const SurfaceAt& at, glm::dvec3 world);
glm::dvec3 to_world(const SurfaceAt& at, glm::dvec3 direction);

}  // namespace burnish::viewer
