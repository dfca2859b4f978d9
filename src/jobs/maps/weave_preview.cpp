#include "jobs/maps/weave_preview.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "burnish/image_io.hpp"
#include "jobs/maps/map_preview.hpp"
#include "plot/sheet.hpp"

namespace burnish {

namespace {

constexpr int kClothSide = 512;
constexpr int kSamples = 4;  // samples on a side of a pixel
constexpr double kCloseYarns = 6.0;

using Sample = std::function<glm::vec3(int x, int y)>;

// A square of the periodic cloth, `side_mm` wide, from its lower left corner; each pixel is the
// mean of `sample` over its texels.
Image window(const WeaveMaps& maps, const WeaveMapSettings& settings, double side_mm,
             const Sample& sample) {
    const double x_scale = maps.width / settings.width_mm() * side_mm / (kClothSide * kSamples);
    const double y_scale = maps.height / settings.height_mm() * side_mm / (kClothSide * kSamples);
    Image image(kClothSide, kClothSide, 3);
    for (int y = 0; y < kClothSide * kSamples; ++y) {
        const int up =
            static_cast<int>((kClothSide * kSamples - 1 - y + 0.5) * y_scale) % maps.height;
        for (int x = 0; x < kClothSide * kSamples; ++x) {
            const int right = static_cast<int>((x + 0.5) * x_scale) % maps.width;
            const glm::vec3 value = sample(right, maps.height - 1 - up);
            float* to = image.at(x / kSamples, y / kSamples);
            for (int c = 0; c < 3; ++c) to[c] += value[c] / (kSamples * kSamples);
        }
    }
    return image;
}

glm::vec3 normal_at(const WeaveMaps& maps, int x, int y) {
    const float* n = maps.normals.at(x, y);
    return {n[0], n[1], std::sqrt(std::max(1.0f - n[0] * n[0] - n[1] * n[1], 0.0f))};
}

glm::vec3 color_at(const WeaveMaps& maps, const WeaveMapSettings& settings, int x, int y) {
    const int yarn = maps.yarns[static_cast<std::size_t>(y) * static_cast<std::size_t>(maps.width) +
                                static_cast<std::size_t>(x)];
    return weave_yarn_color(maps, settings, yarn);
}

// Diffuse linear light: a lamp from the upper left at 45 degrees elevation, and a little ambient
// light.
glm::vec3 lit(const WeaveMaps& maps, const WeaveMapSettings& settings, int x, int y) {
    const glm::vec3 n = normal_at(maps, x, y);
    const float cosine = std::max(-0.5f * n.x + 0.5f * n.y + 0.70710678f * n.z, 0.0f);
    return color_at(maps, settings, x, y) * (0.2f + 0.9f * cosine);
}

Image displayed(Image image) {
    for (float& value : image.pixels) value = srgb_from_linear(std::min(value, 1.0f));
    return image;
}

}  // namespace

Image weave_preview(const WeaveMaps& maps, const WeaveMapSettings& settings) {
    const double tile = std::max(settings.width_mm(), settings.height_mm());
    const double close = std::min(tile, kCloseYarns * settings.yarn_mm);
    const auto ends = std::minmax_element(maps.heights.pixels.begin(), maps.heights.pixels.end());
    const float low = *ends.first, range = std::max(*ends.second - low, 1e-12f);
    const Sample light = [&](int x, int y) { return lit(maps, settings, x, y); };
    const Sample normals = [&](int x, int y) { return 0.5f + 0.5f * normal_at(maps, x, y); };
    const Sample heights = [&](int x, int y) {
        return glm::vec3((*maps.heights.at(x, y) - low) / range);
    };
    const Sample lines = [&](int x, int y) {
        glm::vec3 rgb;
        line_color(maps.direction.at(x, y), &rgb.x);
        return rgb;
    };
    const auto seen = [&](double side_mm, const Sample& sample) {
        return window(maps, settings, side_mm, sample);
    };
    return compose_sheet(
        {{{displayed(seen(tile, light)), fmt::format("{}, {:g} mm", settings.draft.name, tile)},
          {displayed(seen(2.0 * tile, light)), fmt::format("{:g} mm", 2.0 * tile)},
          {displayed(seen(close, light)), fmt::format("{:.3g} mm", close)}},
         {{seen(close, normals), "normal"},
          {seen(close, heights),
           fmt::format("height, {:.3g} to {:.3g} mm", static_cast<double>(low),
                       static_cast<double>(low + range))},
          {seen(close, lines), "fibre direction (red along x, cyan along y)"}}});
}

}  // namespace burnish
