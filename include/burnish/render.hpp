// Rendering as `burnish render` does it: from a file and parameters to pictures on disk.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/parameters.hpp"
#include "burnish/progress.hpp"
#include "burnish/shading_names.hpp"

namespace burnish {

// What is to be seen, and in which light.
struct StageRequest {
    std::string input;                // model, scene file or builtin:<name>
    std::string environment;          // "": the scene file's, else builtin:studio; "none"
    std::vector<std::string> lights;  // --light words (see parse_light); empty: the file's lights
    ParameterValues values;           // they win over the scene file's parameters
};

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
    std::string device;                 // GL_RENDERER
};

// Every output is written whole or not at all. Throws UsageError for combinations that make no
// sense, before anything is rendered, and Error for everything else that fails.
RenderReport render(const RenderRequest& request, const Progress& progress = {});

}  // namespace burnish
