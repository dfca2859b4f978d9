// Spectra to color: a reflectance spectrum under daylight in linear Rec. 709.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace burnish {

// The color-matching functions x, y, z of the CIE 1931 observer, by the multi-lobe fit of Wyman,
// Sloan & Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT
// 2(2), 2013, within 0.025 of the tables.
std::array<double, 3> cie_xyz_bar(double wavelength_nm);

// Relative power of CIE standard illuminant D65, 100 at 560 nm: linear between values every 10 nm,
// 0 outside 380 to 780 nm.
double illuminant_d65(double wavelength_nm);

// The weight of each sample of a reflectance spectrum in red, green and blue: rgb = sum over k of
// weight[k] reflectance[k]. The spectrum is linear between its wavelengths (nm, strictly
// increasing, at least two, from 400 or less to 700 or more) and constant beyond them. A
// reflectance of 1 is exactly (1, 1, 1); colors outside the gamut have components below 0.
std::vector<std::array<double, 3>> reflectance_to_rgb(std::span<const float> wavelengths_nm);

}  // namespace burnish
