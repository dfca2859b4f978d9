#include "maps/normal/bumps.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "burnish/error.hpp"
#include "core/constants.hpp"
#include "core/parallel.hpp"

namespace burnish {

namespace {

struct Bump {
    double x, y;    // center on the unit tile
    double radius;  // in tiles
    double sign;    // +1 bump, -1 dimple
};

// Bumps in a square grid of cells, one per cell, at most half a cell away from it, so that
// evaluating a point needs only the 5 x 5 cells around its own.
struct BumpField {
    int cells;
    std::vector<Bump> bumps;  // row after row
};

struct HeightAndSlope {
    double height, dx, dy;  // height in tiles; slopes along the columns and down the rows
};

// A counter-based random number in [0,1), the same on every machine and thread. Mixing steps of
// MurmurHash3's 32-bit finalizer (Appleby, public domain).
double random_unit(std::uint32_t seed, std::uint32_t index) {
    std::uint32_t h = seed * 0x9e3779b9u + index;
    h ^= h >> 16;
    h *= 0x85ebca6bu;
    h ^= h >> 13;
    h *= 0xc2b2ae35u;
    h ^= h >> 16;
    return h * 0x1p-32;
}

double wrapped(double difference) {
    return difference - std::round(difference);
}

// The profile of a bump of unit radius and unit steepest slope. The slope q (1 - q^4) is nearly
// linear over most of the radius, as on a sphere, and falls to zero at the rim. h and h' are
// continuous at the rim.
const double kSteepest = std::pow(0.2, 0.25);  // where q - q^5 is largest
const double kSlopeScale = 1.0 / (0.8 * kSteepest);

double profile_height(double q) {
    return kSlopeScale * (1.0 / 3.0 - q * q / 2.0 + std::pow(q, 6.0) / 6.0);
}

// Sets each radius to about half the distance to the nearest neighbor, so that no two bumps
// overlap.
void set_radii(BumpField& field) {
    const int n = field.cells;
    for (int i = 0; i < n * n; ++i) {
        Bump& bump = field.bumps[static_cast<std::size_t>(i)];
        double nearest = 1.0;  // a single bump touches its copy in the next tile
        for (int j = 0; j < 25; ++j) {
            const int column = (i % n + j % 5 - 2 + 2 * n) % n;
            const int row = (i / n + j / 5 - 2 + 2 * n) % n;
            if (row * n + column == i) continue;
            const Bump& other = field.bumps[static_cast<std::size_t>(row * n + column)];
            nearest =
                std::min(nearest, std::hypot(wrapped(bump.x - other.x), wrapped(bump.y - other.y)));
        }
        // 0.48 leaves a gap of 4 % of the distance, so that the plane is visible between bumps.
        bump.radius = 0.48 * nearest;
    }
}

BumpField make_field(const BumpOptions& options) {
    BumpField field;
    field.cells = std::max(1, static_cast<int>(std::lround(std::sqrt(options.count))));
    const int n = field.cells;
    // With more than half a cell of jitter, neighbors may be so close that both become tiny.
    const double jitter = 0.5 * options.irregularity;
    for (int i = 0; i < n * n; ++i) {
        const auto index = 3u * static_cast<std::uint32_t>(i);
        // Every other row is shifted by half a cell. The tile repeats only for an even number of
        // rows.
        const double shift = n % 2 == 0 && (i / n) % 2 == 1 ? 0.25 : n % 2 == 0 ? -0.25 : 0.0;
        Bump bump{};
        bump.x = (i % n + 0.5 + shift + jitter * (random_unit(options.seed, index) - 0.5)) / n;
        bump.y = (i / n + 0.5 + jitter * (random_unit(options.seed, index + 1) - 0.5)) / n;
        bump.sign = random_unit(options.seed, index + 2) < options.dimples ? -1.0 : 1.0;
        field.bumps.push_back(bump);
    }
    set_radii(field);
    return field;
}

HeightAndSlope evaluate(const BumpField& field, double steepest, double x, double y) {
    const int n = field.cells;
    const int column = static_cast<int>(x * n), row = static_cast<int>(y * n);
    for (int j = 0; j < 9; ++j) {
        const int c = column + j % 3 - 1, r = row + j / 3 - 1;
        // A cell beyond the tile is the wrapped cell, translated by a whole tile.
        const int tile_x = c < 0 ? -1 : c >= n ? 1 : 0, tile_y = r < 0 ? -1 : r >= n ? 1 : 0;
        const int cell = (r - tile_y * n) * n + c - tile_x * n;
        const Bump& bump = field.bumps[static_cast<std::size_t>(cell)];
        const double dx = x - bump.x - tile_x, dy = y - bump.y - tile_y;
        const double squared = dx * dx + dy * dy;
        if (squared >= bump.radius * bump.radius) continue;
        const double q = std::sqrt(squared) / bump.radius;
        const double amount = bump.sign * steepest;
        // The slope divided by the distance, which needs no division by zero at the center.
        const double falling = -amount * kSlopeScale * (1.0 - q * q * q * q) / bump.radius;
        return {amount * bump.radius * profile_height(q), falling * dx, falling * dy};
    }
    return {0.0, 0.0, 0.0};
}

void check(int size, const BumpOptions& options) {
    const auto require = [](bool good, const char* key, const char* expected, double found) {
        if (!good) throw UsageError("bump map", key, expected, shown(std::to_string(found)));
    };
    require(size >= 2 && size <= 16384, "size", "2 to 16384 texels", size);
    require(options.count >= 1 && options.count <= 4096, "count", "1 to 4096", options.count);
    require(options.max_tilt_deg >= 0.0 && options.max_tilt_deg <= 80.0, "max_tilt_deg",
            "0 to 80 degrees", options.max_tilt_deg);
    require(options.irregularity >= 0.0 && options.irregularity <= 1.0, "irregularity", "0 to 1",
            options.irregularity);
    require(options.dimples >= 0.0 && options.dimples <= 1.0, "dimples", "0 to 1", options.dimples);
}

void store_normal(float* rgb, double slope_right, double slope_down) {
    const double scale = 0.5 / std::sqrt(1.0 + slope_right * slope_right + slope_down * slope_down);
    rgb[0] = static_cast<float>(0.5 - scale * slope_right);
    rgb[1] = static_cast<float>(0.5 + scale * slope_down);  // y points up the picture
    rgb[2] = static_cast<float>(0.5 + scale);
}

// Calls texel(x, y) for the whole tile, rows in parallel.
template <typename Texel>
void for_each_texel(int size, const Texel& texel) {
    parallel_for(static_cast<std::size_t>(size), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y)
            for (int x = 0; x < size; ++x) texel(x, static_cast<int>(y));
    });
}

