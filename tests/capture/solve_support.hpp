// Renders one point's pictures with an independent forward model: a table read bilinearly, or a
// lobe in closed form, under far lights on a dome.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "capture/stack/light_geometry.hpp"
#include "table_support.hpp"

namespace burnish::test {

using Double3 = std::array<double, 3>;

// Reads rings x azimuths bilinearly in u and phi, constant outside the outermost centers.
inline double read_table(const NdfGrid& grid, const std::vector<float>& table, const Double3& h,
                         double columns) {
    const double theta = std::acos(std::min(h[2], 1.0)), u = std::sqrt(2 * theta / kPi);
    const double ring = std::clamp(u * grid.rings - 0.5, 0.0, grid.rings - 1.0);
    const int r0 = std::min(static_cast<int>(ring), grid.rings - 2);
    const double column = std::atan2(h[1], h[0]) / (2 * kPi) * grid.azimuths - columns;
    const int c0 = static_cast<int>(std::floor(column));
    const auto at = [&](int r, int c) { return static_cast<double>(table[cell(grid, r, c)]); };
    const double t = column - c0, f = ring - r0;
    return (1 - f) * ((1 - t) * at(r0, c0) + t * at(r0, c0 + 1)) +
           f * ((1 - t) * at(r0 + 1, c0) + t * at(r0 + 1, c0 + 1));
}

// Exact unpolarized Fresnel reflectance relative to normal incidence; eta 0: 1.
inline double fresnel_ratio(double eta, double c) {
    if (eta == 0) return 1;
    const auto F = [eta](double x) {
        const double t = std::sqrt(1 - (1 - x * x) / (eta * eta));
        const double s = (x - eta * t) / (x + eta * t), p = (eta * x - t) / (eta * x + t);
        return (s * s + p * p) / 2;
    };
    return F(c) / F(1);
}

struct Surface {
    Double3 diffuse{}, specular{};  // rgb
    double eta = 0;
    std::function<double(const Double3& h)> D;
    std::function<double(const Double3& k)> area;
};

struct Shot {
    PointLights lights;
    std::vector<float> values;  // lights x 3
};

// Lights spread evenly over a cap (sunflower spiral); `turn` is the first light's azimuth.
inline std::vector<Double3> cap_of(int count, double most_degrees, double turn = 0) {
    std::vector<Double3> out;
    const double lowest = std::cos(most_degrees * kPi / 180);
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (1 - lowest) * (i + 0.5) / count, s = std::sqrt(1 - z * z);
        const double phi = turn + i * kPi * (3 - std::sqrt(5.0));
        out.push_back({s * std::cos(phi), s * std::sin(phi), z});
    }
    return out;
}

inline double dot3(const Double3& a, const Double3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// I = received (n.i) (d / pi + s F(i.h)/F(1) D(h) / (4 g(i) g(o))), with the normal along z.
inline Shot shot_of(const Surface& surface, const std::vector<Double3>& lights, const Double3& eye,
                    double intensity = 1) {
    Shot out;
    for (std::size_t c = 0; c < 3; ++c) out.lights.to_eye[c] = static_cast<float>(eye[c]);
    for (const Double3& i : lights) {
        Double3 h = {i[0] + eye[0], i[1] + eye[1], i[2] + eye[2]};
        const double length = std::sqrt(dot3(h, h));
        for (double& v : h) v /= length;
        out.lights.x.push_back(static_cast<float>(i[0]));
        out.lights.y.push_back(static_cast<float>(i[1]));
        out.lights.z.push_back(static_cast<float>(i[2]));
        const double shape = fresnel_ratio(surface.eta, dot3(i, h)) * surface.D(h) /
                             (4 * surface.area(i) * surface.area(eye));
        for (std::size_t c = 0; c < 3; ++c) {
            out.lights.received[c].push_back(static_cast<float>(intensity));
            const double rho = surface.diffuse[c] / kPi + surface.specular[c] * shape;
            out.values.push_back(static_cast<float>(intensity * i[2] * rho));
        }
    }
    return out;
}

inline PointSamples samples_of(const Shot& shot, const NdfGrid& grid) {
    PointSamples out;
    gather_samples(shot.lights, {0, 0, 1}, shot.values, {}, grid, out);
    return out;
}

inline double luminance(const Double3& rgb) {
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

// Int D (n.h) dw of a table, cell by cell.
inline double mass_of(const NdfGrid& grid, const float* table, int first_ring = 0) {
    double mass = 0;
    for (int r = first_ring; r < grid.rings; ++r)
        for (int a = 0; a < grid.azimuths; ++a)
            mass += cosine_weight(grid, r) * static_cast<double>(table[cell(grid, r, a)]);
    return mass;
}

inline std::vector<float> normalized(const NdfGrid& grid, std::vector<float> table) {
    const auto mass = static_cast<float>(ndf_mass(grid, table.data()));
    for (float& v : table) v /= mass;
    return table;
}

}  // namespace burnish::test
