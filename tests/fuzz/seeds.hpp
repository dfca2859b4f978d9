// Where every fuzz run starts: small sound inputs of each reader, and the words of its format.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace burnish::fuzz {

// Contents of files.
std::vector<std::string> gltf_seeds();
std::vector<std::string> image_seeds();

}  // namespace burnish::fuzz
