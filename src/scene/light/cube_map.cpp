#include "scene/light/cube_map.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "core/constants.hpp"
#include "core/parallel.hpp"

namespace burnish {
namespace {

std::size_t texel_count(int size) {
    return 6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
}

// Solid angle of the rectangle from the middle of a face at distance 1 to (x, y).
double corner_solid_angle(double x, double y) {
    return std::atan2(x * y, std::sqrt(x * x + y * y + 1));
}

// The point (a, b), in [-1, 1]^2, of a face of the cube of half side 1.
glm::vec3 face_point(int face, float a, float b) {
    switch (face) {
        case 0:
            return {1, -b, -a};
        case 1:
            return {-1, -b, a};
        case 2:
            return {a, 1, b};
        case 3:
            return {a, -1, -b};
        case 4:
            return {a, -b, 1};
        default:
            return {-a, -b, -1};
    }
}

// Solid angles of the texels of one face, row by row, steradians.
std::vector<float> solid_angles(int size) {
    const auto n = static_cast<std::size_t>(size) + 1;
    std::vector<double> corners(n * n);
    for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t column = 0; column < n; ++column) {
            const double step = 2.0 / size;
            corners[row * n + column] = corner_solid_angle(static_cast<double>(column) * step - 1,
                                                           static_cast<double>(row) * step - 1);
        }
    }
    std::vector<float> angles;
    angles.reserve((n - 1) * (n - 1));
    for (std::size_t row = 0; row + 1 < n; ++row) {
        for (std::size_t column = 0; column + 1 < n; ++column) {
            const double* top = corners.data() + row * n + column;
            angles.push_back(static_cast<float>(top[n + 1] - top[n] - top[1] + top[0]));
        }
    }
    return angles;
}

// The texels of a cube as light sources, stored in groups of kLanes for a vectorized loop.
constexpr std::size_t kLanes = 8;

struct IrradianceSources {
    // Direction (0 to 2), radiance times solid angle (3 to 5) and solid angle (6). Padding sources
    // in the last group have no solid angle.
    std::array<std::vector<float>, 7> values;
    std::size_t count() const { return values[0].size(); }
};

IrradianceSources sources_of(const CubeMap& radiance) {
    IrradianceSources sources;
    const int n = radiance.size;
    const std::size_t count = (texel_count(n) + kLanes - 1) / kLanes * kLanes;
    for (std::vector<float>& list : sources.values) list.assign(count, 0.0f);
    for (std::size_t i = 0; i < texel_count(n); ++i) {
        const int index = static_cast<int>(i);
        const int row = index / n % n;
        const int column = index % n;
        const auto angle = static_cast<float>(cube_texel_solid_angle(n, row, column));
        const glm::vec3 d = cube_direction(index / (n * n), (column + 0.5) / n, (row + 0.5) / n);
        const glm::vec3 power = angle * radiance.texels[i];
        const std::array<float, 7> values = {d.x, d.y, d.z, power.r, power.g, power.b, angle};
        for (std::size_t k = 0; k < values.size(); ++k) sources.values[k][i] = values[k];
    }
    return sources;
}

// The mean radiance over the hemisphere about n, weighted by the cosine.
glm::vec3 cosine_mean(const IrradianceSources& sources, const glm::vec3& n) {
    std::array<std::array<float, kLanes>, 4> sums{};  // red, green, blue, weight
    const auto& v = sources.values;
    for (std::size_t i = 0; i < sources.count(); i += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const std::size_t k = i + lane;
            const float cosine = n.x * v[0][k] + n.y * v[1][k] + n.z * v[2][k];
            const float weight = cosine > 0.0f ? cosine : 0.0f;
            for (std::size_t c = 0; c < sums.size(); ++c) sums[c][lane] += weight * v[3 + c][k];
        }
    }
    glm::vec4 total(0.0f);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        total += glm::vec4(sums[0][lane], sums[1][lane], sums[2][lane], sums[3][lane]);
    }
    return glm::vec3(total) / total.w;
}

}  // namespace

glm::vec3 cube_direction(int face, double s, double t) {
    return glm::normalize(
        face_point(face, static_cast<float>(2 * s - 1), static_cast<float>(2 * t - 1)));
}

double cube_texel_solid_angle(int size, int row, int column) {
    const double step = 2.0 / size;
    const double x = column * step - 1;
    const double y = row * step - 1;
    return corner_solid_angle(x + step, y + step) - corner_solid_angle(x, y + step) -
           corner_solid_angle(x + step, y) + corner_solid_angle(x, y);
}

int cube_size_for(int latlong_width) {
    int size = 16;
    while (size < latlong_width / 4 && size < 512) size *= 2;
    return size;
}

std::vector<CubeMap> cube_mips(const CubeMap& base) {
    std::vector<CubeMap> levels;
    for (int size = base.size / 2; size >= 1; size /= 2) {
        const CubeMap& finer = levels.empty() ? base : levels.back();
        const std::vector<float> weights = solid_angles(finer.size);
        CubeMap level;
        level.size = size;
        level.texels.reserve(texel_count(size));
        for (int face = 0; face < 6; ++face) {
            for (int row = 0; row < size; ++row) {
                for (int column = 0; column < size; ++column) {
                    glm::vec3 sum(0.0f);
                    float total = 0.0f;
                    for (int j = 0; j < 4; ++j) {
                        const int r = 2 * row + j / 2;
                        const int c = 2 * column + j % 2;
                        const float w = weights[static_cast<std::size_t>(r * finer.size + c)];
                        sum += w * finer.at(face, r, c);
                        total += w;
                    }
                    level.texels.push_back(sum / total);
                }
            }
        }
        levels.push_back(std::move(level));
    }
    return levels;
}

CubeMap cube_irradiance(const CubeMap& radiance, int size) {
    const IrradianceSources sources = sources_of(radiance);
    CubeMap cube;
    cube.size = size;
    cube.texels.resize(texel_count(size));
    parallel_for(cube.texels.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int index = static_cast<int>(i);
            const glm::vec3 n = cube_direction(index / (size * size), (index % size + 0.5) / size,
                                               (index / size % size + 0.5) / size);
            cube.texels[i] = cosine_mean(sources, n);
        }
    });
    return cube;
}

}  // namespace burnish
