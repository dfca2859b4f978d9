// Scratch maps as textures of a scene's materials: `--scratch`, `--scratch-direction`.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// Texels a side of a preset engraved for rendering.
inline constexpr int kScratchPresetSize = 2048;

bool is_scratch_preset(std::string_view name);

// What `scratch`, `scratch_direction` and `uv_scale` say of the materials [first, first + count),
// whose lobe is set already. Throws UsageError for a name that is neither a preset nor a folder,
// Error for a folder whose maps cannot be read.
void apply_scratch(Scene& scene, std::size_t first, std::size_t count,
                   const ParameterValues& values);

// Whether a texture was made by apply_scratch: it repeats with the normal map.
bool is_scratch_texture(const Texture& texture);

}  // namespace burnish
