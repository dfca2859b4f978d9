// burnish scratch: from settings to a folder of maps (docs/reference/map-folders.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/scratch_settings.hpp"

namespace burnish {

// Settings with the files that go with them: what scratch.json holds.
struct ScratchRecipe {
    ScratchSettings settings;
    std::filesystem::path wear_mask;        // empty: none
    std::filesystem::path direction_image;  // empty: none
    bool direction_is_double_angle = false;
};

// A scratch.json, or the folder it lies in. Files it names lie beside it. Throws Error with file,
// key, expected and found.
ScratchRecipe load_scratch_recipe(const std::filesystem::path& file_or_folder);

struct ScratchRequest {
    ScratchRecipe recipe;
    std::filesystem::path output;  // a folder, made when it is not there
    std::string command;           // for metadata
};

struct ScratchReport {
    std::vector<std::filesystem::path> written;
    std::vector<std::string> warnings;
    double low_mm = 0.0, high_mm = 0.0;  // of the height
    double rms_slope = 0.0;
    std::uint64_t memory = 0;  // bytes that were asked for
};

// Writes all maps or, when anything fails, none.
ScratchReport make_scratch_maps(const ScratchRequest& request, const Progress& progress);

}  // namespace burnish
