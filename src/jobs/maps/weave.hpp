// burnish weave: from a draft to a folder of maps (docs/reference/map-folders.md).
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

namespace burnish {

// Rows of THE parameter table that the maps depend on.
std::span<const std::string_view> weave_map_parameters();

struct WeaveRequest {
    std::string weave;                        // one of draft_names(), or a WIF file
    ParameterValues values;                   // those of weave_map_parameters() that are set
    std::optional<int> width, height;         // texels; one alone or none: texels are square
    std::optional<int> repeats_u, repeats_v;  // of the draft; none: at least 16 yarns a side
    double yarn_mm = 1.0;
    std::filesystem::path output;  // a folder, made when it is not there
    std::string command;           // for metadata
};

struct WeaveReport {
    std::vector<std::filesystem::path> written;
    std::vector<std::string> warnings;
    double low_mm = 0.0, high_mm = 0.0;  // of the height
    std::uint64_t memory = 0;            // bytes that were asked for
};

// Writes all maps or, when anything fails, none.
WeaveReport make_weave_maps(const WeaveRequest& request, const Progress& progress);

}  // namespace burnish
