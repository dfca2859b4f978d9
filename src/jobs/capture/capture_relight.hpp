// burnish capture relight: pictures of a fitted material under the lights of a rig
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
    std::filesystem::path output;                  // a folder, made when it is not there
    std::string command;                           // for metadata
};

struct CaptureRelightResult {
    std::vector<std::filesystem::path> written;  // rig.json first
    std::vector<std::string> warnings;
    std::optional<StackError> error;  // where there was something to compare with
};

// Writes 0000.exr ... and rig.json, which names them, so that they are a stack; with `compare` also
// compare.csv. All or, when anything fails, none.
CaptureRelightResult capture_relight(const CaptureRelightRequest& request,
                                     const Progress& progress);

// Texels lie where the material says, then where the rig says, else 1 mm apart: the rig's size is
// set, and what does not agree warned of.
void take_size_of(const TabulatedMaterial& material, Rig& rig, std::vector<std::string>& warnings);

}  // namespace burnish
