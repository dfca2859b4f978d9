#include "stage/map_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "burnish/error.hpp"
#include "burnish/parameters.hpp"
#include "formats/own_folder.hpp"
#include "stage/folder_hint.hpp"
#include "stage/map_textures.hpp"
#include "stage/scratch_material.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 11> kEndings = {
    ".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".hdr", ".webp", ".tga", ".bmp", ".avif"};

// Endings of pictures that are not read, with what converts them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kUnread = {
    {{".ktx2", " (`ktx extract IN.ktx2 OUT.png` converts it)"},
     {".ktx", ""},
     {".dds", " (`oiiotool IN.dds -o OUT.png` converts it)"},
     {".psd", ""}}};

std::string ending_of(const fs::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

std::string name_of(const fs::path& file) {
    return one_line(file.filename().string());
}

// The pictures of the folder in the order of their names. Those that cannot be read are warned of.
std::vector<fs::path> pictures_in(const fs::path& folder, std::vector<std::string>& warnings) {
    std::vector<fs::path> pictures;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const fs::path& file = entry->path();
        const std::string ending = ending_of(file);
        const auto* const unread = std::find_if(
            kUnread.begin(), kUnread.end(), [&](const auto& row) { return row.first == ending; });
        if (unread != kUnread.end() && map_role_of(file))
            warnings.push_back(fmt::format("{}: this format is not read{}: the map is left out",
                                           one_line(file.string()), unread->second));
        if (std::find(kEndings.begin(), kEndings.end(), ending) == kEndings.end()) continue;
        std::error_code of_file;
        if (fs::is_regular_file(file, of_file)) {
            pictures.push_back(file);
        } else if (!fs::exists(file, of_file)) {
            warnings.push_back(
                fmt::format("{}: a link to a file that is not there: the map is "
                            "left out",
                            one_line(file.string())));
        }
    }
    std::sort(pictures.begin(), pictures.end());
    std::sort(warnings.begin(), warnings.end());
    return pictures;
}

// Of two files of one name the one that keeps more: floats before 16 bits before 8.
int rank_of(const fs::path& file) {
    const std::string ending = ending_of(file);
    if (ending == ".exr" || ending == ".hdr") return 3;
    if (ending == ".tif" || ending == ".tiff") return 2;
    return ending == ".png" ? 1 : 0;
}

// The tile of a UDIM set, 1001 to 1999, that ends the file's name; 0: none.
int udim_of(const fs::path& file) {
    const std::string stem = file.stem().string();
    const std::size_t digits = stem.find_last_not_of("0123456789");
    if (digits == std::string::npos || stem.size() - digits != 5) return 0;
    const bool apart = stem[digits] == '.' || stem[digits] == '_' || stem[digits] == '-';
    const int tile = std::stoi(stem.substr(digits + 1));
    return apart && tile >= 1001 && tile <= 1999 ? tile : 0;
}

std::string without_udim(const fs::path& file) {
    const std::string stem = file.stem().string();
    return stem.substr(0, stem.size() - 4);
}

// Several tiles of one name are a UDIM set. Its lowest tile alone is kept.
void keep_one_tile(const fs::path& folder, std::vector<fs::path>& pictures,
                   std::vector<std::string>& warnings) {
    std::map<std::string, std::pair<int, int>> range;  // of the tiles of a name
    for (const fs::path& picture : pictures) {
        const int tile = udim_of(picture);
        if (tile == 0) continue;
        const auto [known, fresh] = range.emplace(without_udim(picture), std::pair(tile, tile));
        known->second = {std::min(known->second.first, tile), std::max(known->second.second, tile)};
    }
    int first = 0, last = 0;
    for (const auto& [name, tiles] : range)
        if (tiles.second > tiles.first) {
            first = first == 0 ? tiles.first : std::min(first, tiles.first);
            last = std::max(last, tiles.second);
        }
    if (first == 0) return;
    std::erase_if(pictures, [&](const fs::path& picture) {
        const int tile = udim_of(picture);
        return tile != 0 && tile != range.at(without_udim(picture)).first;
    });
    warnings.push_back(fmt::format(
        "{}: the maps are tiles of a UDIM set, {} to {}: UDIM is not supported; tile {} "
        "is drawn in place of the others",
        one_line(folder.string()), first, last, first));
}