double steepest_of(const BumpOptions& options) {
    return std::tan(options.max_tilt_deg * kDegree);
}

}  // namespace

Image bump_normal_map(int size, const BumpOptions& options) {
    check(size, options);
    const BumpField field = make_field(options);
    const double steepest = steepest_of(options);
    Image map(size, size, 3);
    for_each_texel(size, [&](int x, int y) {
        const HeightAndSlope at = evaluate(field, steepest, (x + 0.5) / size, (y + 0.5) / size);
        store_normal(map.at(x, y), at.dx, at.dy);
    });
    return map;
}

Image bump_height_map(int size, const BumpOptions& options) {
    check(size, options);
    const BumpField field = make_field(options);
    const double steepest = steepest_of(options);
    Image map(size, size, 1);
    for_each_texel(size, [&](int x, int y) {
        const HeightAndSlope at = evaluate(field, steepest, (x + 0.5) / size, (y + 0.5) / size);
        *map.at(x, y) = static_cast<float>(at.height * size);
    });
    return map;
}

Image normal_map_from_height(const Image& height, double scale) {
    if (height.empty() || height.channels != 1)
        throw Error("height map", "channels", "1", std::to_string(height.channels));
    const int w = height.width, h = height.height;
    Image map(w, h, 3);
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            const auto value = [&](int column, int row) {
                return static_cast<double>(*height.at((column + w) % w, (row + h) % h));
            };
            store_normal(map.at(x, y), 0.5 * scale * (value(x + 1, y) - value(x - 1, y)),
                         0.5 * scale * (value(x, y + 1) - value(x, y - 1)));
        }
    }
    return map;
}

}  // namespace burnish
