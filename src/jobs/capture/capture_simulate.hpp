// burnish capture simulate: renders a stack of pictures of a known sample, with its rig and the
// truth (docs/guide/capture.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/virtual_sample.hpp"

namespace burnish {

enum class StackFormat { exr, png16, png8 };

struct CaptureSimulateRequest {
    std::string preset;
    VirtualSettings sample;
    std::string rig = "bar";    // bar, dome, or a rig file whose lights are used
    int leds = 40, steps = 20;  // of the bar
    int dome_lights = 100;
    VirtualRigSettings placing;
    VirtualCamera camera;
    StackFormat format = StackFormat::exr;
    std::filesystem::path output;  // a folder, created if it is missing
    std::string command;
};

struct CaptureSimulateResult {
    std::vector<std::filesystem::path> written;  // the rig and the truth; not the pictures
    std::size_t pictures = 0;
};

// Writes all files, or none if anything fails; an older stack in the folder then stays complete.
// Throws Error.
CaptureSimulateResult capture_simulate(const CaptureSimulateRequest& request,
                                       const Progress& progress);

}  // namespace burnish
