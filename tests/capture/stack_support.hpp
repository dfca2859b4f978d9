// Makes small stacks on disk for the tests that read them.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "burnish/image_io.hpp"
#include "capture/stack/image_stack.hpp"
#include "support/test_folder.hpp"
#include "table_support.hpp"

namespace burnish::test {

inline RigLight light_of(const std::vector<RigExposure>& images) {
    RigLight light;
    light.images = images;
    light.place = {false, {0, 0, 1}};
    light.where = "lights[0]";
    return light;
}

inline Rig rig_of(const ScratchFolder& folder, const std::vector<std::string>& names,
                  RigResponse response = RigResponse::linear) {
    Rig rig;
    rig.file = folder.write("rig.json", "{}");
    rig.response = response;
    rig.width_mm = rig.height_mm = 40;
    rig.camera = {false, {0, 0.6, 0.8}};
    for (const std::string& name : names) rig.lights.push_back(light_of({{folder / name, 1.0}}));
    return rig;
}

// Distinct linear values over four decades.
inline Image random_picture(int width, int height, double brightest, std::uint32_t seed) {
    Random random(seed);
    Image out(width, height, 3);
    for (float& v : out.pixels)
        v = static_cast<float>(brightest * std::pow(10, -4 * random.uniform()));
    return out;
}

// A picture of display codes, as in a camera's 8-bit file.
inline Image coded_picture(int width, int height, const std::vector<int>& codes) {
    Image out(width, height, 3);
    for (std::size_t i = 0; i < out.pixels.size(); ++i)
        out.pixels[i] = static_cast<float>(codes[i % codes.size()]) / 255.0f;
    return out;
}

// The sRGB curve of IEC 61966-2-1.
inline double linear_of_code(int code) {
    const double v = code / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

// [pixel][light][channel] of the whole stack, read a few pixels at a time.
inline std::vector<float> all_samples(const ImageStack& stack, std::size_t at_once = 7) {
    std::vector<float> out(stack.pixels() * stack.lights() * 3);
    for (std::size_t b = 0; b < stack.bands(); ++b) {
        const StackBand band = stack.load(b);
        for (std::size_t from = 0; from < band.pixels; from += at_once) {
            const std::size_t count = std::min(at_once, band.pixels - from);
            stack.decode(band, from, count, out.data() + (band.first + from) * stack.lights() * 3);
        }
    }
    return out;
}

// Error of 16-bit codes of the square root relative to the light's largest sample: half a step of
// the root times twice the root, plus the rounding of single precision.
inline double coding_error(double value, double largest) {
    return std::sqrt(value * largest) / 65534 + largest / (4 * 65534.0 * 65534.0) + 1e-6 * value;
}

inline std::set<std::string> files_in(const std::filesystem::path& folder) {
    std::set<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        out.insert(entry.path().filename().string());
    return out;
}

}  // namespace burnish::test
