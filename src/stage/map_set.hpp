// A folder of maps of one surface, told by the names of its files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "stage/map_role.hpp"

namespace burnish {

struct MapSet {
    std::map<MapRole, std::filesystem::path> files;  // of normal and normal_directx one
    std::vector<std::string> notes;     // what was passed over for another map: a line each
    std::vector<std::string> warnings;  // what the picture will lack: a line each
    double tile_mm = 0.0;  // width of the tile, where a folder of Burnish's states it; else 0
};

// Maps that are not taken from the folder, by the parameter beside it that says so.
using MapsBeside = std::map<MapRole, std::string_view>;

// Throws UsageError where `folder` is none or holds no map, and Error where two files have the same
// role: both are named, none is guessed. The reasons why one of two roles is taken are in `notes`.
MapSet find_map_set(const std::filesystem::path& folder, const MapsBeside& beside = {});

// Width of the tile in mm that a folder of Burnish's states; 0: it states none.
double map_folder_tile_mm(const std::filesystem::path& folder);

}  // namespace burnish
