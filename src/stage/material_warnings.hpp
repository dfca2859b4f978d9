// Warnings for values without effect.
#pragma once

#include <string>
#include <vector>

#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// Appends a warning "name: why: nothing changes" for each value without effect on any material, for each that a tabulated
// material or a metal hides, and for each mesh that lacks the texture coordinates that a value
// needs. `values`: those applied, one entry per material of the scene.
void append_warnings(const Scene& scene, const std::vector<ParameterValues>& values,
                     std::vector<std::string>& warnings);

}  // namespace burnish
