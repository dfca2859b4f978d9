// Spectra to colors: what the CIE 1931 observer sees of a reflectance under daylight D65.
//
// Threads: functions of their arguments.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace burnish {

inline constexpr int kWavelengths = 81;

// Of sample i of a spectrum: 380, 385, ..., 780.
constexpr double wavelength_nm(int i) {
    return 380.0 + 5.0 * i;
}

using Spectrum = std::array<double, kWavelengths>;

// X, Y, Z of a reflectance under D65; Y of a perfect reflector is 1.
glm::dvec3 xyz_of_reflectance(const Spectrum& reflectance);

// Linear Rec. 709, whose white is that of these tables: a perfect reflector is (1, 1, 1). Channels of
// saturated reflectances lie below 0 or above 1.
glm::dvec3 rec709_of_reflectance(const Spectrum& reflectance);

}  // namespace burnish
