// `burnish info` of rigs.
#pragma once

#include <string>

#include "burnish/rig.hpp"

namespace burnish {

// Several lines: the contents of the file and the coverage of the rig. Pictures may be missing.
// Throws as read_rig.
std::string describe_rig(const std::string& path, const RigOverrides& overrides = {});

}  // namespace burnish