// Whether the file has the name of the set alone, to which the others add a role: the picture of a
// "Rusty_Metal_2K.png" beside "Rusty_Metal_2K_Color.png".
bool is_picture_of_set(const fs::path& file, const std::vector<fs::path>& all) {
    std::vector<std::string> name = words_of_name(file);
    while (!name.empty() && is_size_word(name.back())) name.pop_back();
    return std::any_of(all.begin(), all.end(), [&](const fs::path& other) {
        std::vector<std::string> longer = words_of_name(other);
        std::erase_if(longer, is_size_word);
        return longer.size() > name.size() && map_role_of(other) &&
               std::equal(name.begin(), name.end(), longer.begin());
    });
}

// Takes `kept` and passes over `other` where both are there.
void prefer(MapSet& set, MapRole kept, MapRole other) {
    const auto file = set.files.find(other);
    if (!set.files.contains(kept) || file == set.files.end()) return;
    set.notes.push_back(fmt::format("{}: passed over, {} holds the {}", name_of(file->second),
                                    name_of(set.files[kept]), map_role_name(kept)));
    set.files.erase(file);
}

void settle_roles(MapSet& set) {
    prefer(set, MapRole::normal, MapRole::normal_directx);
    prefer(set, MapRole::normal, MapRole::height);
    prefer(set, MapRole::normal_directx, MapRole::height);
    prefer(set, MapRole::roughness, MapRole::glossiness);
    for (const MapRole packed : kPackedRoles) {
        if (!set.files.contains(packed)) continue;
        for (const MapRole other : kPackedRoles)
            if (other != packed) prefer(set, packed, other);
        const MapPacking packing = *packing_of(packed);
        if (packing.roughness >= 0 || packing.smoothness >= 0)
            for (const MapRole role : {MapRole::roughness, MapRole::glossiness})
                prefer(set, packed, role);
        if (packing.metallic >= 0) prefer(set, packed, MapRole::metallic);
        if (packing.occlusion >= 0) prefer(set, packed, MapRole::occlusion);
    }
}

// --- folders of Burnish's own --------------------------------------------------------------------

std::optional<OwnFolder> own_folder_of(const fs::path& folder, std::vector<std::string>& warnings) {
    try {
        return find_own_folder(folder);
    } catch (const Error& error) {
        warnings.push_back(fmt::format("{}; the maps are told by their names", error.what()));
        return std::nullopt;
    }
}

// Why a picture of an own folder is no map of a material; empty: it may be one.
std::string_view other_use(const std::optional<OwnFolder>& own, const fs::path& picture) {
    if (picture.stem() == "preview") return "it is a preview";
    if (!own) return "";
    // Directions of grooves, whose strength is no material's.
    if (own->kind == OwnFolderKind::scratch && picture.stem() == "anisotropy")
        return "it is for --scratch with --scratch-direction follow";
    // Unit vectors, angles and alphas of the sample; the .png beside them are glTF's.
    if (own->kind == OwnFolderKind::sample && picture.extension() == ".exr")
        return "it is data of the sample in other units";
    return "";
}

void warn_of_missing(const OwnFolder& own, const fs::path& folder, std::vector<std::string>& to) {
    std::error_code error;
    for (const std::string& file : own.maps)
        // A link to nothing has been warned of.
        if (!fs::is_symlink(folder / file, error) && !fs::exists(folder / file, error))
            to.push_back(
                fmt::format("{}: {} names this map, but it is not there: the map is left "
                            "out",
                            one_line((folder / file).string()), name_of(own.description)));
}

// --- the set -------------------------------------------------------------------------------------

