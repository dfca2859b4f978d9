// OpenEXR's two windows. Private to the image readers.
#pragma once

#include "burnish/image.hpp"

namespace burnish {

// A rectangle of pixels of the plane that both windows lie in.
struct PixelWindow {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const PixelWindow&) const = default;
};

// Makes the pixels of the data window those of the display window: what lies outside the display
// window is cropped, and pixels outside the data window are 0.
void fit_to_display_window(Texture& texture, const PixelWindow& data, const PixelWindow& display);

}  // namespace burnish
