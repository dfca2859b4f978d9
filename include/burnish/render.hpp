// Rendering as `burnish render` does it: from a file and parameters to pictures on disk.
//
// Threads: any number may render at a time, each in a context of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/error.hpp"
#include "burnish/progress.hpp"
#include "burnish/shading_names.hpp"
#include "burnish/stage.hpp"

namespace BURNISH_API burnish {

struct RenderRequest {
    StageRequest stage;
    std::filesystem::path output;  // .png .jpg .tif (display) or .exr (linear)
    std::vector<Method> compare;   // two or more: a labelled sheet of these methods
    int turntable = 0;             // pictures of a full turn; 0: a still
    int gl_device = -1;            // -1: the first hardware device, else software
    std::string command;           // kept in the pictures' metadata
};

struct RenderReport {
    std::vector<std::filesystem::path> written;
    std::vector<std::string> warnings;  // what will look different, one line each
    std::vector<std::string> notes;     // what was chosen, one line each
    std::string device;                 // GL_RENDERER
};

// Every output is written whole or not at all. Throws UsageError for combinations that make no
// sense, before anything is rendered, and Error for everything else that fails.
RenderReport render(const RenderRequest& request, const Progress& progress = {});

}  // namespace burnish
