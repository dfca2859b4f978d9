#include "viewer/inspect/table_lobe.hpp"

#include <algorithm>
#include <utility>

#include "burnish/ndf_grid.hpp"
#include "core/constants.hpp"
#include "core/index_of.hpp"

namespace burnish::viewer {
namespace {

double interpolated(const float* values, const NdfGrid& grid, double row, double turns) {
    const f64::TablePlace place = f64::table_place(grid.azimuths, grid.rings, row, turns);
    const auto at = [&](int r, int column) {
        return static_cast<double>(
            values[index_of(r) * index_of(grid.azimuths) + index_of(column % grid.azimuths)]);
    };
    return f64::table_value(place, at(place.row, place.column), at(place.row, place.column + 1),
                            at(place.row + 1, place.column), at(place.row + 1, place.column + 1));
}

// The first place of `shares` (cumulative) above xi, and the share before it.
int place_of_share(const float* shares, int count, double xi, double& before) {
    const float* above = std::upper_bound(shares, shares + count, static_cast<float>(xi));
    const int place = std::min(static_cast<int>(above - shares), count - 1);
    before = place > 0 ? static_cast<double>(shares[place - 1]) : 0.0;
    return place;
}

}  // namespace

TableLobe::TableLobe(std::shared_ptr<const TabulatedMaterial> material, int exemplar,
                     std::shared_ptr<TableIntegrals> integrals)
    : material_(std::move(material)), integrals_(std::move(integrals)), exemplar_(exemplar) {
    const float* D = material_->table(exemplar_);
    highest_cell_ = static_cast<int>(std::max_element(D, D + material_->grid.cells()) - D);
}

double TableLobe::D(const f64::LobePoint& at, double turns) const {
    const NdfGrid& grid = material_->grid;
    const f64::LobePoint q = f64::lobe_point_unit(at);
    return q.weight * interpolated(material_->table(exemplar_), grid,
                                   f64::tabulated_row(q, grid.rings),
                                   f64::tabulated_turns(q.x, q.y) + turns);
}

NdfOrigin TableLobe::origin(const f64::LobePoint& q, double turns) const {
    const NdfGrid& grid = material_->grid;
    const f64::TableDraw cell = f64::tabulated_cell(q, grid.azimuths, grid.rings, turns);
    return material_->origin[index_of(exemplar_) * index_of(grid.cells()) +
                             index_of(cell.ring * grid.azimuths + cell.column)];
}

f64::vec3 TableLobe::highest(double turns) const {
    const NdfGrid& grid = material_->grid;
    const auto theta = static_cast<double>(grid.theta(highest_cell_ / grid.azimuths));
    const double azimuth = static_cast<double>(highest_cell_ % grid.azimuths) / grid.azimuths;
    const double phi = kTwoPi * (azimuth - turns);
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double TableLobe::area(f64::vec3 w, double turns) const {
    std::call_once(integrals_->areas_made, [&] {
        integrals_->areas = ndf_areas(material_->grid, material_->table(exemplar_));
    });
    const double more = interpolated(integrals_->areas.data(), kAreaGrid,
                                     f64::tabulated_area_row(w, kAreaGrid.rings),
                                     f64::tabulated_turns(w.x, w.y) + turns);
    return f64::tabulated_area(more, w);
}

const TabulatedDraws& TableLobe::draws() const {
    std::call_once(integrals_->draws_made, [&] {
        integrals_->draws = tabulated_draws(material_->grid, material_->table(exemplar_));
    });
    return integrals_->draws;
}

f64::vec3 TableLobe::sample(f64::vec2 xi, double turns) const {
    const NdfGrid& grid = material_->grid;
    const TabulatedDraws& d = draws();
    f64::TableDraw draw;
    double before = 0;
    draw.ring = place_of_share(d.rings.data(), grid.rings, xi.y, before);
    draw.along =
        f64::table_draw_part(xi.y, before, static_cast<double>(d.rings[index_of(draw.ring)]));
    const float* columns = d.cells.data() + index_of(draw.ring) * index_of(grid.azimuths);
    draw.column = place_of_share(columns, grid.azimuths, xi.x, before);
    draw.across = f64::table_draw_part(xi.x, before, static_cast<double>(columns[draw.column]));
    return f64::tabulated_half_vector(draw, grid.azimuths, grid.rings, turns);
}

double TableLobe::density(const f64::LobePoint& q, double turns) const {
    const NdfGrid& grid = material_->grid;
    const f64::TableDraw cell = f64::tabulated_cell(q, grid.azimuths, grid.rings, turns);
    return q.weight *
           static_cast<double>(draws().density[index_of(cell.ring * grid.azimuths + cell.column)]);
}

namespace {

struct KnownTable {
    std::weak_ptr<const TabulatedMaterial> material;
    int exemplar = 0;
    std::shared_ptr<TableIntegrals> integrals;
};
constexpr std::size_t kMostKnownTables = 256;

std::shared_ptr<TableIntegrals> integrals_of(
    const std::shared_ptr<const TabulatedMaterial>& material, int exemplar) {
    static std::mutex guard;
    static std::vector<KnownTable> known;  // the latest at the end
    const std::lock_guard lock(guard);
    std::erase_if(known, [](const KnownTable& table) { return table.material.expired(); });
    const auto found = std::find_if(known.begin(), known.end(), [&](const KnownTable& table) {
        return table.exemplar == exemplar && table.material.lock() == material;
    });
    if (found != known.end()) return found->integrals;
    if (known.size() >= kMostKnownTables) known.erase(known.begin());
    known.push_back({material, exemplar, std::make_shared<TableIntegrals>()});
    return known.back().integrals;
}

}  // namespace

std::shared_ptr<const TableLobe> table_lobe(
    const std::shared_ptr<const TabulatedMaterial>& material, int exemplar) {
    return std::make_shared<const TableLobe>(material, exemplar, integrals_of(material, exemplar));
}

}  // namespace burnish::viewer
