// He, Torrance, Sillion & Greenberg, "A Comprehensive Physical Model for Light Reflection",
// SIGGRAPH 1991: the directional-diffuse term, unpolarised. Without the mirror peak (a delta,
// strongest where the surface is smooth) and the uniform-diffuse term. Isotropic.
#pragma once

#include <array>

#include "burnish/mdf.hpp"

namespace burnish {

// Heights and distances in wavelengths of the light.
struct HeSurface {
    double sigma;  // root mean square height, 0 to 5
    double tau;    // correlation length, 0.1 to 1000
};

// Sum over m >= 1 of g^m e^-g / (m! m) exp(-x/m), cut where what is left is below `remainder` of
// the sum. `last` is the largest m that was added.
struct HeSeries {
    double sum;
    int last;
};
HeSeries he_series(double g, double x, double remainder);

// The series is cut at this share of its sum.
inline constexpr double kHeRemainder = 1e-12;

// Without Fresnel; 0 below the horizon and for sigma = 0.
double he_value(HeSurface surface, Direction<double> wi, Direction<double> wo);

// Half of the samples by the slopes that a rough surface of these statistics has (Beckmann with
// m = 2 sigma/tau), half by the cosine: slight roughness scatters far wider than its slopes.
Direction<double> he_sample(HeSurface surface, Direction<double> wo, std::array<double, 3> xi,
                            double& pdf);
double he_pdf(HeSurface surface, Direction<double> wi, Direction<double> wo);

}  // namespace burnish
