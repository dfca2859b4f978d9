#include "maps/normal/normal_map_look.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "image/texel_value.hpp"

namespace burnish {

bool looks_like_normal_map(const Texture& texture) {
    if (texture.channels < 3 || texture.empty()) return false;
    constexpr std::size_t kEnough = std::size_t{1} << 20;
    // Filters shorten the mean of two normals 50 degrees apart to 0.9; 8 bits round by 0.007 at most.
    constexpr double kNearlyUnit = 0.12;
    // Edges of charts and steep relief are a few texels of a map.
    constexpr double kNearlyAll = 0.9;
    const auto channels = static_cast<std::size_t>(texture.channels);
    const std::size_t texels =
        static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
    const std::size_t step = texels / kEnough + 1;
    glm::dvec3 sum(0.0);
    std::size_t counted = 0, unit = 0;
    for (std::size_t i = 0; i < texels; i += step) {
        glm::dvec3 rgb;
        for (std::size_t c = 0; c < 3; ++c)
            rgb[static_cast<int>(c)] = static_cast<double>(texel_value(texture, i * channels + c));
        if (rgb == glm::dvec3(0.0) || !std::isfinite(rgb.x + rgb.y + rgb.z)) continue;
        const glm::dvec3 n = 2.0 * rgb - 1.0;
        unit += std::abs(glm::length(n) - 1.0) < kNearlyUnit;
        sum += n;
        ++counted;
    }
    if (counted == 0) return false;
    const glm::dvec3 mean = sum / static_cast<double>(counted);
    // Heights rise as much as they fall. 0.5 is far below the mean z of steep relief, and 45 degrees
    // lie between +z and the direction of gray, 55 degrees away.
    return static_cast<double>(unit) >= kNearlyAll * static_cast<double>(counted) &&
           mean.z >= 0.5 && mean.z >= 0.7 * glm::length(mean);
}

}  // namespace burnish
