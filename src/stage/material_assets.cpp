#include "burnish/material_assets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "burnish/builtin_meshes.hpp"
#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/load_tabulated.hpp"
#include "burnish/wif.hpp"
#include "maps/normal/bumps.hpp"
#include "maps/normal/normal_without_z.hpp"
#include "stage/folder_hint.hpp"
#include "stage/map_textures.hpp"
#include "stage/scratch_material.hpp"

namespace burnish {
namespace {

constexpr std::string_view kBumps = "builtin:bumps";
constexpr int kBumpsSize = 1024;  // texels a side

// 16 bits: with 8, the highlight of a smooth metal would show steps.
Texture bumps_texture() {
    const Image map = bump_normal_map(kBumpsSize);
    Texture texture{std::string(kBumps), map.width,          map.height, 3,
                    TexelType::u16,      ColorSpace::linear, {}};
    texture.texels.resize(map.pixels.size() * sizeof(std::uint16_t));
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        const auto code = static_cast<std::uint16_t>(std::lround(map.pixels[i] * 65535.0f));
        std::memcpy(texture.texels.data() + i * sizeof code, &code, sizeof code);
    }
    return texture;
}

Texture load_normal_map(const std::string& parameter, const std::string& name,
                        std::vector<std::string>& warnings) {
    if (is_builtin(name) && name != kBumps)
        throw UsageError(parameter, "", "a picture, builtin:bumps or none", shown(name));
    refuse_folder(parameter, "a picture, builtin:bumps or none", name);
    Texture texture =
        name == kBumps ? bumps_texture() : read_texture(name, ColorSpace::linear, &warnings);
    if (texture.channels < 2)
        throw Error(name, "channels", "a normal map with red, green and blue, or with x and y",
                    std::to_string(texture.channels));
    texture.name = name;
    if (std::optional<Texture> map = normal_map_without_z(texture)) {
        warnings.push_back(normal_without_z_warning(name));
        return std::move(*map);
    }
    return texture;
}

std::shared_ptr<const Draft> load_draft(const std::string& name,
                                        std::vector<std::string>& warnings) {
    const auto known = draft_names();
    if (std::find(known.begin(), known.end(), name) != known.end())
        return std::make_shared<Draft>(builtin_draft(name));
    const std::string expected =
        fmt::format("a .wif file, none, or {}", fmt::join(draft_names(), ", "));
    refuse_folder("weave", expected, name);
    // A name with a dot or a folder must be a file.
    const bool file = name.find_first_of("./\\") != std::string::npos;
    std::error_code error;
    if (!file && !std::filesystem::is_regular_file(name, error))
        throw UsageError("weave", "", expected, shown(name));
    return std::make_shared<Draft>(load_wif(name, warnings));
}

template <typename Loaded>
Loaded find_or(const std::map<std::string, Loaded>& all, const std::string& name,
               Loaded otherwise) {
    const auto found = all.find(name);
    return found == all.end() ? otherwise : found->second;
}

}  // namespace

bool names_one(const ParameterValues& values, std::string_view name) {
    return values.is_set(name) && values.text(name) != "none";
}

MaterialAssets::Thing& MaterialAssets::use(const std::string& parameter, const std::string& name) {
    Thing& thing = things_[{parameter, name}];
    thing.used = clock_;
    return thing;
}

int MaterialAssets::place(Thing& thing, std::vector<Texture>& textures, Texture texture) {
    int index = static_cast<int>(textures.size());
    if (free_places_.empty()) {
        textures.push_back(std::move(texture));
    } else {
        index = free_places_.back();
        free_places_.pop_back();
        textures[static_cast<std::size_t>(index)] = std::move(texture);
        ++texture_changes_[index];
    }
    thing.textures.push_back(index);
    return index;
}

void MaterialAssets::load_scratch_maps(const std::string& name, bool follow,
                                       std::vector<Texture>& textures) {
    Thing& thing = use("scratch", name);
    ScratchMaps maps = scratch(name);
    if (maps.normal >= 0 && (!follow || maps.anisotropy >= 0)) return;
    const bool ready = !name.empty() && ready_.first == name;
    ScratchTextures made = ready ? std::move(ready_.second) : load_scratch(name, follow);
    if (ready) ready_ = {};
    maps.tile_mm = made.tile_mm;
    if (maps.normal < 0) maps.normal = place(thing, textures, std::move(made.normal));
    if (follow) maps.anisotropy = place(thing, textures, std::move(made.anisotropy));
    scratch_[name] = maps;
}

