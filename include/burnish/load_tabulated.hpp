// Measured materials of either kind of file.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <filesystem>
#include <memory>

#include "burnish/api.hpp"
#include "burnish/tabulated_material.hpp"

namespace BURNISH_API burnish {

// A tabulated material, or the distribution of an RGL .bsdf as one; told by content. Throws Error.
std::shared_ptr<const TabulatedMaterial> load_tabulated(const std::filesystem::path& path);

}  // namespace burnish
