#include "maps/scratch/scratch_slopes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/constants.hpp"
#include "core/large_pages.hpp"
#include "core/parallel.hpp"
#include "image/large_image.hpp"
#include "maps/normal/box_taps.hpp"

namespace burnish {

namespace {

SlopeMoments moments_of(float sx, float sy) {
    return {sx, sy, sx * sx, sy * sy, sx * sy};
}

// Three neighboring rows of heights of the repeating tile.
struct HeightRows {
    const float *above, *here, *below;
    float per_mm;

    HeightRows(const ScratchMaps& maps, int y)
        : above(maps.height.at(0, y > 0 ? y - 1 : maps.size - 1)),
          here(maps.height.at(0, y)),
          below(maps.height.at(0, y + 1 < maps.size ? y + 1 : 0)),
          per_mm(static_cast<float>(maps.size / (32.0 * maps.tile_mm))) {}

    float slope_x(std::size_t left, std::size_t right) const {
        return per_mm * (3.0f * ((above[right] - above[left]) + (below[right] - below[left])) +
                         10.0f * (here[right] - here[left]));
    }
    float slope_y(std::size_t left, std::size_t x, std::size_t right) const {
        return per_mm * (3.0f * ((above[left] - below[left]) + (above[right] - below[right])) +
                         10.0f * (above[x] - below[x]));
    }
};

// The slopes of a row, by the formula of slope_at: arithmetic only, so that compilers vectorize it.
struct SlopeRow {
    std::vector<float> x, y;

    explicit SlopeRow(int size)
        : x(static_cast<std::size_t>(size)), y(static_cast<std::size_t>(size)) {}

