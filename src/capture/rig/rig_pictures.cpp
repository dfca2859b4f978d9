#include "capture/rig/rig_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "burnish/error.hpp"
#include "capture/rig/rig_reading.hpp"
#include "core/text.hpp"
#include "image/guard/format.hpp"

namespace burnish::rig_reading {

namespace {

namespace fs = std::filesystem;

// Names that a message lists.
constexpr std::size_t kListed = 3;

bool contains(std::span<const std::string_view> endings, const std::string& ending) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

bool is_same_file(const std::optional<fs::path>& one, const fs::path& other) {
    std::error_code error;
    return one && fs::equivalent(*one, other, error) && !error;
}

// Pictures beside the file except its mask and flat field, by order. Names that start with a dot
// are of systems, not of cameras.
std::vector<fs::path> pictures_beside(const Rig& rig) {
    std::vector<fs::path> pictures;
    std::error_code error;
    for (fs::directory_iterator entry(folder_of(rig.file), error), end; !error && entry != end;
         entry.increment(error)) {
        const fs::path name = entry->path().filename();
        if (name.string().starts_with('.') || !contains(all_endings(), lower_extension(name)) ||
            !is_there(entry->path()) || is_same_file(rig.mask, entry->path()) ||
            is_same_file(rig.white, entry->path()))
            continue;
        pictures.push_back(rig.file.parent_path() / name);
    }
    // Raw files beside developed ones are the same pictures again.
    const auto raw = std::stable_partition(pictures.begin(), pictures.end(), [](const fs::path& p) {
        return !has_raw_ending(p.string());
    });
    if (raw != pictures.begin()) pictures.erase(raw, pictures.end());
    std::sort(pictures.begin(), pictures.end(), [](const fs::path& a, const fs::path& b) {
        return natural_less(a.filename().string(), b.filename().string());
    });
    return pictures;
}

// "25 (24 .jpg, 1 .png)": pictures of two kinds in one folder are a usual reason of a wrong count.
std::string count_by_ending(const std::vector<fs::path>& pictures) {
    std::map<std::string, std::size_t> counts;
    for (const fs::path& picture : pictures) ++counts[lower_extension(picture)];
    std::string kinds;
    for (const auto& [ending, count] : counts)
        kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", count, ending);
    return counts.size() < 2 ? fmt::to_string(pictures.size())
                             : fmt::format("{} ({})", pictures.size(), kinds);
}

void warn_of_order(const std::vector<fs::path>& pictures, std::vector<std::string>& warnings) {
    for (std::size_t k = 1; k < pictures.size(); ++k) {
        const std::string before = pictures[k - 1].filename().string(),
                          after = pictures[k].filename().string();
        if (before < after) continue;
        warnings.push_back(fmt::format(
            "pictures are taken in the order of the numbers in their names, {} before {}, which "
            "is not that of their letters",
            shown(before), shown(after)));
        return;
    }
}

// The pictures of all lights; a light that names none gets one.
std::vector<fs::path*> places_of(Rig& rig) {
    std::vector<fs::path*> places;
    for (RigLight& light : rig.lights) {
        if (light.images.empty()) light.images.push_back({});
        for (RigExposure& exposure : light.images) places.push_back(&exposure.image);
    }
    return places;
}

std::string listed(const std::vector<PictureFinder::Named>& pictures) {
    std::string text;
    for (std::size_t k = 0; k < std::min(pictures.size(), kListed); ++k)
        text += fmt::format("{}{}", k == 0 ? "" : ", ", shown(pictures[k].name));
    return text + (pictures.size() > kListed ? " ..." : "");
}

std::string missing_text(const PictureFinder& finder, const Rig& rig) {
    const auto& missing = finder.missing();
    std::string text = shown(missing.front().name);
    if (missing.size() > 1)
        text += fmt::format(" and {} more of {} pictures missing: {}", missing.size() - 1,
                            finder.count(), listed(missing));
    if (missing.size() < finder.count())
        text += missing.size() > 1 ? "; --skip-missing goes on without their lights"
                                   : "; --skip-missing goes on without its light";
    if (pictures_beside(rig).size() == finder.count())
        text += fmt::format("; --by-order takes the {} beside the file by their order",
                            plural(finder.count(), "picture"));
    return text;
}

void leave_out(const PictureFinder& finder, Rig& rig) {
    std::set<fs::path> missing;
    for (const PictureFinder::Named& named : finder.missing()) missing.insert(named.path);
    std::size_t lights = rig.lights.size();
    for (RigLight& light : rig.lights)
        std::erase_if(light.images, [&](const RigExposure& exposure) {
            return missing.contains(exposure.image);
        });
    std::string without;
    for (const RigLight& light : rig.lights)
        if (light.images.empty() && without.empty()) without = light.where;
    std::erase_if(rig.lights, [](const RigLight& light) { return light.images.empty(); });
    lights -= rig.lights.size();
    rig.warnings.push_back(fmt::format(
        "{} of {} pictures are missing ({}): {}", finder.missing().size(), finder.count(),
        listed(finder.missing()),
        lights == 0
            ? std::string("the other exposures of their lights are used")
            : fmt::format("{} left out, the first is {}", plural(lights, "light"), without)));
}

}  // namespace

std::span<const std::string_view> all_endings() {
    static const std::vector<std::string_view> all = [] {
        std::vector<std::string_view> list(picture_endings().begin(), picture_endings().end());
        list.insert(list.end(), raw_camera_endings().begin(), raw_camera_endings().end());
        return list;
    }();
    return all;
}

fs::path PictureFinder::find(const std::string& where, const std::string& name) {
    ++count_;
    return find(where, name, missing_);
}

fs::path PictureFinder::find_aside(const std::string& where, const std::string& name) {
    return find(where, name, missing_aside_);
}

fs::path PictureFinder::find(const std::string& where, const std::string& name,
                             std::vector<Named>& missing) {
    FoundFile found = finder_.find(name);
    Named named{where, name, found, found ? found.path : folder_ / name};
    if (!found) {
        missing.push_back(named);
    } else if (!found.is_exact()) {
        others_.push_back(named);
    }
    return named.path;
}

void warn_of_others(const PictureFinder& finder, std::vector<std::string>& warnings) {
    const auto& others = finder.others();
    if (others.empty()) return;
    const PictureFinder::Named& first = others.front();
    warnings.push_back(fmt::format(
        "{}: {} is taken for {} ({}){}", first.where, shown(first.path.filename().string()),
        shown(first.name), difference_of(first.found),
        others.size() == 1 ? std::string() : fmt::format("; so are {} more", others.size() - 1)));
}

void settle_missing(const PictureFinder& finder, bool needs_images, bool skip_missing, Rig& rig) {
    for (const PictureFinder::Named& aside : finder.missing_aside())
        rig.missing += fmt::format("{}{}: {}", rig.missing.empty() ? "" : "; ", aside.where,
                                   shown(aside.name));
    if (finder.missing().empty()) return;
    const std::string text = missing_text(finder, rig);
    const bool some_are_there = finder.missing().size() < finder.count();
    if (skip_missing && some_are_there) return leave_out(finder, rig);
    if (!needs_images) {
        rig.missing += fmt::format("{}{}: {}", rig.missing.empty() ? "" : "; ",
                                   finder.missing().front().where, text);
        return;
    }
    throw Error(rig.file.string(), finder.missing().front().where, "a picture that is there", text);
}

void take_by_order(bool needs_images, Rig& rig) {
    const std::vector<fs::path> pictures = pictures_beside(rig);
    std::size_t wanted = 0;
    for (const RigLight& light : rig.lights)
        wanted += std::max<std::size_t>(light.images.size(), 1);
    if (pictures.size() != wanted) {
        const std::string expected =
            fmt::format("{} pictures beside the file, one a {}", wanted,
                        wanted == rig.lights.size() ? "light" : "light and exposure");
        if (needs_images) throw Error(rig.file.string(), "", expected, count_by_ending(pictures));
        rig.missing = fmt::format("{} found; expected {}", count_by_ending(pictures), expected);
        return;
    }
    const std::vector<fs::path*> places = places_of(rig);
    const std::string named = places.front()->filename().string();
    for (std::size_t k = 0; k < pictures.size(); ++k) *places[k] = pictures[k];
    if (!named.empty())
        rig.warnings.push_back(
            fmt::format("the {} beside the file are taken by their order, the first, {}, for {}",
                        plural(pictures.size(), "picture"),
                        shown(pictures.front().filename().string()), shown(named)));
    warn_of_order(pictures, rig.warnings);
}

}  // namespace burnish::rig_reading
