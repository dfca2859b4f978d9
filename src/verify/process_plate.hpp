// A plate whose surface a process has really moved: what a method claims to draw on a flat one.
#pragma once

#include "verify/sphere.hpp"

namespace burnish::verify {

// One model, distribution and method, by the numbers of shading/names.glsl. p0, p1: exponents of ashikhmin-shirley,
// alphas of the others.
struct Subject {
    int brdf = f64::kBrdfMicrofacet;
    int mdf = f64::kMdfGgx;
    double p0 = 0.1, p1 = 0.4;
    int method = f64::kMethodFollowGrain;
};

f64::SurfaceMaterial material_of(const Subject& subject);  // Fresnel 1, no diffuse term

// The directions that x, y and z of the plate become (docs/theory/processes.md).
struct SurfaceMap {
    vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

// The map of the process that the method stands for, where the perturbed normal is n. Methods without a process
// (normal-map and the deformations) have that of follow-grain, the plate that really is tilted; rotate-approx has
// that of rotate-exact.
SurfaceMap process_of(const Subject& subject, vec3 n);

// Whether the plate can be computed: models without Smith's term know no moved facets, only turned ones.
bool has_process_plate(const Subject& subject);

// Reflected radiance towards wo of the moved plate under light of unit irradiance from wi. Made of the unperturbed
// lobe and of the map alone, not of the methods of shading/.
Radiance process_plate(const Subject& subject, vec3 n, vec3 wo);

}  // namespace burnish::verify
