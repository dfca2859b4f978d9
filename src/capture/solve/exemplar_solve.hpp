// Solves for the tables of exemplars from the pictures. Least squares over all samples of all
// points of an exemplar, each point at its own rotation, so that the bilinear lookup of the table
// predicts the samples. The push-pull tables that clustering starts from are blurred by their
// splats; these tables are not.
#pragma once

#include <functional>
#include <vector>

#include "capture/solve/exemplars.hpp"
#include "capture/solve/point_fit.hpp"

namespace burnish {

// Normal equations of one table. A sample couples the four nodes of one bilinear cell; with
// symmetry, a node has five coefficients. Partial sums over points can be computed separately and
// merged.
class TableEquations {
  public:
    explicit TableEquations(const NdfGrid& grid);

    // Adds one point's samples: I - received d/pi = received s F/(4 g g) D(h rotated back).
    void add(const PointSamples& samples, const PointFitter& fitter, const ExemplarTables& tables,
             const PointFit& fit);
    // Adds the sums of other points on the same grid. The order of merges changes the rounding.
    void merge(const TableEquations& other);

    // Solves for the table, starting from its values. A weak smoothness term determines cells
    // without samples. `weights` receives 1 for cells that samples determine and 0 for the others.
    // Values are nonnegative.
    void solve(float* table, float* weights) const;
    // The table whose specular light is closest to the points' diffuse light. Moving light from D
    // along this table to the diffuse strengths hardly changes any sample, so that solving for D
    // and diffuse alternately converges slowly along it (SlideAlong).
    std::vector<float> diffuse_mimic() const;

  private:
    std::vector<double> minimizer(const std::vector<double>& target, std::vector<double> x) const;
    void apply(const std::vector<double>& x, double smoothness, std::vector<double>& out) const;

    NdfGrid grid_;
    std::vector<double> diagonal_, right_, next_ring_, next_ring_right_, next_ring_left_, target_,
        diffuse_target_;
};

// Computes the step of the table along `mimic` (TableEquations::diffuse_mimic) when the points'
// diffuse strengths may change with it: least squares over the added points. The step is damped, so
// that it is near 0 where diffuse light imitates that of `mimic` within noise: under few lights the
// samples do not tell the two apart.
class SlideAlong {
  public:
    void add(const PointSamples& samples, const PointFitter& fitter, const ExemplarTables& tables,
             const float* mimic, const PointFit& fit);
    float distance() const;

  private:
    double bend_ = 0.0, slope_ = 0.0;
    double light_ = 0.0;  // weighted square of the light of `mimic`
};

// Completes the cells that no sample determines. They are taken from similar exemplars, rotated and
// scaled, blended at the seam. Cells that are still missing extrapolate the outermost known ring
// with a power of the slope, which falls at least as fast as GGX's tail. Sets `origin`, normalizes
// the tables and computes their areas.
struct CompletionReport {
    int completed = 0;  // exemplars that took cells from others
    double measured = 0.0, completed_share = 0.0, extrapolated = 0.0;  // shares of the solid angle
};
CompletionReport complete_exemplars(Exemplars& exemplars);

}  // namespace burnish
