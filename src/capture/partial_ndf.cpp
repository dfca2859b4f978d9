#include "capture/partial_ndf.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "capture/push_pull.hpp"

namespace burnish {

namespace {

// Areas vary slowly: worked out for few directions from few cells (error: docs/capture.md).
constexpr NdfGrid kCoarse = {8, 24};
constexpr int kMostRounds = 10;
constexpr float kTolerance = 1e-4f;

Vec3f direction_at(float theta, float phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

float dot(const Vec3f& a, const Vec3f& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

float azimuth(const NdfGrid& grid, int column) {
    return 2.0f * std::numbers::pi_v<float> * static_cast<float>(column) /
           static_cast<float>(grid.azimuths);
}

std::vector<Vec3f> directions_of(const NdfGrid& grid) {
    std::vector<Vec3f> out;
    for (int r = 0; r < grid.rings; ++r)
        for (int c = 0; c < grid.azimuths; ++c)
            out.push_back(direction_at(grid.theta(r), azimuth(grid, c)));
    return out;
}

// Equidistant: distance from the middle is theta, so that a gap is as wide wherever it lies.
int side_for(float spacing_rad) {
    const float pixel = 0.7f * std::clamp(spacing_rad, 0.01f, 0.3f);
    const float wanted = std::numbers::pi_v<float> / pixel;
    int side = 32;
    while (side < 128 && static_cast<float>(side) * 1.5f < wanted) side *= 2;
    return side;
}

}  // namespace

float low_percentile(const PointSamples& samples, float share) {
    if (samples.size() == 0) return 0.0f;
    std::vector<float> rho(samples.size());
    for (std::size_t q = 0; q < rho.size(); ++q) rho[q] = samples.value[q] / samples.received[q];
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<float>(rho.size() - 1));
    std::nth_element(rho.begin(), rho.begin() + at, rho.end());
    return rho[static_cast<std::size_t>(at)];
}

PartialNdfSolver::PartialNdfSolver(const NdfGrid& grid, float spacing_rad, float eta)
    : grid_(grid), eta_(eta), side_(side_for(spacing_rad)), cell_direction_(directions_of(grid)) {
    const float scale = static_cast<float>(side_) / std::numbers::pi_v<float>;
    for (int r = 0; r < grid.rings; ++r)
        for (int c = 0; c < grid.azimuths; ++c) {
            const float theta = grid.theta(r), phi = azimuth(grid, c);
            cell_x_.push_back(0.5f * static_cast<float>(side_) + scale * theta * std::cos(phi));
            cell_y_.push_back(0.5f * static_cast<float>(side_) + scale * theta * std::sin(phi));
            cell_mass_.push_back(std::cos(theta) * static_cast<float>(grid.solid_angle(r)));
        }
    const std::vector<Vec3f> coarse = directions_of(kCoarse);
    for (const Vec3f& k : coarse)
        for (std::size_t h = 0; h < coarse.size(); ++h) {
            const auto ring = static_cast<int>(h) / kCoarse.azimuths;
            area_kernel_.push_back(std::max(dot(k, coarse[h]), 0.0f) *
                                   static_cast<float>(kCoarse.solid_angle(ring)));
        }
}

namespace {

// Means over blocks of a fine grid's cells, by mass; cells without weight count as empty.
void coarsen(const NdfGrid& grid, const float* table, const float* weights,
             std::vector<float>& out) {
    out.assign(static_cast<std::size_t>(kCoarse.cells()), 0.0f);
    std::vector<float> counted(out.size(), 0.0f);
    for (int r = 0; r < grid.rings; ++r) {
        const auto share = static_cast<float>(grid.solid_angle(r));
        for (int c = 0; c < grid.azimuths; ++c) {
            // The coarse column's middle lies on a fine column.
            const int cr = r * kCoarse.rings / grid.rings;
            const int half = grid.azimuths / kCoarse.azimuths / 2;
            const int cc = ((c + half) % grid.azimuths) * kCoarse.azimuths / grid.azimuths;
            const auto to = static_cast<std::size_t>(cr * kCoarse.azimuths + cc);
            const int from = r * grid.azimuths + c;
            if (weights[from] > 0.0f) out[to] += share * table[from];
            counted[to] += share;
        }
    }
    for (std::size_t i = 0; i < out.size(); ++i) out[i] /= std::max(counted[i], 1e-20f);
}

Vec3f reflected(const Vec3f& o, const Vec3f& h) {
    const float twice = 2.0f * dot(o, h);
    return {twice * h[0] - o[0], twice * h[1] - o[1], twice * h[2] - o[2]};
}

}  // namespace

PartialNdf PartialNdfSolver::solve(const PointSamples& samples, float* table,
                                   float* weights) const {
    PartialNdf result;
    const auto cells = static_cast<std::size_t>(grid_.cells());
    std::fill_n(table, cells, 0.0f);
    std::fill_n(weights, cells, 0.0f);
    if (samples.size() == 0) return result;
    const float low = low_percentile(samples, kDiffuseShare);
    result.diffuse = low * std::numbers::pi_v<float>;

    PushPullImage image(side_);
    const float scale = static_cast<float>(side_) / std::numbers::pi_v<float>;
    for (std::size_t q = 0; q < samples.size(); ++q) {
        const float rho = samples.value[q] / samples.received[q] - low;
        const GridPlace& place = samples.half[q];
        const float theta = grid_.theta(static_cast<float>(place.ring) + place.fraction);
        const float phi =
            place.column * 2.0f * std::numbers::pi_v<float> / static_cast<float>(grid_.azimuths);
        image.splat(0.5f * static_cast<float>(side_) + scale * theta * std::cos(phi),
                    0.5f * static_cast<float>(side_) + scale * theta * std::sin(phi),
                    4.0f * std::max(rho, 0.0f) / relative_fresnel(eta_, samples.cosine_ih[q]));
    }
    push_pull(image, 2);

    // From the picture to the polar grid; a cell is known as far as the pixels about it are.
    for (std::size_t i = 0; i < cells; ++i) {
        const float x = std::clamp(cell_x_[i] - 0.5f, 0.0f, static_cast<float>(side_) - 1.001f);
        const float y = std::clamp(cell_y_[i] - 0.5f, 0.0f, static_cast<float>(side_) - 1.001f);
        const auto x0 = static_cast<std::size_t>(x), y0 = static_cast<std::size_t>(y);
        const float tx = x - static_cast<float>(x0), ty = y - static_cast<float>(y0);
        float sum = 0.0f, total = 0.0f;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t at = (y0 + (k >> 1)) * static_cast<std::size_t>(side_) + x0 + (k & 1);
            const float w = ((k & 1) ? tx : 1.0f - tx) * ((k >> 1) ? ty : 1.0f - ty) *
                            std::min(image.weight[at], 1.0f);
            sum += w * image.value[at];
            total += w;
        }
        const Vec3f i_direction = reflected(samples.to_eye, cell_direction_[i]);
        if (total < 0.25f || i_direction[2] < kLeastLightCosine) continue;
        table[i] = sum / total;
        weights[i] = std::min(total, 1.0f);
    }

