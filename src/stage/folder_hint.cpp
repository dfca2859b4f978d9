#include "stage/folder_hint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "burnish/error.hpp"
#include "core/find_file.hpp"
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

bool is_picture_name(const fs::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const auto endings = picture_endings();
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

bool holds_maps(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (is_picture_name(entry->path()) && map_role_of(entry->path())) return true;
    return false;
}

}  // namespace

std::string folder_hint(const std::string& folder) {
    if (const auto kind = own_folder_kind(folder))
        return fmt::format("a folder of {} ({})", command_of(*kind), takers_of(folder, *kind));
    if (holds_maps(folder)) return "a folder of maps (--maps takes it)";
    const std::vector<std::string> inner = map_folders_in(folder);
    if (inner.empty()) return "a folder";
    return fmt::format("a folder with maps in {} (--maps takes that)",
                       shown((fs::path(folder) / inner.front()).string()));
}

std::vector<std::string> map_folders_in(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const fs::path& inner = entry->path();
        std::error_code of_entry;
        if (fs::is_directory(inner, of_entry) &&
            (own_folder_kind(inner.string()) || holds_maps(inner)))
            names.push_back(inner.filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string inner_folder_hint(const std::string& folder) {
    const std::vector<std::string> inner = map_folders_in(folder);
    if (inner.empty()) return "";
    constexpr std::size_t kNamed = 3;
    std::string names;
    for (std::size_t i = 0; i < std::min(inner.size(), kNamed); ++i)
        names += fmt::format("{}{}", i == 0 ? "" : " or ",
                             shown((fs::path(folder) / inner[i]).string()));
    return fmt::format(
        "; did you mean {}{}?", names,
        inner.size() > kNamed ? fmt::format(" or {} others", inner.size() - kNamed) : "");
}

void refuse_folder(std::string_view parameter, std::string_view expected, const std::string& name) {
    std::error_code error;
    if (!fs::is_directory(name, error)) return;
    throw UsageError(parameter, "", expected,
                     fmt::format("{}, {}", shown(name), folder_hint(name)));
}

}  // namespace burnish
