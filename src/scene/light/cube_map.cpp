#include "scene/light/cube_map.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/parallel.hpp"

namespace burnish {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::size_t texel_count(int size) {
    return 6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
}

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

// Mean of each texel with `reach` neighbours on both sides, around the row; `sums` is scratch.
void average_row(glm::vec3* texels, int width, int reach, std::vector<glm::dvec3>& sums) {
    sums.resize(static_cast<std::size_t>(width) * 3 + 1);
    for (int x = 0; x < 3 * width; ++x) {  // three turns: no wrapping below
        sums[static_cast<std::size_t>(x) + 1] =
            sums[static_cast<std::size_t>(x)] + glm::dvec3(texels[x % width]);
    }
    for (int x = 0; x < width; ++x) {
        const auto middle = static_cast<std::size_t>(x + width);
        const auto r = static_cast<std::size_t>(reach);
        texels[x] = glm::vec3((sums[middle + r + 1] - sums[middle - r]) / (2.0 * reach + 1));
    }
}

// Towards the poles columns crowd together. Each row averaged, twice, over as many columns as fit
// into one at the equator: what is lost is finer than the cube, and no sun is too narrow for its
// samples.
void even_out_columns(LatLong& map) {
    parallel_for(static_cast<std::size_t>(map.height), 8, [&](std::size_t begin, std::size_t end) {
        std::vector<glm::dvec3> sums;
        for (std::size_t row = begin; row < end; ++row) {
            const double sine = std::sin((static_cast<double>(row) + 0.5) * kPi / map.height);
            const int reach = std::min(static_cast<int>(0.5 / sine), (map.width - 1) / 2);
            if (reach == 0) continue;
            glm::vec3* texels = map.texels.data() + row * static_cast<std::size_t>(map.width);
            average_row(texels, map.width, reach, sums);
            average_row(texels, map.width, reach, sums);
        }
    });
}

// atan2(y, x) to 1e-6 rad, several times as fast as the library's: atan on [0, 1] by its polynomial
// of degree 13 through Chebyshev nodes, and three reflections.
float quick_atan2(float y, float x) {
    const float ax = std::abs(x);
    const float ay = std::abs(y);
    const float q = std::min(ax, ay) / std::max(std::max(ax, ay), 1e-30f);
    const float w = q * q;
    float a =
        q * (0.999999226f +
             w * (-0.33325678f +
                  w * (0.198720403f +
                       w * (-0.134478641f +
                            w * (0.083126453f + w * (-0.0363604309f + w * 0.00764835393f))))));
    a = ay > ax ? static_cast<float>(0.5 * kPi) - a : a;
    a = x < 0.0f ? static_cast<float>(kPi) - a : a;
    return y < 0.0f ? -a : a;
}

// Bilinear; columns wrap around, rows end at the poles. `d` need not be unit.
glm::vec3 radiance_towards(const LatLong& map, const glm::vec3& d) {
    const float u = 0.5f + quick_atan2(d.x, -d.z) * static_cast<float>(0.5 / kPi);
    const float level = std::sqrt(d.x * d.x + d.z * d.z);
    const float v = quick_atan2(level, d.y) * static_cast<float>(1.0 / kPi);
    const float x = u * static_cast<float>(map.width) + 0.5f;  // plus 1: stays positive
    const float y = std::clamp(v * static_cast<float>(map.height) - 0.5f, 0.0f,
                               static_cast<float>(map.height - 1));
    const int x0 = static_cast<int>(x);
    const int row = static_cast<int>(y);
    const int column = x0 == 0 ? map.width - 1 : std::min(x0 - 1, map.width - 1);
    const int next = column + 1 == map.width ? 0 : column + 1;
    const int below = std::min(row + 1, map.height - 1);
    const float a = x - static_cast<float>(x0);
    const float b = y - static_cast<float>(row);
    return (1 - b) * ((1 - a) * map.at(row, column) + a * map.at(row, next)) +
           b * ((1 - a) * map.at(below, column) + a * map.at(below, next));
}

// Solid angle of the rectangle from the middle of a face at distance 1 to (x, y).
double corner_solid_angle(double x, double y) {
    return std::atan2(x * y, std::sqrt(x * x + y * y + 1));
}

// The point (a, b) in [-1, 1] of a face of the cube of half side 1.
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

// The mean over a texel, samples weighted by solid angle, which goes as 1/r^3 within a face.
glm::vec3 texel_mean(const LatLong& map, int face, int row, int column, int size, int samples) {
    const float step = 2.0f / static_cast<float>(size * samples);
    const float left = (static_cast<float>(column * samples) + 0.5f) * step - 1.0f;
    const float top = (static_cast<float>(row * samples) + 0.5f) * step - 1.0f;
    glm::vec3 sum(0.0f);
    float weights = 0.0f;
    for (int j = 0; j < samples; ++j) {
        const float b = top + static_cast<float>(j) * step;
        for (int i = 0; i < samples; ++i) {
            const float a = left + static_cast<float>(i) * step;
            const float r2 = a * a + b * b + 1;
            const float weight = 1 / (r2 * std::sqrt(r2));
            sum += weight * radiance_towards(map, face_point(face, a, b));
            weights += weight;
        }
    }
    return sum / weights;
}

// Of the texels of one face, row by row.
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

CubeMap cube_from_latlong(const Image& latlong, int size) {
    LatLong map = copy_of(latlong);
    while (map.width > 5 * size && map.width % 2 == 0 && map.height % 2 == 0) map = halved(map);
    even_out_columns(map);
    // At least three and a half samples a texel of the map where the cube is coarsest, the middle
    // of a face.
    const int samples =
        std::clamp(static_cast<int>(std::ceil(3.5 * map.width / (kPi * size))), 4, 16);
    CubeMap cube;
    cube.size = size;
    cube.texels.resize(texel_count(size));
    const std::size_t rows = 6 * static_cast<std::size_t>(size);
    parallel_for(rows, 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t line = begin; line < end; ++line) {
            const int face = static_cast<int>(line) / size;
            const int row = static_cast<int>(line) % size;
            for (int column = 0; column < size; ++column) {
                cube.texels[line * static_cast<std::size_t>(size) +
                            static_cast<std::size_t>(column)] =
                    texel_mean(map, face, row, column, size, samples);
            }
        }
    });
    return cube;
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

}  // namespace burnish
