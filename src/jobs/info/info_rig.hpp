// `burnish info` of rigs.
#pragma once

#include <string>

#include "burnish/rig.hpp"

namespace burnish {

// Several lines: what the file says and what such a rig can see. Pictures may be missing. Throws as
// read_rig.
std::string describe_rig(const std::string& path, const RigOverrides& overrides = {});

}  // namespace burnish
