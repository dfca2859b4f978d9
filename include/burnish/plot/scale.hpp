// From values to positions on an axis or a colour bar, and the numbers written beside it.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/api.hpp"

namespace burnish {
namespace BURNISH_API plot {

enum class ScaleKind { linear = 0, gamma = 1, log = 2 };
std::span<const std::string_view> scale_names();  // in the order of the enumeration

// Display gamma of the kind `gamma`: position = (value fraction)^(1/2.2), so that the skirts of a
// peaked lobe are visible and the peak keeps its shape, which a logarithm flattens.
inline constexpr double kPlotGamma = 2.2;

struct Tick {
    double position = 0;  // 0..1 along the axis
    std::string label;    // may be empty: a minor tick
};

// low < high, both finite; log: low > 0.
struct Scale {
    ScaleKind kind = ScaleKind::linear;
    double low = 0;
    double high = 1;

    // 0 at low, 1 at high; below 0 and above 1 beyond them (log of 0: -infinity; NaN stays NaN).
    double position(double value) const;
    double value(double position) const;

    // About `count` round numbers; log: every decade, or every second, third ... one.
    std::vector<Tick> ticks(int count = 5) const;
};

// A scale from 0 (log: `decades` below the top) to `high`; a `high` that is not finite and positive
// counts as 1.
Scale scale_to(ScaleKind kind, double high, double decades = 4);

// "0.25", "1.6 x 10^5" with a real multiplication sign and marked-up exponent (see Canvas::text).
std::string number_text(double value, int digits = 3);

}  // namespace plot
}  // namespace burnish
