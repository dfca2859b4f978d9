// Layout of a tabulated material in the parts of its file (docs/reference/tabulated-file.md), for
// its reader and its writer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "burnish/ndf_grid.hpp"

namespace burnish {

inline constexpr int kTabulatedVersion = 1;
inline constexpr std::string_view kTabulatedVersionKey = "tabulated:version";
inline constexpr std::string_view kTabulatedMetadata = "metadata:";  // followed by the name

inline constexpr int kMostAtlasSide = 32768;
inline constexpr int kMostRings = 1024, kMostAzimuths = 4096;
inline constexpr int kMostExemplars = 65535;         // 0xffff is kNoExemplar
inline constexpr std::int64_t kMostCells = 1 << 26;  // of all tables: reading integrates each
inline constexpr double kMassTolerance = 0.02;       // tolerance of Int D (n.h) dw = 1
inline constexpr float kMostDistribution = 1e12F;    // of a lobe 0.1 arc seconds wide
inline constexpr float kMostColor = 65504.0F;        // largest half float

// Blocks of exemplars, row by row; within a block rings run downwards and azimuths to the right.
struct TabulatedAtlas {
    NdfGrid grid;
    int exemplars = 1, columns = 1;

    int rows() const;
    int width() const { return columns * grid.azimuths; }
    int height() const { return rows() * grid.rings; }
    std::size_t at(int exemplar, int ring, int azimuth) const;  // index into a picture's values
};

// Throws Error when all tables together have more than kMostCells cells. The sizes must be within
// bounds.
void check_cells(const std::string& file, const NdfGrid& grid, int exemplars);

// Returns an atlas with no side above kMostAtlasSide if there is one. Otherwise a side is larger,
// which the caller checks.
TabulatedAtlas tabulated_atlas(const NdfGrid& grid, int exemplars);

}  // namespace burnish
