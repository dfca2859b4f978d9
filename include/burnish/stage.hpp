// What a picture shows, said by names of files and parameters.
#pragma once

#include <string>
#include <vector>

#include "burnish/parameters.hpp"

namespace burnish {

// What is to be seen, and in which light.
struct StageRequest {
    std::string input;                // model, scene file or builtin:<name>
    std::string environment;          // "": the scene file's, else builtin:studio; "none"
    std::vector<std::string> lights;  // --light words (see parse_light); empty: the file's lights
    ParameterValues values;           // they win over the scene file's parameters
};

}  // namespace burnish
