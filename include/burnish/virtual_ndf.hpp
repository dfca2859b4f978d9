// Known distributions for simulated captures: mixtures of the analytic lobes of shading/, in double
// precision. Independent of everything that fits: no table takes part.
//
// Threads and lifetime: plain values; copies are independent, and any number of threads may read
// one.
#pragma once

#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/rig.hpp"
#include "burnish/shading_names.hpp"

namespace BURNISH_API burnish {

// A lobe with its x axis rotated by `rotation` radians from the class's, about a mean slope: facets
// lean, as those of a pile or of half-worn scratches do. Slopes are (h_x, h_y) / h_z in the class's
// frame.
struct VirtualLobe {
    double weight = 1.0;
    Mdf mdf = Mdf::ggx;
    double alpha_x = 0.1, alpha_y = 0.4;
    double rotation = 0.0;
    double lean_x = 0.0, lean_y = 0.0;
};

// Int D (n.h) dw = 1 when the weights sum to 1. The groove runs along x.
struct VirtualNdf {
    std::string name;
    std::vector<VirtualLobe> lobes;

    double D(const Vec3d& h) const;     // per steradian; 0 for h_z <= 0
    double area(const Vec3d& k) const;  // Int max(h.k, 0) D dw, closed: |k_z| Lambda terms of Smith
};

// `v` rotated by `angle` radians about z, counter-clockwise.
Vec3d rotated_about_z(const Vec3d& v, double angle);

}  // namespace burnish
