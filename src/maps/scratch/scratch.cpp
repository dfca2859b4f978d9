#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "burnish/error.hpp"
#include "burnish/scratch_maps.hpp"
#include "core/large_pages.hpp"
#include "core/parallel.hpp"
#include "image/large_image.hpp"
#include "maps/scratch/scratch_field.hpp"
#include "maps/scratch/scratch_raster.hpp"
#include "maps/scratch/scratch_slopes.hpp"
#include "maps/scratch/scratch_strokes.hpp"

namespace burnish {

namespace {

struct DrawnLayer {
    std::vector<TexelStroke> strokes;
    StrokeBins bins;
};

// Engraves blocks of one tile; any thread may engrave any block.
class Engraver {
  public:
    Engraver(const ScratchSettings& settings, const ScratchInputs& inputs,
             const std::vector<std::vector<Stroke>>& strokes, ScratchMaps& maps)
        : settings_(settings), maps_(maps), ground_(settings.layers.front(), inputs) {
        for (std::size_t i = 0; i < settings.layers.size(); ++i) {
            std::vector<TexelStroke> drawn = texel_strokes(strokes[i], settings.layers[i].taper,
                                                           settings.tile_mm / settings.size);
            StrokeBins bins(drawn, settings.size);
            layers_.push_back({std::move(drawn), std::move(bins)});
        }
    }

    std::size_t blocks_a_side() const {
        return static_cast<std::size_t>((settings_.size + kBlock - 1) / kBlock);
    }

    // `block` is a buffer that successive blocks reuse.
    void engrave_block(std::size_t number, BlockBuffers& block) const {
        const int x0 = static_cast<int>(number % blocks_a_side()) * kBlock;
        const int y0 = static_cast<int>(number / blocks_a_side()) * kBlock;
        block.move_to(x0, y0, std::min(kBlock, settings_.size - x0),
                      std::min(kBlock, settings_.size - y0));
        for (std::size_t i = 0; i < layers_.size(); ++i) {
            const DrawnLayer& layer = layers_[i];
            block.clear_layer();
            for (const StrokeUse* use = layer.bins.begin(number); use != layer.bins.end(number);
                 ++use)
                draw_stroke(layer.strokes[use->stroke], settings_.layers[i].profile,
                            static_cast<double>(use->shift_x) * settings_.size,
                            static_cast<double>(use->shift_y) * settings_.size, block);
            add_heights(block);
        }
        store_directions(block);
    }

  private:
    void add_heights(const BlockBuffers& block) const {
        for (int y = 0; y < block.height; ++y) {
            float* height = maps_.height.at(block.x0, block.y0 + y);
            const std::size_t row = block.at(0, y);
            for (std::size_t x = 0; x < static_cast<std::size_t>(block.width); ++x)
                height[x] += block.groove[row + x] + block.lip[row + x];
        }
    }

    void store_directions(const BlockBuffers& block) const {
        for (int y = 0; y < block.height; ++y) {
            float* to = maps_.direction.at(block.x0, block.y0 + y);
            const std::size_t row = block.at(0, y), width = static_cast<std::size_t>(block.width);
            // From the left normal (x, y), y down: the tangent, y up, is (-y, -x). 1e-12: the
            // normal vanishes at the center of a stroke's circle, which the stroke may cover.
            for (std::size_t x = 0; x < width; ++x) {
                const float lx = block.line_x[row + x], ly = block.line_y[row + x];
                const float inverse = 1.0f / std::max(lx * lx + ly * ly, 1e-12f);
                to[2 * x] = (ly * ly - lx * lx) * inverse;
                to[2 * x + 1] = 2.0f * lx * ly * inverse;
            }
            for (std::size_t x = 0; x < width; ++x)
                if (!(block.score[row + x] > 0.0f))
                    store_ground(block.x0 + static_cast<int>(x), block.y0 + y);
        }
    }

    void store_ground(int x, int y) const {
        const DoubleAngle line =
            ground_.at({(x + 0.5) / settings_.size, (y + 0.5) / settings_.size});
        float* to = maps_.direction.at(x, y);
        to[0] = static_cast<float>(line.c);
        to[1] = static_cast<float>(line.s);
    }

