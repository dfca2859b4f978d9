#include "stage/folder_hint.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "burnish/error.hpp"
#include "formats/own_folder.hpp"
#include "stage/map_role.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

// Which flag, or which file of it, takes the folder.
std::string takers_of(const fs::path& folder, OwnFolderKind kind) {
    std::error_code error;
    std::string takers = kind == OwnFolderKind::scratch ? "--scratch takes it" : "--maps takes it";
    if (fs::exists(folder / "draft.wif", error)) takers += ", --weave its draft.wif";
    if (fs::exists(folder / "measured.exr", error)) takers += ", --tabulated its measured.exr";
    if (fs::exists(folder / "material.gltf", error)) takers += ", burnish render its material.gltf";
    return takers;
}

bool holds_maps(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (map_role_of(entry->path())) return true;
    return false;
}

}  // namespace

std::string folder_hint(const std::string& folder) {
    if (const auto kind = own_folder_kind(folder))
        return fmt::format("a folder of {} ({})", command_of(*kind), takers_of(folder, *kind));
    return holds_maps(folder) ? "a folder of maps (--maps takes it)" : "a folder";
}

void refuse_folder(std::string_view parameter, std::string_view expected, const std::string& name) {
    std::error_code error;
    if (!fs::is_directory(name, error)) return;
    throw UsageError(parameter, "", expected,
                     fmt::format("{}, {}", shown(name), folder_hint(name)));
}

}  // namespace burnish
