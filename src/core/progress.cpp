#include "burnish/progress.hpp"

#include "burnish/error.hpp"

namespace burnish {

void Progress::step(std::string_view stage, double done) const {
    throw_if_cancelled();
    if (!report_) return;
    // The comparisons are written so that NaN becomes 0.
    report_(stage, done > 0.0 ? (done < 1.0 ? done : 1.0) : 0.0);
}

void Progress::throw_if_cancelled() const {
    if (cancelled()) throw Interrupted();
}

Progress Progress::with_report(Report report) const {
    Progress part(std::move(report));
    part.token_ = token_;
    return part;
}

}  // namespace burnish
