// Densities on the unit square, bilinear between the nodes of a grid. They are tabulated for
// several values of two outer parameters, and linear between those. A density can be evaluated,
// sampled and inverted. The warp takes the second coordinate from the marginal distribution over
// rows, then the first from the conditional distribution along the row. Dupuy & Jakob, "An Adaptive
// Parameterization for Efficient Material Acquisition and Rendering", ACM TOG 37(6), 2018, section
// 3. Every step has a closed form.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace burnish {

// The slices around one value of both parameters, with weights that add up to 1. A slice may occur
// twice, or with weight 0.
struct SliceMix {
    std::array<std::size_t, 4> slice{};
    std::array<double, 4> weight{1, 0, 0, 0};
};

// The positions of the slices: index = i_phi * thetas + i_theta. Both lists increase strictly (one
// value: no dependence on that parameter). Values outside are clamped.
class SliceGrid {
  public:
    SliceGrid() = default;
    SliceGrid(std::vector<double> phi, std::vector<double> theta)
        : phi_(std::move(phi)), theta_(std::move(theta)) {}

    SliceMix at(double phi, double theta) const;
    std::size_t size() const { return phi_.size() * theta_.size(); }
    std::span<const double> phi() const { return phi_; }
    std::span<const double> theta() const { return theta_; }

  private:
    std::vector<double> phi_{0.0}, theta_{0.0};
};

// Numbers at the nodes of a grid, `columns` >= 2 along x and `rows` >= 2 along y, x contiguous;
// slices one after the other. Plain interpolation, not a density.
class BilinearTable {
  public:
    BilinearTable() = default;
    BilinearTable(std::vector<float> values, std::size_t columns, std::size_t rows);

    // x, y in [0, 1]; clamped.
    double value(const SliceMix& mix, double x, double y) const;
    double value(std::size_t slice, double x, double y) const;
    std::size_t columns() const { return columns_; }
    std::size_t rows() const { return rows_; }

  private:
    std::vector<float> values_;
    std::size_t columns_ = 0, rows_ = 0;
};

struct Warped {
    double x = 0, y = 0;
    double density = 0;  // per unit of the square's area
};

class BilinearWarp {
  public:
    BilinearWarp() = default;
    // `values` as for BilinearTable, all >= 0, at least one > 0 in each slice. Each slice is scaled
    // to an integral of 1.
    BilinearWarp(std::span<const float> values, std::size_t columns, std::size_t rows);

    double density(const SliceMix& mix, double x, double y) const;
    // Maps (u, v), uniform in the square, to a point with the density, and back. `invert` returns
    // (u, v) in x, y and the density at the given point.
    Warped sample(const SliceMix& mix, double u, double v) const;
    Warped invert(const SliceMix& mix, double x, double y) const;

  private:
    struct Cell;
    double mixed(const std::vector<double>& table, std::size_t stride, const SliceMix& mix,
                 std::size_t index) const;
    double value_at(const SliceMix& mix, std::size_t index) const;
    double row_part(const SliceMix& mix, std::size_t row, std::size_t column) const;
    double marginal(const SliceMix& mix, std::size_t row) const;
    double row_total(const SliceMix& mix, std::size_t row) const;
    Cell cell_at(double x, double y) const;
    void integrate_slice(std::size_t slice);

    std::size_t columns_ = 0, rows_ = 0;
    // Integrals in units of a cell: their product with the number of cells is a density per unit
    // area.
    std::vector<double> values_;    // slice, row, column
    std::vector<double> along_;     // integral of a row up to a column: slice, row, column
    std::vector<double> marginal_;  // integral of the slice up to a row: slice, row
};

}  // namespace burnish
