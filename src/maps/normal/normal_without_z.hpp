// Normal maps of three channels that hold x and y alone, as they are packed for graphics cards: blue
// is 0, or the same everywhere.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "burnish/image.hpp"

namespace burnish {

// The map with its red and green alone: z is then what is left of 1 wherever two-channel maps are
// drawn. Nothing when blue varies, when red and green do not, and when blue is the z of every
// normal up to rounding (a map of shallow relief whose blue is 255 throughout). Black texels, the
// padding between charts, do not count.
std::optional<Texture> normal_map_without_z(const Texture& map);

// One line for the user: what was seen and what is drawn.
std::string normal_without_z_warning(std::string_view name);

}  // namespace burnish
