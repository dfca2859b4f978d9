// Measured materials as those of a scene: `--tabulated`.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"
#include "scene/material/tabulated_material.hpp"

namespace burnish {

// A tabulated material, or the distribution of an RGL .bsdf as one; told by content. Throws Error.
std::shared_ptr<const TabulatedMaterial> load_tabulated(const std::filesystem::path& path);

// What `tabulated` says of the materials [first, first + count), whose lobe and colour are set
// already. A normal map beside it perturbs it further; a weave or a scratch map takes the place of
// an earlier one. Warns of values that it hides; throws UsageError beside a weave or a scratch map,
// Error for a file that cannot be read.
void apply_tabulated(Scene& scene, std::size_t first, std::size_t count,
                     const ParameterValues& values);

}  // namespace burnish
