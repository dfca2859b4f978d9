// Woven cloth as the surface of a scene's materials: `--weave` and what belongs to it.
#pragma once

#include <cstddef>
#include <string_view>

#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// A built-in draft, or "none": not a file.
bool is_weave_name(std::string_view name);

// What `weave`, `weave_...`, `warp_color` and `weft_color` say of the materials [first, first +
// count), whose lobe and colour are set already. A new cloth is no metal and its fibres reflect as
// kClothAlpha, unless the values say otherwise. Throws UsageError for a name that is neither a
// draft nor a file and for numbers of cloth where there is none, Error for a file that cannot be
// read.
void apply_cloth(Scene& scene, std::size_t first, std::size_t count, const ParameterValues& values);

// Along and across the fibres.
inline constexpr glm::vec2 kClothAlpha{0.2f, 0.45f};

}  // namespace burnish
