// Where and in which color each family of yarns of a cloth shows, as a chain of halved images.
// Pure; thread-safe.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "burnish/draft.hpp"

namespace burnish {

// One level. A texel holds rgb color times share, and the share: that of the area on which the
// family shows.
struct ClothLevel {
    int width = 0, height = 0;
    std::vector<glm::vec4> weft, warp;
};

// Level 0 has a texel a cell of the draft, the last level a single texel. Each level is the one
// before averaged over areas, whatever its size, so that all have the same mean. `warp_from_draft`:
// the draft's colors in place of `warp_color`; the weft likewise.
std::vector<ClothLevel> cloth_levels(const Draft& draft, float gap, glm::vec3 warp_color,
                                     glm::vec3 weft_color, bool warp_from_draft,
                                     bool weft_from_draft);

}  // namespace burnish
