#include "scene/material/tabulated_images.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <numbers>
#include <string>

#include "burnish/error.hpp"
#include "core/index_of.hpp"
#include "scene/material/tabulated_draws.hpp"

namespace burnish {
namespace {

int rows_of_areas(const NdfGrid& grid) {
    return kAreaGrid.rings + (grid.rings + kAreaGrid.azimuths - 1) / kAreaGrid.azimuths;
}

// Number of columns for a nearly square arrangement of blocks, within the largest side of the
// device.
int columns_for(const TabulatedMaterial& m, int side) {
    const int widest = std::max(m.grid.azimuths, kAreaGrid.azimuths);
    const int highest = std::max(m.grid.rings, rows_of_areas(m.grid));
    const int most = side / widest, rows = side / highest;
    if (most < 1 || rows < 1 || (m.exemplars + most - 1) / most > rows) {
        throw Error("tabulated material", "exemplars",
                    "at most " + std::to_string(most * rows) + " of " +
                        std::to_string(m.grid.azimuths) + " x " + std::to_string(m.grid.rings) +
                        " on this device",
                    std::to_string(m.exemplars));
    }
    const int least = (m.exemplars + rows - 1) / rows;
    const int wished =
        static_cast<int>(std::ceil(std::sqrt(static_cast<double>(m.exemplars) * highest / widest)));
    return std::clamp(std::max(wished, least), 1, most);
}

std::uint32_t code_of_angle(float angle) {
    constexpr double kTurn = 2 * std::numbers::pi;
    const double turns = static_cast<double>(angle) / kTurn;
    return static_cast<std::uint32_t>(std::lround((turns - std::floor(turns)) * 65536)) & 0xffffU;
}

std::uint32_t code_of_slope(float v) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(v, -1.0F, 1.0F) * 32767.0F) + 32768);
}

std::uint32_t code_of_pair(float x, float y) {
    return code_of_slope(x) | code_of_slope(y) << 16;
}

std::uint32_t code_of_direction(float angle) {
    return code_of_pair(std::cos(angle), std::sin(angle));
}

std::vector<std::uint32_t> texels_of(const TabulatedMaterial& m) {
    std::vector<std::uint32_t> words;
    words.reserve(4 * m.texels());
    for (std::size_t i = 0; i < m.texels(); ++i) {
        const float* n = m.normal.pixels.data() + 3 * i;
        const bool measured = m.exemplar[i] != TabulatedMaterial::kNoExemplar;
        const float groove = measured ? m.groove[m.exemplar[i]] : 0.0F;
        words.push_back(m.exemplar[i] | code_of_angle(groove) << 16);
        words.push_back(code_of_pair(n[0], n[1]));
        words.push_back(code_of_direction(m.angle[i]));
        words.push_back(code_of_direction(m.angle[i] + groove));
    }
    return words;
}

std::uint32_t half_of(float v) {
    return glm::packHalf1x16(std::clamp(v, 0.0F, 65504.0F));
}

std::vector<std::uint32_t> colors_of(const TabulatedMaterial& m) {
    std::vector<std::uint32_t> words;
    words.reserve(4 * m.texels());
    for (std::size_t i = 0; i < m.texels(); ++i) {
        const float* d = m.diffuse.pixels.data() + 3 * i;
        const float* s = m.specular.pixels.data() + 3 * i;
        words.push_back(half_of(d[0]) | half_of(d[1]) << 16);
        words.push_back(half_of(d[2]) | half_of(s[0]) << 16);
        words.push_back(half_of(s[1]) | half_of(s[2]) << 16);
        words.push_back(0);
    }
    return words;
}

// Stores each value with the three that it is interpolated with: next column, next ring, and both.
void put_fours(TableBlocks& blocks, int exemplar, const NdfGrid& grid, const float* table) {
    for (int r = 0; r < grid.rings; ++r) {
        const float* low = table + r * grid.azimuths;
        const float* high = table + std::min(r + 1, grid.rings - 1) * grid.azimuths;
        for (int a = 0; a < grid.azimuths; ++a) {
            const int next = (a + 1) % grid.azimuths;
            float* to = blocks.at(exemplar, a, r);
            to[0] = low[a];
            to[1] = low[next];
            to[2] = high[a];
            to[3] = high[next];
        }
    }
}

}  // namespace

TableBlocks::TableBlocks(int exemplars, int columns_, int width_, int height_, int values_)
    : columns(columns_), width(width_), height(height_), values(values_) {
    texels.resize(index_of(total_width()) * index_of((exemplars + columns - 1) / columns * height) *
                  index_of(values));
}

int TableBlocks::total_height() const {
    return static_cast<int>(texels.size() / index_of(values) / index_of(total_width()));
}

float* TableBlocks::at(int exemplar, int x, int y) {
    const std::size_t row = index_of(exemplar / columns * height + y);
    const std::size_t column = index_of(exemplar % columns * width + x);
    return texels.data() + (row * index_of(total_width()) + column) * index_of(values);
}

TabulatedImages tabulated_images(const TabulatedMaterial& m, int largest_side) {
    if (m.width > largest_side || m.height > largest_side) {
        throw Error("tabulated material", "texels",
                    "at most " + std::to_string(largest_side) + " a side on this device",
                    std::to_string(m.width) + " x " + std::to_string(m.height));
    }
    TabulatedImages images;
    images.columns = columns_for(m, largest_side);
    images.area_rows = rows_of_areas(m.grid);
    images.tables = TableBlocks(m.exemplars, images.columns, m.grid.azimuths, m.grid.rings, 4);
    images.areas =
        TableBlocks(m.exemplars, images.columns, kAreaGrid.azimuths, images.area_rows, 4);
    for (int e = 0; e < m.exemplars; ++e) {
        put_fours(images.tables, e, m.grid, m.table(e));
        put_fours(images.areas, e, kAreaGrid, ndf_areas(m.grid, m.table(e)).data());
        const TabulatedDraws draws = tabulated_draws(m.grid, m.table(e));
        for (int r = 0; r < m.grid.rings; ++r) {
            *images.areas.at(e, r % kAreaGrid.azimuths, kAreaGrid.rings + r / kAreaGrid.azimuths) =
                draws.rings[index_of(r)];
        }
    }
    images.texels = texels_of(m);
    images.colors = colors_of(m);
    return images;
}

TableBlocks tabulated_draw_blocks(const TabulatedMaterial& m, int columns) {
    TableBlocks blocks(m.exemplars, columns, m.grid.azimuths, m.grid.rings, 2);
    for (int e = 0; e < m.exemplars; ++e) {
        const TabulatedDraws draws = tabulated_draws(m.grid, m.table(e));
        for (int r = 0; r < m.grid.rings; ++r) {
            for (int a = 0; a < m.grid.azimuths; ++a) {
                float* to = blocks.at(e, a, r);
                to[0] = draws.cells[index_of(r * m.grid.azimuths + a)];
                to[1] = draws.density[index_of(r * m.grid.azimuths + a)];
            }
        }
    }
    return blocks;
}

}  // namespace burnish
