// Measured optical constants n + ik of metals and oxides, at the wavelengths of the measurements. The
// tables were read in the refractiveindex.info database (public domain, CC0) unless a table says
// otherwise; each names its paper.
//
// Threads: constants.
#pragma once

#include <complex>
#include <span>
#include <string_view>

namespace burnish {

struct OpticalSample {
    double nm;
    double n, k;
};

struct MeasuredMetal {
    std::string_view name;
    std::span<const OpticalSample> samples;  // ascending; from at most 390 to at least 775 nm
    std::string_view oxide;                  // the formula of a MeasuredOxide; empty: none is known
};

struct MeasuredOxide {
    std::string_view formula;
    std::span<const OpticalSample> samples;
};

// In the order of conductor_names.
std::span<const MeasuredMetal> measured_metals();
std::span<const MeasuredOxide> measured_oxides();

// n + ik, linear between the neighboring samples and constant beyond the last ones.
std::complex<double> optical_index(std::span<const OpticalSample> samples, double nm);

}  // namespace burnish
