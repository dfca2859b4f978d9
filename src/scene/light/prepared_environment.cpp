#include "scene/light/prepared_environment.hpp"

#include <algorithm>
#include <glm/gtc/packing.hpp>
#include <string_view>
#include <utility>

#include "burnish/error.hpp"
#include "core/parallel.hpp"
#include "scene/light/cube_map.hpp"

namespace burnish {
namespace {

// Texels along an edge of a face. Irradiance is smooth except at a sun's terminator: 32 texels keep
// the error there below 2 % of the peak.
constexpr int kIrradianceSize = 32;
// Largest edge, in texels, of the cube that irradiance is summed over. A finer cube would move
// light by less than the 3 degrees of a texel.
constexpr int kIrradianceSource = 32;
// The largest stored value. It is below 65504 so that filters between texels cannot overflow.
constexpr float kLargestStored = 60000.0f;

float highest(const CubeMap& cube) {
    float high = 0.0f;
    for (const glm::vec3& v : cube.texels) high = std::max({high, v.x, v.y, v.z});
    return high;
}

// The cube of a lat-long map and its mips.
std::vector<CubeMap> cube_levels(const Image& map) {
    std::vector<CubeMap> levels = {cube_from_latlong(map, cube_size_for(map.width))};
    for (CubeMap& level : cube_mips(levels.front())) levels.push_back(std::move(level));
    return levels;
}

HalfCube half_of(const CubeMap& cube, float scale) {
    HalfCube half;
    half.size = cube.size;
    half.values.resize(4 * cube.texels.size());
    parallel_for(cube.texels.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::vec3 v = cube.texels[i] / scale;
            for (int c = 0; c < 3; ++c) {
                half.values[4 * i + static_cast<std::size_t>(c)] = glm::packHalf1x16(v[c]);
            }
            half.values[4 * i + 3] = 0x3c00;  // 1
        }
    });
    return half;
}

}  // namespace

std::shared_ptr<const PreparedEnvironment> prepare_environment(Environment environment,
                                                               const Progress& progress) {
    const Image& map = environment.radiance;
    if (map.width < 2 || map.height < 1 || map.channels < 1) {
        throw Error(environment.name, "environment", "a lat-long picture", "an empty one");
    }
    constexpr std::string_view kStage = "environment";
    progress.step(kStage, 0.0);
    const std::vector<CubeMap> levels = cube_levels(map);
    progress.step(kStage, 0.6);
    const auto source = std::find_if(levels.begin(), levels.end(), [](const CubeMap& level) {
        return level.size <= kIrradianceSource;
    });
    const CubeMap irradiance = cube_irradiance(*source, kIrradianceSize);
    progress.step(kStage, 0.9);

    auto prepared = std::make_shared<PreparedEnvironment>();
    prepared->scale = std::max(1.0f, highest(levels.front()) / kLargestStored);
    for (const CubeMap& level : levels)
        prepared->radiance.push_back(half_of(level, prepared->scale));
    prepared->irradiance = half_of(irradiance, prepared->scale);
    if (!environment.backdrop.empty())
        for (const CubeMap& level : cube_levels(environment.backdrop))
            prepared->backdrop.push_back(half_of(level, prepared->scale));
    prepared->environment = std::move(environment);
    progress.step(kStage, 1.0);
    return prepared;
}

}  // namespace burnish
