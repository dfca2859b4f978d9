// Checks whether a texture is a plausible tangent-space normal map.
#include "stage/normal_map_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <utility>

#include "burnish/error.hpp"
#include "image/texel_value.hpp"
#include "maps/normal/slope_symmetry.hpp"

namespace burnish {

namespace {

// Mean of 2 rgb - 1 (gray three times, as it is drawn) over texels that are not black; +z when all
// are black. Looks at about a million texels at most.
glm::dvec3 mean_direction(const Texture& texture) {
    constexpr std::size_t kEnough = std::size_t{1} << 20;
    const auto channels = static_cast<std::size_t>(texture.channels);
    const std::size_t texels =
        static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
    const std::size_t step = texels / kEnough + 1;
    glm::dvec3 sum(0.0);
    std::size_t counted = 0;
    for (std::size_t i = 0; i < texels; i += step) {
        glm::dvec3 rgb;
        for (std::size_t c = 0; c < 3; ++c)
            rgb[static_cast<int>(c)] =
                static_cast<double>(texel_value(texture, i * channels + std::min(c, channels - 1)));
        if (rgb == glm::dvec3(0.0) || !std::isfinite(rgb.x + rgb.y + rgb.z)) continue;
        sum += 2.0 * rgb - 1.0;
        ++counted;
    }
    return counted == 0 ? glm::dvec3(0, 0, 1) : sum / static_cast<double>(counted);
}

// Heights rise as much as they fall, so the mean normal of a map is close to +z. 0.5 is far below
// the mean z of steep relief. The direction of gray is 55 degrees from +z; the limit is 45 degrees.
bool is_odd(const glm::dvec3& mean) {
    return !(mean.z >= 0.5 && mean.z >= 0.7 * glm::length(mean));
}

// Beyond this correlation a map says which way its green points; those of heights reach 0.8 and more,
// noise stays below 0.1.
constexpr double kTelling = 0.5;

// A map whose green points the other way than the material says; empty: it agrees, or says nothing.
std::string warning_of_green(const Texture& texture, bool flipped) {
    const double symmetry = slope_symmetry(texture) * (flipped ? -1.0 : 1.0);
    if (symmetry > -kTelling) return "";
    return fmt::format(
        "{}: its slopes are those of a height only where green points {} (correlation {:.2f}); it "
        "is drawn as {}: bumps look like dents ({})",
        one_line(texture.name), flipped ? "up (OpenGL)" : "down (DirectX)", symmetry,
        flipped ? "DirectX" : "OpenGL",
        flipped ? "--flip-green=false draws it as OpenGL" : "--flip-green draws it as DirectX");
}

// A normal map of a material or of its coat, and the flag that takes it off.
struct CheckedMap {
    const TextureUse& use;
    bool flipped;
    const char* flag;
};

std::string warning_of(const Scene& scene, const CheckedMap& map) {
    const Texture& texture = scene.textures[static_cast<std::size_t>(map.use.texture)];
    // Of two channels z is what is left of 1.
    if (texture.channels == 2 || texture.empty()) return "";
    const glm::dvec3 mean = mean_direction(texture);
    if (!is_odd(mean)) return warning_of_green(texture, map.flipped);
    return fmt::format(
        "{} does not look like a tangent-space normal map: its mean direction is "
        "({:.2f}, {:.2f}, {:.2f}), expected near (0, 0, 1); it is drawn as one "
        "({} none takes it off)",
        one_line(texture.name), mean.x, mean.y, mean.z, map.flag);
}

}  // namespace

void warn_of_odd_normal_maps(Scene& scene) {
    std::set<int> seen;
    for (const Material& m : scene.materials) {
        const CheckedMap maps[] = {{m.normal_texture, m.flip_green, "--normal-map"},
                                   {m.coat.normal_texture, m.coat.flip_green, "--coat-normal-map"}};
        for (const CheckedMap& map : maps) {
            const bool unread = &map.use == &m.normal_texture && cloth_of(m);
            if (!map.use || unread || !seen.insert(map.use.texture).second) continue;
            std::string line = warning_of(scene, map);
            if (!line.empty()) scene.warnings.push_back(std::move(line));
        }
    }
}

}  // namespace burnish
