// Prints the errors of pictures against a reference with as good as no noise, one line a picture: the
// root mean square error of radiance, for .exr, and that of displayed values, from 0 to 1.
// Usage: picture_error REFERENCE.exr PICTURE...
// Radiance counts up to 4, four times what a display shows as white: a few pixels at the sun would
// otherwise decide the error of a whole picture.
#include <algorithm>
#include <cstdio>
#include <exception>

#include "burnish/display.hpp"
#include "burnish/image_io.hpp"
#include "plot/sheet.hpp"

namespace {

burnish::Image limited(burnish::Image image) {
    for (float& value : image.pixels) value = std::min(value, 4.0f);
    return image;
}

burnish::Image displayed(const burnish::Image& linear) {
    return burnish::to_display(linear, 0.0, burnish::ToneMap::khronos_neutral);
}

burnish::Image in_color(const burnish::Image& image) {
    burnish::Image color(image.width, image.height, 3);
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < color.pixels.size(); ++i)
        color.pixels[i] = image.pixels[i / 3 * channels + i % 3];
    return color;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "usage: picture_error REFERENCE.exr PICTURE...\n");
        return 2;
    }
    try {
        const burnish::Image reference = in_color(burnish::read_image(argv[1]));
        for (int i = 2; i < argc; ++i) {
            const bool linear = burnish::holds_linear(argv[i]);
            const burnish::Image picture =
                in_color(burnish::read_image(argv[i], {.as_data = true}));
            if (linear)
                std::printf("%s %.5f %.5f\n", argv[i],
                            burnish::rmse(limited(picture), limited(reference)),
                            burnish::rmse(displayed(picture), displayed(reference)));
            else
                std::printf("%s - %.5f\n", argv[i], burnish::rmse(picture, displayed(reference)));
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "picture_error: %s\n", error.what());
        return 1;
    }
    return 0;
}
