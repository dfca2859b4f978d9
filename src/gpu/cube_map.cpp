#include "gpu/cube_map.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/parallel.hpp"

namespace burnish::gpu {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::size_t texel_count(int size) {
    return 6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
}

// A lat-long map with a border that saves the tests at its edges.
struct LatLong {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> texels;

    const glm::vec3& at(int row, int column) const {
        return texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column)];
    }
};

float usable(float value) {
    return std::isfinite(value) && value > 0.0f ? value : 0.0f;
}

LatLong copy_of(const Image& image) {
    LatLong map;
    map.width = image.width;
    map.height = image.height;
    map.texels.reserve(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
    const int step = image.channels >= 3 ? 1 : 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const float* p = image.at(x, y);
            map.texels.emplace_back(usable(p[0]), usable(p[step]), usable(p[2 * step]));
        }
    }
    return map;
}

// Half the width and height, rows weighted by the solid angle they cover: keeps the integral.
LatLong halved(const LatLong& map) {
    LatLong half;
    half.width = map.width / 2;
    half.height = map.height / 2;
    half.texels.resize(static_cast<std::size_t>(half.width) *
                       static_cast<std::size_t>(half.height));
    const double step = kPi / map.height;
    parallel_for(static_cast<std::size_t>(half.height), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const int y = static_cast<int>(row) * 2;
            const double top = std::sin((y + 0.5) * step);
            const double bottom = std::sin((y + 1.5) * step);
            const auto w = static_cast<float>(0.5 * top / (top + bottom));
            for (int x = 0; x < half.width; ++x) {
                half.texels[row * static_cast<std::size_t>(half.width) +
                            static_cast<std::size_t>(x)] =
                    w * (map.at(y, 2 * x) + map.at(y, 2 * x + 1)) +
                    (0.5f - w) * (map.at(y + 1, 2 * x) + map.at(y + 1, 2 * x + 1));
            }
        }
    });
    return half;
}

// Bilinear; columns wrap around, rows end at the poles.
glm::vec3 radiance_towards(const LatLong& map, const glm::vec3& d) {
    const float u = 0.5f + std::atan2(d.x, -d.z) * static_cast<float>(0.5 / kPi);
    const float v = std::acos(std::clamp(d.y, -1.0f, 1.0f)) * static_cast<float>(1.0 / kPi);
    const float x = u * static_cast<float>(map.width) - 0.5f;
    const float y = std::clamp(v * static_cast<float>(map.height) - 0.5f, 0.0f,
                               static_cast<float>(map.height - 1));
    const float x0 = std::floor(x);
    const float y0 = std::floor(y);
    const int column = (static_cast<int>(x0) + map.width) % map.width;
    const int next = (column + 1) % map.width;
    const int row = static_cast<int>(y0);
    const int below = std::min(row + 1, map.height - 1);
    const float a = x - x0;
    const float b = y - y0;
    return (1 - b) * ((1 - a) * map.at(row, column) + a * map.at(row, next)) +
           b * ((1 - a) * map.at(below, column) + a * map.at(below, next));
}

// Solid angle of the rectangle from the middle of a face at distance 1 to (x, y).
double corner_solid_angle(double x, double y) {
    return std::atan2(x * y, std::sqrt(x * x + y * y + 1));
}

}  // namespace

