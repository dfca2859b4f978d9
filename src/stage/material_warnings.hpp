// Values that change nothing: what is refused, and what is said.
#pragma once

#include <string>
#include <vector>

#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"
#include "burnish/scene_file.hpp"

namespace burnish {

// Throws when no material on which a number of cloth is set is a cloth: UsageError for numbers of
// `flags`, Error with the place for those of the file. All vectors are one a material.
void require_belonging(const std::vector<Material>& materials,
                       const std::vector<ParameterValues>& values,
                       const std::vector<SceneFile::Layer>& layers, const ParameterValues& flags);

// Appends a line for each value that changes nothing on any material, for each that a tabulated
// material or a metal hides, and for each mesh whose texture coordinates a value asks for in vain.
// `values`: those applied, one a material of the scene.
void append_warnings(const Scene& scene, const std::vector<ParameterValues>& values,
                     std::vector<std::string>& warnings);

}  // namespace burnish
