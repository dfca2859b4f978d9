// Functions of `burnish render` that others use; the command itself is include/burnish/render.hpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

#include "burnish/image.hpp"
#include "burnish/progress.hpp"
#include "burnish/stage.hpp"

namespace burnish {

using Metadata = std::map<std::string, std::string>;  // as write_image takes it

// "a/b.png", 7 -> "a/b_0007.png".
std::filesystem::path numbered(const std::filesystem::path& path, int number);

// What a picture of the stage says of itself, but for "burnish:device".
Metadata picture_metadata(const std::string& command, const Stage& stage);

// Writes a linear picture as the file holds it: linear, or as a display has it.
void write_picture(const std::filesystem::path& path, const Image& linear, const Stage& stage,
                   const Metadata& metadata);

// Progress of part `index` of `count` equal parts of a longer job.
Progress part_of(const Progress& whole, std::size_t index, std::size_t count);

}  // namespace burnish
