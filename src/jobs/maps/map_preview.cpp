#include "jobs/maps/map_preview.hpp"

#include <algorithm>
#include <cmath>

namespace burnish {

void line_color(const float* line, float* rgb) {
    if (line[0] == 0.0f && line[1] == 0.0f) {
        std::fill(rgb, rgb + 3, 0.2f);
        return;
    }
    const float hue = std::atan2(line[1], line[0]);
    for (int c = 0; c < 3; ++c)
        rgb[c] = 0.5f + 0.45f * std::cos(hue - static_cast<float>(c) * 2.0943951f);
}

}  // namespace burnish
