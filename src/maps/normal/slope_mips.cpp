#include "maps/normal/slope_mips.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/large_pages.hpp"
#include "core/parallel.hpp"
#include "maps/normal/box_taps.hpp"

namespace burnish {
namespace {

constexpr std::size_t kRows = 16;  // rows per parallel task

std::size_t count_of(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

float unit_value(std::uint8_t v) {
    return static_cast<float>(v) * (1.0f / 255.0f);
}
float unit_value(std::uint16_t v) {
    return static_cast<float>(v) * (1.0f / 65535.0f);
}
float unit_value(float v) {
    return v;
}

SlopeTexel slopes_of(f32::vec3 v) {
    // Written so that NaN fails; an infinite x, y or z is not a direction either.
    if (!(v.z > 0.0f) || !std::isfinite(v.x + v.y + v.z)) return {};
    const f32::vec2 slopes = f32::slopes_of_normal(v);
    return {slopes.x, slopes.y, 0.0f, 0.0f};
}

template <typename T>
void read_row(const Texture& map, std::size_t row, SlopeTexel* to) {
    const auto n = static_cast<std::size_t>(map.channels);
    const auto width = static_cast<std::size_t>(map.width);
    const std::byte* from = map.texels.data() + row * width * n * sizeof(T);
    for (std::size_t i = 0; i < width; ++i, from += n * sizeof(T)) {
        T texel[4] = {};
        std::memcpy(texel, from, n * sizeof(T));
        const float red = unit_value(texel[0]);
        const float green = n == 1 ? red : unit_value(texel[1]);
        to[i] = slopes_of(n == 2 ? f32::vector_of_texel(f32::vec2(red, green))
                                 : f32::vector_of_texel(
                                       f32::vec3(red, green, n == 1 ? red : unit_value(texel[2]))));
    }
}

SlopeLevel level_of_size(int width, int height) {
    SlopeLevel level;
    level.width = width;
    level.height = height;
    level.texels = zeros_on_large_pages<SlopeTexel>(count_of(width, height));
    return level;
}

SlopeLevel finest_level(const Texture& map) {
    SlopeLevel level = level_of_size(map.width, map.height);
    parallel_for(
        static_cast<std::size_t>(map.height), kRows, [&](std::size_t begin, std::size_t end) {
            for (std::size_t y = begin; y < end; ++y) {
                SlopeTexel* row = level.texels.data() + y * static_cast<std::size_t>(map.width);
                if (map.type == TexelType::u8) read_row<std::uint8_t>(map, y, row);
                if (map.type == TexelType::u16) read_row<std::uint16_t>(map, y, row);
                if (map.type == TexelType::f32) read_row<float>(map, y, row);
            }
        });
    return level;
}

// Law of total variance: the mean of the variances plus the variance of the means. E[x^2] - E[x]^2
// would cancel where slopes are similar.
struct Weighted {
    double weight;
    const SlopeTexel* texel;
};

SlopeTexel mean_of(const Weighted* parts, int count) {
    double x = 0, y = 0;
    for (int i = 0; i < count; ++i) {
        x += parts[i].weight * static_cast<double>(parts[i].texel->x);
        y += parts[i].weight * static_cast<double>(parts[i].texel->y);
    }
    double vx = 0, vy = 0;
    for (int i = 0; i < count; ++i) {
        const SlopeTexel& t = *parts[i].texel;
        const double dx = static_cast<double>(t.x) - x, dy = static_cast<double>(t.y) - y;
        vx += parts[i].weight * (static_cast<double>(t.variance_x) + dx * dx);
        vy += parts[i].weight * (static_cast<double>(t.variance_y) + dy * dy);
    }
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(vx),
            static_cast<float>(vy)};
}

SlopeTexel mean_under(const SlopeLevel& from, const Taps& tx, const Taps& ty) {
    Weighted parts[9];
    int count = 0;
    for (int j = 0; j < ty.count; ++j) {
        const SlopeTexel* row = from.texels.data() + count_of(from.width, ty.first + j);
        for (int i = 0; i < tx.count; ++i)
            parts[count++] = {ty.weight[j] * tx.weight[i], row + tx.first + i};
    }
    return mean_of(parts, count);
}

SlopeLevel halved(const SlopeLevel& from) {
    SlopeLevel level = level_of_size(std::max(1, from.width / 2), std::max(1, from.height / 2));
    parallel_for(
        static_cast<std::size_t>(level.height), kRows, [&](std::size_t begin, std::size_t end) {
            for (std::size_t y = begin; y < end; ++y) {
                const Taps ty = taps_of(static_cast<int>(y), from.height, level.height);
                SlopeTexel* row = level.texels.data() + y * static_cast<std::size_t>(level.width);
                for (int x = 0; x < level.width; ++x)
                    row[x] = mean_under(from, taps_of(x, from.width, level.width), ty);
            }
        });
    return level;
}

// Law of total covariance, of the parts of `from` that texel `mean` of the next level covers.
float covariance_under(const SlopeLevel& from, const std::vector<float>& covariances,
                       const SlopeTexel& mean, const Taps& tx, const Taps& ty) {
    double sum = 0;
    for (int j = 0; j < ty.count; ++j) {
        for (int i = 0; i < tx.count; ++i) {
            const std::size_t at =
                count_of(from.width, ty.first + j) + static_cast<std::size_t>(tx.first + i);
            const SlopeTexel& t = from.texels[at];
            const double dx = static_cast<double>(t.x) - static_cast<double>(mean.x);
            const double dy = static_cast<double>(t.y) - static_cast<double>(mean.y);
            sum += ty.weight[j] * tx.weight[i] * (static_cast<double>(covariances[at]) + dx * dy);
        }
    }
    return static_cast<float>(sum);
}

}  // namespace

std::vector<SlopeLevel> slope_mips(const Texture& map) {
    std::vector<SlopeLevel> levels;
    levels.push_back(finest_level(map));
    while (levels.back().width > 1 || levels.back().height > 1)
        levels.push_back(halved(levels.back()));
    return levels;
}

std::vector<std::vector<float>> slope_covariances(std::span<const SlopeLevel> levels) {
    std::vector<std::vector<float>> all;
    all.emplace_back(levels.front().texels.size(), 0.0f);
    for (const SlopeLevel& level : levels.subspan(1)) {
        const SlopeLevel& from = levels[all.size() - 1];
        std::vector<float> covariances(level.texels.size());
        for (int y = 0; y < level.height; ++y) {
            const Taps ty = taps_of(y, from.height, level.height);
            for (int x = 0; x < level.width; ++x) {
                const std::size_t at = count_of(level.width, y) + static_cast<std::size_t>(x);
                covariances[at] = covariance_under(from, all.back(), level.texels[at],
                                                   taps_of(x, from.width, level.width), ty);
            }
        }
        all.push_back(std::move(covariances));
    }
    return all;
}

}  // namespace burnish
