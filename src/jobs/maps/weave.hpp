// burnish weave: makes a folder of maps from a draft (docs/reference/map-folders.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/parameters.hpp"
#include "burnish/progress.hpp"
#include "burnish/shading_names.hpp"

namespace burnish {

// Parameters that the maps depend on, as named in the parameter table.
std::span<const std::string_view> weave_map_parameters();

struct WeaveRequest {
    std::string weave;                        // one of draft_names(), or a WIF file
    ParameterValues values;                   // those of weave_map_parameters() that are set
    std::optional<int> width, height;         // texels; square texels if one or none is given
    std::optional<int> repeats_u, repeats_v;  // of the draft; default: at least 16 yarns on a side
    double yarn_mm = 1.0;
    bool orm = false;              // ao.png and orm.png too, and anisotropy.png
    std::filesystem::path output;  // a folder, created if it is missing
    std::string command;           // for metadata
};

// What the maps are to the fibers, whose directions are stated in the plane of the cloth: they keep their shadow there
// as the yarn curves (docs/theory/processes.md). For --process.
inline constexpr Process kWeaveProcess = Process::embossed;

struct WeaveReport {
    std::vector<std::filesystem::path> written;
    std::vector<std::string> warnings;
    double low_mm = 0.0, high_mm = 0.0;  // of the height
    std::uint64_t memory = 0;            // allocated bytes
};

// Writes all maps, or none if anything fails.
WeaveReport make_weave_maps(const WeaveRequest& request, const Progress& progress);

}  // namespace burnish
