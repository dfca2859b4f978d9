#include "rays/environment_lookup.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>

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

glm::vec3 EnvironmentLookup::irradiance(const glm::vec3& normal) const {
    return is_dark() ? glm::vec3(0.0f) : at(irradiance_, normal);
}

}  // namespace burnish
