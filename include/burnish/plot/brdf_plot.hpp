// Plots of reflection models: polar cuts, lobes as surfaces, albedo over the angle of incidence.
// Every number comes from models/brdf_models.hpp, or from a measurement.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/brdf_models.hpp"
#include "burnish/plot/figure.hpp"
#include "burnish/plot/panels.hpp"

namespace burnish {
namespace BURNISH_API plot {

// Reflection that is not a model's: `f` per steradian, 0 below the horizon, and a sampler of wo for
// wi, xi uniform in [0, 1). The density is per solid angle; a draw of density 0 is thrown away.
// Both are called from several threads.
struct MeasuredReflection {
    std::function<double(Direction<double> wi, Direction<double> wo)> f;
    std::function<Direction<double>(Direction<double> wi, std::array<double, 3> xi,
                                    double& density)>
        sample;
    // Directions wo closer to the horizon than this cosine are not drawn, because measurements are
    // unreliable there. Albedos count them.
    double least_cosine = 0;
};

// One model with its parameters, or a measured material.
struct BrdfSubject {
    const BrdfModel* model = nullptr;  // null: `measured`
    std::array<double, kMostBrdfParameters> p{};
    std::string label;  // in legends; parameters_text(...) where only the parameters differ
    MeasuredReflection measured = {};

    double f(Direction<double> wi, Direction<double> wo) const {
        if (model) return model->value_f64(p, wi, wo);
        return wo.z >= measured.least_cosine ? measured.f(wi, wo) : 0.0;
    }
};

// "ks 1, alpha_x 0.15, alpha_y 0.4"; "measured" for what is not a model.
std::string parameters_text(const BrdfSubject& subject);

// Towards the light: `incidence_deg` from the normal, at azimuth `azimuth_deg` from the tangent.
Direction<double> incident(double incidence_deg, double azimuth_deg);

// ---- polar cuts ---------------------------------------------------------------------------------

// The curve (angle from the normal in radians, -pi/2..pi/2; f) of the cut through the normal at
// azimuth `cut_deg`. Positive angles on the side away from the light when the cut is the plane of
// incidence (cut_deg = azimuth of the light), so that the mirror direction is at +incidence. The
// points are denser where f curves, so that no spike is lost.
std::vector<Point> polar_cut(const BrdfSubject& subject, Direction<double> wi, double cut_deg);

struct PolarPlot {
    std::vector<BrdfSubject> subjects;
    double incidence_deg = 45;
    double azimuth_deg = 0;
    std::optional<double> cut_deg = {};  // default: the plane of incidence
    ScaleKind kind = ScaleKind::linear;  // log: four decades below the top
    std::optional<double> high = {};     // radius 1; default: the largest f to 85 degrees
};
Panel polar_panel(const PolarPlot& plot, std::string title, double width = 400);

// The same panel for curves that are at hand: x the angle from the normal in radians, positive on
// the side away from the light, y is f.
struct PolarCurves {
    std::vector<Series> curves;
    std::optional<double> light_deg = {};  // from the normal; none: the light is not in the plane
    ScaleKind kind = ScaleKind::linear;
    std::optional<double> high = {};  // radius 1; default: the largest f to 85 degrees
};
Panel polar_curves_panel(const PolarCurves& plot, std::string title, double width = 400);

// ---- surfaces -----------------------------------------------------------------------------------

struct SurfaceView {
    double azimuth_deg = -75;   // of the viewer about the normal, from the tangent
    double elevation_deg = 25;  // above the tangent plane
};

// The direction in which f is largest, and f there.
struct BrdfPeak {
    Direction<double> wo{0, 0, 1};
    double f = 0;
};
BrdfPeak peak_of(const BrdfSubject& subject, Direction<double> wi);

// The lobe over the hemisphere as a shaded surface: distance from the origin is f over its peak
// (log: over four decades), with the incident direction, the tangent frame and the tangent plane.
// A depth buffer hides the parts behind others.
Panel surface_panel(const BrdfSubject& subject, double incidence_deg, double azimuth_deg,
                    ScaleKind kind, const SurfaceView& view, std::string title, double width = 320);

// ---- albedo -------------------------------------------------------------------------------------

// The curve (incidence in degrees, albedo): every 2.5 degrees to 80, every half degree to 89, by
// models/albedo.hpp or the measurement's own sampler.
std::vector<Point> albedo_curve(const BrdfSubject& subject, double azimuth_deg);
Panel albedo_panel(std::span<const BrdfSubject> subjects, double azimuth_deg, std::string title);

// Legend of polar and albedo panels.
std::vector<LegendEntry> legend_of(std::span<const BrdfSubject> subjects);

}  // namespace plot
}  // namespace burnish