    const ScratchSettings& settings_;
    ScratchMaps& maps_;
    GrainField ground_;
    std::vector<DrawnLayer> layers_;
};

void require_square(const Image& image, const char* name, int least_channels,
                    const char* channels) {
    if (image.empty()) return;
    const std::string size = fmt::format("{}x{}", image.width, image.height);
    if (image.width != image.height)
        throw UsageError(name, "size", "a square picture, which is stretched over the tile", size);
    if (image.channels < least_channels)
        throw UsageError(name, "channels", channels, std::to_string(image.channels));
    for (const float value : image.pixels)
        if (!std::isfinite(value)) throw UsageError(name, "", "numbers", "infinities or NaN");
}

}  // namespace

void check_scratch_inputs(const ScratchSettings& settings, const ScratchInputs& inputs) {
    check_scratch_settings(settings, "scratch settings");
    require_square(inputs.wear_mask, "wear mask", 1, "1 or more");
    require_square(inputs.direction, "direction image", 2,
                   "2 or more: red and green are the direction");
    const bool wanted =
        std::any_of(settings.layers.begin(), settings.layers.end(),
                    [](const ScratchLayer& l) { return l.field == ScratchField::image; });
    if (wanted && inputs.direction.empty())
        throw UsageError("scratch settings", "field image", "a direction image", "none");
    if (!wanted && !inputs.direction.empty())
        throw UsageError("scratch settings", "direction image",
                         "a layer with the field image, which would use it", "none");
}

std::uint64_t scratch_memory(const ScratchSettings& settings) {
    const double texels = static_cast<double>(settings.size) * settings.size;
    const double coarse = 1.0 / 3.0;  // size of all halved levels, relative to the full one
    double bytes = texels * (3 * sizeof(float) + coarse * sizeof(SlopeMoments));
    for (const ScratchLayer& layer : settings.layers) {
        const double length = layer.length_mm.typical() / settings.tile_mm * settings.size;
        // A stroke touches two or three blocks per half block of its length.
        const double uses = 4.0 + 3.0 * length / (0.5 * kBlock);
        bytes += scratch_count(settings, layer) *
                 (2 * sizeof(Stroke) + sizeof(TexelStroke) + uses * sizeof(StrokeUse));
    }
    constexpr double kRest = 16 << 20;  // buffers of the threads, images of a few megabytes
    return static_cast<std::uint64_t>(bytes + kRest);
}

ScratchMaps engrave(const ScratchSettings& settings, const ScratchInputs& inputs,
                    std::uint64_t memory_limit, const Progress& progress) {
    check_scratch_inputs(settings, inputs);
    const std::uint64_t needed = scratch_memory(settings);
    if (needed > memory_limit)
        throw Error("scratch map", fmt::format("size {}", settings.size),
                    fmt::format("{:.1f} MB of free memory", static_cast<double>(needed) / 1e6),
                    fmt::format("{:.1f} MB", static_cast<double>(memory_limit) / 1e6));
    progress.step("scratches", 0.0);
    ScratchMaps maps =
        engrave_strokes(settings, inputs, strokes_of_layers(settings, inputs), progress);
    progress.step("moments", 0.0);
    maps.moments = moment_levels(maps);
    progress.step("moments", 1.0);
    return maps;
}

ScratchMaps engrave_strokes(const ScratchSettings& settings, const ScratchInputs& inputs,
                            const std::vector<std::vector<Stroke>>& strokes,
                            const Progress& progress) {
    ScratchMaps maps;
    maps.size = settings.size;
    maps.tile_mm = settings.tile_mm;
    maps.height = image_on_large_pages(settings.size, settings.size, 1);
    maps.direction = image_on_large_pages(settings.size, settings.size, 2);
    const Engraver engraver(settings, inputs, strokes, maps);
    const std::size_t side = engraver.blocks_a_side(), blocks = side * side;
    // Cancellation takes effect between these steps only; 256 blocks are 4 million texels.
    constexpr std::size_t kStep = 256;
    for (std::size_t from = 0; from < blocks; from += kStep) {
        progress.step("engrave", static_cast<double>(from) / static_cast<double>(blocks));
        // Four blocks per task, so that they reuse the pages of one buffer.
        parallel_for(std::min(kStep, blocks - from), 4, [&](std::size_t begin, std::size_t end) {
            BlockBuffers block;
            for (std::size_t i = begin; i < end; ++i) engraver.engrave_block(from + i, block);
        });
    }
    return maps;
}

}  // namespace burnish
