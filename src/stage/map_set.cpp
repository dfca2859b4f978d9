#include "stage/map_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "burnish/error.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, kMapRoles> kNames = {
    "base color", "normal",   "DirectX normal", "roughness",
    "glossiness", "metallic", "occlusion",      "occlusion-roughness-metallic",
    "anisotropy", "height",   "emissive",       "opacity"};

struct Word {
    std::string_view text;
    MapRole role;
};

// Words of ambientCG, Poly Haven, cgbookcase, Substance, and of burnish's own folders. Several words
// of a name are compared as one: "Base_Color", "nor_gl", "AmbientOcclusion".
constexpr Word kWords[] = {
    {"basecolor", MapRole::base_color},
    {"basecolour", MapRole::base_color},
    {"albedo", MapRole::base_color},
    {"color", MapRole::base_color},
    {"colour", MapRole::base_color},
    {"col", MapRole::base_color},
    {"diffuse", MapRole::base_color},
    {"diff", MapRole::base_color},
    {"diffusecolor", MapRole::base_color},
    {"normal", MapRole::normal},
    {"normals", MapRole::normal},
    {"normalgl", MapRole::normal},
    {"normalogl", MapRole::normal},
    {"normalopengl", MapRole::normal},
    {"norgl", MapRole::normal},
    {"nor", MapRole::normal},
    {"norm", MapRole::normal},
    {"nrm", MapRole::normal},
    {"normaldx", MapRole::normal_directx},
    {"normaldirectx", MapRole::normal_directx},
    {"nordx", MapRole::normal_directx},
    {"roughness", MapRole::roughness},
    {"rough", MapRole::roughness},
    {"rgh", MapRole::roughness},
    {"glossiness", MapRole::glossiness},
    {"gloss", MapRole::glossiness},
    {"smoothness", MapRole::glossiness},
    {"metallic", MapRole::metallic},
    {"metalness", MapRole::metallic},
    {"metal", MapRole::metallic},
    {"met", MapRole::metallic},
    {"mtl", MapRole::metallic},
    {"ambientocclusion", MapRole::occlusion},
    {"occlusion", MapRole::occlusion},
    {"ao", MapRole::occlusion},
    {"orm", MapRole::orm},
    {"arm", MapRole::orm},
    {"occlusionroughnessmetallic", MapRole::orm},
    {"anisotropy", MapRole::anisotropy},
    {"height", MapRole::height},
    {"displacement", MapRole::height},
    {"disp", MapRole::height},
    {"bump", MapRole::height},
    {"emissive", MapRole::emissive},
    {"emission", MapRole::emissive},
    {"emit", MapRole::emissive},
    {"opacity", MapRole::opacity},
    {"alpha", MapRole::opacity},
    {"mask", MapRole::opacity},
};

constexpr std::array<std::string_view, 11> kExtensions = {
    ".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".hdr", ".webp", ".tga", ".bmp", ".avif"};

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](char c) { return lower(c); });
    return text;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// The words of a name in lower case: separated by other characters than letters and digits, and
// where a small letter is followed by a capital.
std::vector<std::string> words_of(const std::string& name) {
    std::vector<std::string> words;
    char before = '_';
    for (const char c : name) {
        const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
        const bool capital = c >= 'A' && c <= 'Z', small = before >= 'a' && before <= 'z';
        if (letter) {
            const bool starts = std::isalnum(static_cast<unsigned char>(before)) == 0;
            if (starts || (capital && small)) words.emplace_back();
            words.back().push_back(lower(c));
        }
        before = c;
    }
    return words;
}

// "2k", "4096", "16bit", "1001" (a tile): they say nothing of the role.
bool is_size(const std::string& word) {
    const bool number = !word.empty() && is_digit(word.front());
    const std::size_t end = std::min(word.find_first_not_of("0123456789"), word.size());
    const std::string_view rest = std::string_view(word).substr(end);
    return number && (rest.empty() || rest == "k" || rest == "bit" || rest == "px");
}

std::optional<MapRole> role_of_word(std::string_view text) {
    for (const Word& word : kWords)
        if (word.text == text) return word.role;
    return std::nullopt;
}

bool is_picture(const fs::path& path) {
    const std::string extension = lower(path.extension().string());
    return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

std::vector<fs::path> pictures_in(const fs::path& folder) {
    std::vector<fs::path> pictures;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->is_regular_file(error) && is_picture(entry->path()))
            pictures.push_back(entry->path());
    std::sort(pictures.begin(), pictures.end());
    return pictures;
}

// Of two files of one name the one that keeps more: floats before 16 bits before 8.
int rank_of(const fs::path& file) {
    const std::string extension = lower(file.extension().string());
    if (extension == ".exr" || extension == ".hdr") return 3;
    if (extension == ".tif" || extension == ".tiff") return 2;
    return extension == ".png" ? 1 : 0;
}

