#include "viewer/document/viewer_section.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "burnish/error.hpp"
#include "core/text.hpp"
#include "formats/json_text.hpp"
#include "viewer/document/json_numbers.hpp"

namespace burnish::viewer {
namespace {

constexpr double kFarthestPlace = 1e6;  // meters, as in the parameter table
constexpr std::size_t kMostBookmarks = 1000;

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

Compare read_compare(const JsonPlace& place) {
    constexpr std::array<std::string_view, 4> kKeys = {"mode", "methods", "dividers", "gain"};
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
    return compare;
}

}  // namespace

ViewerSection read_viewer_section(const std::string& text, const std::string& file) {
    ViewerSection section;
    if (text.empty()) return section;
    const std::string where = file + ": viewer";
    const nlohmann::json json = parse_json(where, text);
    const JsonPlace root(where, json);
    constexpr std::array<std::string_view, 2> kKeys = {"bookmarks", "compare"};
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
        if (root.has("compare")) section.compare = read_compare(root.at("compare"));
        require_valid(section.compare);
    } catch (const UsageError& error) {  // of the file, not of the command line
        const std::string line = error.what();
        throw Error(line.starts_with(where) ? line : where + ": " + line);
    }
    return section;
}

nlohmann::ordered_json viewer_section(const Document& document) {
    nlohmann::ordered_json out;
    for (const Bookmark& bookmark : document.bookmarks)
        out["bookmarks"].push_back({{"name", bookmark.name},
                                    {"position", json_of(bookmark.position)},
                                    {"target", json_of(bookmark.target)},
                                    {"fov_deg", bookmark.fov_deg}});
    const Compare& compare = document.compare;
    if (compare == Compare{}) return out;
    nlohmann::ordered_json& section = out["compare"];
    section["mode"] = compare_mode_names()[static_cast<std::size_t>(compare.mode)];
    for (const Method method : compare.methods) section["methods"].push_back(name_of(method));
    if (!compare.dividers.empty()) section["dividers"] = compare.dividers;
    section["gain"] = compare.gain;
    return out;
}

}  // namespace burnish::viewer
