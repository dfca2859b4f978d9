// The unit of a capture's intensities. A rig that states none leaves it open: a pixel is then
// reflectance times an unknown factor, the same for all pictures.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "burnish/rig.hpp"
#include "capture/stack/image_stack.hpp"

namespace burnish {

// Brightness of the sample under the kept lights (`keep`: one value a light; empty: all), relative
// to a white diffuser in its place: pi Sum I / Sum E (n.i) of the brightest channel, 1 for the
// diffuser. Not more than about 1 for any surface that does not shine by itself, unless the lights
// gather around its highlight. The 99th percentile over the pixels with light; 0: none has any.
double relative_brightness(const ImageStack& stack, const Rig& rig,
                           const std::vector<std::uint8_t>& keep);

// Limits of relative_brightness within which a rig that states no intensities is taken as it is.
// The darkest materials known reflect a few thousandths.
inline constexpr double kDarkestSample = 1e-3, kBrightestSample = 1.0;
// The brightness that is chosen beyond these limits: white paper, as pictures are exposed for white.
inline constexpr double kChosenBrightness = 0.8;
// Limits for a rig that states its intensities: what the half floats of a material file hold. Below
// 1e-5 their steps are more than half a percent.
inline constexpr double kDarkestStated = 1e-5, kBrightestStated = 65504.0;

// Limits of the brightest sample of a stack: the squares of its samples are single precision.
inline constexpr double kDarkestStack = 1e-15, kBrightestStack = 1e15;

struct LightLevel {
    double brightness = 0.0;  // relative_brightness with the rig's own intensities
    double intensity = 1.0;   // the factor on all intensities; 1: as the rig has them
    bool chosen() const { return intensity != 1.0; }
};

// Throws Error where stated intensities, or the samples of the stack, are beyond their limits.
LightLevel light_level(const ImageStack& stack, const Rig& rig,
                       const std::vector<std::uint8_t>& keep);

// Multiplies the intensities of all lights; they count as stated then.
void multiply_intensities(Rig& rig, double factor);

// ---- A chosen level in a material's metadata, for pictures that are made of it later.

// `rig`: as the fit used it, with the chosen intensities.
void record_level(const LightLevel& level, const Rig& rig,
                  std::map<std::string, std::string>& metadata);

// The factor on the intensities of a rig that states none, with which a material that was fitted
// at a chosen level comes out as bright as in the fit's pictures; 1 where nothing was chosen. The
// factor of the fit for lights about as strong and as near as those of the fit. For other rigs,
// that which gives the middle of the sample the same mean irradiance.
double recorded_factor(const std::map<std::string, std::string>& metadata, const Rig& rig);

}  // namespace burnish
