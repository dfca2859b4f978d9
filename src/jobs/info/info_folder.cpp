#include "jobs/info/info_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/material_assets.hpp"
#include "burnish/rig.hpp"
#include "formats/own_folder.hpp"
#include "jobs/info/info_rig.hpp"
#include "stage/folder_hint.hpp"
#include "stage/map_set.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

// How a folder of a kind is drawn.
std::string_view use_of(OwnFolderKind kind) {
    switch (kind) {
        case OwnFolderKind::scratch:
            return "burnish render MODEL --scratch FOLDER draws it; --settings FOLDER starts from "
                   "it";
        case OwnFolderKind::weave:
            return "burnish render MODEL --weave FOLDER/draft.wif draws the cloth, --maps FOLDER "
                   "its "
                   "maps";
        case OwnFolderKind::material:
        case OwnFolderKind::sample:
            return "burnish render FOLDER/material.gltf shows it, --maps FOLDER puts its maps on a "
                   "model";
    }
    return "";
}

std::string described(const OwnFolder& own, const std::string& shown_as) {
    std::string text = fmt::format("{}: folder of {}", shown_as, command_of(own.kind));
    if (!own.name.empty()) text += fmt::format(", {}", shown(own.name));
    if (own.width > 0) text += fmt::format(", {}x{} texels", own.width, own.height);
    if (own.width_mm > 0.0)
        text += fmt::format(" of {:.4g} x {:.4g} mm", own.width_mm, own.height_mm);
    text += own.repeats || own.kind != OwnFolderKind::material ? "\n" : ", does not repeat\n";
    for (const std::string& line : own.approximated)
        text += fmt::format("  approximated: {}\n", one_line(line));
    if (!own.made_by.empty()) text += fmt::format("  made by: {}\n", one_line(own.made_by));
    return text + fmt::format("  {}\n", use_of(own.kind));
}

// What --maps takes for what.
std::string described(const MapSet& set) {
    std::string text;
    for (const auto& [role, file] : set.files)
        text += fmt::format("  --maps takes {} for the {} map\n",
                            one_line(file.filename().string()), map_role_name(role));
    for (const std::string& line : set.warnings) text += fmt::format("  warning: {}\n", line);
    for (const std::string& line : set.notes) text += fmt::format("  note: {}\n", line);
    return text;
}

std::string described_set(const fs::path& folder, const std::optional<OwnFolder>& own) {
    try {
        const std::string maps = described(find_map_set(folder));
        return own ? maps : fmt::format("{}: folder of maps\n{}", folder.string(), maps);
    } catch (const UsageError&) {
        if (own) return "";
        std::vector<std::string> inner = map_folders_in(folder.string());
        for (std::string& name : inner) name = one_line(name);
        if (inner.empty())
            throw Error(folder.string(), "",
                        "a file, or a folder of maps, of burnish scratch, weave, export or capture",
                        "a folder with none of these");
        return fmt::format("{}: a folder that holds folders of maps: {}\n", folder.string(),
                           fmt::join(inner, ", "));
    }
}

}  // namespace

std::string describe_folder(const std::string& folder) {
    const fs::path rig = fs::path(folder) / "rig.json";
    std::error_code error;
    if (fs::exists(rig, error)) return describe_rig(rig.string());
    const std::optional<OwnFolder> own = find_own_folder(folder);
    return (own ? described(*own, folder) : "") + described_set(folder, own);
}

std::optional<std::string> describe_own_description(const std::string& file) {
    const std::optional<OwnFolder> own = read_own_description(file);
    if (!own) return std::nullopt;
    const std::string folder = fs::path(file).parent_path().string();
    return described(*own, file) + described_set(folder.empty() ? "." : folder, own);
}

}  // namespace burnish
