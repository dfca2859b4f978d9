// Reads and merges the pictures of one light.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "capture/stack/image_stack.hpp"

namespace burnish {

namespace {

// Values from here on are clipped: the last code of 8 bits, less half a code. In a 16-bit picture
// the margin covers the noise of clipped samples.
constexpr float kLastCode = 254.5f / 255.0f;

struct Exposed {
    Image rgb;
    bool coded = false;  // integer samples, which clip at 1
};

Image with_three_channels(const Image& image) {
    if (image.channels == 3) return image;
    Image out(image.width, image.height, 3);
    for (std::size_t i = 0; i < out.pixels.size() / 3; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            out.pixels[3 * i + c] =
                image.channels == 1
                    ? image.pixels[i]
                    : image.pixels[static_cast<std::size_t>(image.channels) * i + c];
    return out;
}

Exposed read_exposure(const Rig& rig, const std::filesystem::path& path) {
    Exposed out;
    const std::string type = read_image_info(path).pixel_type;
    out.coded = type.find("int") != std::string::npos;
    out.rgb = with_three_channels(
        read_image(path, {.as_data = rig.response == RigResponse::linear, .finite_only = true}));
    return out;
}

void require_size(const std::filesystem::path& path, const Image& image, int width, int height) {
    if (width == 0 || (image.width == width && image.height == height)) return;
    throw Error(path.string(), "",
                fmt::format("{} x {} pixels, as the first picture has", width, height),
                fmt::format("{} x {}", image.width, image.height));
}

}  // namespace

Image read_flat_field(const Rig& rig) {
    if (!rig.white) return {};
    Image white = read_exposure(rig, *rig.white).rgb;
    double sum = 0.0;
    for (const float value : white.pixels) sum += static_cast<double>(value);
    const auto mean = static_cast<float>(sum / static_cast<double>(white.pixels.size()));
    if (!(mean > 0.0f))
        throw Error(rig.white->string(), "", "a picture of a white target", "all black");
    for (float& value : white.pixels) value = std::max(value / mean, 0.01f);
    return white;
}

LightImage read_light_image(const Rig& rig, const RigLight& light, const Image& white, int width,
                            int height) {
    LightImage out;
    std::vector<float> weights;
    // The merge weights each exposure by its time, since longer exposures hold less noise; clipped
    // samples are excluded.
    for (const RigExposure& exposure : light.images) {
        Exposed picture = read_exposure(rig, exposure.image);
        require_size(exposure.image, picture.rgb, width, height);
        out.coded |= picture.coded;
        if (out.rgb.empty()) {
            width = picture.rgb.width;
            height = picture.rgb.height;
            out.rgb = Image(width, height, 3);
            weights.assign(out.rgb.pixels.size(), 0.0f);
            out.clipped.assign(out.rgb.pixels.size(), 0);
        }
        const auto seconds = static_cast<float>(exposure.exposure);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const float value = std::max(picture.rgb.pixels[i], 0.0f);
            if (picture.coded && value >= kLastCode) continue;
            out.rgb.pixels[i] += value;
            weights[i] += seconds;
        }
    }
    if (!white.empty()) require_size(*rig.white, white, width, height);
    const auto shortest = std::min_element(
        light.images.begin(), light.images.end(),
        [](const RigExposure& a, const RigExposure& b) { return a.exposure < b.exposure; });
    bool any = false;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] > 0.0f) {
            out.rgb.pixels[i] /= weights[i];
        } else {
            out.clipped[i] = 1;
            out.rgb.pixels[i] = 1.0f / static_cast<float>(shortest->exposure);
            any = true;
        }
        if (!white.empty()) out.rgb.pixels[i] /= white.pixels[i];
    }
    if (!any) out.clipped.clear();
    return out;
}

}  // namespace burnish
