// A distribution under a method and a normal, prepared for many half vectors. Private to the MDF
// plots.
#pragma once

#include <array>

#include "burnish/f64.hpp"
#include "burnish/plot/mdf_plot.hpp"

namespace burnish::plot {

class MdfEvaluator {
  public:
    explicit MdfEvaluator(const MdfSubject& subject)
        : lobe_(f64::lobe_make(static_cast<int>(subject.mdf), subject.p0, subject.p1)),
          perturbation_(f64::perturb_make(
              static_cast<int>(subject.method), subject.n,
              f64::lobe_grooves_along_x(static_cast<int>(subject.mdf), subject.p0, subject.p1),
              subject.normalization == Normalization::conserving)),
          paper_(subject.normalization == Normalization::paper) {}

    double D(Direction<double> h) const {
        return paper_ ? f64::lobe_paper_D(lobe_, perturbation_, h)
                      : f64::lobe_D(lobe_, perturbation_, h);
    }
    // A half vector from the lobe's own sampler.
    Direction<double> sample(const std::array<double, 3>& xi) const {
        return f64::lobe_sample(lobe_, perturbation_, {xi[0], xi[1]}, xi[2]);
    }
    const f64::Lobe& lobe() const { return lobe_; }
    const f64::Perturbation& perturbation() const { return perturbation_; }

  private:
    f64::Lobe lobe_;
    f64::Perturbation perturbation_;
    bool paper_;
};

// The half vector of a point of the disk. Points beyond the rim move to the rim, where z = 0.
Direction<double> lifted(double x, double y);

// Half the width of the lobe on the disk, across and along it. A lobe is visible when it spans a
// few pixels. A perturbation squeezes it by n~z (rotations) or up to 1 - |d| (deformations).
struct Footprint {
    double narrow, wide;
};
Footprint footprint_of(const MdfSubject& subject);

}  // namespace burnish::plot