void MaterialAssets::load(const ParameterValues& values, std::vector<Texture>& textures,
                          std::vector<std::string>& warnings) {
    // What the reader says of a thing, when it is read and whenever it is named again.
    const auto say = [&](const Thing& thing) {
        for (const std::string& line : thing.warnings)
            if (std::find(warnings.begin(), warnings.end(), line) == warnings.end())
                warnings.push_back(line);
    };
    // One picture serves a surface and a coat.
    for (const char* parameter : {"normal_map", "coat_normal_map"}) {
        if (!names_one(values, parameter)) continue;
        const std::string name = values.text(parameter);
        Thing& thing = use("normal_map", name);
        if (!normal_maps_.contains(name)) {
            thing.warnings.clear();
            normal_maps_[name] =
                place(thing, textures, load_normal_map(parameter, name, thing.warnings));
        }
        say(thing);
    }
    if (const std::string names = map_names(values); names_maps(values)) {
        Thing& thing = use("maps", names);
        if (!maps_.contains(names)) {
            MapTextures maps = load_map_textures(
                values, [&](Texture t) { return place(thing, textures, std::move(t)); });
            thing.warnings = maps.warnings;
            maps_[names] = std::move(maps);
        }
        say(thing);
    }
    if (values.is_set("scratch")) {
        const bool follow = static_cast<ScratchDirection>(values.choice("scratch_direction")) ==
                            ScratchDirection::follow;
        load_scratch_maps(values.text("scratch"), follow, textures);
    }
    if (names_one(values, "weave")) {
        const std::string name = values.text("weave");
        Thing& thing = use("weave", name);
        if (!drafts_.contains(name)) {
            thing.warnings.clear();
            drafts_[name] = load_draft(name, thing.warnings);
        }
        say(thing);
    }
    if (names_one(values, "tabulated")) {
        const std::string name = values.text("tabulated");
        refuse_folder("tabulated", "a file of burnish capture fit, an RGL .bsdf or none", name);
        use("tabulated", name);
        if (!tabulated_.contains(name)) tabulated_[name] = load_tabulated(name);
    }
}

void MaterialAssets::forget(const std::string& parameter, const std::string& name) {
    if (parameter == "normal_map") normal_maps_.erase(name);
    if (parameter == "maps") maps_.erase(name);
    if (parameter == "scratch") scratch_.erase(name);
    if (parameter == "weave") drafts_.erase(name);
    if (parameter == "tabulated") tabulated_.erase(name);
}

void MaterialAssets::free_unused(std::vector<Texture>& textures) {
    std::vector<decltype(things_)::iterator> unused;
    for (auto thing = things_.begin(); thing != things_.end(); ++thing)
        if (thing->second.used != clock_) unused.push_back(thing);
    std::stable_sort(unused.begin(), unused.end(),
                     [](auto a, auto b) { return a->second.used > b->second.used; });
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < unused.size(); ++i) {
        const std::vector<int>& places = unused[i]->second.textures;
        for (const int index : places)
            bytes += textures[static_cast<std::size_t>(index)].texels.size();
        if (i < kMostUnused && bytes <= kMostUnusedBytes) continue;
        for (const int index : places) {
            textures[static_cast<std::size_t>(index)] = Texture{};
            ++texture_changes_[index];
            free_places_.push_back(index);
        }
        forget(unused[i]->first.first, unused[i]->first.second);
        things_.erase(unused[i]);
    }
}

int MaterialAssets::normal_map(const std::string& name) const {
    return find_or(normal_maps_, name, -1);
}

MaterialAssets::ScratchMaps MaterialAssets::scratch(const std::string& name) const {
    return find_or(scratch_, name, ScratchMaps{});
}

std::shared_ptr<const Draft> MaterialAssets::draft(const std::string& name) const {
    return find_or(drafts_, name, std::shared_ptr<const Draft>());
}

MapTextures MaterialAssets::maps(const ParameterValues& values) const {
    return find_or(maps_, map_names(values), MapTextures{});
}

std::shared_ptr<const TabulatedMaterial> MaterialAssets::tabulated(const std::string& name) const {
    return find_or(tabulated_, name, std::shared_ptr<const TabulatedMaterial>());
}

}  // namespace burnish
