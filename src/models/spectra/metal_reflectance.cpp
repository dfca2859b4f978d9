#include "models/spectra/metal_reflectance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "burnish/conductors.hpp"
#include "burnish/error.hpp"
#include "core/text.hpp"
#include "models/spectra/optical_constants.hpp"

namespace burnish {
namespace {

using Complex = std::complex<double>;

// The cosine in a medium of index m below air; sine2: squared sine of the angle of incidence.
Complex refracted_cosine(Complex m, double sine2) {
    return std::sqrt(1.0 - sine2 / (m * m));
}

// Amplitudes of reflection between two media, electric field across (s) and in the plane (p).
struct Amplitudes {
    Complex s, p;
};
Amplitudes amplitudes(Complex m0, Complex cos0, Complex m1, Complex cos1) {
    return {(m0 * cos0 - m1 * cos1) / (m0 * cos0 + m1 * cos1),
            (m1 * cos0 - m0 * cos1) / (m1 * cos0 + m0 * cos1)};
}

double unpolarized(const Amplitudes& r) {
    return 0.5 * (std::norm(r.s) + std::norm(r.p));
}

const MeasuredMetal& metal_named(std::string_view name) {
    const int index = index_of_name(conductor_names(), name, "metal", "");
    return measured_metals()[static_cast<std::size_t>(index)];
}

const MeasuredOxide& oxide_on(const MeasuredMetal& metal) {
    for (const MeasuredOxide& oxide : measured_oxides())
        if (oxide.formula == metal.oxide) return oxide;
    std::vector<std::string> known;
    for (const MeasuredMetal& other : measured_metals())
        if (!other.oxide.empty()) known.push_back(fmt::format("{} ({})", other.name, other.oxide));
    throw UsageError("oxide", "",
                     fmt::format("a metal whose oxide is known: {}", fmt::join(known, ", ")),
                     fmt::format("{}, of which no oxide is known", metal.name));
}

}  // namespace

std::complex<double> optical_index(std::span<const OpticalSample> samples, double nm) {
    const auto after = std::ranges::lower_bound(samples, nm, {}, &OpticalSample::nm);
    if (after == samples.begin()) return {samples.front().n, samples.front().k};
    if (after == samples.end()) return {samples.back().n, samples.back().k};
    const OpticalSample &a = *(after - 1), &b = *after;
    const double t = (nm - a.nm) / (b.nm - a.nm);
    return {std::lerp(a.n, b.n, t), std::lerp(a.k, b.k, t)};
}

double interface_reflectance(Complex metal, double cosine) {
    const Complex inside = refracted_cosine(metal, 1.0 - cosine * cosine);
    return unpolarized(amplitudes(1.0, cosine, metal, inside));
}

double film_reflectance(Complex film, double thickness_nm, Complex metal, double nm,
                        double cosine) {
    const double sine2 = 1.0 - cosine * cosine;
    const Complex in_film = refracted_cosine(film, sine2);
    const Complex in_metal = refracted_cosine(metal, sine2);
    const Amplitudes top = amplitudes(1.0, cosine, film, in_film);
    const Amplitudes bottom = amplitudes(film, in_film, metal, in_metal);
    // Once down and up again.
    const Complex round_trip =
        std::exp(Complex(0.0, 4.0 * std::numbers::pi * thickness_nm / nm) * film * in_film);
    const auto airy = [&](Complex first, Complex second) {
        return (first + second * round_trip) / (1.0 + first * second * round_trip);
    };
    return unpolarized({airy(top.s, bottom.s), airy(top.p, bottom.p)});
}

MetalReflectance::MetalReflectance(std::string_view name, double thickness_nm)
    : thickness_nm_(thickness_nm), film_{} {
    const MeasuredMetal& metal = metal_named(name);
    for (int i = 0; i < kWavelengths; ++i)
        metal_[static_cast<std::size_t>(i)] = optical_index(metal.samples, wavelength_nm(i));
    if (thickness_nm <= 0.0) return;
    const MeasuredOxide& oxide = oxide_on(metal);
    for (int i = 0; i < kWavelengths; ++i)
        film_[static_cast<std::size_t>(i)] = optical_index(oxide.samples, wavelength_nm(i));
}

double MetalReflectance::at(int wavelength, double cosine) const {
    const auto i = static_cast<std::size_t>(wavelength);
    if (thickness_nm_ <= 0.0) return interface_reflectance(metal_[i], cosine);
    return film_reflectance(film_[i], thickness_nm_, metal_[i], wavelength_nm(wavelength), cosine);
}

glm::dvec3 MetalReflectance::color(double cosine) const {
    Spectrum spectrum;
    for (int i = 0; i < kWavelengths; ++i) spectrum[static_cast<std::size_t>(i)] = at(i, cosine);
    return rec709_of_reflectance(spectrum);
}

glm::dvec3 MetalReflectance::held_color(double cosine) const {
    return glm::clamp(color(cosine), 0.0, 1.0);
}

}  // namespace burnish
