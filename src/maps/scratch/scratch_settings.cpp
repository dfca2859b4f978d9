#include "burnish/scratch_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "burnish/error.hpp"
#include "burnish/shading_names.hpp"
#include "core/text.hpp"

namespace burnish {

namespace {

constexpr std::array<std::string_view, 3> kProfiles = {"round", "v", "burr"};
constexpr std::array<std::string_view, 5> kFields = {"random", "constant", "circular", "radial",
                                                     "image"};
constexpr std::array<std::string_view, 2> kPlacements = {"random", "even"};

constexpr double kCut = 3.0;          // standard deviations
constexpr double kLeastShare = 0.05;  // of the mean: a normal distribution would go below 0
constexpr double kMostScratches = 1e7;
constexpr std::size_t kMostLayers = 16;

std::optional<double> parse_number(std::string_view text) {
    double value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

// A standard normal deviate between -kCut and kCut (Box and Muller 1958; values beyond the cut, 0.3
// % of them, are wrapped into the interval by the remainder).
double normal_deviate(double u1, double u2) {
    const double z = std::sqrt(-2.0 * std::log(1.0 - u1)) * std::cos(2.0 * std::numbers::pi * u2);
    return std::remainder(z, 2.0 * kCut);
}

// Checks values by key and throws errors that name `where`.
struct Checker {
    std::string_view where;
    std::string prefix;

    void require(bool good, std::string_view key, std::string_view expected,
                 const std::string& found) const {
        if (!good) throw UsageError(where, prefix + std::string(key), expected, found);
    }
    void range(double value, double low, double high, std::string_view key) const {
        require(value >= low && value <= high, key,
                fmt::format("a number from {:g} to {:g}", low, high), fmt::format("{:g}", value));
    }
    void range(const Spread& s, double low, double high, std::string_view key) const {
        require(s.lowest() >= low && s.highest() <= high, key,
                fmt::format("values from {:g} to {:g}", low, high),
                fmt::format("{} ({:g} to {:g})", to_text(s), s.lowest(), s.highest()));
    }
};

void check_layer(const ScratchSettings& settings, const ScratchLayer& layer, const Checker& check) {
    check.require(layer.count == 0.0 || layer.density_per_cm2 == 0.0, "density_per_cm2",
                  "a count or a density, not both",
                  fmt::format("count {:g} and density {:g}", layer.count, layer.density_per_cm2));
    check.range(layer.count, 0.0, kMostScratches, "count");
    check.range(layer.density_per_cm2, 0.0, 1e9, "density_per_cm2");
    const double most = std::floor(kMostScratches * 100.0 / (settings.tile_mm * settings.tile_mm));
    check.require(scratch_count(settings, layer) <= kMostScratches, "density_per_cm2",
                  fmt::format("at most {:.6g}, which is {:g} scratches on a tile of {:g} mm", most,
                              kMostScratches, settings.tile_mm),
                  fmt::format("{:g}", layer.density_per_cm2));
    // A scratch longer than four tiles crosses itself so often that a pattern shows.
    check.range(layer.length_mm, 1e-4, 4.0 * settings.tile_mm, "length_mm");
    check.range(layer.width_mm, 1e-5, 0.5 * settings.tile_mm, "width_mm");
    check.range(layer.depth_mm, 0.0, settings.tile_mm, "depth_mm");
    // With a greater curvature, a scratch would turn within its own width.
    check.range(layer.curvature_per_mm, -1e4, 1e4, "curvature_per_mm");
    check.range(layer.taper, 0.01, 1.0, "taper");
    check.range(layer.angle_deg, -360.0, 360.0, "angle_deg");
    check.range(layer.range_deg, 0.0, 90.0, "range_deg");
    const double width = layer.width_mm.typical();
    check.require(layer.length_mm.typical() >= width, "width_mm",
                  fmt::format("no more than the length, {:g} mm", layer.length_mm.typical()),
                  fmt::format("{:g} mm", width));
    check.require(layer.depth_mm.typical() <= 0.5 * width, "depth_mm",
                  fmt::format("no more than half the width, {:g} mm (a hemisphere)", 0.5 * width),
                  fmt::format("{:g} mm", layer.depth_mm.typical()));
    const bool aimless = layer.field == ScratchField::random;
    check.require(!aimless || layer.range_deg == 0.0, "range_deg",
                  "0 with the direction random, which has all directions",
                  fmt::format("{:g}", layer.range_deg));
    check.require(!aimless || layer.angle_deg == 0.0, "angle_deg",
                  "0 with the direction random, which has all directions",
                  fmt::format("{:g}", layer.angle_deg));
    const bool placed =
        layer.placement == ScratchPlacement::random || layer.field == ScratchField::constant;
    check.require(placed, "placement", "random, unless the direction is constant", "even");
    check.range(layer.passes, 0.0, 64.0, "passes");
    check.require(layer.passes == std::floor(layer.passes), "passes", "a whole number",
                  fmt::format("{:g}", layer.passes));
    check.require(layer.passes == 0.0 || layer.placement == ScratchPlacement::even, "passes",
                  "0, unless the placement is even", fmt::format("{:g}", layer.passes));
}

// --- presets ----------------------------------------------------------------------------------

using Shape = Spread::Shape;

ScratchLayer layer_of(double density, Spread length, Spread width, Spread depth) {
    ScratchLayer layer;
    layer.density_per_cm2 = density;
    layer.length_mm = length;
    layer.width_mm = width;
    layer.depth_mm = depth;
    return layer;
}

Spread lognormal(double median, double sigma) {
    return {Shape::lognormal, median, sigma};
}

void aim(ScratchLayer& layer, ScratchField field, double angle_deg, double range_deg) {
    layer.field = field;
    layer.angle_deg = angle_deg;
    layer.range_deg = range_deg;
}

// Grinding belt: dense fine lines in one direction, a few of them deeper.
std::vector<ScratchLayer> brushed() {
    ScratchLayer fine =
        layer_of(420, lognormal(14, 0.5), lognormal(0.09, 0.35), lognormal(0.0065, 0.5));
    aim(fine, ScratchField::constant, 0, 1.2);
    ScratchLayer deeper =
        layer_of(18, lognormal(18, 0.5), lognormal(0.12, 0.3), lognormal(0.015, 0.4));
    aim(deeper, ScratchField::constant, 0, 2.5);
    deeper.profile = ScratchProfile::v;
    return {fine, deeper};
}

// Handling: short and long hairlines in every direction.
std::vector<ScratchLayer> fine_random() {
    ScratchLayer hair = layer_of(22, lognormal(5, 0.7), lognormal(0.1, 0.3), lognormal(0.012, 0.5));
    hair.curvature_per_mm = {Shape::normal, 0.0, 0.03};
    ScratchLayer faint =
        layer_of(70, lognormal(2.5, 0.6), lognormal(0.07, 0.25), lognormal(0.005, 0.4));
    faint.curvature_per_mm = {Shape::normal, 0.0, 0.05};
    return {hair, faint};
}

// Abuse: a few broad furrows with raised lips among lighter marks.
std::vector<ScratchLayer> deep_gouges() {
    ScratchLayer gouge =
        layer_of(1.1, lognormal(12, 0.6), lognormal(0.55, 0.4), lognormal(0.07, 0.4));
    gouge.profile = ScratchProfile::burr;
    gouge.curvature_per_mm = {Shape::normal, 0.0, 0.012};
    gouge.taper = 0.7;
    ScratchLayer nick =
        layer_of(6, lognormal(2.2, 0.6), lognormal(0.22, 0.4), lognormal(0.03, 0.4));
    nick.profile = ScratchProfile::burr;
    nick.curvature_per_mm = {Shape::normal, 0.0, 0.05};
    ScratchLayer hair =
        layer_of(20, lognormal(5, 0.6), lognormal(0.08, 0.3), lognormal(0.007, 0.5));
    hair.curvature_per_mm = {Shape::normal, 0.0, 0.03};
    return {gouge, nick, hair};
}

// Turned or spun against an abrasive: circles about the middle of the tile, over the full face.
std::vector<ScratchLayer> circular_brushed() {
    ScratchLayer fine =
        layer_of(450, lognormal(12, 0.5), lognormal(0.09, 0.35), lognormal(0.0065, 0.5));
    aim(fine, ScratchField::circular, 0, 0.8);
    ScratchLayer deeper =
        layer_of(20, lognormal(17, 0.5), lognormal(0.12, 0.3), lognormal(0.015, 0.4));
    aim(deeper, ScratchField::circular, 0, 1.2);
    deeper.profile = ScratchProfile::v;
    return {fine, deeper};
}

// A buffing pad: shallow arcs with radii of a few millimeters, in every direction.
std::vector<ScratchLayer> swirl_marks() {
    ScratchLayer arcs =
        layer_of(45, lognormal(8, 0.5), lognormal(0.09, 0.25), lognormal(0.008, 0.45));
    arcs.curvature_per_mm = lognormal(0.16, 0.5);
    ScratchLayer wide =
        layer_of(4, lognormal(16, 0.4), lognormal(0.11, 0.25), lognormal(0.014, 0.4));
    wide.curvature_per_mm = lognormal(0.09, 0.3);
    return {arcs, wide};
}

// A face mill: arcs of one radius at a constant feed, in two passes, and fine lines from dragged
// chips.
std::vector<ScratchLayer> tool_marks() {
    ScratchLayer furrow =
        layer_of(11, {Shape::normal, 30, 0.8}, lognormal(0.5, 0.1), lognormal(0.016, 0.2));
    furrow.curvature_per_mm = constant_spread(0.014);
    furrow.taper = 0.25;
    aim(furrow, ScratchField::constant, 90, 0.25);
    furrow.placement = ScratchPlacement::even;
    furrow.passes = 2;
    ScratchLayer drag =
        layer_of(40, {Shape::normal, 28, 2}, lognormal(0.06, 0.3), lognormal(0.0025, 0.4));
    drag.curvature_per_mm = constant_spread(0.014);
    drag.taper = 0.6;
    aim(drag, ScratchField::constant, 90, 0.4);
    drag.placement = ScratchPlacement::even;
    drag.passes = 2;
    return {furrow, drag};
}

struct Preset {
    std::string_view name;
    std::vector<ScratchLayer> (*layers)();
};

constexpr std::array kPresets = {
    Preset{"brushed", brushed},         Preset{"fine-random", fine_random},
    Preset{"deep-gouges", deep_gouges}, Preset{"circular-brushed", circular_brushed},
    Preset{"swirl-marks", swirl_marks}, Preset{"tool-marks", tool_marks}};

}  // namespace

// --- Spread -----------------------------------------------------------------------------------

double Spread::lowest() const {
    switch (shape) {
        case Shape::constant:
        case Shape::uniform:
            return a;
        case Shape::normal:
            return a == 0.0 ? -kCut * b : std::max(a - kCut * b, kLeastShare * a);
        case Shape::lognormal:
            return a * std::exp(-kCut * b);
    }
    return a;
}

double Spread::highest() const {
    switch (shape) {
        case Shape::constant:
            return a;
        case Shape::uniform:
            return b;
        case Shape::normal:
            return a + kCut * b;
        case Shape::lognormal:
            return a * std::exp(kCut * b);
    }
    return a;
}

double Spread::typical() const {
    return shape == Shape::uniform ? 0.5 * (a + b) : a;
}

Spread Spread::times(double factor) const {
    const bool scales_b = shape == Shape::uniform || shape == Shape::normal;
    return {shape, a * factor, scales_b ? b * factor : b};
}

double Spread::sample(double u1, double u2) const {
    switch (shape) {
        case Shape::constant:
            return a;
        case Shape::uniform:
            return a + (b - a) * u1;
        case Shape::normal:
            return std::clamp(a + b * normal_deviate(u1, u2), lowest(), highest());
        case Shape::lognormal:
            return a * std::exp(b * normal_deviate(u1, u2));
    }
    return a;
}

Spread constant_spread(double value) {
    return {Spread::Shape::constant, value, 0.0};
}

Spread parse_spread(std::string_view text, std::string_view where) {
    const auto fail = [&] {
        throw UsageError(where, "",
                         "a number, uniform:FROM:TO, normal:MEAN:SD or lognormal:MEDIAN:SIGMA",
                         shown(text));
    };
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) {
        const std::optional<double> value = parse_number(text);
        if (!value) fail();
        return constant_spread(*value);
    }
    const std::string_view name = text.substr(0, colon), rest = text.substr(colon + 1);
    const std::size_t second = rest.find(':');
    if (second == std::string_view::npos) fail();
    const std::optional<double> a = parse_number(rest.substr(0, second));
    const std::optional<double> b = parse_number(rest.substr(second + 1));
    if (!a || !b) fail();
    const bool uniform = name == "uniform", normal = name == "normal";
    if (!uniform && !normal && name != "lognormal") fail();
    if (uniform && *b < *a) throw UsageError(where, "", "uniform:FROM:TO, FROM first", shown(text));
    if (!uniform && (*b < 0.0 || *a < 0.0))
        throw UsageError(where, "", "numbers that are not negative", shown(text));
    return {uniform ? Shape::uniform : normal ? Shape::normal : Shape::lognormal, *a, *b};
}

std::string to_text(const Spread& spread) {
    switch (spread.shape) {
        case Shape::constant:
            return fmt::format("{}", spread.a);
        case Shape::uniform:
            return fmt::format("uniform:{}:{}", spread.a, spread.b);
        case Shape::normal:
            return fmt::format("normal:{}:{}", spread.a, spread.b);
        case Shape::lognormal:
            return fmt::format("lognormal:{}:{}", spread.a, spread.b);
    }
    return {};
}

// --- settings ---------------------------------------------------------------------------------

std::span<const std::string_view> scratch_profile_names() {
    return kProfiles;
}

std::span<const std::string_view> scratch_field_names() {
    return kFields;
}

std::span<const std::string_view> scratch_placement_names() {
    return kPlacements;
}

ScratchSettings scaled_scratches(ScratchSettings settings, double amount, double strength) {
    for (ScratchLayer& layer : settings.layers) {
        layer.count *= amount;
        layer.density_per_cm2 *= amount;
        layer.depth_mm = layer.depth_mm.times(strength);
    }
    return settings;
}

double scratch_count(const ScratchSettings& settings, const ScratchLayer& layer) {
    const double tile_cm = settings.tile_mm / 10.0;
    const double wished =
        layer.count > 0.0 ? layer.count : layer.density_per_cm2 * tile_cm * tile_cm;
    return std::round(wished);
}

void check_scratch_settings(const ScratchSettings& settings, std::string_view where) {
    const Checker check{where, ""};
    check.range(settings.size, 16, 16384, "size");
    check.range(settings.tile_mm, 0.1, 1e4, "tile_mm");
    check.require(!settings.layers.empty() && settings.layers.size() <= kMostLayers, "layers",
                  fmt::format("1 to {} layers", kMostLayers),
                  std::to_string(settings.layers.size()));
    for (std::size_t i = 0; i < settings.layers.size(); ++i)
        check_layer(settings, settings.layers[i], {where, fmt::format("layers[{}].", i)});
}

std::span<const std::string_view> scratch_preset_names() {
    static const auto names = [] {
        std::array<std::string_view, kPresets.size()> all;
        std::transform(kPresets.begin(), kPresets.end(), all.begin(),
                       [](const Preset& preset) { return preset.name; });
        return all;
    }();
    return names;
}

ScratchSettings scratch_preset(std::string_view name, std::string_view where) {
    const int index = index_of_name(scratch_preset_names(), name, "preset", where);
    ScratchSettings settings;
    settings.layers = kPresets[static_cast<std::size_t>(index)].layers();
    return settings;
}

}  // namespace burnish
