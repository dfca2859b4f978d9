// Functions that the reader and the writer of tabulated materials share.
#include "formats/tabulated/tabulated_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "burnish/error.hpp"
#include "burnish/tabulated_file.hpp"
#include "image/image_parts.hpp"

namespace burnish {

int TabulatedAtlas::rows() const {
    return (exemplars + columns - 1) / columns;
}

std::size_t TabulatedAtlas::at(int exemplar, int ring, int azimuth) const {
    const int row = exemplar / columns * grid.rings + ring;
    const int column = exemplar % columns * grid.azimuths + azimuth;
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width()) +
           static_cast<std::size_t>(column);
}

TabulatedAtlas tabulated_atlas(const NdfGrid& grid, int exemplars) {
    // A nearly square atlas, which viewers show as a whole.
    const double aspect = static_cast<double>(grid.rings) / grid.azimuths;
    const int wished = static_cast<int>(std::ceil(std::sqrt(exemplars * aspect)));
    const int most = std::max(kMostAtlasSide / grid.azimuths, 1);
    const int least = (exemplars * grid.rings + kMostAtlasSide - 1) / kMostAtlasSide;
    return {grid, exemplars, std::clamp(std::max(wished, least), 1, std::min(most, exemplars))};
}

void check_cells(const std::string& file, const NdfGrid& grid, int exemplars) {
    const std::int64_t cells = std::int64_t{exemplars} * grid.cells();
    if (cells <= kMostCells) return;
    throw Error(file, "exemplars", fmt::format("at most {} cells in all", kMostCells),
                fmt::format("{} of {} x {}", exemplars, grid.azimuths, grid.rings));
}

bool is_tabulated_material(const std::filesystem::path& path) {
    return has_image_part_attribute(path, kTabulatedVersionKey);
}

}  // namespace burnish
