// Scratch maps (K11 section 2.4): hemispherical pits stretched into strokes, engraved on a tile.
//
// Everything derives from one height field in millimetres: slopes are its differences over the
// repeating tile, normals and moments are made of those slopes. Maps have row 0 at the top;
// x runs right and y UP the picture, as glTF's tangent space has it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/image.hpp"
#include "burnish/progress.hpp"
#include "burnish/scratch_settings.hpp"

namespace BURNISH_API burnish {

// Pictures that go with settings; empty when there is none.
struct ScratchInputs {
    // 1 channel, 0 unworn .. 1 worn: the share of scratches that are there. Square, any size,
    // stretched over the tile.
    Image wear_mask = {};
    // 2 or more channels: red and green hold an arrow, (1 + d) / 2 with y up, of which only the
    // line counts; grey (0.5, 0.5) has no direction and lets scratches run anywhere. Square.
    Image direction = {};
    bool direction_is_double_angle = false;  // red and green hold cos 2a and sin 2a instead
};

// Slopes and their second moments: the mean over a texel and everything under it.
struct SlopeMoments {
    float sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
};

struct MomentLevel {
    int size = 0;
    std::vector<SlopeMoments> texels;  // size x size, row 0 at the top
};

struct ScratchMaps {
    int size = 0;
    double tile_mm = 0.0;
    Image height;  // 1 channel, millimetres; 0 the untouched surface, grooves below
    // 2 channels, (cos 2a, sin 2a), a the direction of the GROOVE, counter-clockwise from +x with
    // y up: of the deepest scratch at this texel, elsewhere of the first layer's field; (0, 0)
    // where there is neither. A line field: only in double angle may it be filtered.
    Image direction;
    // Halved levels, 1 the finest (level 0 follows from the heights: slope_moments), down to 1x1.
    std::vector<MomentLevel> moments;
};

// Bytes that engrave needs at its peak, output included.
std::uint64_t scratch_memory(const ScratchSettings& settings);

// Makes the maps. The same settings, inputs and size give the same bytes on any number of threads.
// Throws UsageError for settings and inputs that cannot be (`where` names them), and Error with the
// figure when more than `memory_limit` bytes would be needed.
ScratchMaps engrave(const ScratchSettings& settings, const ScratchInputs& inputs,
                    std::uint64_t memory_limit, const Progress& progress = {});

// Slope of the height along +x and +y (up); the tile repeats. Central differences over two texels,
// weighted 3 10 3 across (H. Scharr, "Optimale Operatoren in der Digitalen Bildverarbeitung",
// 2000): plain ones turn the slope of a groove four texels wide by up to 7 degrees towards the
// diagonal.
std::array<float, 2> slope_at(const ScratchMaps& maps, int x, int y);
SlopeMoments slope_moments(const ScratchMaps& maps, int x, int y);

// Rows [begin, end) of the pictures that are made of these maps, `to` is packed.
void normal_rows(const ScratchMaps& maps, int begin, int end, float* to);  // RGB, (1 + n) / 2
void moment_rows(const ScratchMaps& maps, int begin, int end, float* to);  // 5 channels
// RGB of KHR_materials_anisotropy: RG the direction of STRETCH, across the groove, (1 + d) / 2 with
// y up; B 1 where there is a direction, else 0. Of the two arrows of a line the one nearer to
// that of the field of `ground`, the first layer, is stored (of circular and radial fields the one
// that points away from the middle of the tile): neighbours agree as far as arrows can.
void stretch_rows(const ScratchMaps& maps, const ScratchLayer& ground, int begin, int end,
                  float* to);

Image normal_map(const ScratchMaps& maps);

}  // namespace burnish
