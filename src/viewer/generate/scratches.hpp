// The generator of scratches without its window: what is chosen, the coarse maps that are shown while
// it changes, and the folders of full maps that documents name.
//
// Full maps lie in a cache, a folder for each set of settings: undo finds the former ones there. A
// saved scene has copies of its own (save_scene.hpp).
//
// Threads: functions may be called from any thread. Lifetime: what they return refers to nothing else.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/stage.hpp"
#include "jobs/maps/scratch.hpp"
#include "stage/scratch_material.hpp"

namespace burnish::viewer {

inline constexpr double kMostScratchAmount = 8.0, kMostScratchStrength = 4.0;

struct ScratchChoice {
    std::string base = "brushed";  // a preset, or a folder made by `burnish scratch`
    ScratchRecipe recipe{};        // what the base says, and what was changed of it
    double amount = 1.0;           // 0 to kMostScratchAmount; as --amount of `burnish scratch`
    double strength = 1.0;         // 0 to kMostScratchStrength; as --strength
};

// The base as it is. Throws UsageError for a name that is neither a preset nor a folder with a
// scratch.json, Error for a scratch.json that cannot be read.
ScratchChoice scratch_choice(const std::string& base);

// What is engraved: `burnish scratch` with these settings gives the same maps.
ScratchRecipe scratch_recipe(const ScratchChoice& choice);

// Makes `value` the median (of a uniform quantity the mean): the other values keep their ratios to it.
void set_typical(Spread& spread, double value);

// Coarse maps of the recipe in about 30 ms: the same scratches, with the mean squared slope of the full
// maps. Throws as make_scratch_maps does.
ScratchTextures coarse_scratches(const ScratchRecipe& recipe);

// --- full maps in the cache
// Where the maps of the recipe lie, or would lie.
std::filesystem::path scratch_folder(const std::filesystem::path& cache,
                                     const ScratchRecipe& recipe);
// Makes the maps that rendering reads, unless they are there. Returns their folder. Throws Error when it
// cannot be written, and what make_scratch_maps throws.
std::filesystem::path make_cached_scratches(const std::filesystem::path& cache,
                                            const ScratchRecipe& recipe, const Progress& progress);
// Removes the folders that were used longest ago, until those that are left take `most_bytes` together;
// none that was used during the last day. Never throws.
void prune_scratch_cache(const std::filesystem::path& cache, std::uintmax_t most_bytes);

// --- materials
// What the material is scratched with, in all layers: a preset or a folder; "" for none.
std::string scratches_of(const Stage& stage, int material);

// A material as it is while its scratches change. Its normal texture has to be set to one of the coarse
// maps, and so does its anisotropy texture where `follows`.
struct ScratchPreview {
    int material = 0;  // index into the scene's
    Material shown;
    bool follows = false;
};
// Of one material, or of all without an index. Woven and measured materials are left out: without
// their cloth they are other materials.
std::vector<ScratchPreview> scratch_previews(const Stage& stage, std::optional<int> material,
                                             double tile_mm);

}  // namespace burnish::viewer
