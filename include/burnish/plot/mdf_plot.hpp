// Plots of microfacet distributions under a perturbed normal. Every number comes from
// models/mdf.hpp and burnish/f64.hpp. All directions are in the unperturbed tangent space.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/image.hpp"
#include "burnish/mdf.hpp"
#include "burnish/plot/figure.hpp"
#include "burnish/plot/panels.hpp"
#include "burnish/shading_names.hpp"

namespace burnish {
namespace BURNISH_API plot {

// The one of the three values of MdfValues that is shown.
enum class Normalization { paper = 0, projected = 1, conserving = 2 };
std::span<const std::string_view> normalization_names();  // "paper", "projected", "conserving"

// One distribution under one method and one normal.
struct MdfSubject {
    Mdf mdf = Mdf::ashikhmin_shirley;
    double p0 = 200, p1 = 10;  // exponents or alphas, as mdf_parameters says
    Method method = Method::none;
    Direction<double> n{0, 0, 1};  // unit, n.z > 0
    Normalization normalization = Normalization::paper;

    double D(Direction<double> h) const;
};

// n~ of a tilt away from the normal towards an azimuth (from x towards y).
Direction<double> tilted_normal(double tilt_deg, double azimuth_deg);

// "ashikhmin-shirley, e = 200, 10", "30 deg at 40 deg", what D is called in labels.
std::string lobe_text(Mdf mdf, double p0, double p1);
std::string normal_text(Direction<double> n);
std::string value_text(Mdf mdf, Normalization normalization);

// D at the centre of every texel of a square over the disk, h_x = -1..1 to the right, h_y = -1..1
// upwards; NaN outside. Where the lobe is narrower than a few texels, a texel holds the largest D
// that the lobe's own samples find in it, so that the lobe is not lost between texels.
Image disk_values(const MdfSubject& subject, int side);

// The largest D and its half vector, found by samples of the lobe and of the disk.
struct Peak {
    double D = 0;
    Direction<double> h{0, 0, 1};
};
Peak peak_of(const MdfSubject& subject);

// One scale for panels to compare: from 0 (log: 4 decades below) to the largest peak. The peak of
// normal-map can be thousands of times the others'; it counts only where normal-map is alone, and
// `above` is otherwise set to it. `high`: a top chosen by hand.
ColorBar disk_bar(std::span<const MdfSubject> subjects, ScaleKind kind,
                  std::optional<double> high = {});

// K11 Fig 2, 6, 8, K12 Fig 2, 3, 5: D on the disk of (h_x, h_y), n~ marked with a cross. A lobe
// that is narrower than a few pixels is ringed, so that it is seen.
Panel disk_panel(const MdfSubject& subject, const Scale& scale, std::string title,
                 double side = 260);

// ---- the map as a warped grid (K11 Fig 7) -------------------------------------------------------

// A line of the polar grid on the disk before and after: `to` is the forward map of `from`.
struct GridLine {
    std::vector<Direction<double>> from;
    std::vector<Direction<double>> to;
};

// The image of half vector m under the method (perturb_forward). D is evaluated with the inverse of
// that map. Throws UsageError for normal-map, which is no map.
Direction<double> forward(const MdfSubject& subject, Direction<double> m);
std::vector<GridLine> warped_grid(const MdfSubject& subject, int rings = 5, int rays = 24);

// The three panels of K11 Fig 7: the original distribution with p, R and C; the warped grid with
// the moves of p and C; the deformed distribution. `point`: p on the disk, |p| < 1.
std::vector<Panel> grid_panels(const MdfSubject& subject, const Scale& scale, Point point,
                               double side = 260);

// ---- profiles -----------------------------------------------------------------------------------

enum class ProfileLine { along_x, along_y };  // through n~, parallel to an axis of the disk

// The curve (h_x or h_y; D) from rim to rim, denser where D curves.
std::vector<Point> profile(const MdfSubject& subject, ProfileLine line);
Panel profile_panel(std::span<const MdfSubject> subjects, std::span<const std::string> labels,
                    ProfileLine line, const Scale& scale, std::string title);

}  // namespace plot
}  // namespace burnish
