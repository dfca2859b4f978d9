// Names of files that hold wherever they are read from.
//
// Threads: functions may be called from any thread.
#pragma once

#include <filesystem>
#include <string>

namespace burnish::viewer {

// The folder, absolute and without symbolic links, so that ".." leads where it seems to lead.
std::filesystem::path real_folder(const std::filesystem::path& folder);

// The file or folder in its real folder, a link itself not followed; builtin:<name> and "" as they are.
std::string absolute_name(const std::string& path);

}  // namespace burnish::viewer
