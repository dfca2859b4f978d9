// Writes tensor files and measured materials with known numbers, so that results of reading them
// are known too. The formulas (GGX's distribution and projected area in closed form) are written
// here and do not use shading/.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish::test {

struct TensorPart {
    std::string name;
    unsigned type;  // as in the file: 1 uint8, 10 float32
    std::vector<std::uint64_t> shape;
    std::string data;
};

std::string tensor_text(const std::vector<TensorPart>& parts);
TensorPart floats_part(std::string name, std::vector<std::uint64_t> shape,
                       std::span<const float> values);
TensorPart bytes_part(std::string name, std::string_view bytes);

using Vector = std::array<double, 3>;

// GGX with exact D(h) and projected area sigma(w).
struct KnownSurface {
    double alpha_x = 0.3, alpha_y = 0.3;
    double D(Vector h) const;
    double sigma(Vector w) const;  // w above the horizon
};

// A material with reflectance f cos(theta_i) = color(x, y) D(h) / (4 sigma(wo)), where (x, y) is
// the position in the square that visible normals are warped from.
struct KnownMaterial {
    KnownSurface surface;
    std::size_t thetas = 8;    // incident directions, evenly spaced from 0 to 90 degrees
    std::size_t phis = 1;      // 1: isotropic
    unsigned symmetry = 1;     // 2, 4: azimuths over half or a quarter of the circle
    std::size_t normals = 64;  // nodes on a side of the grids of ndf, sigma and vndf
    std::size_t samples = 16;  // nodes on a side of luminance and color
    std::function<std::array<double, 3>(double x, double y)> color = [](double, double) {
        return std::array<double, 3>{0.8, 0.5, 0.2};
    };
    std::function<double(double x, double y)> luminance = [](double, double) { return 1.0; };
    // Not empty: the file is spectral, and color()[0] is the value at each wavelength.
    std::vector<float> wavelengths{};
    std::string description = "made by a test";

    std::vector<TensorPart> parts() const;
    std::string text() const { return tensor_text(parts()); }
    double theta(std::size_t i) const;
    double phi(std::size_t i) const;
};

}  // namespace burnish::test
