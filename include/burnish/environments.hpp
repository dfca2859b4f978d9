// Environments: light from everywhere. Throws Error with one line naming the file, the key, what
// was expected and what was found, for any broken, hostile or unsupported input; never crashes,
// hangs, or allocates by a count that it has not checked.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/scene.hpp"

namespace BURNISH_API burnish {

// .hdr, .exr (or any allowed image) lat-long, or "builtin:studio" (soft boxes in a dark room; the
// default), "builtin:white" (constant 1, the furnace), "builtin:black". Infinite pixels become 65504
// and those that are no number 0. `warnings`, if any, receives how many there were, and that a
// picture of integers clips what is brighter than white, one line each.
Environment load_environment(const std::string& path_or_builtin,
                             std::vector<std::string>* warnings = nullptr);

}  // namespace burnish
