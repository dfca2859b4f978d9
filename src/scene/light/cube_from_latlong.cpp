#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec4.hpp>

#include "core/constants.hpp"
#include "core/parallel.hpp"
#include "scene/light/cube_map.hpp"

namespace burnish {
namespace {

// A fourth number beside every radiance, so that a texel fills one register.
struct LatLong {
    int width = 0;
    int height = 0;
    std::vector<glm::vec4> texels;  // row, column; w is 0

    const glm::vec4* row(int y) const {
        return texels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }
    glm::vec4* row(int y) {
        return texels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
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
            map.texels.emplace_back(usable(p[0]), usable(p[step]), usable(p[2 * step]), 0.0f);
        }
    }
    return map;
}

// Halves the width and height. The two rows of a pair are weighted by their solid angles, which
// preserves the integral over the sphere.
LatLong halved(const LatLong& map) {
    LatLong half;
    half.width = map.width / 2;
    half.height = map.height / 2;
    half.texels.resize(static_cast<std::size_t>(half.width) *
                       static_cast<std::size_t>(half.height));
    const double step = kPi / map.height;
    parallel_for(static_cast<std::size_t>(half.height), 8, [&](std::size_t begin, std::size_t end) {
        for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
            const double top = std::sin((2 * row + 0.5) * step);
            const double bottom = std::sin((2 * row + 1.5) * step);
            const auto w = static_cast<float>(0.5 * top / (top + bottom));
            const glm::vec4* upper = map.row(2 * row);
            const glm::vec4* lower = map.row(2 * row + 1);
            glm::vec4* texels = half.row(row);
            for (int x = 0; x < half.width; ++x) {
                texels[x] = w * (upper[2 * x] + upper[2 * x + 1]) +
                            (0.5f - w) * (lower[2 * x] + lower[2 * x + 1]);
            }
        }
    });
    return half;
}

// The mean of each texel and `reach` neighbors on each side, around the row; `sums` is scratch.
void average_row(glm::vec4* texels, int width, int reach, std::vector<glm::dvec4>& sums) {
    sums.resize(static_cast<std::size_t>(width) * 3 + 1);
    for (int x = 0; x < 3 * width; ++x) {  // three periods: no index wraps below
        sums[static_cast<std::size_t>(x) + 1] =
            sums[static_cast<std::size_t>(x)] + glm::dvec4(texels[x % width]);
    }
    for (int x = 0; x < width; ++x) {
        const auto middle = static_cast<std::size_t>(x + width);
        const auto r = static_cast<std::size_t>(reach);
        texels[x] = glm::vec4((sums[middle + r + 1] - sums[middle - r]) / (2.0 * reach + 1));
    }
}

// Columns converge towards the poles. Each row is averaged twice over as many columns as span one
// column at the equator. The lost detail is finer than the cube, and no sun is too narrow for the
// samples.
void even_out_columns(LatLong& map) {
    parallel_for(static_cast<std::size_t>(map.height), 8, [&](std::size_t begin, std::size_t end) {
        std::vector<glm::dvec4> sums;
        for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
            const double sine = std::sin((row + 0.5) * kPi / map.height);
            const int reach = std::min(static_cast<int>(0.5 / sine), (map.width - 1) / 2);
            if (reach == 0) continue;
            average_row(map.row(row), map.width, reach, sums);
            average_row(map.row(row), map.width, reach, sums);
        }
    });
}

// atan2(y, x) within 1e-6 rad, several times as fast as the library's: the interpolating polynomial
// of degree 13 of atan on [0, 1] at Chebyshev nodes, and three reflections.
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

// Two neighboring rows or columns of the map, and the weight of the second.
struct Pair {
    int first;
    int second;
    float share;
};

// The columns at an azimuth about +y from -z, in [-2 pi, 2 pi]; columns wrap around.
Pair columns_at(const LatLong& map, float azimuth) {
    float u = 0.5f + azimuth * static_cast<float>(0.5 / kPi);
    u -= std::floor(u);
    const float x = u * static_cast<float>(map.width) + 0.5f;  // plus 1: stays positive
    const int x0 = static_cast<int>(x);
    const int column = x0 == 0 ? map.width - 1 : std::min(x0 - 1, map.width - 1);
    return {column, column + 1 == map.width ? 0 : column + 1, x - static_cast<float>(x0)};
}

// The rows at an angle from +y in [0, pi]; rows end at the poles.
Pair rows_at(const LatLong& map, float polar) {
    const float y =
        std::clamp(polar * static_cast<float>(1.0 / kPi) * static_cast<float>(map.height) - 0.5f,
                   0.0f, static_cast<float>(map.height - 1));
    const int row = static_cast<int>(y);
    return {row, std::min(row + 1, map.height - 1), y - static_cast<float>(row)};
}

glm::vec4 bilinear(const LatLong& map, const Pair& rows, const Pair& columns) {
    const glm::vec4* upper = map.row(rows.first);
    const glm::vec4* lower = map.row(rows.second);
    return (1 - rows.share) * ((1 - columns.share) * upper[columns.first] +
                               columns.share * upper[columns.second]) +
           rows.share *
               ((1 - columns.share) * lower[columns.first] + columns.share * lower[columns.second]);
}

