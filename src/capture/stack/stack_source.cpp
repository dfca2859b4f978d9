// Sources of a stack's pictures: the files of a rig, or memory.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "burnish/error.hpp"
#include "capture/stack/image_stack.hpp"

namespace burnish {
namespace {

constexpr const char* kMemory = "pictures";

std::string size_of(const Image& image) {
    return fmt::format("{} x {} pixels of {} channels", image.width, image.height, image.channels);
}

void check(const Image& image, std::size_t light, int width, int height) {
    const std::string key = fmt::format("pictures[{}]", light);
    const bool right = !image.empty() && (image.channels == 1 || image.channels == 3) &&
                       (width == 0 || (image.width == width && image.height == height));
    if (!right)
        throw Error(kMemory, key,
                    width == 0
                        ? "a picture of 1 or 3 channels"
                        : fmt::format("{} x {} pixels, as the first picture has", width, height),
                    size_of(image));
    for (const float value : image.pixels)
        if (!std::isfinite(value))
            throw Error(kMemory, key, "finite values", fmt::format("{}", value));
}

Image as_rgb(const Image& image) {
    if (image.channels == 3) return image;
    Image out(image.width, image.height, 3);
    for (std::size_t i = 0; i < out.pixels.size(); ++i) out.pixels[i] = image.pixels[i / 3];
    return out;
}

std::vector<std::uint8_t> mask_of(const Image& mask, int width, int height) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (mask.empty()) return std::vector<std::uint8_t>(pixels, 1);
    if (mask.width != width || mask.height != height || mask.channels != 1)
        throw Error(kMemory, "mask", fmt::format("{} x {} pixels of 1 channel", width, height),
                    size_of(mask));
    std::vector<std::uint8_t> out(pixels);
    bool any = false;
    for (std::size_t i = 0; i < pixels; ++i) {
        out[i] = mask.pixels[i] > 0.5f;
        any = any || out[i] != 0;
    }
    if (!any) throw Error(kMemory, "mask", "something above 0.5: the part to be fitted", "nothing");
    return out;
}

}  // namespace

StackSource files_of(const Rig& rig) {
    const auto white = std::make_shared<const Image>(read_flat_field(rig));
    StackSource source;
    source.lights = rig.lights.size();
    source.picture = [&rig, white](std::size_t light, int width, int height) {
        return read_light_image(rig, rig.lights[light], *white, width, height);
    };
    source.mask = [&rig](int width, int height) { return read_mask(rig, width, height); };
    return source;
}

StackSource images_of(const Rig& rig, std::span<const Image> pictures, const Image& mask) {
    if (pictures.size() != rig.lights.size())
        throw Error(kMemory, "", fmt::format("one a light, {}", rig.lights.size()),
                    fmt::format("{}", pictures.size()));
    StackSource source;
    source.lights = pictures.size();
    source.picture = [pictures](std::size_t light, int width, int height) {
        check(pictures[light], light, width, height);
        LightImage out;
        out.rgb = as_rgb(pictures[light]);
        for (float& value : out.rgb.pixels) value = value > 0.0f ? value : 0.0f;
        return out;
    };
    source.mask = [&mask](int width, int height) { return mask_of(mask, width, height); };
    return source;
}

}  // namespace burnish