glm::vec3 cube_direction(int face, double s, double t) {
    const double a = 2 * s - 1;
    const double b = 2 * t - 1;
    glm::dvec3 d(0);
    switch (face) {
        case 0:
            d = {1, -b, -a};
            break;
        case 1:
            d = {-1, -b, a};
            break;
        case 2:
            d = {a, 1, b};
            break;
        case 3:
            d = {a, -1, -b};
            break;
        case 4:
            d = {a, -b, 1};
            break;
        default:
            d = {-a, -b, -1};
            break;
    }
    return glm::vec3(d / std::sqrt(a * a + b * b + 1));
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

CubeMap cube_from_latlong(const Image& latlong, int size) {
    LatLong map = copy_of(latlong);
    while (map.width > 5 * size && map.width % 2 == 0 && map.height % 2 == 0) map = halved(map);
    // At least four samples a texel of the map where the cube is coarsest, the middle of a face.
    const int samples =
        std::clamp(static_cast<int>(std::ceil(4.0 * map.width / (kPi * size))), 4, 16);
    CubeMap cube;
    cube.size = size;
    cube.texels.resize(texel_count(size));
    const std::size_t rows = 6 * static_cast<std::size_t>(size);
    parallel_for(rows, 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t line = begin; line < end; ++line) {
            const int face = static_cast<int>(line) / size;
            const int row = static_cast<int>(line) % size;
            for (int column = 0; column < size; ++column) {
                // Samples weighted by solid angle, which goes as 1/r^3 within a face.
                glm::vec3 sum(0.0f);
                float weights = 0.0f;
                for (int j = 0; j < samples * samples; ++j) {
                    const double s = (column + (j % samples + 0.5) / samples) / size;
                    const double t = (row + (j / samples + 0.5) / samples) / size;
                    const auto x = static_cast<float>(2 * s - 1);
                    const auto y = static_cast<float>(2 * t - 1);
                    const float r2 = x * x + y * y + 1;
                    const float weight = 1 / (r2 * std::sqrt(r2));
                    sum += weight * radiance_towards(map, cube_direction(face, s, t));
                    weights += weight;
                }
                cube.texels[line * static_cast<std::size_t>(size) +
                            static_cast<std::size_t>(column)] = sum / weights;
            }
        }
    });
    return cube;
}

std::vector<CubeMap> cube_mips(const CubeMap& base) {
    std::vector<CubeMap> levels;
    for (int size = base.size / 2; size >= 1; size /= 2) {
        const CubeMap& finer = levels.empty() ? base : levels.back();
        CubeMap level;
        level.size = size;
        level.texels.reserve(texel_count(size));
        for (int face = 0; face < 6; ++face) {
            for (int row = 0; row < size; ++row) {
                for (int column = 0; column < size; ++column) {
                    glm::vec3 sum(0.0f);
                    float weights = 0.0f;
                    for (int j = 0; j < 4; ++j) {
                        const int r = 2 * row + j / 2;
                        const int c = 2 * column + j % 2;
                        const auto w = static_cast<float>(cube_texel_solid_angle(finer.size, r, c));
                        sum += w * finer.at(face, r, c);
                        weights += w;
                    }
                    level.texels.push_back(sum / weights);
                }
            }
        }
        levels.push_back(std::move(level));
    }
    return levels;
}

CubeMap cube_irradiance(const CubeMap& radiance, int size) {
    struct Source {
        glm::vec3 direction;
        glm::vec3 power;
        float solid_angle;
    };
    std::vector<Source> sources;
    sources.reserve(radiance.texels.size());
    for (std::size_t i = 0; i < radiance.texels.size(); ++i) {
        const int n = radiance.size;
        const int index = static_cast<int>(i);
        const int face = index / (n * n);
        const int row = index / n % n;
        const int column = index % n;
        const auto w = static_cast<float>(cube_texel_solid_angle(n, row, column));
        sources.push_back(
            {cube_direction(face, (column + 0.5) / n, (row + 0.5) / n), w * radiance.texels[i], w});
    }
    CubeMap cube;
    cube.size = size;
    cube.texels.resize(texel_count(size));
    parallel_for(cube.texels.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int index = static_cast<int>(i);
            const glm::vec3 n = cube_direction(index / (size * size), (index % size + 0.5) / size,
                                               (index / size % size + 0.5) / size);
            glm::vec3 sum(0.0f);
            float weights = 0.0f;
            for (const Source& source : sources) {
                const float cosine = std::max(glm::dot(n, source.direction), 0.0f);
                sum += cosine * source.power;
                weights += cosine * source.solid_angle;
            }
            cube.texels[i] = sum / weights;
        }
    });
    return cube;
}

}  // namespace burnish::gpu
