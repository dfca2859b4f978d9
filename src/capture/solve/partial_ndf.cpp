#include "capture/solve/partial_ndf.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "capture/solve/push_pull.hpp"

namespace burnish {

namespace {

// Grid of the directions and cells for areas, which vary slowly. docs/theory/capture-model.md has
// the error.
constexpr NdfGrid kCoarse = {8, 24};
// Upper bound of the rounds that solve for D and its areas alternately.
constexpr int kMostRounds = 10;
// Largest change of an area, at most 1, at which the rounds end.
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

Vec3f reflected(const Vec3f& o, const Vec3f& h) {
    const float twice = 2.0f * dot(o, h);
    return {twice * h[0] - o[0], twice * h[1] - o[1], twice * h[2] - o[2]};
}

// Side of the picture of half vectors in pixels. The distance from its center is theta, so that
// gaps between samples have about equal widths everywhere.
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
    : grid_(grid),
      fresnel_(eta),
      side_(side_for(spacing_rad)),
      cell_direction_(directions_of(grid)) {
    const float scale = static_cast<float>(side_) / std::numbers::pi_v<float>;
    std::vector<float> block(static_cast<std::size_t>(kCoarse.cells()), 0.0f);
    for (int r = 0; r < grid.rings; ++r)
        for (int c = 0; c < grid.azimuths; ++c) {
            const float theta = grid.theta(r), phi = azimuth(grid, c);
            cell_x_.push_back(0.5f * static_cast<float>(side_) + scale * theta * std::cos(phi));
            cell_y_.push_back(0.5f * static_cast<float>(side_) + scale * theta * std::sin(phi));
            const auto share = static_cast<float>(grid.solid_angle(r));
            cell_mass_.push_back(std::cos(theta) * share);
            // The center of a coarse column lies on a fine column.
            const int half = grid.azimuths / kCoarse.azimuths / 2;
            const int cc = ((c + half) % grid.azimuths) * kCoarse.azimuths / grid.azimuths;
            cell_block_.push_back(
                static_cast<std::size_t>(r * kCoarse.rings / grid.rings * kCoarse.azimuths + cc));
            cell_share_.push_back(share);
            block[cell_block_.back()] += share;
        }
    for (std::size_t i = 0; i < cell_share_.size(); ++i) cell_share_[i] /= block[cell_block_[i]];
    const std::vector<Vec3f> coarse = directions_of(kCoarse);
    for (std::size_t h = 0; h < coarse.size(); ++h) {
        const auto ring = static_cast<int>(h) / kCoarse.azimuths;
        for (const Vec3f& k : coarse)
            area_kernel_.push_back(std::max(dot(k, coarse[h]), 0.0f) *
                                   static_cast<float>(kCoarse.solid_angle(ring)));
    }
    for (const Vec3f& k : coarse) least_area_.push_back(k[2]);
}

void PartialNdfSolver::splat(const PointSamples& samples, float low, PartialNdfWork& work) const {
    PushPullImage& image = work.image_;
    fresnel_.of(samples.cosine_ih, work.fresnel_);
    image.clear(side_);
    const float middle = 0.5f * static_cast<float>(side_);
    const float scale = static_cast<float>(side_) / std::numbers::pi_v<float>;
    for (std::size_t q = 0; q < samples.size(); ++q) {
        const float rho = samples.value[q] / samples.received[q] - low;
        const GridPlace& place = samples.half[q];
        const float theta = grid_.theta(static_cast<float>(place.ring) + place.fraction);
        const float phi =
            place.column * 2.0f * std::numbers::pi_v<float> / static_cast<float>(grid_.azimuths);
        image.splat(middle + scale * theta * std::cos(phi), middle + scale * theta * std::sin(phi),
                    4.0f * std::max(rho, 0.0f) / work.fresnel_[q]);
    }
    push_pull(image, 2);
}

// Reads the cells of the polar grid from the picture; the weight of a cell is interpolated from the
// pixels around it.
void PartialNdfSolver::read_cells(const PointSamples& samples, PartialNdfWork& work,
                                  float* weights) const {
    const auto side = static_cast<std::size_t>(side_);
    const float last = static_cast<float>(side_) - 1.001f;
    work.known_.clear();
    for (std::size_t i = 0; i < cell_direction_.size(); ++i) {
        const Vec3f in = reflected(samples.to_eye, cell_direction_[i]);
        if (in[2] < kLeastLightCosine) continue;
        const float x = std::clamp(cell_x_[i] - 0.5f, 0.0f, last);
        const float y = std::clamp(cell_y_[i] - 0.5f, 0.0f, last);
        const auto x0 = static_cast<std::size_t>(x), y0 = static_cast<std::size_t>(y);
        const float tx = x - static_cast<float>(x0), ty = y - static_cast<float>(y0);
        float sum = 0.0f, total = 0.0f;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t at = (y0 + (k >> 1)) * side + x0 + (k & 1);
            const float w = ((k & 1) ? tx : 1.0f - tx) * ((k >> 1) ? ty : 1.0f - ty) *
                            std::min(work.image_.weight[at], 1.0f);
            sum += w * work.image_.value[at];
            total += w;
        }
        if (total < 0.25f) continue;
        weights[i] = std::min(total, 1.0f);
        work.known_.push_back({i, sum / total, grid_place(kCoarse, in[0], in[1], in[2])});
    }
}

// Computes g of the coarse directions from means over blocks of cells; unknown cells count as 0.
float PartialNdfSolver::next_areas(const float* table, PartialNdfWork& work) const {
    work.coarse_.assign(least_area_.size(), 0.0f);
    for (const auto& cell : work.known_)
        work.coarse_[cell_block_[cell.index]] += cell_share_[cell.index] * table[cell.index];
    work.next_.assign(least_area_.size(), 0.0f);
    for (std::size_t h = 0; h < work.coarse_.size(); ++h) {
        const float* kernel = area_kernel_.data() + h * work.next_.size();
        const float d = work.coarse_[h];
        if (d <= 0.0f) continue;
        for (std::size_t k = 0; k < work.next_.size(); ++k) work.next_[k] += kernel[k] * d;
    }
    float change = 0.0f;
    for (std::size_t k = 0; k < work.next_.size(); ++k) {
        // g(k) >= k_z holds for a complete distribution; a partial D can violate it.
        work.next_[k] = std::max(work.next_[k], least_area_[k]);
        change = std::max(change, std::abs(work.next_[k] - work.areas_[k]));
    }
    work.areas_.swap(work.next_);
    return change;
}

PartialNdf PartialNdfSolver::solve(const PointSamples& samples, PartialNdfWork& work, float* table,
                                   float* weights) const {
    PartialNdf result;
    std::fill_n(table, cell_direction_.size(), 0.0f);
    std::fill_n(weights, cell_direction_.size(), 0.0f);
    if (samples.size() == 0) return result;
    const float low = low_percentile(samples, kDiffuseShare);
    result.diffuse = low * std::numbers::pi_v<float>;
    splat(samples, low, work);
    read_cells(samples, work, weights);

    // The areas g of both directions depend on D. D and g are solved for alternately, starting
    // without shadowing, g(k) = k_z.
    const GridPlace out =
        grid_place(kCoarse, samples.to_eye[0], samples.to_eye[1], samples.to_eye[2]);
    work.areas_ = least_area_;
    for (result.rounds = 0; result.rounds < kMostRounds; ++result.rounds) {
        const float area_out = lookup(kCoarse, work.areas_.data(), out, 0.0f);
        float mass = 0.0f;
        for (const auto& cell : work.known_) {
            table[cell.index] =
                cell.base * lookup(kCoarse, work.areas_.data(), cell.in, 0.0f) * area_out;
            mass += table[cell.index] * cell_mass_[cell.index];
        }
        result.specular = mass;
        if (mass <= 0.0f) break;
        for (const auto& cell : work.known_) table[cell.index] /= mass;
        if (next_areas(table, work) < kTolerance) break;
    }
    return result;
}

}  // namespace burnish
