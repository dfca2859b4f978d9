#include "rays/near_points.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace burnish {
namespace {

constexpr float kLeastCosine = 0.9f;
constexpr std::uint32_t kMostOfCell = 8;  // points that are looked at
constexpr std::size_t kMostFound = 64;
// The weight of a corner beyond the radius.
constexpr float kFarWeight = 0.25f;

}  // namespace

NearPoints::NearPoints(const SampleMesh& mesh, const SampleMesh::Fans& fans, float radius)
    : mesh_(mesh), fans_(fans), radius_(std::max(radius, 1e-20f)), points_(mesh.points()) {
    std::vector<std::uint64_t> keys(mesh.points());
    for (std::uint32_t i = 0; i < keys.size(); ++i) keys[i] = key_of(cell_of(mesh.position(i)));
    std::iota(points_.begin(), points_.end(), 0U);
    std::ranges::stable_sort(points_, {}, [&](std::uint32_t i) { return keys[i]; });
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
        auto& range = cells_.try_emplace(keys[points_[i]], std::array{i, i}).first->second;
        range[1] = i + 1;
    }
}

NearPoints::Cell NearPoints::cell_of(const glm::vec3& position) const {
    // Clamped: coordinates that are far from the rest share a cell.
    const auto cell = [&](float x) {
        return static_cast<std::int32_t>(std::floor(std::clamp(x / radius_, -1e6f, 1e6f)));
    };
    return {cell(position.x), cell(position.y), cell(position.z)};
}

// 21 bits a coordinate.
std::uint64_t NearPoints::key_of(const Cell& cell) {
    std::uint64_t key = 0;
    for (const std::int32_t x : cell)
        key = (key << 21) | (static_cast<std::uint64_t>(x + (1 << 20)) & 0x1fffffU);
    return key;
}

void NearPoints::add_cell(std::uint32_t point, const Cell& cell, std::vector<Near>& found) const {
    const auto at = cells_.find(key_of(cell));
    if (at == cells_.end()) return;
    const auto [first, end] = at->second;
    const std::uint32_t step = std::max((end - first) / kMostOfCell, 1U);
    for (std::uint32_t i = first; i < end && found.size() < kMostFound; i += step) {
        const std::uint32_t other = points_[i];
        if (other == point || !is_parallel(point, other)) continue;
        const float distance2 = distance2_between(point, other);
        if (distance2 < 1.0f) found.push_back({other, 1.0f - distance2});
    }
}

// In coarse meshes there is nothing within the radius.
void NearPoints::add_far_corners(std::uint32_t point, std::vector<Near>& found) const {
    for (const SampleMesh::Corner& corner : fans_.of(point)) {
        const std::span<const std::uint32_t> points = mesh_.points_of(corner.mesh);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t index = 3 * static_cast<std::size_t>(corner.triangle) + k;
            const std::uint32_t other = points[mesh_.meshes()[corner.mesh].indices[index]];
            if (other == point || !is_parallel(point, other) || found.size() == kMostFound)
                continue;
            if (distance2_between(point, other) >= 1.0f) found.push_back({other, kFarWeight});
        }
    }
}

bool NearPoints::is_parallel(std::uint32_t a, std::uint32_t b) const {
    return glm::dot(mesh_.normal(a), mesh_.normal(b)) > kLeastCosine;
}

float NearPoints::distance2_between(std::uint32_t a, std::uint32_t b) const {
    const glm::vec3 d = (mesh_.position(b) - mesh_.position(a)) / radius_;
    return glm::dot(d, d);
}

void NearPoints::find(std::uint32_t point, std::vector<Near>& found) const {
    found.clear();
    const Cell cell = cell_of(mesh_.position(point));
    for (std::int32_t x = -1; x <= 1; ++x)
        for (std::int32_t y = -1; y <= 1; ++y)
            for (std::int32_t z = -1; z <= 1; ++z)
                add_cell(point, {cell[0] + x, cell[1] + y, cell[2] + z}, found);
    add_far_corners(point, found);
}

}  // namespace burnish
