// Tables of exemplars from the pictures themselves: least squares over all samples of all points
// that are assigned to one, each at its own turn, so that the table as it is READ (bilinearly)
// explains them. Push-pull tables, from which clustering starts, are blurred by their splats; these
// are not.
#pragma once

#include <functional>
#include <vector>

#include "capture/solve/exemplars.hpp"
#include "capture/solve/point_fit.hpp"

namespace burnish {

// Normal equations of one table. Neighbours within a bilinear cell only: five coefficients a cell.
class TableEquations {
  public:
    explicit TableEquations(const NdfGrid& grid);

    // Adds one point's samples: I - received d/pi = received s F/(4 g g) D(h turned back).
    void add(const PointSamples& samples, const PointFitter& fitter, const ExemplarTables& tables,
             const PointFit& fit);

    // Solves for the table, starting from it. Slight smoothness holds what no sample sees;
    // `weights` receives 1 where samples decide, 0 where they do not. Nothing is below 0.
    void solve(float* table, float* weights) const;
    // The table that mimics the points' diffuse light best: light that taking it away from D and
    // giving it back as diffuse hardly changes. Solved for together, D and diffuse converge slowly
    // along it (slide_along).
    std::vector<float> diffuse_mimic() const;

  private:
    std::vector<double> minimiser(const std::vector<double>& target, std::vector<double> x) const;
    void apply(const std::vector<double>& x, double smoothness, std::vector<double>& out) const;

    NdfGrid grid_;
    std::vector<double> diagonal_, right_, next_ring_, next_ring_right_, next_ring_left_, target_,
        diffuse_target_;
};

// How far along `mimic` the table should go when the points' diffuse strengths are free to follow.
class SlideAlong {
  public:
    void add(const PointSamples& samples, const PointFitter& fitter, const ExemplarTables& tables,
             const float* mimic, const PointFit& fit);
    float distance() const { return bend_ > 0.0 ? static_cast<float>(slope_ / bend_) : 0.0f; }

  private:
    double bend_ = 0.0, slope_ = 0.0;
};

// Cells that no sample decides: from alike exemplars, turned and scaled, blended in at the seam;
// what is still missing continues the outermost known ring as a power of the slope, no slower than
// GGX's tail. Sets `origin`, normalises, and works out the areas.
struct CompletionReport {
    int completed = 0;  // exemplars that took cells from others
    double measured = 0.0, completed_share = 0.0, extrapolated = 0.0;  // of all cells' solid angle
};
CompletionReport complete_exemplars(Exemplars& exemplars);

}  // namespace burnish
