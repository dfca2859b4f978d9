#include "maps/scratch_slopes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/parallel.hpp"

namespace burnish {

namespace {

struct Taps {
    int first = 0;
    int count = 0;
    double weight[3] = {};
};

// What texel i of `to` covers of a row of `from`, 1 <= from / to < 3.
Taps taps_of(int i, int from, int to) {
    const double ratio = static_cast<double>(from) / to;
    const double begin = i * ratio, end = (i + 1) * ratio;
    Taps taps;
    taps.first = static_cast<int>(begin);
    for (int j = taps.first; j < from && taps.count < 3; ++j) {
        const double covered = std::min(end, j + 1.0) - std::max(begin, static_cast<double>(j));
        // 1e-9: what rounding leaves of a texel that is not covered.
        if (covered <= 1e-9) break;
        taps.weight[taps.count++] = covered / ratio;
    }
    return taps;
}

template <typename Source>
SlopeMoments mean_of(const Taps& tx, const Taps& ty, const Source& source) {
    double sums[5] = {};
    for (int j = 0; j < ty.count; ++j) {
        for (int i = 0; i < tx.count; ++i) {
            const double w = ty.weight[j] * tx.weight[i];
            const SlopeMoments m = source(tx.first + i, ty.first + j);
            sums[0] += w * static_cast<double>(m.sx);
            sums[1] += w * static_cast<double>(m.sy);
            sums[2] += w * static_cast<double>(m.sxx);
            sums[3] += w * static_cast<double>(m.syy);
            sums[4] += w * static_cast<double>(m.sxy);
        }
    }
    const auto f = [&](int i) { return static_cast<float>(sums[i]); };
    return {f(0), f(1), f(2), f(3), f(4)};
}

template <typename Source>
MomentLevel halved(int size, const Source& source) {
    MomentLevel level;
    level.size = std::max(1, size / 2);
    const auto side = static_cast<std::size_t>(level.size);
    level.texels.resize(side * side);
    std::vector<Taps> taps;
    for (int i = 0; i < level.size; ++i) taps.push_back(taps_of(i, size, level.size));
    parallel_for(side, 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y)
            for (std::size_t x = 0; x < side; ++x)
                level.texels[y * side + x] = mean_of(taps[x], taps[y], source);
    });
    return level;
}

// Calls texel(x, y, place in `to`) for rows [begin, end), in parallel.
template <typename Texel>
void for_rows(int size, int begin, int end, int channels, float* to, const Texel& texel) {
    parallel_for(static_cast<std::size_t>(end - begin), 8, [&](std::size_t from, std::size_t stop) {
        for (std::size_t row = from; row < stop; ++row) {
            float* at =
                to + row * static_cast<std::size_t>(size) * static_cast<std::size_t>(channels);
            for (int x = 0; x < size; ++x, at += channels)
                texel(x, begin + static_cast<int>(row), at);
        }
    });
}

void store_normal(std::array<float, 2> slope, float* rgb) {
    const float scale = 0.5f / std::sqrt(1.0f + slope[0] * slope[0] + slope[1] * slope[1]);
    rgb[0] = 0.5f - scale * slope[0];
    rgb[1] = 0.5f - scale * slope[1];
    rgb[2] = 0.5f + scale;
}

}  // namespace

std::array<float, 2> slope_at(const ScratchMaps& maps, int x, int y) {
    const int n = maps.size;
    const int left = x > 0 ? x - 1 : n - 1, right = x + 1 < n ? x + 1 : 0;
    const float* above = maps.height.at(0, y > 0 ? y - 1 : n - 1);
    const float* here = maps.height.at(0, y);
    const float* below = maps.height.at(0, y + 1 < n ? y + 1 : 0);
    const auto per_mm = static_cast<float>(n / (32.0 * maps.tile_mm));
    const float dx = 3.0f * ((above[right] - above[left]) + (below[right] - below[left])) +
                     10.0f * (here[right] - here[left]);
    const float dy = 3.0f * ((above[left] - below[left]) + (above[right] - below[right])) +
                     10.0f * (above[x] - below[x]);
    return {per_mm * dx, per_mm * dy};
}

SlopeMoments slope_moments(const ScratchMaps& maps, int x, int y) {
    const auto [sx, sy] = slope_at(maps, x, y);
    return {sx, sy, sx * sx, sy * sy, sx * sy};
}

void normal_rows(const ScratchMaps& maps, int begin, int end, float* to) {
    for_rows(maps.size, begin, end, 3, to,
             [&](int x, int y, float* rgb) { store_normal(slope_at(maps, x, y), rgb); });
}

void moment_rows(const ScratchMaps& maps, int begin, int end, float* to) {
    for_rows(maps.size, begin, end, 5, to, [&](int x, int y, float* out) {
        const SlopeMoments m = slope_moments(maps, x, y);
        const float values[] = {m.sx, m.sy, m.sxx, m.syy, m.sxy};
        std::copy(std::begin(values), std::end(values), out);
    });
}

void stretch_rows(const ScratchMaps& maps, const ScratchLayer& ground, int begin, int end,
                  float* to) {
    const bool from_middle =
        ground.field == ScratchField::circular || ground.field == ScratchField::radial;
    const double across = (ground.angle_deg + 90.0) * std::numbers::pi / 180.0;
    const auto rx = static_cast<float>(std::cos(across));
    const auto ry = static_cast<float>(std::sin(across));
    const float middle = 0.5f * static_cast<float>(maps.size - 1);
    for_rows(maps.size, begin, end, 3, to, [&](int x, int y, float* rgb) {
        const float* line = maps.direction.at(x, y);
        if (line[0] == 0.0f && line[1] == 0.0f) {
            rgb[0] = 1.0f;
            rgb[1] = 0.5f;
            rgb[2] = 0.0f;
            return;
        }
        // Half of the double angle, and a quarter turn further: across the groove.
        const float groove = 0.5f * std::atan2(line[1], line[0]);
        float dx = -std::sin(groove), dy = std::cos(groove);
        const float ax = from_middle ? static_cast<float>(x) - middle : rx;
        const float ay = from_middle ? middle - static_cast<float>(y) : ry;
        const float sign = dx * ax + dy * ay < 0.0f ? -1.0f : 1.0f;
        dx *= sign;
        dy *= sign;
        rgb[0] = 0.5f + 0.5f * dx;
        rgb[1] = 0.5f + 0.5f * dy;
        rgb[2] = 1.0f;
    });
}

Image normal_map(const ScratchMaps& maps) {
    Image map(maps.size, maps.size, 3);
    normal_rows(maps, 0, maps.size, map.pixels.data());
    return map;
}

std::vector<MomentLevel> moment_levels(const ScratchMaps& maps) {
    std::vector<MomentLevel> levels;
    if (maps.size < 2) return levels;
    levels.push_back(halved(maps.size, [&](int x, int y) { return slope_moments(maps, x, y); }));
    while (levels.back().size > 1) {
        const MomentLevel& last = levels.back();
        MomentLevel next = halved(last.size, [&](int x, int y) {
            return last.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(last.size) +
                               static_cast<std::size_t>(x)];
        });
        levels.push_back(std::move(next));
    }
    return levels;
}

}  // namespace burnish
