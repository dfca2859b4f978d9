// What a rig can see: which half vectors its lights make with the camera, how far rotation about
// the normal carries them, and how narrow a lobe may be before it falls between them. Derivations
// in docs/theory/capture-model.md.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/rig.hpp"

namespace BURNISH_API burnish {

// At one point of the sample. Angles in degrees; shares are of the hemisphere's solid angle 2 pi.
struct PointCoverage {
    Vec3d point_mm{};
    double theta_view = 0.0;          // of the camera, the mean where each light has its own
    std::vector<Vec3d> half_vectors;  // one a light, in their order; unit
    double theta_h_max = 0.0;
    // Largest (theta_light + theta_view) / 2: no half vector, and no turned one, can tilt more.
    double theta_h_limit = 0.0;
    // Median distance of a half vector to the next one; coincident ones count once. 0 where there
    // are fewer than two.
    double spacing = 0.0;
    // Share within `reach` of a half vector; reach = 3/4 of the spacing, at most 10 degrees: just
    // above the 1/sqrt(2) that leaves a square lattice without holes.
    double reach = 0.0;
    double covered = 0.0;
    // The same when all half vectors may be turned about the normal by any angle: what pixels with
    // other grain directions can add.
    double covered_turned = 0.0;
};

struct RigCoverage {
    PointCoverage center;
    std::vector<PointCoverage> corners;  // top left, top right, bottom left, bottom right; none
                                         // where the size is unknown or everything is far away
    double lowest_light = 0.0, highest_light = 0.0;  // elevation over the sample at its center
    double azimuth_spread = 0.0;  // 360 minus the widest gap between neighbouring lights' azimuths
    // Narrowest isotropic lobe, or side of an anisotropic one, that the spacing at the center
    // samples: full width at half maximum of two spacings. 0 where there is no spacing.
    double narrowest_ggx = 0.0, narrowest_beckmann = 0.0;
    std::vector<std::string> diagnosis;  // one line each, in words
};

RigCoverage rig_coverage(const Rig& rig);
PointCoverage point_coverage(const Rig& rig, const Vec3d& point_mm);

// The alpha whose lobe is twice `spacing_deg` wide at half its maximum.
double narrowest_ggx_alpha(double spacing_deg);
double narrowest_beckmann_alpha(double spacing_deg);

}  // namespace burnish
