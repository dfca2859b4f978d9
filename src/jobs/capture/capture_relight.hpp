// burnish capture relight: renders a fitted material under the lights of a rig
// (docs/guide/relight-and-export.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/rig.hpp"
#include "burnish/tabulated_material.hpp"
#include "capture/judge/relight_compare.hpp"

namespace burnish {

struct CaptureRelightRequest {
    std::filesystem::path material, rig;
    std::optional<std::filesystem::path> compare;  // a rig whose lights name pictures
    RigOverrides overrides;                        // of both rigs
    std::filesystem::path output;                  // a folder, created if it is missing
    std::string command;                           // for metadata
};

struct CaptureRelightResult {
    std::vector<std::filesystem::path> written;  // rig.json first
    std::vector<std::string> warnings;
    std::optional<StackError> error;  // set if there were pictures to compare with
};

// Writes a picture of each light, named after that of the rig (p01.jpg: p01.exr) or numbered
// (0000.exr ...) where the rig has no names or two alike, and rig.json, which names them, so that
// they form a stack; with `compare` also compare.csv. Writes all files, or none if anything fails.
// Throws Error where it would write over a picture of the rigs.
CaptureRelightResult capture_relight(const CaptureRelightRequest& request,
                                     const Progress& progress);

// The warnings of the rig, each with the name of its file.
std::vector<std::string> warnings_of(const Rig& rig);

// Sets the rig's size to that of the material, else keeps the rig's, else uses 1 mm per texel.
// Warns if the material and the rig disagree.
void take_size_of(const TabulatedMaterial& material, Rig& rig, std::vector<std::string>& warnings);

// Gives a rig that states no intensities those with which the material was fitted, where the fit
// chose them (light_level.hpp), and says so.
void take_level_of(const TabulatedMaterial& material, Rig& rig, std::vector<std::string>& warnings);

}  // namespace burnish