std::vector<std::string> words_without_size(const fs::path& file) {
    std::vector<std::string> words = words_of(file.stem().string());
    while (!words.empty() && is_size(words.back())) words.pop_back();
    return words;
}

// Whether the file has the name of the set alone, to which the others add a role: the picture of a
// "Rusty_Metal_2K.png" beside "Rusty_Metal_2K_Color.png".
bool is_picture_of_set(const fs::path& file, const std::vector<fs::path>& all) {
    const std::vector<std::string> name = words_without_size(file);
    return std::any_of(all.begin(), all.end(), [&](const fs::path& other) {
        std::vector<std::string> longer = words_of(other.stem().string());
        std::erase_if(longer, is_size);
        return longer.size() > name.size() && map_role_of(other) &&
               std::equal(name.begin(), name.end(), longer.begin());
    });
}

// Takes `kept` and passes over `other` where both are there.
void prefer(MapSet& set, MapRole kept, MapRole other) {
    const auto file = set.files.find(other);
    if (!set.files.contains(kept) || file == set.files.end()) return;
    set.notes.push_back(fmt::format("{}: passed over, {} holds the {}",
                                    file->second.filename().string(),
                                    set.files[kept].filename().string(), map_role_name(kept)));
    set.files.erase(file);
}

}  // namespace

std::string_view map_role_name(MapRole role) {
    return kNames[static_cast<std::size_t>(role)];
}

std::optional<MapRole> map_role_of(const fs::path& file) {
    const std::vector<std::string> words = words_without_size(file);
    // The longest run of last words that is a role: "base", "color" before "color". Libraries put a
    // resolution, or a kind of normal map ("nor_gl_2k"), behind the role.
    for (std::size_t first = words.size() > 3 ? words.size() - 3 : 0; first < words.size();
         ++first) {
        std::string joined;
        for (std::size_t i = first; i < words.size(); ++i) joined += words[i];
        if (const auto role = role_of_word(joined)) return role;
    }
    return std::nullopt;
}

MapSet find_map_set(const fs::path& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error))
        throw UsageError(
            "maps", "",
            "a folder of maps of one surface (a single map has a flag of its own, such as "
            "--base-color-map)",
            shown(folder.string()) +
                (fs::exists(folder, error) ? ", a file" : ", which is not there"));
    MapSet set;
    std::string unknown, taken;
    const std::vector<fs::path> pictures = pictures_in(folder);
    const bool of_scratches = fs::exists(folder / "scratch.json", error);
    for (const fs::path& picture : pictures) {
        // Of `burnish scratch`: directions of grooves, whose strength is no material's.
        if (of_scratches && picture.stem() == "anisotropy") {
            set.notes.push_back(
                fmt::format("{}: passed over, it is for --scratch with --scratch-direction follow",
                            one_line(picture.string())));
            continue;
        }
        if (picture.stem() == "preview") continue;  // of our own folders
        const auto role = map_role_of(picture);
        if (!role || is_picture_of_set(picture, pictures)) {
            unknown +=
                fmt::format("{}{}", unknown.empty() ? "" : ", ", picture.filename().string());
            continue;
        }
        const auto [held, fresh] = set.files.emplace(*role, picture);
        if (!fresh && held->second.stem() == picture.stem()) {
            if (rank_of(picture) > rank_of(held->second)) held->second = picture;
            continue;
        }
        if (!fresh)
            throw Error(folder.string(), std::string(map_role_name(*role)), "one map of this role",
                        fmt::format("{} and {}: move one away, or name each map by its flag",
                                    shown(held->second.filename().string()),
                                    shown(picture.filename().string())));
    }
    if (set.files.empty())
        throw UsageError(
            "maps", "", "a folder with maps whose names state a role, such as color.png",
            fmt::format("{} with {}", shown(folder.string()),
                        unknown.empty() ? std::string("no pictures (folders in it are not "
                                                      "looked into)")
                                        : "these: " + one_line(unknown)));
    prefer(set, MapRole::normal, MapRole::normal_directx);
    prefer(set, MapRole::normal, MapRole::height);
    prefer(set, MapRole::normal_directx, MapRole::height);
    prefer(set, MapRole::roughness, MapRole::glossiness);
    for (const MapRole role :
         {MapRole::roughness, MapRole::glossiness, MapRole::metallic, MapRole::occlusion})
        prefer(set, MapRole::orm, role);
    for (const auto& [role, file] : set.files)
        taken += fmt::format("{}{} {}", taken.empty() ? "" : ", ", map_role_name(role),
                             one_line(file.filename().string()));
    set.notes.push_back(fmt::format("maps of {}: {}", one_line(folder.string()), taken));
    if (!unknown.empty())
        set.notes.push_back(fmt::format("maps of {}: passed over, as their names state no role: {}",
                                        one_line(folder.string()), one_line(unknown)));
    return set;
}

}  // namespace burnish
