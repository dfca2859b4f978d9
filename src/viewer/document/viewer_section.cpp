#include "viewer/document/viewer_section.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "burnish/error.hpp"
#include "core/text.hpp"
#include "formats/json_text.hpp"
#include "viewer/document/file_names.hpp"
#include "viewer/document/json_numbers.hpp"

namespace burnish::viewer {
namespace {

constexpr double kFarthestPlace = 1e6;  // meters, as in the parameter table
constexpr std::size_t kMostBookmarks = 1000, kMostDark = 1000;

template <typename Value>
Value name_at(const JsonPlace& place, std::span<const std::string_view> names,
              std::string_view kind) {
    return static_cast<Value>(
        index_of_name(names, place.text(), kind, place.file() + ": " + place.path()));
}

Bookmark read_bookmark(const JsonPlace& place) {
    constexpr std::array<std::string_view, 4> kKeys = {"name", "position", "target", "fov_deg"};
    place.require_object(kKeys);
    Bookmark bookmark;
    bookmark.name = place.at("name").text();
    bookmark.position = place.at("position").triple(-kFarthestPlace, kFarthestPlace);
    bookmark.target = place.at("target").triple(-kFarthestPlace, kFarthestPlace);
    bookmark.fov_deg = place.at("fov_deg").number(1.0, 170.0);
    return bookmark;
}

int read_index(const JsonPlace& place) {
    return static_cast<int>(place.number(0.0, 1e6));
}

// A number is a material of the scene, a text a file.
MaterialPair read_pair(const JsonPlace& place, const std::filesystem::path& folder) {
    constexpr std::array<std::string_view, 2> kKeys = {"material", "other"};
    place.require_object(kKeys);
    const JsonPlace other = place.at("other");
    MaterialPair pair;
    pair.material = read_index(place.at("material"));
    pair.other = other.value().is_number() ? fmt::format("#{}", read_index(other))
                                           : absolute_name((folder / other.text()).string());
    return pair;
}

Compare read_compare(const JsonPlace& place, const std::filesystem::path& folder) {
    constexpr std::array<std::string_view, 6> kKeys = {"mode", "methods",   "dividers",
                                                       "gain", "materials", "middle"};
    place.require_object(kKeys);
    Compare compare;
    if (place.has("mode"))
        compare.mode = name_at<CompareMode>(place.at("mode"), compare_mode_names(), "mode");
    if (place.has("methods")) {
        const JsonPlace methods = place.at("methods");
        methods.require_array(kMostCompared);
        compare.methods.clear();
        for (std::size_t i = 0; i < methods.size(); ++i)
            compare.methods.push_back(name_at<Method>(methods.at(i), method_names(), "method"));
    }
    if (place.has("dividers")) {
        const JsonPlace dividers = place.at("dividers");
        dividers.require_array(kMostCompared - 1);
        for (std::size_t i = 0; i < dividers.size(); ++i)
            compare.dividers.push_back(dividers.at(i).number(0.0, 1.0));
    }
    if (place.has("gain")) compare.gain = place.at("gain").number(0.01, 1000.0);
    if (place.has("materials")) compare.materials = read_pair(place.at("materials"), folder);
    if (place.has("middle")) compare.middle = place.at("middle").number(0.0, 1.0);
    return compare;
}

std::map<int, float> read_dark(const JsonPlace& place) {
    constexpr std::array<std::string_view, 2> kKeys = {"light", "intensity"};
    place.require_array(kMostDark);
    std::map<int, float> dark;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace light = place.at(i);
        light.require_object(kKeys);
        dark[read_index(light.at("light"))] =
            static_cast<float>(light.at("intensity").number(0.0, 1e9));
    }
    return dark;
}

}  // namespace

ViewerSection read_viewer_section(const std::string& text, const std::string& file) {
    ViewerSection section;
    if (text.empty()) return section;
    const std::string where = file + ": viewer";
    const nlohmann::json json = parse_json(where, text);
    const JsonPlace root(where, json);
    constexpr std::array<std::string_view, 4> kKeys = {"bookmarks", "compare", "dark_lights",
                                                       "scene"};
    root.require_object(kKeys);
    try {
        if (root.has("bookmarks")) {
            const JsonPlace bookmarks = root.at("bookmarks");
            bookmarks.require_array(kMostBookmarks);
            for (std::size_t i = 0; i < bookmarks.size(); ++i) {
                section.bookmarks.push_back(read_bookmark(bookmarks.at(i)));
                require_valid(section.bookmarks.back());
            }
        }
        if (root.has("compare"))
            section.compare =
                read_compare(root.at("compare"), std::filesystem::absolute(file).parent_path());
        require_valid(section.compare);
        if (root.has("scene")) section.scene = root.at("scene").text();
        if (root.has("dark_lights")) section.dark = read_dark(root.at("dark_lights"));
    } catch (const UsageError& error) {  // of the file, not of the command line
        const std::string line = error.what();
        throw Error(line.starts_with(where) ? line : where + ": " + line);
    }
    return section;
}

nlohmann::ordered_json viewer_section(
    const Document& document, const std::vector<Light>& lights,
    const std::function<std::string(const std::string&)>& file_name) {
    nlohmann::ordered_json out;
    for (const Bookmark& bookmark : document.bookmarks)
        out["bookmarks"].push_back({{"name", bookmark.name},
                                    {"position", json_of(bookmark.position)},
                                    {"target", json_of(bookmark.target)},
                                    {"fov_deg", bookmark.fov_deg}});
    for (const int index : document.dark)
        if (static_cast<std::size_t>(index) < lights.size())
            out["dark_lights"].push_back(
                {{"light", index},
                 {"intensity", decimal_of(lights[static_cast<std::size_t>(index)].intensity)}});
    const Compare& compare = document.compare;
    if (compare == Compare{}) return out;
    nlohmann::ordered_json& section = out["compare"];
    section["mode"] = compare_mode_names()[static_cast<std::size_t>(compare.mode)];
    for (const Method method : compare.methods) section["methods"].push_back(name_of(method));
    if (!compare.dividers.empty()) section["dividers"] = compare.dividers;
    section["gain"] = compare.gain;
    if (compare.middle != Compare{}.middle) section["middle"] = compare.middle;
    if (!compare.materials) return out;
    nlohmann::ordered_json& pair = section["materials"];
    pair["material"] = compare.materials->material;
    if (const auto index = scene_material_of(compare.materials->other))
        pair["other"] = *index;
    else
        pair["other"] = file_name(compare.materials->other);
    return out;
}

}  // namespace burnish::viewer
