#include "bsdf_writer.hpp"

#include <cmath>
#include <utility>

#include "core/constants.hpp"

namespace burnish::test {
namespace {

template <typename Number>
void append(std::string& text, Number value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

Vector at(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double share(std::size_t i, std::size_t count) {
    return static_cast<double>(i) / static_cast<double>(count - 1);
}

// A table over the square of directions: theta = u^2 pi/2 along x, phi = pi (2 v - 1) along y.
template <typename Value>
std::vector<float> over_directions(std::size_t side, const Value& value) {
    std::vector<float> table;
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i) {
            const double u = share(i, side);
            table.push_back(
                static_cast<float>(value(u, u * u * kPi / 2, kPi * (2 * share(j, side) - 1))));
        }
    return table;
}

}  // namespace

std::string tensor_text(const std::vector<TensorPart>& parts) {
    std::size_t offset = 18;
    for (const TensorPart& part : parts)
        offset += 2 + part.name.size() + 2 + 1 + 8 + 8 * part.shape.size();
    std::string text("tensor_file\0\1\0", 14);
    append(text, static_cast<std::uint32_t>(parts.size()));
    for (const TensorPart& part : parts) {
        append(text, static_cast<std::uint16_t>(part.name.size()));
        text += part.name;
        append(text, static_cast<std::uint16_t>(part.shape.size()));
        append(text, static_cast<std::uint8_t>(part.type));
        append(text, static_cast<std::uint64_t>(offset));
        for (const std::uint64_t size : part.shape) append(text, size);
        offset += part.data.size();
    }
    for (const TensorPart& part : parts) text += part.data;
    return text;
}

TensorPart floats_part(std::string name, std::vector<std::uint64_t> shape,
                       std::span<const float> values) {
    return {std::move(name), 10, std::move(shape),
            std::string(reinterpret_cast<const char*>(values.data()), values.size_bytes())};
}

TensorPart bytes_part(std::string name, std::string_view bytes) {
    return {std::move(name), 1, {bytes.size()}, std::string(bytes)};
}

double KnownSurface::D(Vector h) const {
    const double x = h[0] / alpha_x, y = h[1] / alpha_y;
    return 1 / (kPi * alpha_x * alpha_y * std::pow(x * x + y * y + h[2] * h[2], 2));
}

double KnownSurface::sigma(Vector w) const {
    const double x = w[0] * alpha_x, y = w[1] * alpha_y;
    return 0.5 * (w[2] + std::sqrt(w[2] * w[2] + x * x + y * y));
}

double KnownMaterial::theta(std::size_t i) const {
    return thetas == 1 ? 0.0 : share(i, thetas) * kPi / 2;
}

double KnownMaterial::phi(std::size_t i) const {
    return phis == 1 ? 0.0 : -kPi + share(i, phis) * 2 * kPi / symmetry;
}

std::vector<TensorPart> KnownMaterial::parts() const {
    std::vector<float> theta_i, phi_i, vndf, light, colors;
    for (std::size_t t = 0; t < thetas; ++t) theta_i.push_back(static_cast<float>(theta(t)));
    for (std::size_t p = 0; p < phis; ++p) phi_i.push_back(static_cast<float>(phi(p)));
    const std::size_t channels = wavelengths.empty() ? 3 : wavelengths.size();
    for (std::size_t p = 0; p < phis; ++p)
        for (std::size_t t = 0; t < thetas; ++t) {
            const Vector wo = at(theta(t), phi(p));
            const auto seen = over_directions(normals, [&](double u, double theta_m, double phi_m) {
                const Vector h = at(theta_m, phi_m);
                const double facing = h[0] * wo[0] + h[1] * wo[1] + h[2] * wo[2];
                return facing > 0 ? surface.D(h) * facing * u * std::sin(theta_m) : 0.0;
            });
            vndf.insert(vndf.end(), seen.begin(), seen.end());
            for (std::size_t c = 0; c < channels; ++c)
                for (std::size_t j = 0; j < samples; ++j)
                    for (std::size_t i = 0; i < samples; ++i) {
                        const double x = share(i, samples), y = share(j, samples);
                        if (c == 0) light.push_back(static_cast<float>(luminance(x, y)));
                        colors.push_back(
                            static_cast<float>(color(x, y)[wavelengths.empty() ? c : 0]));
                    }
        }
    const auto ndf = over_directions(normals, [&](double, double theta_m, double phi_m) {
        return surface.D(at(theta_m, phi_m));
    });
    const auto area = over_directions(normals, [&](double, double theta_m, double phi_m) {
        return surface.sigma(at(theta_m, phi_m));
    });
    std::vector<TensorPart> result = {
        bytes_part("description", description),
        floats_part("phi_i", {phis}, phi_i),
        floats_part("theta_i", {thetas}, theta_i),
        floats_part("sigma", {normals, normals}, area),
        floats_part("ndf", {normals, normals}, ndf),
        floats_part("vndf", {phis, thetas, normals, normals}, vndf),
        floats_part("luminance", {phis, thetas, samples, samples}, light),
        floats_part(wavelengths.empty() ? "rgb" : "spectra",
                    {phis, thetas, channels, samples, samples}, colors),
        bytes_part("jacobian", std::string_view("\1", 1))};
    if (!wavelengths.empty())
        result.push_back(floats_part("wavelengths", {wavelengths.size()}, wavelengths));
    return result;
}

}  // namespace burnish::test
