// Folders of maps that the commands of Burnish write (docs/reference/map-folders.md), told by the
// file that each command writes last.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

// material: of `burnish export material`; sample: of `burnish capture export`.
enum class OwnFolderKind { scratch, weave, material, sample };

struct OwnFolder {
    OwnFolderKind kind;
    std::filesystem::path description;  // the file that was written last
    // What the description says; of a sample, whose description is a glTF, nothing.
    std::string name;
    int width = 0, height = 0;               // texels
    double width_mm = 0.0, height_mm = 0.0;  // of the tile; 0: not stated
    bool repeats = true;
    std::vector<std::string> maps;          // names of files in the folder
    std::vector<std::string> approximated;  // what the maps cannot say
    std::string made_by;                    // the command line
};

std::string_view command_of(OwnFolderKind kind);  // "burnish scratch"

// Without reading the description. Of two descriptions in one folder the material's counts.
std::optional<OwnFolderKind> own_folder_kind(const std::filesystem::path& folder);

// None where the folder is none of these, or its description is of another program. Throws Error for
// a broken description.
std::optional<OwnFolder> find_own_folder(const std::filesystem::path& folder);

// The folder that a description lies in: "gold/material.json". None, and errors, as above.
std::optional<OwnFolder> read_own_description(const std::filesystem::path& file);

}  // namespace burnish