void require_folder(const fs::path& folder) {
    std::error_code error;
    if (fs::is_directory(folder, error)) return;
    throw UsageError(
        "maps", "",
        "a folder of maps of one surface (a single map has a flag of its own, such as "
        "--base-color-map)",
        shown(folder.string()) + (fs::exists(folder, error) ? ", a file" : ", which is not there"));
}

void take(MapSet& set, MapRole role, const fs::path& picture, const fs::path& folder) {
    const auto [held, fresh] = set.files.emplace(role, picture);
    if (fresh) return;
    // One map in two formats: the one that keeps more, where one does.
    const int rank = rank_of(picture), held_rank = rank_of(held->second);
    if (held->second.stem() == picture.stem() && rank != held_rank) {
        const fs::path other = rank > held_rank ? held->second : picture;
        if (rank > held_rank) held->second = picture;
        set.notes.push_back(
            fmt::format("{}: passed over, {} is the same map in a format that keeps "
                        "more",
                        one_line(other.string()), name_of(held->second)));
        return;
    }
    const std::string_view parameter = map_parameter(role);
    throw Error(folder.string(), std::string(map_role_name(role)), "one map of this role",
                fmt::format("{} and {}: move one away{}", shown(held->second.filename().string()),
                            shown(picture.filename().string()),
                            parameter.empty() ? "" : ", or name the map by " + flag_of(parameter)));
}

[[noreturn]] void fail_without_maps(const fs::path& folder, const std::string& unknown,
                                    const std::vector<std::string>& warnings) {
    std::error_code error;
    std::string found = unknown.empty()
                            ? std::string("no pictures (folders in it are not looked into)")
                            : "these: " + unknown;
    if (!warnings.empty()) found = "none: " + warnings.front();
    if (fs::exists(folder / "rig.json", error))
        found = "a rig.json: pictures of a sample, which burnish capture fit takes";
    throw UsageError("maps", "", "a folder with maps whose names state a role, such as color.png",
                     fmt::format("{} with {}{}", shown(folder.string()), found,
                                 inner_folder_hint(folder.string())));
}

}  // namespace

double map_folder_tile_mm(const fs::path& folder) {
    std::vector<std::string> unused;
    const std::optional<OwnFolder> own = own_folder_of(folder, unused);
    return own && own->width_mm > 0.0 ? own->width_mm : scratch_tile_mm(folder.string());
}

MapSet find_map_set(const fs::path& folder, const MapsBeside& beside) {
    require_folder(folder);
    MapSet set;
    std::vector<fs::path> pictures = pictures_in(folder, set.warnings);
    keep_one_tile(folder, pictures, set.warnings);
    const std::optional<OwnFolder> own = own_folder_of(folder, set.warnings);
    if (own) warn_of_missing(*own, folder, set.warnings);
    std::string unknown;
    bool any_beside = false;
    for (const fs::path& picture : pictures) {
        if (const std::string_view use = other_use(own, picture); !use.empty()) {
            if (picture.stem() != "preview")
                set.notes.push_back(
                    fmt::format("{}: passed over, {}", one_line(picture.string()), use));
            continue;
        }
        const auto role = map_role_of(picture);
        if (!role || is_picture_of_set(picture, pictures)) {
            unknown += fmt::format("{}{}", unknown.empty() ? "" : ", ", name_of(picture));
        } else if (const auto other = beside.find(*role); other != beside.end()) {
            any_beside = true;
            set.notes.push_back(fmt::format("{}: passed over, {} is set beside the folder",
                                            one_line(picture.string()), other->second));
        } else {
            take(set, *role, picture, folder);
        }
    }
    if (set.files.empty() && !any_beside) fail_without_maps(folder, unknown, set.warnings);
    settle_roles(set);
    if (!unknown.empty())
        set.notes.push_back(
            fmt::format("maps of {}: passed over, as their names state no role that is read: {}",
                        one_line(folder.string()), unknown));
    set.tile_mm = map_folder_tile_mm(folder);
    return set;
}

}  // namespace burnish
