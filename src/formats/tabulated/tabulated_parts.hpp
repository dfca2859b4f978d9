// How a tabulated material lies in the parts of its file (docs/reference/tabulated-file.md): what its
// reader and its writer share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "burnish/ndf_grid.hpp"

namespace burnish {

inline constexpr int kTabulatedVersion = 1;
inline constexpr std::string_view kTabulatedVersionKey = "tabulated:version";
inline constexpr std::string_view kTabulatedMetadata = "metadata:";  // and the name

inline constexpr int kMostAtlasSide = 32768;
inline constexpr int kMostRings = 1024, kMostAzimuths = 4096;
inline constexpr int kMostExemplars = 65535;         // 0xffff is kNoExemplar
inline constexpr std::int64_t kMostCells = 1 << 26;  // of all tables: each is integrated
inline constexpr double kMassTolerance = 0.02;       // of Int D (n.h) dw = 1
inline constexpr float kMostDistribution = 1e12F;    // of a lobe a tenth of a second of arc wide
inline constexpr float kMostColor = 65504.0F;        // of half floats

// Exemplars beside one another, row by row; of each, rings downwards and azimuths to the right.
struct TabulatedAtlas {
    NdfGrid grid;
    int exemplars = 1, columns = 1;

    int rows() const;
    int width() const { return columns * grid.azimuths; }
    int height() const { return rows() * grid.rings; }
    std::size_t at(int exemplar, int ring, int azimuth) const;  // of a picture's values
};

// Throws Error where the tables together are more than kMostCells. The sizes are within bounds.
void check_cells(const std::string& file, const NdfGrid& grid, int exemplars);

// One that no side of which passes kMostAtlasSide when there is one; else the caller's check sees
// it.
TabulatedAtlas tabulated_atlas(const NdfGrid& grid, int exemplars);

}  // namespace burnish
