// Distributions of microfacet normals on a polar grid, so that turning one about the normal shifts
// its columns. Rings are equal steps of u = sqrt(2 theta / pi), narrow near the normal (Dupuy &
// Jakob 2018 use the same for .bsdf files): ring r has its centre at u = (r + 1/2) / rings, column
// a at phi = 2 pi a / azimuths, counter-clockwise from +x.
//
// Values are D(h) per steradian, read bilinearly in (u, phi), constant inside the first ring's
// centre and outside the last one's. Normalised: Int D (n.h) dw = 1 over the upper hemisphere. Area
// seen from a direction: g(k) = Int max(h.k, 0) D dw, so that g(n) = 1; a specular BRDF is k_s F
// D(h) / (4 g(i) g(o)) (Ashikhmin, Premoze & Shirley 2000; W08): the separable Smith form.
#pragma once

#include <span>
#include <vector>

namespace burnish {

struct NdfGrid {
    int rings = 32;
    int azimuths = 96;

    int cells() const { return rings * azimuths; }
    float theta(double ring) const;      // radians, at a ring's centre (or between)
    double solid_angle(int ring) const;  // of one cell, steradians; cells tile the hemisphere
    friend bool operator==(const NdfGrid&, const NdfGrid&) = default;
};

// u of a direction with this z (1 at the horizon and below).
float ndf_u(float z);

// The table (rings x azimuths, ring-major) at u in [0, 1] and phi in radians, any turn.
float ndf_lookup(const NdfGrid& grid, const float* table, float u, float phi);

// Int D (n.h) dw of the table as it is read (midpoint rule over a grid finer than its cells).
double ndf_mass(const NdfGrid& grid, const float* table);

// Areas g seen from directions, on the same kind of grid: rings x azimuths of `seen`.
// Above 60 degrees it is small and changes quickly but stays smooth; 16 x 32 is within 1e-3 of
// g(n).
inline constexpr NdfGrid kAreaGrid = {16, 32};
std::vector<float> ndf_areas(const NdfGrid& grid, const float* table,
                             const NdfGrid& seen = kAreaGrid);

}  // namespace burnish
