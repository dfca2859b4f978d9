// burnish capture simulate: a stack of pictures of a sample that is known exactly, its rig and the
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
    std::string rig = "bar";    // bar, dome, or a rig file whose lights are taken
    int leds = 40, steps = 20;  // of the bar
    int dome_lights = 100;
    VirtualRigSettings placing;
    VirtualCamera camera;
    StackFormat format = StackFormat::exr;
    std::filesystem::path output;  // a folder, made when it is not there
    std::string command;
};

struct CaptureSimulateResult {
    std::vector<std::filesystem::path> written;  // the rig and the truth; not each picture
    std::size_t pictures = 0;
};

// All or, when anything fails, none: an older stack of that folder stays whole. Throws Error.
CaptureSimulateResult capture_simulate(const CaptureSimulateRequest& request,
                                       const Progress& progress);

}  // namespace burnish
