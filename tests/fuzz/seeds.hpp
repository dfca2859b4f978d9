// Where every fuzz run starts: small sound inputs of each reader, and the words of its format.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace burnish::fuzz {

using Words = std::vector<std::string>;

// Contents of files.
Words gltf_seeds();
Words image_seeds();
Words rig_seeds();
Words tabulated_seeds();

// What their formats are made of.
Words image_words();
Words rig_words();
Words tabulated_words();

}  // namespace burnish::fuzz
