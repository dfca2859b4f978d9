// What a folder is that was given where another thing is expected, and which flag takes it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace burnish {

// The folders in `folder` that hold maps, or are ones of Burnish's, by their names.
std::vector<std::string> map_folders_in(const std::string& folder);

// "; did you mean \"wood/textures\"?" where `folder` has such folders in it; else empty.
std::string inner_folder_hint(const std::string& folder);

// "a folder of burnish weave (--maps takes it)"
std::string folder_hint(const std::string& folder);

// Throws UsageError "<parameter>: expected <expected>, found <the folder, and what takes it>" where
// `name` is a folder.
void refuse_folder(std::string_view parameter, std::string_view expected, const std::string& name);

}  // namespace burnish
