#include "maps/normal/height_occlusion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/constants.hpp"
#include "core/parallel.hpp"

namespace burnish {
namespace {

constexpr int kDirections = 12;
constexpr double kGrowth = 1.5;  // of the distances

// A step towards the horizon: texels, and the inverse of its length.
struct Step {
    int x, y;
    float inverse_length;
};
using Ray = std::vector<Step>;

// Steps to distinct texels.
Ray ray_towards(double angle, double texel_width, double texel_height, double farthest) {
    Ray ray;
    const double shorter = std::min(texel_width, texel_height);
    for (double distance = shorter; distance <= farthest; distance *= kGrowth) {
        const int x = static_cast<int>(std::lround(distance * std::cos(angle) / texel_width));
        const int y = static_cast<int>(std::lround(distance * std::sin(angle) / texel_height));
        if (x == 0 && y == 0) continue;
        if (!ray.empty() && ray.back().x == x && ray.back().y == y) continue;
        ray.push_back(
            {x, y, static_cast<float>(1.0 / std::hypot(x * texel_width, y * texel_height))});
    }
    return ray;
}

}  // namespace

Image height_occlusion(const Image& height, double texel_width, double texel_height,
                       const Progress& progress) {
    const double farthest =
        std::max(std::min(height.width * texel_width, height.height * texel_height) / 8.0,
                 2.0 * std::max(texel_width, texel_height));
    std::array<Ray, kDirections> rays;
    for (int d = 0; d < kDirections; ++d)
        rays[static_cast<std::size_t>(d)] =
            ray_towards(kTwoPi * d / kDirections, texel_width, texel_height, farthest);
    Image out(height.width, height.height, 1);
    const auto wrapped = [](int i, int n) {
        const int rest = i % n;
        return rest < 0 ? rest + n : rest;
    };
    const auto fill_row = [&](int y) {
        for (int x = 0; x < height.width; ++x) {
            const float here = *height.at(x, y);
            float open = 0.0f;
            for (const Ray& ray : rays) {
                float tangent = 0.0f;
                for (const Step& s : ray)
                    tangent = std::max(tangent, (*height.at(wrapped(x + s.x, height.width),
                                                            wrapped(y + s.y, height.height)) -
                                                 here) *
                                                    s.inverse_length);
                open += 1.0f / (1.0f + tangent * tangent);
            }
            *out.at(x, y) = open / kDirections;
        }
    };
    constexpr int kStep = 128;
    for (int from = 0; from < height.height; from += kStep) {
        progress.step("occlusion", static_cast<double>(from) / height.height);
        const int rows = std::min(kStep, height.height - from);
        parallel_for(static_cast<std::size_t>(rows), 4, [&](std::size_t begin, std::size_t end) {
            for (std::size_t y = begin; y < end; ++y) fill_row(from + static_cast<int>(y));
        });
    }
    return out;
}

}  // namespace burnish
