// ao.png and orm.png of a height map.
#pragma once

#include <vector>

#include "burnish/image.hpp"
#include "jobs/map_folder.hpp"

namespace burnish {

// `occlusion` has one channel and must outlive the pictures. orm.png: red occlusion, green `roughness`
// (perceptual), blue `metallic`, the same everywhere.
std::vector<NamedPicture> occlusion_pictures(const Image& occlusion, float roughness,
                                             float metallic);

}  // namespace burnish
