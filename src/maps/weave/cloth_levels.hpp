// Coverage and color of each family of yarns of a cloth, as a chain of halved images. Pure;
// thread-safe.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "burnish/draft.hpp"

namespace burnish {

// One level. A texel holds rgb color times coverage, and the coverage: the fraction of the area on
// which the family is visible.
struct ClothLevel {
    int width = 0, height = 0;
    std::vector<glm::vec4> weft, warp;
};

// Level 0 has one texel per cell of the draft, the last level a single texel. Each level averages
// the previous one over areas, for any size, so that all have the same mean. `warp_from_draft`: the
// draft's colors replace `warp_color`; likewise for the weft.
std::vector<ClothLevel> cloth_levels(const Draft& draft, float gap, glm::vec3 warp_color,
                                     glm::vec3 weft_color, bool warp_from_draft,
                                     bool weft_from_draft);

}  // namespace burnish
