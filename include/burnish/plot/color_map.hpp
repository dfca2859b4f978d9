// Colour maps of plots, made in OKLab (B. Ottosson, "A perceptual color space for image
// processing", 2020), so that equal steps of the value look equally large and lightness alone tells
// the order: they read the same in grey and for colour-blind eyes.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <cstddef>

#include "burnish/api.hpp"

namespace burnish {
namespace BURNISH_API plot {

struct Rgb {  // display values (sRGB-encoded), 0..1
    double r = 0, g = 0, b = 0;
    friend bool operator==(const Rgb&, const Rgb&) = default;
};

inline constexpr Rgb kBlack{0, 0, 0};
inline constexpr Rgb kWhite{1, 1, 1};
inline constexpr Rgb kInk{0.13, 0.13, 0.15};    // text and axes
inline constexpr Rgb kGray{0.45, 0.45, 0.48};   // ticks, notes
inline constexpr Rgb kFaint{0.86, 0.86, 0.88};  // grid lines

// OKLab lightness and axes of a display colour, and back (not clamped to the gamut).
struct Oklab {
    double L = 0, a = 0, b = 0;
};
Oklab oklab_of(const Rgb& color);
Rgb display_of(const Oklab& color);

// "Ember": near black through indigo, magenta and orange to pale yellow. t in [0, 1], clamped; NaN
// is the colour of t = 0. Lightness only rises, from 0.12 to 0.97, and the step in OKLab per step
// of t is constant to 2 % (tests/plot/color_map_test.cpp).
Rgb sequential_color(double t);

// "Tide": blue for negative, near white at 0, orange-brown for positive. t in [-1, 1].
Rgb diverging_color(double t);

// Colours for lines and bars, darkened where needed for a contrast of 3:1 on white: the set of
// Okabe & Ito ("Color Universal Design", 2008), without its yellow. The colors repeat after the
// seventh, and series_dash tells those lines apart.
Rgb series_color(std::size_t index);

}  // namespace plot
}  // namespace burnish
