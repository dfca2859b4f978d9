// Lights that a body closes in: a mistake of placement that leaves the picture dark.
#pragma once

#include <string>
#include <vector>

#include "burnish/scene.hpp"

namespace burnish {

// One line for each light with a position from where every direction meets the inner side of a surface first. Open
// shades, rooms seen from within, and bodies that blend close nothing in. Rays are traced only where there is such
// a light.
std::vector<std::string> warnings_of_closed_in_lights(const Scene& scene);

}  // namespace burnish
