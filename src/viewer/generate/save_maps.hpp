// `save maps FOLDER`: the maps of a material, as `burnish scratch` or `burnish weave` writes them.
//
// Threads: functions may be called from any thread. Lifetime: a request refers to nothing else.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/stage.hpp"
#include "jobs/maps/scratch.hpp"
#include "jobs/maps/weave.hpp"

namespace burnish::viewer {

struct MapsRequest {
    std::variant<ScratchRequest, WeaveRequest> maps;
    std::string what;  // "scratches of steel"
};

// Of the material, or without an index of the first one that has scratches or a weave. Throws Error
// where there is none, and where a folder of scratches has no scratch.json.
MapsRequest maps_request(const Stage& stage, std::optional<int> material,
                         const std::filesystem::path& folder);

struct SavedMaps {
    std::vector<std::filesystem::path> written;
    std::vector<std::string> warnings;
};
SavedMaps make_maps(const MapsRequest& request, const Progress& progress);

}  // namespace burnish::viewer
