// Checks whether a texture is a plausible tangent-space normal map.
#include "stage/normal_map_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <type_traits>

#include "burnish/error.hpp"

namespace burnish {

namespace {

template <typename Stored>
float stored_at(const Texture& texture, std::size_t index) {
    Stored value{};
    std::memcpy(&value, texture.texels.data() + index * sizeof value, sizeof value);
    if constexpr (std::is_same_v<Stored, float>) return value;
    return static_cast<float>(value) / static_cast<float>(std::numeric_limits<Stored>::max());
}

float channel_at(const Texture& texture, std::size_t index) {
    switch (texture.type) {
        case TexelType::u8:
            return stored_at<std::uint8_t>(texture, index);
        case TexelType::u16:
            return stored_at<std::uint16_t>(texture, index);
        case TexelType::f32:
            return stored_at<float>(texture, index);
    }
    return 0.0f;
}

// Mean of 2 rgb - 1 (gray three times, as it is drawn) over texels that are not black; +z when all are black. Samples about a million
// texels at most.
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
                static_cast<double>(channel_at(texture, i * channels + std::min(c, channels - 1)));
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

}  // namespace

void warn_of_odd_normal_maps(Scene& scene) {
    std::set<int> seen;
    for (const Material& material : scene.materials) {
        const TextureUse& use = material.normal_texture;
        if (!use || cloth_of(material) || !seen.insert(use.texture).second) continue;
        const Texture& texture = scene.textures[static_cast<std::size_t>(use.texture)];
        // Of two channels z is what is left of 1.
        if (texture.channels == 2 || texture.empty()) continue;
        const glm::dvec3 mean = mean_direction(texture);
        if (!is_odd(mean)) continue;
        scene.warnings.push_back(
            fmt::format("{} does not look like a tangent-space normal map: its mean direction is "
                        "({:.2f}, {:.2f}, {:.2f}), expected near (0, 0, 1); it is drawn as one "
                        "(--normal-map none takes it off)",
                        one_line(texture.name), mean.x, mean.y, mean.z));
    }
}

}  // namespace burnish
