// Measures how similar two distributions are, each known on part of the hemisphere only, when one
// of them may be rotated about the normal and scaled. Tries all rotations by whole columns at once,
// by correlation over azimuth in the frequency domain; docs/theory/rotation-match.md has the
// derivation.
//
// For a point's table T with weights m and an exemplar's table C with weights n, over cells
// weighted by cos(theta) times solid angle, at a rotation of the exemplar by s columns:
//   A = sum m T^2 n(s)    B = sum m n(s) C(s)^2    X = sum m T n(s) C(s)    O = sum m n(s)
// The best scale is X / B and leaves A - X^2 / B; the residual is that divided by A: 0 for the same
// shape, 1 for unrelated shapes. Rotations whose overlap O is too small are invalid.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "burnish/ndf_grid.hpp"

namespace burnish {

struct RotationMatch {
    float residual = 1.0f;  // at the nearest whole column; 1 if no rotation is valid
    // Rotation from the exemplar to the point in columns, from -1/2 to azimuths - 1/2. It is whole
    // if a neighbor of the best rotation is invalid.
    float shift = 0.0f;
    float scale = 0.0f;    // ratio of the point's table to the exemplar's
    float overlap = 0.0f;  // ratio of O to the smaller of the two tables' sums of weights
};

// Tables with their weights, cells in ring-major order, one after another. Weights in [0, 1]; the
// tables need not be finite where the weight is 0.
struct MaskedTables {
    std::span<const float> values, weights;
    std::size_t count = 0;
};

class RotationMatcher {
  public:
    // `least_overlap`: least share of the smaller mask that both tables must know. The grid's
    // number of azimuths must be even.
    explicit RotationMatcher(const NdfGrid& grid, float least_overlap = 0.4f);

    // Computes the spectra of the exemplars once, to match them against many points.
    void set_exemplars(const MaskedTables& exemplars);
    std::size_t exemplars() const { return count_; }

    // Matches every point against the exemplars [first, first + count) of set_exemplars.
    // `take(point, matches)` receives the best rotation of each exemplar. Several threads call it,
    // once for each point. Results do not depend on the number of threads; the number of points of
    // a call may change their rounding.
    using Take = std::function<void(std::size_t point, std::span<const RotationMatch> matches)>;
    void match(const MaskedTables& points, const Take& take) const;
    void match_range(const MaskedTables& points, std::size_t first, std::size_t count,
                     const Take& take) const;

  private:
    class Tile;
    void spectra_of(const MaskedTables& tables, std::size_t first, std::size_t count, bool exemplar,
                    std::vector<float>& out, std::vector<float>& sums) const;
    std::size_t block() const;  // floats of one table's spectrum of one product

    NdfGrid grid_;
    float least_overlap_;
    int frequencies_;
    std::vector<float> ring_weight_;  // cos(theta) dw of a cell
    std::vector<float> forward_;      // azimuths x 2 frequencies
    // The inverse transform, separate for even and odd frequencies: frequencies of that parity x
    // rotations up to a quarter circle.
    std::array<std::vector<float>, 2> cosines_, sines_;
    std::size_t count_ = 0;
    std::vector<float> spectra_, sums_;  // of the exemplars
};

}  // namespace burnish
