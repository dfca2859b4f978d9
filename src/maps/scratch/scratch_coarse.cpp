#include "maps/scratch/scratch_coarse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/constants.hpp"
#include "core/parallel.hpp"
#include "maps/scratch/scratch_raster.hpp"

namespace burnish {

namespace {

using Strokes = std::vector<std::vector<Stroke>>;  // of each layer

constexpr int kWindow = 64;                           // texels a side
constexpr int kFewestWindows = 3, kMostWindows = 12;  // along a side of the tile

// What drawing costs one processor, in nanoseconds, on the machine on which the sizes were chosen: each
// stroke, each row of texels that it crosses, each texel of a straight and of a bent one, and the test
// whether it touches a window.
constexpr double kStroke_ns = 1000, kRow_ns = 100, kTexel_ns = 5, kBentTexel_ns = 10, kTest_ns = 3;
// For all strokes on the map, and for all windows.
constexpr double kMap_ns = 4e7, kWindows_ns = 3e7;

// More are not drawn on the coarse map. More than this are not made for the windows either, and fewer
// where strokes are trimmed to the tile point by point.
constexpr double kMostStrokes = 20000, kMostMade = 120000;

double strokes_of(const ScratchSettings& settings) {
    double count = 0.0;
    for (const ScratchLayer& layer : settings.layers) count += scratch_count(settings, layer);
    return count;
}

// The share that gives `most` strokes, at most all.
double share_of_strokes(const ScratchSettings& settings, double most) {
    return std::min(most / std::max(strokes_of(settings), 1.0), 1.0);
}

bool has_full_face(const ScratchSettings& settings) {
    return std::ranges::any_of(settings.layers, [](const ScratchLayer& layer) {
        return layer.field == ScratchField::circular || layer.field == ScratchField::radial;
    });
}

// Nanoseconds for all strokes on a map of this size.
double drawing_ns(const ScratchSettings& settings, int size) {
    const double texel_mm = settings.tile_mm / size;
    double total = 0.0;
    for (const ScratchLayer& layer : settings.layers) {
        const bool straight = layer.field == ScratchField::constant;
        const double length = layer.length_mm.typical() / texel_mm;
        const double width = std::max(layer.width_mm.typical() / texel_mm, 2.5);
        // Share of the length that is across rows: of lines in all directions 2/pi.
        const double across = straight ? std::abs(std::sin(layer.angle_deg * kDegree)) : 0.64;
        const double rows = length * across + width;
        // Rows are drawn four texels at a time: two more than the stroke has, on average.
        const double texels = length * width + 2.0 * rows;
        const bool bent = !straight || layer.curvature_per_mm != constant_spread(0.0);
        total += scratch_count(settings, layer) *
                 (kStroke_ns + rows * kRow_ns + texels * (bent ? kBentTexel_ns : kTexel_ns));
    }
    return total;
}

struct SquaredSlopes {
    double sum = 0.0, count = 0.0;
    double mean() const { return count > 0.0 ? sum / count : 0.0; }
};

// Of the texels [x0, x1) x [y0, y1) of the repeating tile.
SquaredSlopes squared_slopes(const ScratchMaps& maps, int x0, int y0, int x1, int y1) {
    SquaredSlopes found;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const auto [sx, sy] = slope_at(maps, x % maps.size, y % maps.size);
            found.sum += static_cast<double>(sx * sx + sy * sy);
        }
    found.count = static_cast<double>(x1 - x0) * (y1 - y0);
    return found;
}

// A part of the full map, from (x0, y0) on: heights of kWindow x kWindow texels.
class WindowEngraver {
  public:
    WindowEngraver(const ScratchSettings& settings, const Strokes& strokes) : settings_(settings) {
        for (std::size_t i = 0; i < settings.layers.size(); ++i)
            layers_.push_back(texel_strokes(strokes[i], settings.layers[i].taper,
                                            settings.tile_mm / settings.size));
    }

    SquaredSlopes squared_slopes_at(int x0, int y0) const {
        BlockBuffers block;
        block.move_to(x0, y0, kWindow, kWindow);
        ScratchMaps window;
        window.size = kWindow;
        window.tile_mm = settings_.tile_mm * kWindow / settings_.size;
        window.height = Image(kWindow, kWindow, 1);
        for (std::size_t i = 0; i < layers_.size(); ++i) {
            block.clear_layer();
            for (const TexelStroke& stroke : layers_[i])
                draw_where_it_touches(stroke, settings_.layers[i].profile, block);
            for (std::size_t t = 0; t < window.height.pixels.size(); ++t)
                window.height.pixels[t] += block.groove[t] + block.lip[t];
        }
        // The window itself does not repeat: its rim has no slopes.
        return squared_slopes(window, 1, 1, kWindow - 1, kWindow - 1);
    }

