// What a file that is put onto materials takes back of what was set before.
//
// Threads: functions may be called from any thread.
#pragma once

#include <string>
#include <vector>

#include "burnish/parameters.hpp"

namespace burnish::viewer {

// "metal and scratch were taken back: a folder of maps is a whole material (Ctrl+Z brings them back)"; ""
// where all that was set still is. `before`, `after`: LayeredMaterials::values() of one scene, around a
// change that names a map or a material.
std::string line_of_taken_back(const std::vector<ParameterValues>& before,
                               const std::vector<ParameterValues>& after);

}  // namespace burnish::viewer
