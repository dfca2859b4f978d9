// The nodes of an albedo table (albedo_table.hpp), and those that the build makes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "burnish/f32.hpp"

namespace burnish {

inline constexpr int kAlbedoAlphas = 20;
inline constexpr int kAlbedoCosines = 32;
inline constexpr int kAlbedoNodes = kAlbedoAlphas * kAlbedoAlphas * kAlbedoCosines;

struct AlbedoNode {
    float along, across;  // alphas, at least 0.01
    float cosine;         // of the view, at least 0.002
};

// Node i of n lies at the fraction i/(n - 1) of an axis of AlbedoPlace.
inline AlbedoNode albedo_node(int mdf, int index) {
    const auto fraction = [](int i, int count) {
        return static_cast<float>(i) / static_cast<float>(count - 1);
    };
    const auto alpha = [&](int i) {
        const float root = fraction(i, kAlbedoAlphas);
        return std::max(root * root * f32::albedo_most_alpha(mdf), 0.01f);
    };
    const float root = fraction(index / (kAlbedoAlphas * kAlbedoAlphas), kAlbedoCosines);
    return {alpha(index % kAlbedoAlphas), alpha(index / kAlbedoAlphas % kAlbedoAlphas),
            std::max(root * root, 0.002f)};
}

// Point i of the R2 sequence of shaders/lib/random.glsl.
inline f32::vec2 albedo_point(std::uint32_t i) {
    const auto unit = [](std::uint32_t bits) {
        return static_cast<float>(bits >> 8) * (1.0f / 16777216.0f);
    };
    return {unit(i * 3242174889u + 0x80000000u), unit(i * 2447445414u + 0x80000000u)};
}

// Coefficients of microfacet and microfacet-separable times kAlbedoScale, three a node: made by the build
// (tabulate_albedos.cpp).
inline constexpr float kAlbedoScale = 16384.0f;
std::span<const std::int16_t> made_albedos(bool separable, int mdf);

}  // namespace burnish
