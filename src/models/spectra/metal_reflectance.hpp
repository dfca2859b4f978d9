// What a metal reflects, bare or under a film of its oxide, wavelength by wavelength: Fresnel's and
// Airy's equations with measured optical constants, unpolarized, in air.
//
// Threads: a MetalReflectance is constant after its construction.
#pragma once

#include <array>
#include <complex>
#include <glm/vec3.hpp>
#include <string_view>

#include "models/spectra/cie_1931.hpp"

namespace burnish {

// The reflectance of a half space of index `metal` at the cosine of the angle of incidence, in [0, 1].
double interface_reflectance(std::complex<double> metal, double cosine);

// The same under a film of index `film` and thickness `thickness_nm`: all orders of interference
// (Airy's sum).
double film_reflectance(std::complex<double> film, double thickness_nm, std::complex<double> metal,
                        double nm, double cosine);

class MetalReflectance {
  public:
    // thickness_nm 0: the bare metal. Throws UsageError for a metal that is not in conductor_names,
    // and for a thickness above 0 on a metal whose oxide is not known.
    explicit MetalReflectance(std::string_view metal, double thickness_nm = 0.0);

    double at(int wavelength, double cosine) const;
    // Linear Rec. 709 under D65, not limited to [0, 1].
    glm::dvec3 color(double cosine) const;
    // The color as a renderer holds it: each channel limited to [0, 1], so that no light is gained.
    glm::dvec3 held_color(double cosine) const;

  private:
    double thickness_nm_;
    std::array<std::complex<double>, kWavelengths> metal_, film_;
};

}  // namespace burnish
