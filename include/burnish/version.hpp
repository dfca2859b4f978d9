//
// Threads: any number may call these functions at a time. Lifetime: what they return is static.
#pragma once

#include <string_view>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

// "0.1.0": the version of CMakeLists.txt.
std::string_view version();

}  // namespace burnish
