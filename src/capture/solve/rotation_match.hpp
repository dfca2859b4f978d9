// How alike two distributions are when each is known on a part of the hemisphere only and one of
// them may be rotated about the normal and scaled. All rotations by whole columns are tried at
// once, by correlation over azimuth in frequency space; docs/theory/rotation-match.md derives it.
//
// For a point's table T with weights m and an exemplar's table C with weights n, over cells
// weighted by cos(theta) times solid angle, at a rotation of the exemplar by s columns:
//   A = sum m T^2 n(s)    B = sum m n(s) C(s)^2    X = sum m T n(s) C(s)    O = sum m n(s)
// The scale that fits best is X / B, and it leaves A - X^2 / B; the residual is that over A: 0 for
// the same shape, 1 for unrelated ones. Rotations whose overlap O is too small do not count.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "burnish/ndf_grid.hpp"

namespace burnish {

struct RotationMatch {
    float residual =
        1.0f;  // at the nearest whole column; 1 also where no rotation has enough overlap
    // Columns by which the exemplar is rotated to lie on the point, from -1/2 to azimuths - 1/2;
    // whole where a rotation beside the best one does not count.
    float shift = 0.0f;
    float scale = 0.0f;    // the point's table over the exemplar's
    float overlap = 0.0f;  // O over the smaller of the two tables' own sums of weights
};

// Tables with their weights, cells in ring-major order, one after another. Weights in [0, 1]; the
// tables need not be finite where the weight is 0.
struct MaskedTables {
    std::span<const float> values, weights;
    std::size_t count = 0;
};

class RotationMatcher {
  public:
    // `least_overlap`: share of the smaller mask that must be seen by both. The grid's azimuths
    // must be an even number.
    explicit RotationMatcher(const NdfGrid& grid, float least_overlap = 0.4f);

    // Exemplars to be matched against many points: their spectra, computed once.
    void set_exemplars(const MaskedTables& exemplars);
    std::size_t exemplars() const { return count_; }

    // Matches every point against the exemplars [first, first + count) of set_exemplars:
    // `take(point, matches)` receives the best rotation of each exemplar. It is called from several
    // threads, once for each point. Results do not depend on the number of threads; another number
    // of points in one call may change their rounding.
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
    // The transform back, apart for even and odd frequencies: frequencies of that parity x
    // rotations up to a quarter.
    std::array<std::vector<float>, 2> cosines_, sines_;
    std::size_t count_ = 0;
    std::vector<float> spectra_, sums_;  // of the exemplars
};

}  // namespace burnish
