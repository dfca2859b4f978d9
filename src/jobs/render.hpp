// Functions of `burnish render` that others use; the command itself is include/burnish/render.hpp.
#pragma once

#include <filesystem>

namespace burnish {

// "a/b.png", 7 -> "a/b_0007.png".
std::filesystem::path numbered(const std::filesystem::path& path, int number);

}  // namespace burnish
