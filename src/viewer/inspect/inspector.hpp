// What is known of a picked point: the lobe of its material under several methods side by side.
//
// Directions in a report are unit, in the tangent frame of the point (x tangent, y bitangent, z
// geometric normal on the side of the eye) unless their name ends in _world. Reflectances are per
// steradian; a suffix cos says that n~.wi is multiplied.
//
// Threads: functions of their arguments. Lifetime: a report shares the tables of a measured material
// and refers to nothing else.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "burnish/scene.hpp"
#include "viewer/inspect/lobe_shapes.hpp"
#include "viewer/inspect/pick.hpp"
#include "viewer/inspect/point_lobe.hpp"
#include "viewer/inspect/surface_at.hpp"

namespace burnish::viewer {

// The numbers of one method, for the report's light and eye.
struct MethodReport {
    Method method = Method::none;       // that was asked for
    PointLobe lobe;                     // has_meaning() false: the numbers are 0
    glm::dvec3 normal{0.0};             // n~ as cosines see it
    std::optional<double> grain_deg{};  // PointLobe::grain_deg
    double D = 0;                       // at the half vector; NaN for phong and lafortune, as G
    double G = 0;
    glm::dvec3 F{0.0};           // RGB
    glm::dvec3 f_specular{0.0};  // RGB, the specular term of light that is reflected once
    glm::dvec3 gain{1.0};        // PointLobe::gain
    glm::dvec3 f{0.0};           // f_specular times gain, and the diffuse term
    glm::dvec3 f_cos{0.0};
    double pdf = 0;                  // of drawing the light's direction
    glm::dvec3 peak{0.0};            // half vector of the highest D
    glm::dvec3 peak_to_light{0.0};   // direction of the light whose highlight the point would be
    double highlight_error_deg = 0;  // angle between this peak and that of follow-grain
    LobeDisk disk{};
    LobeMesh mesh{};
    PolarCuts cuts{};
};

struct LobeReport {
    SurfaceAt surface;
    glm::dvec3 to_eye{0.0}, to_light{0.0}, half{0.0};
    glm::dvec3 normal{0.0};  // n~ as the material states it, before it is turned to the eye
    glm::dvec3 normal_world{0.0};
    double tilt = 0;  // |d| = |(n~x, n~y)|, the sine of the tilt
    double tilt_deg = 0;
    glm::dvec2 alpha{0.0};   // along the lobe's x and y axes; 0 for tables
    double stretch_deg = 0;  // from the tangent to the lobe's x axis, under the first method
    std::optional<double>
        grain_deg;  // direction of the groove from the tangent, [0, 180); none: isotropic
    std::vector<MethodReport> methods;  // in the order asked for
};

// `to_eye`, `to_light`: unit, world. Without shapes, disk, mesh and cuts stay empty. Takes a few
// milliseconds a method (the first look at an exemplar of a measured material: 40 ms more).
// Throws Error when the hit does not belong to the scene.
enum class Shapes { none, all };
LobeReport inspect(const Scene& scene, const Hit& hit, glm::dvec3 to_eye, glm::dvec3 to_light,
                   std::span<const Method> methods, Shapes shapes = Shapes::all);

// Share of light from everywhere that the point sends to the eye: Int f cos dwi.
struct LobeAlbedo {
    glm::dvec3 specular{0.0};   // RGB
    glm::dvec3 whole{0.0};      // specular and diffuse
    double error = 0;           // standard error of the largest channel of `whole`
    bool gains_energy = false;  // a channel of `whole` is above 1 by more than three errors
};
// By `samples` draws (at least 64; 8192: an error below 0.005 for most lobes) of an even sequence in 16
// batches, from whose spread the error is estimated.
LobeAlbedo lobe_albedo(const PointLobe& lobe, glm::dvec3 to_eye, int samples = 8192);

// The rows that `burnish brdf eval` evaluates to the specular term of a method (f_specular): one a color
// channel, because a row has one F0. It is the F0 by which Schlick's formula gives F at this angle, so that
// metals with measured indices have a row too. Columns beyond those that brdf eval reads say what a row is.
std::string csv_header();
// None where the model has no row that says the same: measured materials; the methods normal-map,
// rotate-approx and deform-*, which no pair of directions replaces; cook-torrance with two alphas; numbers
// outside of the ranges of the table.
std::optional<std::string> csv_rows(const LobeReport& report, const MethodReport& method);
// The row that `burnish mdf eval` evaluates to D (column D_proj; D_conserving for the conserving
// deform-smooth), for every method. None for measured materials, phong and lafortune.
std::string mdf_csv_header();
std::optional<std::string> mdf_csv_row(const LobeReport& report, const MethodReport& method);

}  // namespace burnish::viewer
