// Measured materials of either kind of file.
#pragma once

#include <filesystem>
#include <memory>

#include "burnish/api.hpp"
#include "burnish/tabulated_material.hpp"

namespace BURNISH_API burnish {

// A tabulated material, or the distribution of an RGL .bsdf as one; told by content. Throws Error.
std::shared_ptr<const TabulatedMaterial> load_tabulated(const std::filesystem::path& path);

}  // namespace burnish
