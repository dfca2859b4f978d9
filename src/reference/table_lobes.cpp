#include "reference/table_lobes.hpp"

#include <algorithm>
#include <span>

#include "core/index_of.hpp"

namespace burnish {
namespace {

float value_at(const NdfGrid& grid, const float* values, const f32::TablePlace& place) {
    const int next = (place.column + 1) % grid.azimuths;
    const float* low = values + place.row * grid.azimuths;
    const float* high = low + grid.azimuths;
    return f32::table_value(place, low[place.column], low[next], high[place.column], high[next]);
}

// The first of the cumulative shares above xi, and how far xi lies into its part.
int part_of(std::span<const float> shares, float xi, float& along) {
    const auto found = std::upper_bound(shares.begin(), shares.end() - 1, xi);
    const auto i = static_cast<std::size_t>(found - shares.begin());
    along = f32::table_draw_part(xi, i > 0 ? shares[i - 1] : 0.0f, shares[i]);
    return static_cast<int>(i);
}

}  // namespace

TableLobe::TableLobe(const TabulatedMaterial& material, int exemplar)
    : grid_(material.grid),
      table_(material.table(exemplar)),
      areas_(ndf_areas(material.grid, material.table(exemplar))),
      draws_(tabulated_draws(material.grid, material.table(exemplar))) {}

float TableLobe::D(const f32::LobePoint& q, float groove) const {
    const f32::TablePlace place =
        f32::table_place(grid_.azimuths, grid_.rings, f32::tabulated_row(q, grid_.rings),
                         f32::tabulated_turns(q.x, q.y) + groove);
    return q.weight * value_at(grid_, table_, place);
}

float TableLobe::area(const f32::vec3& w, float groove) const {
    const f32::TablePlace place = f32::table_place(kAreaGrid.azimuths, kAreaGrid.rings,
                                                   f32::tabulated_area_row(w, kAreaGrid.rings),
                                                   f32::tabulated_turns(w.x, w.y) + groove);
    return f32::tabulated_area(value_at(kAreaGrid, areas_.data(), place), w);
}

float TableLobe::density(const f32::LobePoint& q, float groove) const {
    const f32::TableDraw cell = f32::tabulated_cell(q, grid_.azimuths, grid_.rings, groove);
    return q.weight * draws_.density[index_of(cell.ring * grid_.azimuths + cell.column)];
}

f32::vec3 TableLobe::sample(const f32::vec2& xi, float groove) const {
    f32::TableDraw draw{};
    draw.ring = part_of(draws_.rings, xi.y, draw.along);
    const std::span<const float> cells(draws_.cells);
    draw.column =
        part_of(cells.subspan(index_of(draw.ring * grid_.azimuths), index_of(grid_.azimuths)), xi.x,
                draw.across);
    return f32::tabulated_half_vector(draw, grid_.azimuths, grid_.rings, groove);
}

}  // namespace burnish
