// What is to be scratched: the settings of a scratch map, its presets, and what must not be asked.
//
// Lengths are millimetres on the surface, so that the same settings give the same surface at any
// size in texels. Angles are degrees, counter-clockwise with y up the picture.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

// A quantity that differs from scratch to scratch. As text: "5", "uniform:2:8" (from, to),
// "normal:5:1" (mean, standard deviation; cut at 3 of them and at a twentieth of the mean) or
// "lognormal:5:0.6" (median, standard deviation of the logarithm; cut at 3 of them).
struct Spread {
    enum class Shape { constant, uniform, normal, lognormal };
    Shape shape = Shape::constant;
    double a = 0.0;
    double b = 0.0;

    double lowest() const;
    double highest() const;
    double typical() const;  // mean of uniform, median of the others
    Spread times(double factor) const;
    double sample(double u1, double u2) const;  // two random numbers in [0,1)

    bool operator==(const Spread&) const = default;
};

Spread constant_spread(double value);
// Throws UsageError naming `where`.
Spread parse_spread(std::string_view text, std::string_view where);
std::string to_text(const Spread& spread);  // what parse_spread reads back as the same

enum class ScratchProfile {
    round,  // a cap of a sphere, pressed in: a hemisphere where the depth is half the width
    v,      // two planes
    burr    // a round groove with raised lips
};
enum class ScratchField {
    random,    // any direction
    constant,  // along angle_deg
    circular,  // around the middle of the tile
    radial,    // away from the middle of the tile
    image      // as a picture says
};
enum class ScratchPlacement {
    random,  // anywhere
    even     // evenly spaced across the grooves, as a tool advances
};

std::span<const std::string_view> scratch_profile_names();
std::span<const std::string_view> scratch_field_names();
std::span<const std::string_view> scratch_placement_names();

// One generation of wear. Layers add up; within a layer the deepest scratch wins, as a tool cuts
// down to a depth and not by a depth.
struct ScratchLayer {
    double count = 0.0;            // scratches on the tile, or
    double density_per_cm2 = 0.0;  // scratches per square centimetre: one of the two, not both
    Spread length_mm = constant_spread(5.0);
    Spread width_mm = constant_spread(0.1);  // where it is widest, lips included
    Spread depth_mm = constant_spread(0.01);
    Spread curvature_per_mm = constant_spread(0.0);  // besides the field's; either side
    double taper = 1.0;  // 0.01..1, share of the length that thins out; 1: a stretched hemisphere
    ScratchProfile profile = ScratchProfile::round;
    ScratchField field = ScratchField::random;
    double angle_deg = 0.0;  // of constant; turns the other fields
    double range_deg = 0.0;  // 0..90, to either side of the field
    ScratchPlacement placement = ScratchPlacement::random;
    double passes = 0;  // of even: the tool comes back this many times over the tile (0: anywhere)

    bool operator==(const ScratchLayer&) const = default;
};

struct ScratchSettings {
    int size = 2048;        // texels a side, 16..16384
    double tile_mm = 50.0;  // side of the tile on the surface
    std::uint32_t seed = 1;
    std::vector<ScratchLayer> layers;  // 1..16

    bool operator==(const ScratchSettings&) const = default;
};

// `amount` times as many scratches, all of them `strength` times as deep. Both are 0 or more; whether
// the result can be engraved, check_scratch_settings says.
ScratchSettings scaled_scratches(ScratchSettings settings, double amount, double strength);

// Scratches that a layer tries to place; a wear mask leaves some out.
double scratch_count(const ScratchSettings& settings, const ScratchLayer& layer);

// Throws UsageError "<where>: layers[0].width_mm: expected ..., found ..." for what is out of
// range or contradicts itself.
void check_scratch_settings(const ScratchSettings& settings, std::string_view where);

std::span<const std::string_view> scratch_preset_names();
// Throws UsageError with the nearest name for an unknown one.
ScratchSettings scratch_preset(std::string_view name, std::string_view where);

}  // namespace burnish
