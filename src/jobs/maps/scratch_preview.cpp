#include "jobs/maps/scratch_preview.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "jobs/maps/map_preview.hpp"
#include "plot/sheet.hpp"

namespace burnish {

namespace {

constexpr int kSide = 512;

float rms_slope_of(const ScratchMaps& maps) {
    if (maps.moments.empty()) return 1.0f;
    const SlopeMoments& mean = maps.moments.back().texels.front();
    return std::sqrt(std::max(mean.sxx + mean.syy, 1e-12f));
}

// Shades slopes by light from the upper left, as in relief maps; the contrast is relative to the
// rms slope. Grooves parallel to that light have no slope towards it, so that their flanks are
// darkened slightly.
float relief(float sx, float sy, float rms) {
    constexpr float kDiagonal = std::numbers::sqrt2_v<float> / 2.0f;
    const float towards = (sx - sy) / rms * kDiagonal;
    const float across = std::abs(sx + sy) / rms * kDiagonal;
    return 0.5f + 0.5f * std::tanh(0.7f * towards - 0.35f * across);
}

// Relief of the finest mip level that is not larger than the picture; its texels are repeated.
Image tile_relief(const ScratchMaps& maps, int repeats) {
    const float rms = rms_slope_of(maps);
    const int wanted = kSide / repeats;
    const auto level = std::find_if(maps.moments.begin(), maps.moments.end(),
                                    [&](const MomentLevel& l) { return l.size <= wanted; });
    const bool full = maps.size <= wanted || level == maps.moments.end();
    const int size = full ? maps.size : level->size;
    // Averaging reduces slopes: the contrast is relative to the slopes of this level.
    Image image(kSide, kSide, 1);
    double sum = 0.0;
    const auto slopes = [&](int x, int y) {
        return full ? slope_moments(maps, x, y)
                    : level->texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                                    static_cast<std::size_t>(x)];
    };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const SlopeMoments m = slopes(x, y);
            sum += static_cast<double>(m.sx * m.sx + m.sy * m.sy);
        }
    const float seen = std::max(static_cast<float>(std::sqrt(sum / (size * size))), 0.02f * rms);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const SlopeMoments m =
                slopes((x * repeats * size / kSide) % size, (y * repeats * size / kSide) % size);
            *image.at(x, y) = relief(m.sx, m.sy, seen);
        }
    return image;
}

struct Part {
    int x, y, side;
};

template <typename Color>
Image part_image(const Part& part, const Color& color) {
    Image image(part.side, part.side, 3);
    for (int y = 0; y < part.side; ++y)
        for (int x = 0; x < part.side; ++x) color(part.x + x, part.y + y, image.at(x, y));
    return image;
}

void gray(float value, float* rgb) {
    std::fill(rgb, rgb + 3, value);
}

}  // namespace

Image scratch_preview(const ScratchMaps& maps) {
    const int side = std::min(kSide, maps.size);
    // A part beside the middle, where a full face has its singular point.
    const int corner = (maps.size - side) / 4;
    const Part part{corner, corner, side};
    const float rms = rms_slope_of(maps);
    const auto ends = std::minmax_element(maps.height.pixels.begin(), maps.height.pixels.end());
    const float low = *ends.first, high = *ends.second;
    const float range = std::max(high - low, 1e-12f);
    const Image lit = part_image(part, [&](int x, int y, float* rgb) {
        const auto [sx, sy] = slope_at(maps, x, y);
        gray(relief(sx, sy, rms), rgb);
    });
    const Image normals = part_image(part, [&](int x, int y, float* rgb) {
        const auto [sx, sy] = slope_at(maps, x, y);
        const float scale = 0.5f / std::sqrt(1.0f + sx * sx + sy * sy);
        rgb[0] = 0.5f - scale * sx;
        rgb[1] = 0.5f - scale * sy;
        rgb[2] = 0.5f + scale;
    });
    const Image heights = part_image(
        part, [&](int x, int y, float* rgb) { gray((*maps.height.at(x, y) - low) / range, rgb); });
    const Image directions = part_image(
        part, [&](int x, int y, float* rgb) { line_color(maps.direction.at(x, y), rgb); });
    const double part_mm = maps.tile_mm * side / maps.size;
    return compose_sheet(
        {{{tile_relief(maps, 1), fmt::format("relief, the tile ({:g} mm)", maps.tile_mm)},
          {tile_relief(maps, 2), "relief, two by two tiles"},
          {lit, fmt::format("relief, texel by texel ({:.3g} mm)", part_mm)}},
         {{normals, "normal"},
          {heights, fmt::format("height, {:.3g} to {:.3g} mm", static_cast<double>(low),
                                static_cast<double>(high))},
          {directions, "groove direction (red along x, cyan along y)"}}});
}

}  // namespace burnish
