#include "burnish/environments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "burnish/builtin_meshes.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/shading_names.hpp"
#include "core/text.hpp"
#include "scene/light/studio.hpp"

namespace burnish {

namespace {

constexpr std::string_view kPrefix = "builtin:";
constexpr std::array<std::string_view, 3> kNames = {"studio", "white", "black"};
constexpr int kLeastHeight = 2;
// Largest radiance. The sun's disk has 1.6e9 cd/m^2. Larger values are errors, and their sums would
// overflow.
constexpr float kBrightest = 1e12f;

Environment builtin_environment(std::string_view name) {
    const int which = index_of_name(kNames, name, "built-in environment", "");
    if (which == 0) return make_studio();
    return {
        std::string(kPrefix) + std::string(name), Image(64, 32, 3, which == 1 ? 1.0f : 0.0f), {}};
}

Image as_rgb(const Image& image) {
    Image out(image.width, image.height, 3);
    const auto step = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < out.pixels.size() / 3; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            out.pixels[3 * i + c] = image.pixels[step * i + (image.channels < 3 ? 0 : c)];
    return out;
}

void check_shape(const std::string& path, const Image& image) {
    const double ratio = static_cast<double>(image.width) / std::max(image.height, 1);
    if (image.height < kLeastHeight || std::abs(ratio / 2.0 - 1.0) > 0.02)
        throw Error(path, "size", "a lat-long map, twice as wide as high",
                    fmt::format("{}x{}", image.width, image.height));
}

// What overflowed half, the usual pixels of OpenEXR, is taken for its largest value.
constexpr float kLargestHalf = 65504.0f;

// Infinite pixels become the largest value of half and those that are no number black, with a
// warning that counts them. Values slightly below zero, which filters with negative lobes produce,
// become 0. Values far above any light source are an error of the file.
void check_values(const std::string& path, Image& image, std::vector<std::string>& warnings) {
    std::size_t infinite = 0, no_number = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        float& value = image.pixels[i];
        if (std::isnan(value)) {
            value = 0.0f;
            ++no_number;
        } else if (std::isinf(value)) {
            value = value > 0.0f ? kLargestHalf : 0.0f;
            ++infinite;
        } else if (value > kBrightest) {
            const std::size_t texel = i / 3, width = static_cast<std::size_t>(image.width);
            throw Error(path, fmt::format("pixel {},{}", texel % width, texel / width),
                        fmt::format("a radiance up to {:g}", kBrightest), fmt::format("{}", value));
        }
        value = std::max(value, 0.0f);
    }
    const auto verb = [](std::size_t count) { return count == 1 ? "is" : "are"; };
    if (infinite > 0)
        warnings.push_back(fmt::format("{}: {} {} infinite: {:g} is used, 0 for minus infinity",
                                       path, plural(infinite, "value"), verb(infinite),
                                       kLargestHalf));
    if (no_number > 0)
        warnings.push_back(fmt::format("{}: {} {} not a number: 0 is used", path,
                                       plural(no_number, "value"), verb(no_number)));
}

// Integers end at white, so the sun and lamps of a picture of them are far too dark.
void warn_of_integers(const std::string& path, std::vector<std::string>& warnings) {
    const ImageInfo info = read_image_info(path);
    if (info.pixel_type.find("int") == std::string::npos) return;
    warnings.push_back(
        fmt::format("{}: a {} image of {} bits a channel: light brighter than white is clipped, so "
                    "lamps and their shadows are too weak; a .hdr or .exr of the place helps",
                    path, info.format, info.pixel_type == "uint8" ? 8 : 16));
}

}  // namespace

Environment load_environment(const std::string& path_or_builtin,
                             std::vector<std::string>* warnings) {
    if (is_builtin(path_or_builtin))
        return builtin_environment(std::string_view(path_or_builtin).substr(kPrefix.size()));
    std::vector<std::string> found;
    const Image image = read_image(path_or_builtin, {.finite_only = false, .warnings = &found});
    check_shape(path_or_builtin, image);
    Environment environment{path_or_builtin, as_rgb(image), {}};
    check_values(path_or_builtin, environment.radiance, found);
    warn_of_integers(path_or_builtin, found);
    if (warnings != nullptr) std::move(found.begin(), found.end(), std::back_inserter(*warnings));
    return environment;
}

}  // namespace burnish
