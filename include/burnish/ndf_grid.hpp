// Distributions of microfacet normals on a polar grid, so that turning one about the normal shifts
// its columns. Rings are equal steps of u = sqrt(2 theta / pi), narrow near the normal (Dupuy &
// Jakob 2018 use the same for .bsdf files): ring r has its centre at u = (r + 1/2) / rings, column
// a at phi = 2 pi a / azimuths, counter-clockwise from +x.
//
// Values are D(h) per steradian, read bilinearly in (u, phi), constant inside the first ring's
// centre and outside the last one's. Normalised: Int D (n.h) dw = 1 over the upper hemisphere. Area
// seen from a direction: g(k) = Int max(h.k, 0) D dw, so that g(n) = 1; a specular BRDF is k_s F
// D(h) / (4 g(i) g(o)) (Ashikhmin, Premoze & Shirley 2000; W08): the separable Smith form.
//
// Threads: any number may call these functions at a time. Lifetime: tables are read during the
// call alone.
#pragma once

#include <span>
#include <vector>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

struct NdfGrid {
    int rings = 32;
    int azimuths = 96;

    int cells() const { return rings * azimuths; }
    float theta(double ring) const;      // radians, at a ring's centre (or between)
    double solid_angle(int ring) const;  // of one cell, steradians; cells tile the hemisphere
    friend bool operator==(const NdfGrid&, const NdfGrid&) = default;
};

// u of a direction with this z (1 at the horizon and below). Near the normal a single-precision z
// knows theta to 3e-4 only.
float ndf_u(float z);

// The table (rings x azimuths, ring-major) at u in [0, 1] and phi in radians, any turn.
float ndf_lookup(const NdfGrid& grid, const float* table, float u, float phi);

// Int D (n.h) dw of the table as it is read (midpoint rule over a grid finer than its cells).
double ndf_mass(const NdfGrid& grid, const float* table);

// What a direction sees of a table more than of a mirror: g(k) - k.z, on nodes of its own. Node row
// j of `seen.rings` lies at s = j / (rings - 1), s = sqrt(1 - 2 theta / pi): at the horizon, where
// g turns from k.z to almost nothing, narrow; columns as those of a distribution. 16 x 32 is within
// 0.003 of g for lobes of alpha 0.05 and wider (a test holds it).
inline constexpr NdfGrid kAreaGrid = {16, 32};
std::vector<float> ndf_areas(const NdfGrid& grid, const float* table,
                             const NdfGrid& seen = kAreaGrid);

// g(k) from what ndf_areas made, for a unit direction with z >= 0, in the same frame as the table.
// Never below 1e-6: BRDFs divide by it.
float ndf_area_lookup(const float* areas, float x, float y, float z,
                      const NdfGrid& seen = kAreaGrid);

}  // namespace burnish
