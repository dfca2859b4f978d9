// The papers' measurements, for comparison in reports.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace burnish {

// K12 Table I: Radeon HD 5670, mesh and picture size not given. `printed` is the row "Cost", `fps`
// the row below it: 1004/968 is 1.04, while 1.03 is printed.
struct PaperCost {
    std::string_view technique;  // ours
    std::string_view label;      // theirs
    double printed;
    double fps;
};

inline constexpr std::array<PaperCost, 4> kK12Table1 = {{
    {"gouraud", "Gouraud", 1.0, 1004.0},
    {"aniso", "Aniso", 1.03, 968.0},
    {"normal-map", "N-Map", 1.55, 647.0},
    {"rotate-approx", "MDF", 1.56, 642.0},
}};

// Cost relative to Gouraud from the frames per second; empty for techniques that K12 did not
// measure.
constexpr std::optional<double> k12_cost(std::string_view technique) {
    for (const PaperCost& cost : kK12Table1)
        if (cost.technique == technique) return kK12Table1[0].fps / cost.fps;
    return std::nullopt;
}

// K12 Fig 7: "for rendering one frame", seconds. We read them as additional to normal mapping: the
// frames per second of Table I differ by 1/642 - 1/647 s = 12 microseconds.
inline constexpr double kK12AccurateRotation = 54e-6;
inline constexpr double kK12ApproximateRotation = 11e-6;

// K11 Fig 11 (GeForce 9400M) has no figures in the available text; this is its caption's claim.
inline constexpr std::string_view kK11Figure11 =
    "the deformed MDF is just slightly more expensive than usual normal mapping";

}  // namespace burnish
