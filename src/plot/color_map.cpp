#include "burnish/plot/color_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "burnish/image_io.hpp"
#include "core/constants.hpp"

namespace burnish::plot {
namespace {

struct LightnessChromaHue {
    double L, C, hue_deg;
};

// Stops along the edge of the sRGB gamut, a little inside it.
constexpr std::array<LightnessChromaHue, 8> kEmber = {{{0.12, 0.045, 278},
                                                       {0.24, 0.105, 285},
                                                       {0.38, 0.160, 303},
                                                       {0.50, 0.185, 340},
                                                       {0.62, 0.185, 18},
                                                       {0.73, 0.165, 52},
                                                       {0.84, 0.140, 78},
                                                       {0.97, 0.075, 104}}};

// Stops from the middle outwards. Both sides have the same lightness at the same distance.
constexpr std::array<LightnessChromaHue, 3> kTideBlue = {
    {{0.965, 0.0, 250}, {0.68, 0.115, 250}, {0.38, 0.105, 255}}};
constexpr std::array<LightnessChromaHue, 3> kTideOrange = {
    {{0.965, 0.0, 60}, {0.68, 0.125, 60}, {0.38, 0.080, 55}}};

Oklab oklab_of(const LightnessChromaHue& c) {
    const double hue = c.hue_deg * kDegree;
    return {c.L, c.C * std::cos(hue), c.C * std::sin(hue)};
}

Oklab mixed(const Oklab& a, const Oklab& b, double u) {
    return {a.L + u * (b.L - a.L), a.a + u * (b.a - a.a), a.b + u * (b.b - a.b)};
}

double distance(const Oklab& x, const Oklab& y) {
    return std::hypot(x.L - y.L, x.a - y.a, x.b - y.b);
}

double catmull_rom(double a, double b, double c, double d, double u) {
    return 0.5 *
           (2 * b + u * (c - a + u * (2 * a - 5 * b + 4 * c - d + u * (3 * (b - c) + d - a))));
}

// The curve through the stops, which is continued straight at both ends.
Oklab through(std::span<const Oklab> stops, double t) {
    const auto segments = static_cast<double>(stops.size() - 1);
    const auto i = static_cast<std::size_t>(std::min(t * segments, segments - 1));
    const double u = t * segments - static_cast<double>(i);
    const Oklab &b = stops[i], &c = stops[i + 1];
    const Oklab a = i > 0 ? stops[i - 1] : mixed(c, b, 2);
    const Oklab d = i + 2 < stops.size() ? stops[i + 2] : mixed(b, c, 2);
    return {catmull_rom(a.L, b.L, c.L, d.L, u), catmull_rom(a.a, b.a, c.a, d.a, u),
            catmull_rom(a.b, b.b, c.b, d.b, u)};
}

// Colors at equal distances along the curve. 1024: neighbours differ by less than an 8-bit code.
constexpr std::size_t kEntries = 1024;

std::vector<Oklab> evenly(std::span<const LightnessChromaHue> chosen) {
    std::vector<Oklab> stops;
    for (const LightnessChromaHue& c : chosen) stops.push_back(oklab_of(c));
    constexpr std::size_t kSteps = 8 * kEntries;
    std::vector<Oklab> curve;
    std::vector<double> length;
    for (std::size_t i = 0; i <= kSteps; ++i) {
        curve.push_back(through(stops, static_cast<double>(i) / kSteps));
        length.push_back(i == 0 ? 0 : length[i - 1] + distance(curve[i - 1], curve[i]));
    }
    std::vector<Oklab> even;
    std::size_t at = 1;
    for (std::size_t k = 0; k < kEntries; ++k) {
        const double wanted = length.back() * static_cast<double>(k) / (kEntries - 1);
        while (at < kSteps && length[at] < wanted) ++at;
        const double step = length[at] - length[at - 1];
        even.push_back(mixed(curve[at - 1], curve[at], (wanted - length[at - 1]) / step));
    }
    return even;
}

Rgb look_up(const std::vector<Oklab>& entries, double t) {
    // Written so that NaN becomes 0.
    const double x = t > 0 ? std::min(t, 1.0) * static_cast<double>(kEntries - 1) : 0.0;
    const auto i = std::min(static_cast<std::size_t>(x), kEntries - 2);
    const Rgb color = display_of(mixed(entries[i], entries[i + 1], x - static_cast<double>(i)));
    const auto in_gamut = [](double v) { return std::clamp(v, 0.0, 1.0); };
    return {in_gamut(color.r), in_gamut(color.g), in_gamut(color.b)};
}

double linear(double display) {
    return static_cast<double>(linear_from_srgb(static_cast<float>(display)));
}

double encoded(double linear) {
    return static_cast<double>(srgb_from_linear(static_cast<float>(linear)));
}

}  // namespace

Oklab oklab_of(const Rgb& color) {
    const double r = linear(color.r), g = linear(color.g), b = linear(color.b);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Rgb display_of(const Oklab& color) {
    const auto cubed = [](double v) { return v * v * v; };
    const double l = cubed(color.L + 0.3963377774 * color.a + 0.2158037573 * color.b);
    const double m = cubed(color.L - 0.1055613458 * color.a - 0.0638541728 * color.b);
    const double s = cubed(color.L - 0.0894841775 * color.a - 1.2914855480 * color.b);
    return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

Rgb sequential_color(double t) {
    static const std::vector<Oklab> entries = evenly(kEmber);
    return look_up(entries, t);
}

Rgb diverging_color(double t) {
    static const std::vector<Oklab> blue = evenly(kTideBlue), orange = evenly(kTideOrange);
    return t < 0 ? look_up(blue, -t) : look_up(orange, t);
}

Rgb series_color(std::size_t index) {
    constexpr std::array<Rgb, 7> kColors = {{{0.000, 0.380, 0.640},    // blue, darker
                                             {0.800, 0.300, 0.000},    // vermilion, darker
                                             {0.000, 0.520, 0.380},    // bluish green, darker
                                             {0.741, 0.376, 0.592},    // reddish purple, darker
                                             {0.130, 0.130, 0.150},    // black
                                             {0.140, 0.560, 0.790},    // sky blue, darker
                                             {0.720, 0.490, 0.000}}};  // orange, darker
    return kColors[index % kColors.size()];
}

}  // namespace burnish::plot
