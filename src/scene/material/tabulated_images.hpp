// A tabulated material as pictures, in the layout in which shaders read it
// (shaders/lib/tabulated.glsl, tabulated_texels.glsl). Exemplar i has the block (i % columns, i /
// columns) of three pictures:
//
//   tables  azimuths x rings: D of the cell, of the next azimuth, of the next ring, and of both
//   draws   azimuths x rings: cumulative share of the ring's draws including the cell, density of
//           draws of the cell
//   areas   kAreaGrid: g - z, four values as in the tables; below them the cumulative share of
//           draws including each ring, kAreaGrid.azimuths a row
//
// Every texel of the material has, in words of 16 bits,
//
//   texels  exemplar, angle of its groove (2 pi / 65536); x, y of the normal; cosine and sine of
//           the angle; cosine and sine of angle and groove together
//   colors  diffuse and specular, as half floats
//
// One fetch of four values serves an interpolation between four cells, because the cost of software
// renderers is per fetch. All functions are pure; thread-safe.
#pragma once

#include <cstdint>
#include <vector>

#include "burnish/tabulated_material.hpp"

namespace burnish {

// A picture of one block per exemplar.
struct TableBlocks {
    int columns = 1, width = 0, height = 0;  // blocks a row; texels of a block
    int values = 0;                          // floats a texel
    std::vector<float> texels;               // row by row over all blocks

    TableBlocks() = default;
    TableBlocks(int exemplars, int columns, int width, int height, int values);
    int total_width() const { return columns * width; }
    int total_height() const;
    float* at(int exemplar, int x, int y);
};

struct TabulatedImages {
    int columns = 1;    // of blocks
    int area_rows = 0;  // texels of a block of `areas`
    TableBlocks tables, areas;
    std::vector<std::uint32_t> texels, colors;  // 4 words per texel
};

// Throws Error when a picture would be more than `largest_side` texels wide or high.
TabulatedImages tabulated_images(const TabulatedMaterial& material, int largest_side);

// The picture `draws`, which only sampling an environment reads, in `columns` blocks a row.
TableBlocks tabulated_draw_blocks(const TabulatedMaterial& material, int columns);

}  // namespace burnish
