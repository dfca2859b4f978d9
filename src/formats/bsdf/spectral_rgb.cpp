#include "formats/bsdf/spectral_rgb.hpp"

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double kFirst = 380, kLast = 780, kStep = 10;

// Relative power of D65 from CIE 15, every 10 nm from 380 to 780 nm.
constexpr std::array<double, 41> kD65 = {
    49.9755, 54.6482, 82.7549, 91.486,  93.4318, 86.6823, 104.865, 117.008, 117.812,
    114.861, 115.923, 108.811, 109.354, 107.802, 104.79,  107.689, 104.405, 104.046,
    100.0,   96.3342, 95.788,  88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992,
    80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.349,  61.604,  69.8856,
    75.087,  63.5927, 46.4182, 66.8054, 63.3828};

// A Gaussian with different widths on the two sides of its middle.
double lobe(double wavelength, double height, double middle, double left, double right) {
    const double t = (wavelength - middle) * (wavelength < middle ? left : right);
    return height * std::exp(-0.5 * t * t);
}

// Linear Rec. 709 (D65 white) from XYZ: ITU-R BT.709 primaries.
std::array<double, 3> rec709(const std::array<double, 3>& xyz) {
    const auto [x, y, z] = xyz;
    return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
            -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
            0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

// Adds `amount` to the samples on either side of `at`, with the weights of linear interpolation.
void spread(std::span<const float> wavelengths, double at, const std::array<double, 3>& amount,
            std::vector<std::array<double, 3>>& sums) {
    const std::size_t last = wavelengths.size() - 1;
    const auto above = std::upper_bound(wavelengths.begin(), wavelengths.end(), at);
    const auto high =
        std::clamp<std::size_t>(static_cast<std::size_t>(above - wavelengths.begin()), 1, last);
    const double from = wavelengths[high - 1], to = wavelengths[high];
    const double part = std::clamp((at - from) / (to - from), 0.0, 1.0);
    for (std::size_t c = 0; c < 3; ++c) {
        sums[high - 1][c] += (1 - part) * amount[c];
        sums[high][c] += part * amount[c];
    }
}

}  // namespace

std::array<double, 3> cie_xyz_bar(double w) {
    return {lobe(w, 0.362, 442.0, 0.0624, 0.0374) + lobe(w, 1.056, 599.8, 0.0264, 0.0323) +
                lobe(w, -0.065, 501.1, 0.0490, 0.0382),
            lobe(w, 0.821, 568.8, 0.0213, 0.0247) + lobe(w, 0.286, 530.9, 0.0613, 0.0322),
            lobe(w, 1.217, 437.0, 0.0845, 0.0278) + lobe(w, 0.681, 459.0, 0.0385, 0.0725)};
}

double illuminant_d65(double wavelength_nm) {
    if (!(wavelength_nm >= kFirst && wavelength_nm <= kLast)) return 0;
    const double place = (wavelength_nm - kFirst) / kStep;
    const std::size_t i = std::min(static_cast<std::size_t>(place), kD65.size() - 2);
    const double part = place - static_cast<double>(i);
    return (1 - part) * kD65[i] + part * kD65[i + 1];
}

std::vector<std::array<double, 3>> reflectance_to_rgb(std::span<const float> wavelengths_nm) {
    std::vector<std::array<double, 3>> weights(wavelengths_nm.size());
    std::array<double, 3> white{};
    for (double w = kFirst; w <= kLast; ++w) {  // the curves are smooth at a step of 1 nm
        const double light = illuminant_d65(w);
        std::array<double, 3> amount = rec709(cie_xyz_bar(w));
        for (std::size_t c = 0; c < 3; ++c) {
            amount[c] *= light;
            white[c] += amount[c];
        }
        spread(wavelengths_nm, w, amount, weights);
    }
    for (auto& weight : weights)
        for (std::size_t c = 0; c < 3; ++c) weight[c] /= white[c];
    return weights;
}

}  // namespace burnish
