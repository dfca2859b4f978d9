// Errors and warnings for values without effect.
#pragma once

#include <string>
#include <vector>

#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"
#include "burnish/scene_file.hpp"

namespace burnish {

// Throws when a parameter of cloth is set but no material with it is a cloth: UsageError for
// parameters in `flags`, Error with the place for those of the file. All vectors have one entry per
// material.
void require_belonging(const std::vector<Material>& materials,
                       const std::vector<ParameterValues>& values,
                       const std::vector<SceneFile::Layer>& layers, const ParameterValues& flags);

// Appends a warning for each value without effect on any material, for each that a tabulated
// material or a metal hides, and for each mesh that lacks the texture coordinates that a value
// needs. `values`: those applied, one entry per material of the scene.
void append_warnings(const Scene& scene, const std::vector<ParameterValues>& values,
                     std::vector<std::string>& warnings);

}  // namespace burnish
