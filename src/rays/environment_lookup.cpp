#include "rays/environment_lookup.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>

#include "rays/vectors.hpp"
#include "scene/light/cube_map.hpp"

namespace burnish {
namespace {

// Texels along an edge of the finest face that is kept: a texel of 1.4 degrees.
constexpr int kFinest = 64;

}  // namespace

EnvironmentLookup::EnvironmentLookup(const PreparedEnvironment* environment, float intensity,
                                     float rotation)
    : cos_(std::cos(rotation)), sin_(std::sin(rotation)) {
    if (environment == nullptr || !(intensity > 0.0f)) return;
    const float scale = environment->scale * intensity;
    for (const HalfCube& level : environment->radiance)
        if (level.size <= kFinest) radiance_.push_back(cube_of(level, scale));
    irradiance_ = cube_of(environment->irradiance, scale);
    const Cube& finest = radiance_.front();
    for (std::size_t i = 0; i < finest.texels.size(); ++i) {
        const int index = static_cast<int>(i), size = finest.size;
        const int row = index / size % size, column = index % size;
        const glm::vec3 d =
            cube_direction(index / (size * size), (column + 0.5) / size, (row + 0.5) / size);
        // Back from the environment to the world.
        texels_.push_back(
            {{cos_ * d.x + sin_ * d.z, d.y, cos_ * d.z - sin_ * d.x},
             finest.texels[i] * static_cast<float>(cube_texel_solid_angle(size, row, column))});
    }
}

EnvironmentLookup::Cube EnvironmentLookup::cube_of(const HalfCube& half, float scale) const {
    Cube cube{half.size, {}};
    cube.texels.reserve(half.values.size() / 4);
    for (std::size_t i = 0; i + 3 < half.values.size(); i += 4)
        cube.texels.push_back(scale * glm::vec3(glm::unpackHalf1x16(half.values[i]),
                                                glm::unpackHalf1x16(half.values[i + 1]),
                                                glm::unpackHalf1x16(half.values[i + 2])));
    return cube;
}

// Faces in OpenGL's order and axes (cube_map.hpp). Bilinear within a face: half a texel at its edges is cut off.
glm::vec3 EnvironmentLookup::at(const Cube& cube, const glm::vec3& world) const {
    // The rotation of environment_direction() in shaders/lib/environment.glsl.
    const glm::vec3 d(cos_ * world.x - sin_ * world.z, world.y, sin_ * world.x + cos_ * world.z);
    const glm::vec3 l = glm::abs(d);
    int face = 0;
    glm::vec3 p(0.0f);  // (s, t, major)
    if (l.x >= l.y && l.x >= l.z) {
        face = d.x > 0.0f ? 0 : 1;
        p = {d.x > 0.0f ? -d.z : d.z, -d.y, l.x};
    } else if (l.y >= l.z) {
        face = d.y > 0.0f ? 2 : 3;
        p = {d.x, d.y > 0.0f ? d.z : -d.z, l.y};
    } else {
        face = d.z > 0.0f ? 4 : 5;
        p = {d.z > 0.0f ? d.x : -d.x, -d.y, l.z};
    }
    if (!(p.z > 0.0f)) return glm::vec3(0.0f);  // no direction
    const auto size = static_cast<float>(cube.size);
    const float last = size - 1.0f;
    const float x = std::clamp((0.5f * p.x / p.z + 0.5f) * size - 0.5f, 0.0f, last);
    const float y = std::clamp((0.5f * p.y / p.z + 0.5f) * size - 0.5f, 0.0f, last);
    const int column = std::min(static_cast<int>(x), std::max(cube.size - 2, 0));
    const int row = std::min(static_cast<int>(y), std::max(cube.size - 2, 0));
    const auto texel = [&](int r, int c) {
        r = std::min(r, cube.size - 1);
        c = std::min(c, cube.size - 1);
        return cube.texels[static_cast<std::size_t>((face * cube.size + r) * cube.size + c)];
    };
    const float fx = x - static_cast<float>(column), fy = y - static_cast<float>(row);
    return glm::mix(glm::mix(texel(row, column), texel(row, column + 1), fx),
                    glm::mix(texel(row + 1, column), texel(row + 1, column + 1), fx), fy);
}

glm::vec3 EnvironmentLookup::radiance(const glm::vec3& direction, float alpha) const {
    if (is_dark()) return glm::vec3(0.0f);
    // A lobe of GGX reflects half of its light within about 2 alpha of its axis, and a texel is 1.57/size wide.
    const float wanted = 0.5f * 1.57f / std::max(alpha, 1e-3f);
    std::size_t level = 0;
    while (level + 1 < radiance_.size() && static_cast<float>(radiance_[level].size) > wanted &&
           radiance_[level].size > 4)
        ++level;
    return at(radiance_[level], direction);
}

std::vector<EnvironmentLookup::SkyLamp> EnvironmentLookup::lamps(int count) const {
    const auto luminance_of = [](const SkyLamp& texel) {
        return f32::luminance(to_f32(texel.irradiance));
    };
    double total = 0.0;
    for (const SkyLamp& texel : texels_) total += static_cast<double>(luminance_of(texel));
    std::vector<SkyLamp> lamps;
    if (!(total > 0.0)) return lamps;
    // One lamp for every equal share of the sum, in the order of the texels, half a share from its start.
    const double share = total / count;
    double sum = 0.0, next = 0.5 * share;
    for (const SkyLamp& texel : texels_) {
        const auto own = static_cast<double>(luminance_of(texel));
        sum += own;
        int times = 0;
        for (; next < sum; next += share) ++times;
        if (times == 0) continue;
        const auto scale = static_cast<float>(times * share / own);
        lamps.push_back({texel.direction, texel.irradiance * scale});
    }
    return lamps;
}

glm::vec3 EnvironmentLookup::irradiance(const glm::vec3& normal) const {
    return is_dark() ? glm::vec3(0.0f) : at(irradiance_, normal);
}

}  // namespace burnish
