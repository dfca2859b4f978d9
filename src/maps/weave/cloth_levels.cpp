#include "maps/weave/cloth_levels.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <utility>

#include "burnish/f32.hpp"
#include "core/index_of.hpp"

namespace burnish {
namespace {

// The mean over [low, high] of piecewise constant values on unit intervals: partial weights for the
// first and the last.
template <typename Value>
glm::vec4 mean_over(float low, float high, int count, Value value) {
    glm::vec4 sum(0.0f);
    for (int i = std::max(static_cast<int>(low), 0);
         i < std::min(static_cast<int>(std::ceil(high)), count); ++i) {
        const float part =
            std::min(high, static_cast<float>(i + 1)) - std::max(low, static_cast<float>(i));
        sum += value(i) * std::max(part, 0.0f);
    }
    return sum / (high - low);
}

std::vector<glm::vec4> reduced(const std::vector<glm::vec4>& from, int width, int height,
                               int to_width, int to_height) {
    const auto span = [](int i, int count, int of) {
        const float each = static_cast<float>(of) / static_cast<float>(count);
        return glm::vec2(each * static_cast<float>(i), each * static_cast<float>(i + 1));
    };
    std::vector<glm::vec4> rows(index_of(to_width) * index_of(height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < to_width; ++x) {
            const glm::vec2 s = span(x, to_width, width);
            rows[index_of(y) * index_of(to_width) + index_of(x)] =
                mean_over(s.x, s.y, width,
                          [&](int i) { return from[index_of(y) * index_of(width) + index_of(i)]; });
        }
    }
    std::vector<glm::vec4> to(index_of(to_width) * index_of(to_height));
    for (int y = 0; y < to_height; ++y) {
        for (int x = 0; x < to_width; ++x) {
            const glm::vec2 s = span(y, to_height, height);
            to[index_of(y) * index_of(to_width) + index_of(x)] = mean_over(
                s.x, s.y, height,
                [&](int i) { return rows[index_of(i) * index_of(to_width) + index_of(x)]; });
        }
    }
    return to;
}

}  // namespace

std::vector<ClothLevel> cloth_levels(const Draft& draft, float gap, glm::vec3 warp_color,
                                     glm::vec3 weft_color, bool warp_from_draft,
                                     bool weft_from_draft) {
    ClothLevel first;
    first.width = draft.ends;
    first.height = draft.picks;
    for (int pick = 0; pick < draft.picks; ++pick) {
        for (int end = 0; end < draft.ends; ++end) {
            const bool up = draft.is_warp_up(end, pick);
            const float upper = f32::weave_upper_share(gap), lower = f32::weave_lower_share(gap);
            const glm::vec3 warp = warp_from_draft ? draft.warp_colors[index_of(end)] : warp_color;
            const glm::vec3 weft = weft_from_draft ? draft.weft_colors[index_of(pick)] : weft_color;
            first.warp.push_back(glm::vec4(warp, 1.0f) * (up ? upper : lower));
            first.weft.push_back(glm::vec4(weft, 1.0f) * (up ? lower : upper));
        }
    }
    std::vector<ClothLevel> levels{std::move(first)};
    while (levels.back().width > 1 || levels.back().height > 1) {
        const ClothLevel& last = levels.back();
        ClothLevel next;
        next.width = std::max(last.width / 2, 1);
        next.height = std::max(last.height / 2, 1);
        next.warp = reduced(last.warp, last.width, last.height, next.width, next.height);
        next.weft = reduced(last.weft, last.width, last.height, next.width, next.height);
        levels.push_back(std::move(next));
    }
    return levels;
}

}  // namespace burnish
