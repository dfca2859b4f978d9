// Files of tabulated materials: docs/reference/tabulated-file.md describes the parts.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <filesystem>

#include "burnish/api.hpp"
#include "burnish/tabulated_material.hpp"

namespace BURNISH_API burnish {

// Throws Error naming file, part, channel, expected and found.
TabulatedMaterial read_tabulated_material(const std::filesystem::path& path);
bool is_tabulated_material(const std::filesystem::path& path);  // by content
// Written whole or not at all.
void write_tabulated_material(const std::filesystem::path& path, const TabulatedMaterial& material);

}  // namespace burnish
