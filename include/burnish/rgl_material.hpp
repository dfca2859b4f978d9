// The distribution of an RGL .bsdf as a tabulated material.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <filesystem>

#include "burnish/api.hpp"
#include "burnish/tabulated_material.hpp"

namespace BURNISH_API burnish {

// The microfacet distribution of an RGL .bsdf as a material of one texel (white, no diffuse).
// Throws Error as RglBrdf::load, and for a distribution without normals above the horizon.
TabulatedMaterial tabulated_from_bsdf(const std::filesystem::path& path);

}  // namespace burnish
