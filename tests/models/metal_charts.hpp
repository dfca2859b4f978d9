// Colors of metals at normal incidence as others publish them, for comparison.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "burnish/f64.hpp"

namespace burnish::test {

struct ChartColor {
    std::string_view metal;
    glm::ivec3 srgb;  // 8 bit
};

struct MetalChart {
    std::string_view name;
    std::span<const ChartColor> colors;
};

inline glm::ivec3 srgb8_of_linear(glm::dvec3 linear) {
    glm::ivec3 out;
    for (int c = 0; c < 3; ++c) {
        const double held = std::clamp(linear[c], 0.0, 1.0);
        out[c] = static_cast<int>(std::lround(255.0 * f64::srgb_from_linear(held)));
    }
    return out;
}

// Filament, "Material Properties" (a sheet of 2019, docs/Material Properties.pdf).
inline constexpr ChartColor kFilament[] = {
    {"silver", {250, 249, 245}},   {"aluminium", {244, 245, 245}}, {"iron", {192, 189, 186}},
    {"titanium", {206, 200, 194}}, {"copper", {251, 216, 184}},    {"gold", {255, 220, 157}},
    {"brass", {244, 228, 173}}};

// Adobe, "Metal material references", base color of the Adobe Standard Material.
inline constexpr ChartColor kAdobe[] = {{"silver", {254, 253, 251}}, {"aluminium", {245, 246, 246}},
                                        {"gold", {255, 219, 152}},   {"chromium", {196, 197, 196}},
                                        {"copper", {255, 211, 192}}, {"iron", {243, 241, 233}},
                                        {"nickel", {218, 209, 197}}, {"titanium", {178, 169, 162}}};

// Akenine-Moller et al. 2018, "Real-Time Rendering", 4th edition, table 9.2, linear there. Lagarde's
// memo of 2011 has the same numbers, but for gold, which he divides by its red.
inline constexpr ChartColor kRealTimeRendering[] = {
    {"gold", {255, 229, 158}},      {"silver", {252, 250, 245}},   {"copper", {250, 209, 194}},
    {"aluminium", {245, 246, 246}}, {"titanium", {194, 187, 179}}, {"chromium", {196, 197, 196}},
    {"nickel", {212, 205, 192}},    {"iron", {198, 198, 200}},     {"brass", {245, 228, 174}}};

inline constexpr std::array<MetalChart, 3> kMetalCharts = {
    {{"Filament", kFilament}, {"Adobe", kAdobe}, {"Real-Time Rendering", kRealTimeRendering}}};

// The color of a metal in a chart; nullptr where it has none.
inline const ChartColor* find_color(const MetalChart& chart, std::string_view metal) {
    for (const ChartColor& color : chart.colors)
        if (color.metal == metal) return &color;
    return nullptr;
}

// The largest difference of a channel, of 255.
inline int difference(glm::ivec3 a, glm::ivec3 b) {
    const glm::ivec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

}  // namespace burnish::test
