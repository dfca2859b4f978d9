// scratch.json as text. Private to the scratch command.
#pragma once

#include <filesystem>
#include <string>

#include "jobs/maps/scratch.hpp"

namespace burnish {

// Writes the recipe and its results as text; file names are relative to `folder`.
std::string scratch_recipe_text(const ScratchRecipe& recipe, const ScratchReport& report,
                                const std::string& command, const std::filesystem::path& folder);

}  // namespace burnish
