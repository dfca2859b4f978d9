#include "maps/normal/slope_symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "burnish/f32.hpp"
#include "image/texel_value.hpp"

namespace burnish {
namespace {

struct Slopes {
    double x, y;
};

Slopes slopes_at(const Texture& map, int x, int y) {
    const std::size_t at = static_cast<std::size_t>(map.channels) *
                           (static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                            static_cast<std::size_t>(x));
    const f32::vec3 v = f32::vector_of_texel(
        f32::vec3(texel_value(map, at), texel_value(map, at + 1), texel_value(map, at + 2)));
    if (!(v.z > 0.0f)) return {0.0, 0.0};
    const f32::vec2 s = f32::slopes_of_normal(v);
    return {static_cast<double>(s.x), static_cast<double>(s.y)};
}

}  // namespace

double slope_symmetry(const Texture& map) {
    if (map.channels < 3 || map.width < 3 || map.height < 3 || map.empty()) return 0.0;
    constexpr int kEnough = 1000;  // rows and columns looked at
    const int step_x = std::max(1, map.width / kEnough), step_y = std::max(1, map.height / kEnough);
    double product = 0.0, x2 = 0.0, y2 = 0.0;
    for (int y = 1; y + 1 < map.height; y += step_y)
        for (int x = 1; x + 1 < map.width; x += step_x) {
            // Rows run down, y up.
            const double x_by_y = slopes_at(map, x, y - 1).x - slopes_at(map, x, y + 1).x;
            const double y_by_x = slopes_at(map, x + 1, y).y - slopes_at(map, x - 1, y).y;
            product += x_by_y * y_by_x;
            x2 += x_by_y * x_by_y;
            y2 += y_by_x * y_by_x;
        }
    const double size = std::sqrt(x2 * y2);
    return size > 0.0 && std::isfinite(size) ? product / size : 0.0;
}

}  // namespace burnish
