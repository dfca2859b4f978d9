// What a folder is that was given where another thing is expected, and which flag takes it.
#pragma once

#include <string>
#include <string_view>

namespace burnish {

// "a folder of burnish weave (--maps takes it)"
std::string folder_hint(const std::string& folder);

// Throws UsageError "<parameter>: expected <expected>, found <the folder, and what takes it>" where
// `name` is a folder.
void refuse_folder(std::string_view parameter, std::string_view expected, const std::string& name);

}  // namespace burnish
