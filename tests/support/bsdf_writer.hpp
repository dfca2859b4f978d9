// Tensor files and measured materials made by a test: the numbers are known, so that what is read
// from them is known too. The maths (GGX's distribution and projected area in closed form) is
// written out here, not taken from shading/.
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

// GGX with D(h) and the projected area sigma(w), both exact.
struct KnownSurface {
    double alpha_x = 0.3, alpha_y = 0.3;
    double D(Vector h) const;
    double sigma(Vector w) const;  // w above the horizon
};

// A material whose reflectance is  f cos(theta_i) = colour(x, y) D(h) / (4 sigma(wo)), x and y the
// place in the square that visible normals are warped from.
struct KnownMaterial {
    KnownSurface surface;
    std::size_t thetas = 8;    // incident directions, evenly from 0 to 90 degrees
    std::size_t phis = 1;      // 1: isotropic
    unsigned symmetry = 1;     // 2, 4: azimuths over half or a quarter of the circle
    std::size_t normals = 64;  // nodes of the grids of ndf, sigma and vndf along a side
    std::size_t samples = 16;  // nodes of luminance and colour
    std::function<std::array<double, 3>(double x, double y)> color = [](double, double) {
        return std::array<double, 3>{0.8, 0.5, 0.2};
    };
    std::function<double(double x, double y)> luminance = [](double, double) { return 1.0; };
    // Not empty: the file is spectral, and colour()[0] stands for each of these.
    std::vector<float> wavelengths{};
    std::string description = "made by a test";

    std::vector<TensorPart> parts() const;
    std::string text() const { return tensor_text(parts()); }
    double theta(std::size_t i) const;
    double phi(std::size_t i) const;
};

}  // namespace burnish::test
