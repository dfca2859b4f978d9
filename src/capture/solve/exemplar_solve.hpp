// Tables of exemplars from the pictures themselves: least squares over all samples of all points
// that an exemplar is assigned to, each at its own rotation, so that the table as it is read
// (bilinearly) explains them. The push-pull tables that clustering starts from are blurred by their
// splats; these are not.
#pragma once

#include <functional>
#include <vector>

#include "capture/solve/exemplars.hpp"
#include "capture/solve/point_fit.hpp"

namespace burnish {

// Normal equations of one table. A sample couples the four nodes of one bilinear cell, so that a
// node has five coefficients. Sums of parts of the points can be made apart and merged.
class TableEquations {
  public:
    explicit TableEquations(const NdfGrid& grid);

    // Adds one point's samples: I - received d/pi = received s F/(4 g g) D(h rotated back).
    void add(const PointSamples& samples, const PointFitter& fitter, const ExemplarTables& tables,
             const PointFit& fit);
    // Adds the sums of other points of the same grid. The order of merges decides the rounding.
    void merge(const TableEquations& other);

    // Solves for the table, starting from its values. A slight smoothness decides cells that no
    // sample sees; `weights` receives 1 where samples decide, 0 where they do not. No value ends
    // below 0.
    void solve(float* table, float* weights) const;
    // The table whose specular light is most like the points' diffuse light: taken from D and given
    // back as diffuse, it hardly changes any sample. When D and diffuse are solved for alternately,
    // they converge slowly along it (SlideAlong).
    std::vector<float> diffuse_mimic() const;

  private:
    std::vector<double> minimizer(const std::vector<double>& target, std::vector<double> x) const;
    void apply(const std::vector<double>& x, double smoothness, std::vector<double>& out) const;

    NdfGrid grid_;
    std::vector<double> diagonal_, right_, next_ring_, next_ring_right_, next_ring_left_, target_,
        diffuse_target_;
};

// How far the table should move along `mimic` (TableEquations::diffuse_mimic) when the points'
// diffuse strengths are free to follow: least squares over the points that are added.
class SlideAlong {
  public:
    void add(const PointSamples& samples, const PointFitter& fitter, const ExemplarTables& tables,
             const float* mimic, const PointFit& fit);
    float distance() const { return bend_ > 0.0 ? static_cast<float>(slope_ / bend_) : 0.0f; }

  private:
    double bend_ = 0.0, slope_ = 0.0;
};

// Completes the cells that no sample decides: from alike exemplars, rotated and scaled, blended at
// the seam; cells that are still missing continue the outermost known ring as a power of the slope,
// which falls no slower than GGX's tail. Sets `origin`, normalizes the tables and works out their
// areas.
struct CompletionReport {
    int completed = 0;  // exemplars that took cells from others
    double measured = 0.0, completed_share = 0.0, extrapolated = 0.0;  // of all cells' solid angle
};
CompletionReport complete_exemplars(Exemplars& exemplars);

}  // namespace burnish
