#include "burnish/ndf_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/constants.hpp"
#include "core/index_of.hpp"
#include "core/parallel.hpp"

namespace burnish {
namespace {

// Subdivisions of a cell along u and phi for integrals of the interpolated table: fewer where cells
// are small. The number along phi is odd, so that parts lie symmetrically about the columns.
int parts_along_u(const NdfGrid& grid) {
    return std::clamp(256 / grid.rings, 1, 4);
}
int parts_along_phi(const NdfGrid& grid) {
    return grid.azimuths < 256 ? 3 : 1;
}

// The least g, which BRDFs divide by. g is not small where the table is large.
constexpr float kLeastArea = 1e-6F;

double theta_of_u(double u) {
    return u * u * (kPi / 2);
}

// Two neighboring columns on a circle of `count` columns, and the weight of the second.
struct Columns {
    int left, right;
    float t;
};

Columns columns_at(int count, float phi) {
    constexpr float kTurn = 2 * std::numbers::pi_v<float>;
    const float turns = phi / kTurn;
    const float place = (turns - std::floor(turns)) * static_cast<float>(count);
    const int left = std::min(static_cast<int>(place), count - 1);
    return {left, left + 1 == count ? 0 : left + 1, place - static_cast<float>(left)};
}

// The interpolated value; `row` is a row coordinate in [0, rows - 1].
float bilinear(const NdfGrid& grid, const float* table, float row, float phi) {
    const int low = std::min(static_cast<int>(row), std::max(grid.rings - 2, 0));
    const int high = std::min(low + 1, grid.rings - 1);
    const float t = row - static_cast<float>(low);
    const Columns c = columns_at(grid.azimuths, phi);
    const auto at = [&](int ring) {
        const float* line = table + index_of(ring) * index_of(grid.azimuths);
        return line[c.left] + (line[c.right] - line[c.left]) * c.t;
    };
    return at(low) + (at(high) - at(low)) * t;
}

// A part of a cell: its center direction, and D times its solid angle.
struct Part {
    double x, y, z, amount;
};

// Passes the parts of one ring, from u0 to u1, to `take`.
template <typename Take>
void take_ring(const NdfGrid& grid, const float* table, double u0, double u1, const Take& take) {
    const double t0 = theta_of_u(u0), t1 = theta_of_u(u1), middle = (t0 + t1) / 2;
    const int along = parts_along_phi(grid), around = grid.azimuths * along;
    // cos t0 - cos t1 and the mean cosine over the ring, without cancellation.
    const double height = 2 * std::sin(middle) * std::sin((t1 - t0) / 2);
    const double mean_z = (std::cos(t0) + std::cos(t1)) / 2;
    const double sine = std::sqrt(std::max(1 - mean_z * mean_z, 0.0));
    for (int a = 0; a < around; ++a) {
        const double phi = 2 * kPi * (a - (along - 1) / 2) / around;
        const double D = static_cast<double>(
            ndf_lookup(grid, table, static_cast<float>((u0 + u1) / 2), static_cast<float>(phi)));
        if (!(D > 0)) continue;
        take(Part{sine * std::cos(phi), sine * std::sin(phi), mean_z,
                  D * height * 2 * kPi / around});
    }
}

template <typename Take>
void take_parts(const NdfGrid& grid, const float* table, const Take& take) {
    const int rings = grid.rings * parts_along_u(grid);
    for (int r = 0; r < rings; ++r)
        take_ring(grid, table, static_cast<double>(r) / rings, static_cast<double>(r + 1) / rings,
                  take);
}

}  // namespace

float NdfGrid::theta(double ring) const {
    return static_cast<float>(theta_of_u((ring + 0.5) / rings));
}

double NdfGrid::solid_angle(int ring) const {
    const double t0 = theta_of_u(static_cast<double>(ring) / rings);
    const double t1 = theta_of_u(static_cast<double>(ring + 1) / rings);
    return 2 * std::sin((t0 + t1) / 2) * std::sin((t1 - t0) / 2) * 2 * kPi / azimuths;
}

float ndf_u(float z) {
    const double theta = std::acos(std::clamp(static_cast<double>(z), 0.0, 1.0));
    return static_cast<float>(std::sqrt(theta * (2 / kPi)));
}

float ndf_lookup(const NdfGrid& grid, const float* table, float u, float phi) {
    const float row = u * static_cast<float>(grid.rings) - 0.5F;
    return bilinear(grid, table, std::clamp(row, 0.0F, static_cast<float>(grid.rings - 1)), phi);
}

double ndf_mass(const NdfGrid& grid, const float* table) {
    double sum = 0;
    take_parts(grid, table, [&](const Part& part) { sum += part.amount * part.z; });
    return sum;
}

std::vector<float> ndf_areas(const NdfGrid& grid, const float* table, const NdfGrid& seen) {
    std::vector<Part> parts;
    take_parts(grid, table, [&](const Part& part) { parts.push_back(part); });
    std::vector<float> areas(index_of(seen.cells()));
    parallel_for(areas.size(), index_of(seen.azimuths), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double s = static_cast<double>(i / index_of(seen.azimuths)) / (seen.rings - 1);
            const double theta = (1 - s * s) * (kPi / 2);
            const double phi =
                2 * kPi * static_cast<double>(i % index_of(seen.azimuths)) / seen.azimuths;
            const double x = std::sin(theta) * std::cos(phi), y = std::sin(theta) * std::sin(phi);
            const double z = std::cos(theta);
            double sum = 0;
            for (const Part& p : parts)
                sum += std::max(x * p.x + y * p.y + z * p.z, 0.0) * p.amount;
            areas[i] = static_cast<float>(sum - z);
        }
    });
    return areas;
}

float ndf_area_lookup(const float* areas, float x, float y, float z, const NdfGrid& seen) {
    constexpr float kHalfTurn = std::numbers::pi_v<float> / 2;
    const float theta = std::atan2(std::sqrt(x * x + y * y), z);
    const float s = std::sqrt(std::clamp(1 - theta / kHalfTurn, 0.0F, 1.0F));
    const float row = s * static_cast<float>(seen.rings - 1);
    return std::max(z + bilinear(seen, areas, row, std::atan2(y, x)), kLeastArea);
}

}  // namespace burnish
