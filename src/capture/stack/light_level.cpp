#include "capture/stack/light_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "burnish/error.hpp"
#include "capture/stack/light_geometry.hpp"
#include "core/constants.hpp"
#include "core/statistics.hpp"

namespace burnish {

namespace {

constexpr const char* kIntensityKey = "burnish:chosen_intensity";
constexpr const char* kIrradianceKey = "burnish:chosen_irradiance";
// Pixels that are looked at: the percentile over them is within 0.1 of a percent of that of all.
constexpr std::size_t kPixels = 16384;
constexpr double kPercentile = 0.99;
// Largest ratio of mean irradiances of two rigs that count as the same lamps: the same dome with
// some of its lights left out stays within it.
constexpr double kSameLamps = 2.0;

// Of one pixel; 0 without a valid sample.
double brightness_of(const PointLights& lights, const float* values,
                     const std::vector<std::uint8_t>& keep) {
    std::array<double, 3> seen{}, received{};
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const float* v = values + 3 * k;
        const bool clipped = std::isinf(v[0]) || std::isinf(v[1]) || std::isinf(v[2]);
        if (clipped || (!keep.empty() && !keep[k]) || lights.z[k] < kLeastLightCosine) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            seen[c] += static_cast<double>(v[c]);
            received[c] +=
                static_cast<double>(lights.z[k]) * static_cast<double>(lights.received[c][k]);
        }
    }
    double most = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
        if (received[c] > 0.0) most = std::max(most, kPi * seen[c] / received[c]);
    return most;
}

// The positive values of every `step`-th pixel.
std::vector<double> brightnesses(const ImageStack& stack, const Rig& rig,
                                 const std::vector<std::uint8_t>& keep, std::size_t step) {
    const LightGeometry geometry(rig, stack.width(), stack.height());
    std::vector<float> values(3 * stack.lights());
    PointLights lights;
    std::vector<double> out;
    for (std::size_t b = 0, next = 0; b < stack.bands(); ++b) {
        const StackBand band = stack.load(b);
        for (; next < band.first + band.pixels; next += step) {
            if (!stack.mask()[next]) continue;
            stack.decode(band, next - band.first, 1, values.data());
            geometry.at(next, lights);
            const double value = brightness_of(lights, values.data(), keep);
            if (value > 0.0) out.push_back(value);
        }
    }
    return out;
}

double rounded(double value) {
    const double digit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
    return std::round(value / digit) * digit;
}

// Mean over the lights and channels, at the middle of the sample.
double mean_irradiance(const Rig& rig) {
    double sum = 0.0;
    for (const RigLight& light : rig.lights)
        for (const double e : arrival(light, {0.0, 0.0, 0.0}).irradiance_per_cosine) sum += e;
    return sum / (3.0 * static_cast<double>(std::max<std::size_t>(rig.lights.size(), 1)));
}

std::optional<double> number_of(const std::map<std::string, std::string>& metadata,
                                const char* key) {
    const auto found = metadata.find(key);
    if (found == metadata.end()) return {};
    const std::string& text = found->second;
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !(value > 0.0) || !std::isfinite(value)) return {};
    return value;
}

}  // namespace

double relative_brightness(const ImageStack& stack, const Rig& rig,
                           const std::vector<std::uint8_t>& keep) {
    const std::size_t step = std::max<std::size_t>(stack.pixels() / kPixels, 1);
    std::vector<double> found = brightnesses(stack, rig, keep, step);
    // The light may be on a few pixels between those that were looked at.
    if (found.empty() && step > 1) found = brightnesses(stack, rig, keep, 1);
    return found.empty() ? 0.0 : quantile(found, kPercentile);
}

LightLevel light_level(const ImageStack& stack, const Rig& rig,
                       const std::vector<std::uint8_t>& keep) {
    LightLevel level;
    level.brightness = relative_brightness(stack, rig, keep);
    if (level.brightness == 0.0) return level;  // no light: nothing to choose from
    if (const double most = stack.census().brightest;
        most < kDarkestStack || most > kBrightestStack)
        throw Error(rig.file.string(), "pictures",
                    fmt::format("pictures whose brightest sample is from {:g} to {:g}: multiply "
                                "all of them by one factor",
                                kDarkestStack, kBrightestStack),
                    fmt::format("{:.3g}", most));
    if (rig.intensity_stated) {
        if (level.brightness >= kDarkestStated && level.brightness <= kBrightestStated)
            return level;
        throw Error(
            rig.file.string(), "intensity",
            "intensities in the units of the pictures, with which the sample is at most about as "
            "bright as a white diffuser",
            fmt::format(
                "{:.3g} times that: state {:.3g} times as much (--intensity {:.3g}), or none",
                level.brightness, rounded(level.brightness / kChosenBrightness),
                rounded(level.brightness / kChosenBrightness)));
    }
    if (level.brightness < kDarkestSample || level.brightness > kBrightestSample)
        level.intensity = rounded(level.brightness / kChosenBrightness);
    return level;
}

void multiply_intensities(Rig& rig, double factor) {
    for (RigLight& light : rig.lights)
        for (double& channel : light.intensity) channel *= factor;
    rig.intensity_stated = true;
}

void record_level(const LightLevel& level, const Rig& rig,
                  std::map<std::string, std::string>& metadata) {
    if (!level.chosen()) return;
    metadata[kIntensityKey] = fmt::format("{}", level.intensity);
    metadata[kIrradianceKey] = fmt::format("{}", mean_irradiance(rig));
}

double recorded_factor(const std::map<std::string, std::string>& metadata, const Rig& rig) {
    const auto intensity = number_of(metadata, kIntensityKey);
    const auto irradiance = number_of(metadata, kIrradianceKey);
    const double own = mean_irradiance(rig);
    if (rig.intensity_stated || !intensity || !irradiance || !(own > 0.0)) return 1.0;
    const double ratio = *intensity * own / *irradiance;
    return ratio <= kSameLamps && ratio >= 1.0 / kSameLamps ? *intensity : *irradiance / own;
}

}  // namespace burnish