    void compute(const ScratchMaps& maps, int row) {
        const HeightRows rows(maps, row);
        const std::size_t n = x.size();
        float *sx = x.data(), *sy = y.data();
        for (std::size_t i = 1; i + 1 < n; ++i) {
            sx[i] = rows.slope_x(i - 1, i + 1);
            sy[i] = rows.slope_y(i - 1, i, i + 1);
        }
        for (const std::size_t i : {std::size_t{0}, n - 1}) {
            const std::array<float, 2> slope = slope_at(maps, static_cast<int>(i), row);
            sx[i] = slope[0];
            sy[i] = slope[1];
        }
    }
};

// The weighted mean of the texels in (tx, ty); texel(x, j) is texel x of row ty.first + j.
template <typename Texel>
SlopeMoments mean_of(const Taps& tx, const Taps& ty, const Texel& texel) {
    double sums[5] = {};
    for (int j = 0; j < ty.count; ++j) {
        for (int i = 0; i < tx.count; ++i) {
            const double w = ty.weight[j] * tx.weight[i];
            const SlopeMoments m = texel(static_cast<std::size_t>(tx.first + i), j);
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

// As mean_of for four whole texels, with identical bits.
SlopeMoments mean_of_four(const SlopeMoments& a, const SlopeMoments& b, const SlopeMoments& c,
                          const SlopeMoments& d) {
    const auto mean = [&](float SlopeMoments::*m) {
        const double ab = static_cast<double>(a.*m) + static_cast<double>(b.*m);
        return static_cast<float>(0.25 *
                                  (ab + static_cast<double>(c.*m) + static_cast<double>(d.*m)));
    };
    return {mean(&SlopeMoments::sx), mean(&SlopeMoments::sy), mean(&SlopeMoments::sxx),
            mean(&SlopeMoments::syy), mean(&SlopeMoments::sxy)};
}

// A level of half the size of one with `size` texels a side. `source()` makes a reader for a range
// of rows. reader(first, count) prepares rows of the finer level and returns the argument `texel`
// of mean_of.
template <typename Source>
MomentLevel halved(int size, const Source& source) {
    MomentLevel level;
    level.size = std::max(1, size / 2);
    const auto side = static_cast<std::size_t>(level.size);
    level.texels = zeros_on_large_pages<SlopeMoments>(side * side);
    std::vector<Taps> taps;
    taps.reserve(side);
    for (int i = 0; i < level.size; ++i) taps.push_back(taps_of(i, size, level.size));
    parallel_for(side, 16, [&](std::size_t begin, std::size_t end) {
        auto reader = source();
        for (std::size_t y = begin; y < end; ++y) {
            const auto texel = reader(taps[y].first, taps[y].count);
            SlopeMoments* to = level.texels.data() + y * side;
            for (std::size_t x = 0; x < side; ++x)
                to[x] = size % 2 == 0 ? mean_of_four(texel(2 * x, 0), texel(2 * x + 1, 0),
                                                     texel(2 * x, 1), texel(2 * x + 1, 1))
                                      : mean_of(taps[x], taps[y], texel);
        }
    });
    return level;
}

// Calls row(y, pointer into `to`) for rows [begin, end), in parallel.
template <typename Row>
void for_rows(int size, int begin, int end, int channels, float* to, const Row& row) {
    const std::size_t stride = static_cast<std::size_t>(size) * static_cast<std::size_t>(channels);
    parallel_for(static_cast<std::size_t>(end - begin), 8, [&](std::size_t from, std::size_t stop) {
        for (std::size_t i = from; i < stop; ++i) row(begin + static_cast<int>(i), to + i * stride);
    });
}

// Calls row(slopes of the row, pointer into `to`), as for_rows does.
template <typename Row>
void for_slope_rows(const ScratchMaps& maps, int begin, int end, int channels, float* to,
                    const Row& row) {
    for_rows(maps.size, begin, end, channels, to, [&](int y, float* at) {
        SlopeRow slopes(maps.size);
        slopes.compute(maps, y);
        row(slopes, at);
    });
}

}  // namespace

std::array<float, 2> slope_at(const ScratchMaps& maps, int x, int y) {
    const auto here = static_cast<std::size_t>(x), last = static_cast<std::size_t>(maps.size - 1);
    const std::size_t left = here > 0 ? here - 1 : last, right = here < last ? here + 1 : 0;
    const HeightRows rows(maps, y);
    return {rows.slope_x(left, right), rows.slope_y(left, here, right)};
}

SlopeMoments slope_moments(const ScratchMaps& maps, int x, int y) {
    const auto [sx, sy] = slope_at(maps, x, y);
    return moments_of(sx, sy);
}

void normal_rows(const ScratchMaps& maps, int begin, int end, float* to) {
    for_slope_rows(maps, begin, end, 3, to, [](const SlopeRow& slopes, float* rgb) {
        const std::size_t n = slopes.x.size();
        // Computes a whole row before storing any of it, so that the square roots vectorize.
        std::vector<float> scales(n);
        const float *sx = slopes.x.data(), *sy = slopes.y.data();
        float* scale = scales.data();
        for (std::size_t i = 0; i < n; ++i)
            scale[i] = 0.5f / std::sqrt(1.0f + sx[i] * sx[i] + sy[i] * sy[i]);
        for (std::size_t i = 0; i < n; ++i, rgb += 3) {
            rgb[0] = 0.5f - scale[i] * sx[i];
            rgb[1] = 0.5f - scale[i] * sy[i];
            rgb[2] = 0.5f + scale[i];
        }
    });
}

void moment_rows(const ScratchMaps& maps, int begin, int end, float* to) {
    for_slope_rows(maps, begin, end, 5, to, [](const SlopeRow& slopes, float* out) {
        for (std::size_t i = 0; i < slopes.x.size(); ++i, out += 5) {
            const SlopeMoments m = moments_of(slopes.x[i], slopes.y[i]);
            const float values[] = {m.sx, m.sy, m.sxx, m.syy, m.sxy};
            std::copy(std::begin(values), std::end(values), out);
        }
    });
}

void stretch_rows(const ScratchMaps& maps, const ScratchLayer& ground, int begin, int end,
                  float* to) {
    const bool from_middle =
        ground.field == ScratchField::circular || ground.field == ScratchField::radial;
    const double across = (ground.angle_deg + 90.0) * kDegree;
    const auto rx = static_cast<float>(std::cos(across));
    const auto ry = static_cast<float>(std::sin(across));
    const float middle = 0.5f * static_cast<float>(maps.size - 1);
    const auto texel = [&](int x, int y, float* rgb) {
        const float* line = maps.direction.at(x, y);
        if (line[0] == 0.0f && line[1] == 0.0f) {
            rgb[0] = 1.0f;
            rgb[1] = 0.5f;
            rgb[2] = 0.0f;
            return;
        }
        // Half of the double angle plus 90 degrees: the direction across the groove.
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
    };
    for_rows(maps.size, begin, end, 3, to, [&](int y, float* rgb) {
        for (int x = 0; x < maps.size; ++x, rgb += 3) texel(x, y, rgb);
    });
}

Image normal_map(const ScratchMaps& maps) {
    Image map = image_on_large_pages(maps.size, maps.size, 3);
    normal_rows(maps, 0, maps.size, map.pixels.data());
    return map;
}

std::vector<MomentLevel> moment_levels(const ScratchMaps& maps) {
    std::vector<MomentLevel> levels;
    if (maps.size < 2) return levels;
    levels.push_back(halved(maps.size, [&] {
        return [&maps, rows = std::vector<SlopeRow>(3, SlopeRow(maps.size))](int y,
                                                                             int count) mutable {
            for (int j = 0; j < count; ++j) rows[static_cast<std::size_t>(j)].compute(maps, y + j);
            return [&rows](std::size_t x, int j) {
                const SlopeRow& row = rows[static_cast<std::size_t>(j)];
                return moments_of(row.x[x], row.y[x]);
            };
        };
    }));
    while (levels.back().size > 1) {
        const MomentLevel& last = levels.back();
        MomentLevel next = halved(last.size, [&last] {
            return [&last](int y, int) {
                const auto side = static_cast<std::size_t>(last.size);
                const SlopeMoments* first = last.texels.data() + static_cast<std::size_t>(y) * side;
                return [first, side](std::size_t x, int j) {
                    return first[static_cast<std::size_t>(j) * side + x];
                };
            };
        });
        levels.push_back(std::move(next));
    }
    return levels;
}

}  // namespace burnish
