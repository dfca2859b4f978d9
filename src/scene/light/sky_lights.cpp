#include "scene/light/sky_lights.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "burnish/f64.hpp"

namespace burnish {
namespace {

double sound(float v) {
    return std::isfinite(v) && v > 0.0f ? static_cast<double>(v) : 0.0;
}

glm::dvec3 radiance_at(const Image& map, int x, int y) {
    const float* p = map.at(x, y);
    if (map.channels < 3) return glm::dvec3(sound(p[0]));
    return {sound(p[0]), sound(p[1]), sound(p[2])};
}

double luminance(const glm::dvec3& c) {
    return f64::luminance(f64::vec3(c));
}

// Cumulative sums of the weights: entry i sums the weights before i, and the last entry sums all.
std::vector<double> sums_of(const std::vector<double>& weights) {
    std::vector<double> sums(1, 0.0);
    sums.reserve(weights.size() + 1);
    for (const double w : weights) sums.push_back(sums.back() + w);
    return sums;
}

struct Place {
    int index;
    double within;  // position in the entry, [0, 1)
};

Place pick(const std::vector<double>& sums, double u) {
    const double wanted = u * sums.back();
    const auto after = std::upper_bound(sums.begin() + 1, sums.end() - 1, wanted);
    const auto i = static_cast<std::size_t>(after - sums.begin()) - 1;
    const double width = sums[i + 1] - sums[i];
    return {static_cast<int>(i), width > 0 ? std::min((wanted - sums[i]) / width, 1.0) : 0.5};
}

// The bits of i mirrored about the binary point: van der Corput's sequence.
double mirrored_bits(std::uint32_t i) {
    double value = 0, digit = 0.5;
    for (; i != 0; i >>= 1, digit *= 0.5) value += (i & 1U) != 0 ? digit : 0.0;
    return value;
}

}  // namespace

std::vector<SkyLight> sky_lights(const Environment& environment, int count) {
    const Image& map = environment.radiance;
    // The middle row of an odd height straddles the horizon; row_weight cuts it there.
    const int rows = (map.height + 1) / 2;
    const double step = std::numbers::pi / map.height;
    // Int L cos dw of a texel: the width of its column times Int cos sin dtheta of its row.
    const auto row_weight = [&](int y) {
        const double end = std::min((y + 1) * step, std::numbers::pi / 2);
        const double a = std::sin(y * step), b = std::sin(end);
        return 0.5 * (b * b - a * a) * 2 * std::numbers::pi / map.width;
    };
    std::vector<std::vector<double>> columns;  // cumulative sums along every row
    std::vector<double> row_totals;
    for (int y = 0; y < rows; ++y) {
        std::vector<double> weights;
        weights.reserve(static_cast<std::size_t>(map.width));
        for (int x = 0; x < map.width; ++x) weights.push_back(luminance(radiance_at(map, x, y)));
        columns.push_back(sums_of(weights));
        row_totals.push_back(columns.back().back() * row_weight(y));
    }
    const std::vector<double> row_sums = sums_of(row_totals);
    std::vector<SkyLight> lights;
    if (!(row_sums.back() > 0)) return lights;
    for (int i = 0; i < count; ++i) {
        const Place row = pick(row_sums, (i + 0.5) / count);
        const Place column = pick(columns[static_cast<std::size_t>(row.index)],
                                  mirrored_bits(static_cast<std::uint32_t>(i)) + 0.5 / count);
        const double theta = std::min((row.index + row.within) * step, 1.5707);  // y stays > 0
        // Environment: u = 1/2 + atan2(x, -z) / (2 pi).
        const double phi =
            ((column.index + column.within) / map.width - 0.5) * 2 * std::numbers::pi;
        const glm::dvec3 color = radiance_at(map, column.index, row.index);
        const double share = row_sums.back() / count / luminance(color);
        lights.push_back({glm::vec3(std::sin(theta) * std::sin(phi), std::cos(theta),
                                    -std::sin(theta) * std::cos(phi)),
                          glm::vec3(color * share)});
    }
    return lights;
}

}  // namespace burnish
