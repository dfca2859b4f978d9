#include "formats/bsdf/bilinear_warp.hpp"

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

struct Place {
    std::size_t low = 0, high = 0;
    double part = 0;  // position between low and high, 0 to 1
};

Place place_in(const std::vector<double>& values, double value) {
    if (values.size() < 2) return {};
    const auto above = std::upper_bound(values.begin(), values.end(), value);
    const auto index = std::clamp<std::ptrdiff_t>(above - values.begin() - 1, 0,
                                                  static_cast<std::ptrdiff_t>(values.size()) - 2);
    const auto low = static_cast<std::size_t>(index);
    const double part = (value - values[low]) / (values[low + 1] - values[low]);
    return {low, low + 1, std::clamp(part, 0.0, 1.0)};
}

double between(double a, double b, double t) {
    return (1 - t) * a + t * b;
}

// t in [0, 1] with a t + (b - a) t^2 / 2 = area: the width at which a trapezoid with sides a, b >=
// 0 is filled to `area`. In this form of the root nothing cancels and a = b needs no special case.
double filled(double a, double b, double area) {
    const double root = std::sqrt(std::max(a * a + 2 * area * (b - a), 0.0));
    const double below = a + root;
    return below > 0 ? std::clamp(2 * area / below, 0.0, 1.0) : 0.0;
}

// The last i in [0, count - 2] with part(i) <= value, for non-decreasing parts.
template <typename Part>
std::size_t last_below(std::size_t count, double value, const Part& part) {
    std::size_t low = 0, high = count - 1;
    while (high - low > 1) {
        const std::size_t middle = (low + high) / 2;
        (part(middle) <= value ? low : high) = middle;
    }
    return low;
}

}  // namespace

SliceMix SliceGrid::at(double phi, double theta) const {
    const Place p = place_in(phi_, phi), t = place_in(theta_, theta);
    const std::size_t n = theta_.size();
    return {{p.low * n + t.low, p.low * n + t.high, p.high * n + t.low, p.high * n + t.high},
            {(1 - p.part) * (1 - t.part), (1 - p.part) * t.part, p.part * (1 - t.part),
             p.part * t.part}};
}

// ---- BilinearTable ------------------------------------------------------------------------------

BilinearTable::BilinearTable(std::vector<float> values, std::size_t columns, std::size_t rows)
    : values_(std::move(values)), columns_(columns), rows_(rows) {}

double BilinearTable::value(std::size_t slice, double x, double y) const {
    const double cx = std::clamp(x, 0.0, 1.0) * static_cast<double>(columns_ - 1);
    const double cy = std::clamp(y, 0.0, 1.0) * static_cast<double>(rows_ - 1);
    const std::size_t column = std::min(static_cast<std::size_t>(cx), columns_ - 2);
    const std::size_t row = std::min(static_cast<std::size_t>(cy), rows_ - 2);
    const double tx = cx - static_cast<double>(column), ty = cy - static_cast<double>(row);
    const float* p = values_.data() + (slice * rows_ + row) * columns_ + column;
    return between(between(p[0], p[1], tx), between(p[columns_], p[columns_ + 1], tx), ty);
}

double BilinearTable::value(const SliceMix& mix, double x, double y) const {
    double sum = 0;
    for (std::size_t i = 0; i < mix.slice.size(); ++i)
        if (mix.weight[i] > 0) sum += mix.weight[i] * value(mix.slice[i], x, y);
    return sum;
}

// ---- BilinearWarp -------------------------------------------------------------------------------

// A cell of the grid and a position in it.
struct BilinearWarp::Cell {
    std::size_t column, row;
    double tx, ty;
};

BilinearWarp::BilinearWarp(std::span<const float> values, std::size_t columns, std::size_t rows)
    : columns_(columns), rows_(rows), values_(values.begin(), values.end()) {
    const std::size_t slices = values.size() / (columns * rows);
    along_.resize(values.size());
    marginal_.resize(slices * rows);
    for (std::size_t slice = 0; slice < slices; ++slice) integrate_slice(slice);
}

void BilinearWarp::integrate_slice(std::size_t slice) {
    const std::span values(values_.data() + slice * rows_ * columns_, rows_ * columns_);
    const std::span along(along_.data() + slice * rows_ * columns_, rows_ * columns_);
    const std::span marginal(marginal_.data() + slice * rows_, rows_);
    for (std::size_t row = 0; row < rows_; ++row) {
        const std::size_t first = row * columns_;
        for (std::size_t i = first + 1; i < first + columns_; ++i)
            along[i] = along[i - 1] + 0.5 * (values[i - 1] + values[i]);
    }
    for (std::size_t row = 1; row < rows_; ++row) {
        const double below = along[row * columns_ - 1], here = along[(row + 1) * columns_ - 1];
        marginal[row] = marginal[row - 1] + 0.5 * (below + here);
    }
    const double total = marginal.back();
    for (double& value : values) value /= total;
    for (double& value : along) value /= total;
    for (double& value : marginal) value /= total;
}