// The samples of a face lie on a grid of `side` by `side` points in [-1, 1]^2, `per_texel` along
// each edge of a texel. A sample is weighted by its solid angle, proportional to 1/r^3 within a
// face.
struct FaceGrid {
    int size;       // texels along an edge of the face
    int per_texel;  // samples along an edge of a texel

    int side() const { return size * per_texel; }
    float place(int i) const {
        const float step = 2.0f / static_cast<float>(side());
        return (static_cast<float>(i) + 0.5f) * step - 1.0f;
    }
    static float weight(float a, float b) {
        const float r2 = a * a + b * b + 1;
        return 1 / (r2 * std::sqrt(r2));
    }
    int first_texel(int face, int row) const { return (face * size + row) * size; }
};

// The four faces about +y in OpenGL's order are 0, 1, 4 and 5. The sample (a, b) of each has the
// azimuth of the face's middle less atan(a), and the polar angle atan2(sqrt(a^2 + 1), -b). So rows
// of the map are looked up once for four faces, and columns once for a column of samples.
constexpr std::array<int, 4> kSideFaces = {0, 1, 4, 5};
constexpr std::array<double, 4> kMiddleAzimuths = {0.5 * kPi, -0.5 * kPi, kPi, 0.0};

using SideColumns = std::array<std::vector<Pair>, 4>;

SideColumns side_columns(const LatLong& map, const FaceGrid& grid) {
    SideColumns columns;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        columns[k].reserve(static_cast<std::size_t>(grid.side()));
        for (int i = 0; i < grid.side(); ++i) {
            const float offset = quick_atan2(grid.place(i), 1.0f);
            columns[k].push_back(columns_at(map, static_cast<float>(kMiddleAzimuths[k]) - offset));
        }
    }
    return columns;
}

// Fills one row of texels of all four side faces.
void fill_side_row(const LatLong& map, const FaceGrid& grid, const SideColumns& columns, int row,
                   CubeMap& cube) {
    for (int column = 0; column < grid.size; ++column) {
        std::array<glm::vec4, 4> sums{};
        float weights = 0.0f;
        for (int j = row * grid.per_texel; j < (row + 1) * grid.per_texel; ++j) {
            const float b = grid.place(j);
            for (int i = column * grid.per_texel; i < (column + 1) * grid.per_texel; ++i) {
                const float a = grid.place(i);
                const Pair rows = rows_at(map, quick_atan2(std::sqrt(a * a + 1), -b));
                const float weight = FaceGrid::weight(a, b);
                for (std::size_t k = 0; k < sums.size(); ++k) {
                    sums[k] +=
                        weight * bilinear(map, rows, columns[k][static_cast<std::size_t>(i)]);
                }
                weights += weight;
            }
        }
        for (std::size_t k = 0; k < sums.size(); ++k) {
            const int texel = grid.first_texel(kSideFaces[k], row) + column;
            cube.texels[static_cast<std::size_t>(texel)] = glm::vec3(sums[k]) / weights;
        }
    }
}

// Fills one row of texels of the face +y and the mirrored row of the face -y. The sample (a, b) of
// one and (a, -b) of the other have the same azimuth atan2(a, -b), and polar angles that add up to
// pi.
void fill_cap_rows(const LatLong& map, const FaceGrid& grid, int row, CubeMap& cube) {
    for (int column = 0; column < grid.size; ++column) {
        glm::vec4 top(0.0f);
        glm::vec4 bottom(0.0f);
        float weights = 0.0f;
        for (int j = row * grid.per_texel; j < (row + 1) * grid.per_texel; ++j) {
            const float b = grid.place(j);
            for (int i = column * grid.per_texel; i < (column + 1) * grid.per_texel; ++i) {
                const float a = grid.place(i);
                const float polar = quick_atan2(std::sqrt(a * a + b * b), 1.0f);
                const Pair columns = columns_at(map, quick_atan2(a, -b));
                const float weight = FaceGrid::weight(a, b);
                top += weight * bilinear(map, rows_at(map, polar), columns);
                bottom +=
                    weight * bilinear(map, rows_at(map, static_cast<float>(kPi) - polar), columns);
                weights += weight;
            }
        }
        const int above = grid.first_texel(2, row) + column;
        const int below = grid.first_texel(3, grid.size - 1 - row) + column;
        cube.texels[static_cast<std::size_t>(above)] = glm::vec3(top) / weights;
        cube.texels[static_cast<std::size_t>(below)] = glm::vec3(bottom) / weights;
    }
}

}  // namespace

CubeMap cube_from_latlong(const Image& latlong, int size) {
    LatLong map = copy_of(latlong);
    while (map.width > 5 * size && map.width % 2 == 0 && map.height % 2 == 0) map = halved(map);
    even_out_columns(map);
    // At least 3.5 samples per texel of the map in the middle of a face, where the cube is
    // coarsest.
    const FaceGrid grid{
        size, std::clamp(static_cast<int>(std::ceil(3.5 * map.width / (kPi * size))), 4, 16)};
    const SideColumns columns = side_columns(map, grid);
    CubeMap cube;
    cube.size = size;
    cube.texels.resize(6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    parallel_for(static_cast<std::size_t>(size), 8, [&](std::size_t begin, std::size_t end) {
        for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
            fill_side_row(map, grid, columns, row, cube);
            fill_cap_rows(map, grid, row, cube);
        }
    });
    return cube;
}

}  // namespace burnish