    // g of both directions belongs to D: solved for in turns, on the coarse grid.
    std::vector<float> base(table, table + cells), coarse;
    std::vector<GridPlace> in(cells);
    for (std::size_t i = 0; i < cells; ++i) {
        const Vec3f d = reflected(samples.to_eye, cell_direction_[i]);
        in[i] = grid_place(kCoarse, d[0], d[1], d[2]);
    }
    const GridPlace out =
        grid_place(kCoarse, samples.to_eye[0], samples.to_eye[1], samples.to_eye[2]);
    std::vector<float> areas, before;
    for (int r = 0; r < kCoarse.rings; ++r)  // S = 1: g(k) = k_z
        for (int c = 0; c < kCoarse.azimuths; ++c) areas.push_back(std::cos(kCoarse.theta(r)));
    for (result.rounds = 0; result.rounds < kMostRounds; ++result.rounds) {
        const float area_out = lookup(kCoarse, areas.data(), out, 0.0f);
        float mass = 0.0f;
        for (std::size_t i = 0; i < cells; ++i) {
            if (weights[i] <= 0.0f) continue;
            table[i] = base[i] * lookup(kCoarse, areas.data(), in[i], 0.0f) * area_out;
            mass += table[i] * cell_mass_[i];
        }
        result.specular = mass;
        if (mass <= 0.0f) break;
        for (std::size_t i = 0; i < cells; ++i) table[i] /= mass;
        coarsen(grid_, table, weights, coarse);
        before = areas;
        float change = 0.0f;
        for (std::size_t k = 0; k < areas.size(); ++k) {
            float g = 0.0f;
            const float* kernel = area_kernel_.data() + k * coarse.size();
            for (std::size_t h = 0; h < coarse.size(); ++h) g += kernel[h] * coarse[h];
            // No facet may hide more than all do: g(k) >= k_z, which a part of D alone can miss.
            const auto ring = static_cast<float>(k / static_cast<std::size_t>(kCoarse.azimuths));
            areas[k] = std::max(g, std::cos(kCoarse.theta(ring)));
            change = std::max(change, std::abs(areas[k] - before[k]));
        }
        if (change < kTolerance) break;
    }
    return result;
}

}  // namespace burnish
