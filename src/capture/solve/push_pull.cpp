#include "capture/solve/push_pull.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace burnish {

namespace {

std::size_t index(int side, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
           static_cast<std::size_t>(x);
}

// The weight of a pixel counts as 1 at most, however many samples it holds, so that a crowded pixel
// does not decide the value of its empty neighbors (Gortler et al.: w~ = min(w, 1)).
PushPullImage pulled(const PushPullImage& fine) {
    PushPullImage coarse(fine.side / 2);
    for (int y = 0; y < coarse.side; ++y)
        for (int x = 0; x < coarse.side; ++x) {
            float sum = 0.0f, weights = 0.0f;
            for (int k = 0; k < 4; ++k) {
                const std::size_t from = index(fine.side, 2 * x + (k & 1), 2 * y + (k >> 1));
                const float w = std::min(fine.weight[from], 1.0f);
                sum += w * fine.value[from];
                weights += w;
            }
            const std::size_t to = index(coarse.side, x, y);
            coarse.weight[to] = std::min(weights, 1.0f);
            coarse.value[to] = weights > 0.0f ? sum / weights : 0.0f;
        }
    return coarse;
}

// Columns [first, last) of a row that hold samples; none if first >= last.
struct Extent {
    int first, last;
};

Extent extent_of(const PushPullImage& image, int y) {
    const auto row = image.weight.begin() + static_cast<std::ptrdiff_t>(index(image.side, 0, y));
    const auto holds = [](float w) { return w > 0.0f; };
    const auto first = std::find_if(row, row + image.side, holds);
    if (first == row + image.side) return {image.side, 0};
    auto last = row + image.side;
    while (last != first && !holds(*(last - 1))) --last;
    return {static_cast<int>(first - row), static_cast<int>(last - row)};
}

// Bilinear from the coarse level: weight 9/16 for the nearest pixel, 3/16, 3/16 and 1/16 for its
// neighbors.
void push(const PushPullImage& coarse, PushPullImage& fine) {
    std::vector<Extent> extents;
    extents.reserve(static_cast<std::size_t>(coarse.side));
    for (int y = 0; y < coarse.side; ++y) extents.push_back(extent_of(coarse, y));
    for (int y = 0; y < fine.side; ++y) {
        const int cy = y / 2, ny = std::clamp(cy + ((y & 1) ? 1 : -1), 0, coarse.side - 1);
        // If both coarse rows are empty, this row stays empty.
        const Extent a = extents[static_cast<std::size_t>(cy)];
        const Extent b = extents[static_cast<std::size_t>(ny)];
        const int first = std::max(2 * std::min(a.first, b.first) - 1, 0);
        const int last = std::min(2 * std::max(a.last, b.last) + 1, fine.side);
        for (int x = first; x < last; ++x) {
            const std::size_t to = index(fine.side, x, y);
            const float own = std::min(fine.weight[to], 1.0f);
            fine.weight[to] = own;
            if (own >= 1.0f) continue;
            const int cx = x / 2;
            const int nx = std::clamp(cx + ((x & 1) ? 1 : -1), 0, coarse.side - 1);
            float sum = 0.0f, weights = 0.0f;
            const auto take = [&](int px, int py, float share) {
                const std::size_t from = index(coarse.side, px, py);
                const float w = share * coarse.weight[from];
                sum += w * coarse.value[from];
                weights += w;
            };
            take(cx, cy, 9.0f);
            take(nx, cy, 3.0f);
            take(cx, ny, 3.0f);
            take(nx, ny, 1.0f);
            if (weights <= 0.0f) continue;
            const float filled = sum / weights;
            fine.value[to] = own * fine.value[to] + (1.0f - own) * filled;
            fine.weight[to] = own + (1.0f - own) * std::min(weights / 16.0f, 1.0f);
        }
    }
}

}  // namespace

PushPullImage::PushPullImage(int side_) {
    clear(side_);
}

void PushPullImage::clear(int side_) {
    side = side_;
    value.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), 0.0f);
    weight.assign(value.size(), 0.0f);
}

void PushPullImage::splat(float x, float y, float sample) {
    const float fx = x - 0.5f, fy = y - 0.5f;
    const int x0 = static_cast<int>(std::floor(fx)), y0 = static_cast<int>(std::floor(fy));
    const float tx = fx - static_cast<float>(x0), ty = fy - static_cast<float>(y0);
    for (int k = 0; k < 4; ++k) {
        const int px = x0 + (k & 1), py = y0 + (k >> 1);
        if (px < 0 || py < 0 || px >= side || py >= side) continue;
        const float w = ((k & 1) ? tx : 1.0f - tx) * ((k >> 1) ? ty : 1.0f - ty);
        const std::size_t to = index(side, px, py);
        // A running mean needs no normalization pass after the splats.
        const float total = weight[to] + w;
        if (total > 0.0f) value[to] += (sample - value[to]) * (w / total);
        weight[to] = total;
    }
}

void push_pull(PushPullImage& image, int reach) {
    if (reach <= 0 || image.side < 2) {
        for (float& w : image.weight) w = std::min(w, 1.0f);
        return;
    }
    PushPullImage coarse = pulled(image);
    push_pull(coarse, reach - 1);
    push(coarse, image);
}

}  // namespace burnish