double BilinearWarp::mixed(const std::vector<double>& table, std::size_t stride,
                           const SliceMix& mix, std::size_t index) const {
    double sum = 0;
    for (std::size_t i = 0; i < mix.slice.size(); ++i)
        if (mix.weight[i] > 0) sum += mix.weight[i] * table[mix.slice[i] * stride + index];
    return sum;
}

double BilinearWarp::value_at(const SliceMix& mix, std::size_t index) const {
    return mixed(values_, rows_ * columns_, mix, index);
}

double BilinearWarp::row_part(const SliceMix& mix, std::size_t row, std::size_t column) const {
    return mixed(along_, rows_ * columns_, mix, row * columns_ + column);
}

double BilinearWarp::row_total(const SliceMix& mix, std::size_t row) const {
    return row_part(mix, row, columns_ - 1);
}

double BilinearWarp::marginal(const SliceMix& mix, std::size_t row) const {
    return mixed(marginal_, rows_, mix, row);
}

BilinearWarp::Cell BilinearWarp::cell_at(double x, double y) const {
    const double cx = std::clamp(x, 0.0, 1.0) * static_cast<double>(columns_ - 1);
    const double cy = std::clamp(y, 0.0, 1.0) * static_cast<double>(rows_ - 1);
    const std::size_t column = std::min(static_cast<std::size_t>(cx), columns_ - 2);
    const std::size_t row = std::min(static_cast<std::size_t>(cy), rows_ - 2);
    return {column, row, cx - static_cast<double>(column), cy - static_cast<double>(row)};
}

double BilinearWarp::density(const SliceMix& mix, double x, double y) const {
    const Cell cell = cell_at(x, y);
    const std::size_t i = cell.row * columns_ + cell.column;
    const double left = between(value_at(mix, i), value_at(mix, i + columns_), cell.ty);
    const double right = between(value_at(mix, i + 1), value_at(mix, i + columns_ + 1), cell.ty);
    return between(left, right, cell.tx) * static_cast<double>((columns_ - 1) * (rows_ - 1));
}

Warped BilinearWarp::sample(const SliceMix& mix, double u, double v) const {
    // Below 1, so that the last strip of area is reachable.
    const double most = 1 - 0x1p-53;
    u = std::clamp(u, 0.0, most);
    v = std::clamp(v, 0.0, most);
    // The row: the marginal density is linear between rows.
    const std::size_t row = last_below(rows_, v, [&](std::size_t i) { return marginal(mix, i); });
    const double r0 = row_total(mix, row), r1 = row_total(mix, row + 1);
    // Keeps ty away from the ends of the row by less than doubles in the unit square resolve. A row
    // without density determines no column; the adjacent row does.
    constexpr double kInside = 1e-14;
    const double ty = std::clamp(filled(r0, r1, v - marginal(mix, row)), kInside, 1 - kInside);
    // The column, in the interpolated row between two rows of the table.
    const auto part = [&](std::size_t column) {
        return between(row_part(mix, row, column), row_part(mix, row + 1, column), ty);
    };
    const double area = u * between(r0, r1, ty);
    const std::size_t column = last_below(columns_, area, part);
    const std::size_t i = row * columns_ + column;
    const double c0 = between(value_at(mix, i), value_at(mix, i + columns_), ty);
    const double c1 = between(value_at(mix, i + 1), value_at(mix, i + columns_ + 1), ty);
    const double tx = filled(c0, c1, area - part(column));
    return {(static_cast<double>(column) + tx) / static_cast<double>(columns_ - 1),
            (static_cast<double>(row) + ty) / static_cast<double>(rows_ - 1),
            between(c0, c1, tx) * static_cast<double>((columns_ - 1) * (rows_ - 1))};
}

Warped BilinearWarp::invert(const SliceMix& mix, double x, double y) const {
    const Cell cell = cell_at(x, y);
    const std::size_t i = cell.row * columns_ + cell.column;
    const double c0 = between(value_at(mix, i), value_at(mix, i + columns_), cell.ty);
    const double c1 = between(value_at(mix, i + 1), value_at(mix, i + columns_ + 1), cell.ty);
    const double before = between(row_part(mix, cell.row, cell.column),
                                  row_part(mix, cell.row + 1, cell.column), cell.ty);
    const double r0 = row_total(mix, cell.row), r1 = row_total(mix, cell.row + 1);
    const double total = between(r0, r1, cell.ty);
    // No sample reaches a row without density, so any u serves.
    const double u =
        total > 0 ? (before + cell.tx * (c0 + 0.5 * cell.tx * (c1 - c0))) / total : 0.5;
    const double v = marginal(mix, cell.row) + cell.ty * (r0 + 0.5 * cell.ty * (r1 - r0));
    return {std::clamp(u, 0.0, 1.0), std::clamp(v, 0.0, 1.0),
            between(c0, c1, cell.tx) * static_cast<double>((columns_ - 1) * (rows_ - 1))};
}

}  // namespace burnish
