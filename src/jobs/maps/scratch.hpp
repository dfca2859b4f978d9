// burnish scratch: makes a folder of maps from settings (docs/reference/map-folders.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/scratch_maps.hpp"
#include "burnish/scratch_settings.hpp"
#include "burnish/shading_names.hpp"

namespace burnish {

// The contents of scratch.json: settings and the files that they refer to.
struct ScratchRecipe {
    ScratchSettings settings;
    std::filesystem::path wear_mask;        // empty: none
    std::filesystem::path direction_image;  // empty: none
    bool direction_is_double_angle = false;
};

// Reads a scratch.json, given as a file or by its folder. The files it names are relative to it.
// Throws Error with file, key, expected and found.
ScratchRecipe load_scratch_recipe(const std::filesystem::path& file_or_folder);

// 16 hexadecimal digits that differ where the maps do: of the settings, of the names, sizes and times
// of the files that they refer to, and of the version of the program.
std::string scratch_recipe_key(const ScratchRecipe& recipe);

// The pictures that a recipe refers to. Throws Error for what cannot be read.
ScratchInputs read_scratch_inputs(const ScratchRecipe& recipe);

struct ScratchRequest {
    ScratchRecipe recipe;
    bool orm = false;              // ao.png and orm.png too
    std::filesystem::path output;  // a folder, created if it is missing
    std::string command;           // for metadata
    // normal.png and anisotropy.png alone, with scratch.json: what rendering reads.
    bool drawn_only = false;
};

// Of the metal between the scratches, perceptual, in orm.png.
inline constexpr float kScratchOrmRoughness = 0.3f;

// What the maps are to the grain of the metal: their height is added to that of the grain, whichever came first
// (docs/theory/processes.md). For --process.
inline constexpr Process kScratchProcess = Process::brushed_after;

struct ScratchReport {
    std::vector<std::filesystem::path> written;
    std::vector<std::string> warnings;
    double low_mm = 0.0, high_mm = 0.0;  // of the height
    double rms_slope = 0.0;
    std::uint64_t memory = 0;  // allocated bytes
};

// Writes all maps, or none if anything fails.
ScratchReport make_scratch_maps(const ScratchRequest& request, const Progress& progress);

}  // namespace burnish