  private:
    void draw_where_it_touches(const TexelStroke& stroke, ScratchProfile profile,
                               BlockBuffers& block) const {
        const double size = settings_.size;
        const auto first = [&](int low, double middle, float high_bound) {
            return std::ceil((low - middle - static_cast<double>(high_bound)) / size);
        };
        const auto last = [&](int low, double middle, float low_bound) {
            return std::floor((low + kWindow - middle - static_cast<double>(low_bound)) / size);
        };
        const double x1 = last(block.x0, stroke.mx, stroke.low_x);
        const double y1 = last(block.y0, stroke.my, stroke.low_y);
        for (double y = first(block.y0, stroke.my, stroke.high_y); y <= y1; ++y)
            for (double x = first(block.x0, stroke.mx, stroke.high_x); x <= x1; ++x)
                draw_stroke(stroke, profile, x * size, y * size, block);
    }

    const ScratchSettings& settings_;
    std::vector<std::vector<TexelStroke>> layers_;
};

int windows_a_side(const ScratchSettings& settings) {
    const double share = static_cast<double>(kWindow) / settings.size;
    const double each =
        strokes_of(settings) * kTest_ns + drawing_ns(settings, settings.size) * share * share;
    const int wanted = static_cast<int>(std::sqrt(kWindows_ns / std::max(each, 1.0)));
    return std::clamp(wanted, kFewestWindows, kMostWindows);
}

// Root of the mean squared slope of the full map over that of the coarse one, both over the same
// windows: whether a rare broad furrow runs through them or not, it does so in both.
double slope_ratio(const ScratchSettings& settings, const Strokes& strokes,
                   const ScratchMaps& coarse) {
    const WindowEngraver full(settings, strokes);
    const auto side = static_cast<std::size_t>(windows_a_side(settings));
    std::vector<std::array<SquaredSlopes, 2>> found(side * side);
    const double texels = static_cast<double>(coarse.size) / settings.size;
    parallel_for(found.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto place = [&](std::size_t k) {
                return static_cast<int>((static_cast<double>(k) + 0.5) * settings.size /
                                        static_cast<double>(side)) -
                       kWindow / 2;
            };
            // Rows are shifted against each other, so that windows do not line up along a straight
            // scratch.
            const int y0 = std::max(place(i / side), 0);
            const int x0 =
                (std::max(place(i % side), 0) +
                 static_cast<int>(i / side) * settings.size * 5 / 8 / static_cast<int>(side)) %
                settings.size;
            found[i][0] = full.squared_slopes_at(x0, y0);
            const auto at = [&](int texel) {
                return static_cast<int>(std::lround(texel * texels));
            };
            found[i][1] =
                squared_slopes(coarse, at(x0), at(y0), std::max(at(x0 + kWindow), at(x0) + 1),
                               std::max(at(y0 + kWindow), at(y0) + 1));
        }
    });
    std::array<SquaredSlopes, 2> all;
    for (const auto& window : found)
        for (std::size_t k = 0; k < 2; ++k) {
            all[k].sum += window[k].sum;
            all[k].count += window[k].count;
        }
    // 1e-12: no scratch runs through the windows.
    if (!(all[1].mean() > 1e-12)) return 1.0;
    return std::sqrt(std::max(all[0].mean() / all[1].mean(), 1.0));
}

}  // namespace

int coarse_scratch_size(const ScratchSettings& settings) {
    constexpr std::array kSizes = {512, 384, 256, 192, 128};
    const double share = share_of_strokes(settings, kMostStrokes);
    const auto* const size = std::find_if(kSizes.begin(), kSizes.end() - 1, [&](int texels) {
        return share * drawing_ns(settings, texels) <= kMap_ns;
    });
    return std::min(*size, settings.size);
}

ScratchMaps engrave_coarse(const ScratchSettings& settings, const ScratchInputs& inputs, int size) {
    check_scratch_inputs(settings, inputs);
    const bool is_full = size >= settings.size;
    // Many scratches lie on one another: where they are is seen little, how steep they are is seen.
    ScratchSettings coarse =
        scaled_scratches(settings, is_full ? 1.0 : share_of_strokes(settings, kMostStrokes), 1.0);
    coarse.size = size;
    const Strokes drawn = strokes_of_layers(coarse, inputs);
    ScratchMaps maps = engrave_strokes(coarse, inputs, drawn, {});
    if (is_full) return maps;
    const double share =
        share_of_strokes(settings, has_full_face(settings) ? kMostStrokes : kMostMade);
    const ScratchSettings dense = scaled_scratches(settings, share, 1.0);
    const bool same = dense.layers == coarse.layers;  // strokes do not depend on the size
    const auto scale = static_cast<float>(
        slope_ratio(dense, same ? drawn : strokes_of_layers(dense, inputs), maps));
    for (float& height : maps.height.pixels) height *= scale;
    return maps;
}

}  // namespace burnish
