#include "scene/material/tabulated_draws.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/index_of.hpp"

namespace burnish {
namespace {

// Fraction of the draws that is uniform over the projected hemisphere. It bounds the weights where
// the table is 0 and a method evaluates it at another direction.
constexpr double kEven = 0.02;

// The mean over a cell and its eight neighbors.
double blurred(const NdfGrid& grid, const float* table, int ring, int column) {
    double sum = 0;
    for (int y = -1; y <= 1; ++y) {
        const int r = std::clamp(ring + y, 0, grid.rings - 1);
        for (int x = -1; x <= 1; ++x) {
            const int a = (column + x + grid.azimuths) % grid.azimuths;
            sum += static_cast<double>(table[index_of(r) * index_of(grid.azimuths) + index_of(a)]);
        }
    }
    return sum / 9;
}

}  // namespace

TabulatedDraws tabulated_draws(const NdfGrid& grid, const float* table) {
    TabulatedDraws draws;
    double total = 0;
    std::vector<double> rings, weights;
    for (int r = 0; r < grid.rings; ++r) {
        // The cosine at the cell's center, because draws are uniform within a cell.
        const double cosine = std::max(std::cos(static_cast<double>(grid.theta(r))), 1e-4);
        const double angle = grid.solid_angle(r);
        double ring = 0;
        for (int a = 0; a < grid.azimuths; ++a) {
            const double D = blurred(grid, table, r, a) + kEven / std::numbers::pi;
            weights.push_back(D * cosine);
            ring += D * cosine * angle;
            draws.cells.push_back(static_cast<float>(ring));
        }
        for (int a = 0; a < grid.azimuths; ++a) {
            float& share = draws.cells[index_of(r * grid.azimuths + a)];
            share = static_cast<float>(static_cast<double>(share) / ring);
        }
        total += ring;
        rings.push_back(total);
    }
    for (const double ring : rings) draws.rings.push_back(static_cast<float>(ring / total));
    for (const double weight : weights) draws.density.push_back(static_cast<float>(weight / total));
    return draws;
}

}  // namespace burnish
