#include "jobs/maps/scratch_recipe.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "burnish/error.hpp"
#include "burnish/shading_names.hpp"
#include "burnish/version.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "formats/json_text.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::string_view kFormat = "burnish-scratch";
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 20;

// --- writing ----------------------------------------------------------------------------------

ordered_json spread_json(const Spread& spread) {
    if (spread.shape == Spread::Shape::constant) return spread.a;
    return to_text(spread);
}

std::string_view name_in(std::span<const std::string_view> names, int index) {
    return names[static_cast<std::size_t>(index)];
}

ordered_json layer_json(const ScratchLayer& layer) {
    ordered_json out;
    if (layer.count > 0.0) {
        out["count"] = layer.count;
    } else {
        out["density_per_cm2"] = layer.density_per_cm2;
    }
    out["length_mm"] = spread_json(layer.length_mm);
    out["width_mm"] = spread_json(layer.width_mm);
    out["depth_mm"] = spread_json(layer.depth_mm);
    out["curvature_per_mm"] = spread_json(layer.curvature_per_mm);
    out["taper"] = layer.taper;
    out["profile"] = name_in(scratch_profile_names(), static_cast<int>(layer.profile));
    out["direction"] = name_in(scratch_field_names(), static_cast<int>(layer.field));
    out["angle_deg"] = layer.angle_deg;
    out["range_deg"] = layer.range_deg;
    out["placement"] = name_in(scratch_placement_names(), static_cast<int>(layer.placement));
    out["passes"] = layer.passes;
    return out;
}

ordered_json recipe_json(const ScratchRecipe& recipe, const fs::path& folder) {
    const auto relative = [&](const fs::path& file) {
        std::error_code error;
        const fs::path near = fs::proximate(file, folder, error);
        return (error ? file : near).generic_string();
    };
    ordered_json out;
    out["format"] = kFormat;
    out["version"] = 1;
    out["size"] = recipe.settings.size;
    out["tile_mm"] = recipe.settings.tile_mm;
    out["seed"] = recipe.settings.seed;
    if (!recipe.wear_mask.empty()) out["wear_mask"] = relative(recipe.wear_mask);
    if (!recipe.direction_image.empty()) {
        out["direction_image"] = relative(recipe.direction_image);
        out["direction_is_double_angle"] = recipe.direction_is_double_angle;
    }
    for (const ScratchLayer& layer : recipe.settings.layers)
        out["layers"].push_back(layer_json(layer));
    return out;
}

// Fowler, Noll and Vo, FNV-1a with 64 bits: the same on every machine.
std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 1099511628211u;
    }
    return hash;
}

// What of a file differs when it was written anew.
ordered_json file_stamp(const fs::path& file) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    const auto bytes = fs::file_size(file, error);
    return {fs::absolute(file).string(), error ? 0 : time.time_since_epoch().count(),
            error ? 0 : bytes};
}

// --- reading ----------------------------------------------------------------------------------

Spread read_spread(const JsonPlace& place) {
    if (!place.is_text()) return constant_spread(place.number(-1e9, 1e9));
    return parse_spread(place.text(), place.file() + ": " + place.path());
}

template <typename Name>
void read_name(const JsonPlace& layer, std::string_view key,
               std::span<const std::string_view> names, Name& to) {
    if (!layer.has(key)) return;
    const JsonPlace place = layer.at(key);
    to = static_cast<Name>(
        index_of_name(names, place.text(), key, place.file() + ": " + place.path()));
}

ScratchLayer read_layer(const JsonPlace& place) {
    constexpr std::array<std::string_view, 13> kKeys = {
        "count", "density_per_cm2", "length_mm", "width_mm",  "depth_mm",  "curvature_per_mm",
        "taper", "profile",         "direction", "angle_deg", "range_deg", "placement",
        "passes"};
    place.require_object(kKeys);
    ScratchLayer layer;
    const auto number = [&](std::string_view key, double& to) {
        if (place.has(key)) to = place.at(key).number(-1e9, 1e9);
    };
    const auto spread = [&](std::string_view key, Spread& to) {
        if (place.has(key)) to = read_spread(place.at(key));
    };
    number("count", layer.count);
    number("density_per_cm2", layer.density_per_cm2);
    spread("length_mm", layer.length_mm);
    spread("width_mm", layer.width_mm);
    spread("depth_mm", layer.depth_mm);
    spread("curvature_per_mm", layer.curvature_per_mm);
    number("taper", layer.taper);
    number("angle_deg", layer.angle_deg);
    number("range_deg", layer.range_deg);
    number("passes", layer.passes);
    read_name(place, "profile", scratch_profile_names(), layer.profile);
    read_name(place, "direction", scratch_field_names(), layer.field);
    read_name(place, "placement", scratch_placement_names(), layer.placement);
    return layer;
}

fs::path read_file_name(const JsonPlace& root, std::string_view key, const fs::path& folder) {
    if (!root.has(key)) return {};
    return folder / root.at(key).text();
}

ScratchRecipe read_recipe(const JsonPlace& root, const fs::path& folder) {
    // "made" holds results for readers; the recipe ignores it.
    constexpr std::array<std::string_view, 9> kKeys = {"format",          "version", "size",
                                                       "tile_mm",         "seed",    "wear_mask",
                                                       "direction_image", "layers",  "made"};
    constexpr double kMostSeed = 4294967295.0;
    root.require_object();
    if (root.at("format").text() != kFormat) root.at("format").fail("burnish-scratch");
    if (root.at("version").value() != 1) root.at("version").fail("1");
    if (root.has("direction_is_double_angle")) {
        std::vector<std::string_view> keys(kKeys.begin(), kKeys.end());
        keys.push_back("direction_is_double_angle");
        root.require_object(keys);
    } else {
        root.require_object(kKeys);
    }
    ScratchRecipe recipe;
    ScratchSettings& settings = recipe.settings;
    if (root.has("size")) settings.size = static_cast<int>(root.at("size").number(16, 16384));
    if (root.has("tile_mm")) settings.tile_mm = root.at("tile_mm").number(0.1, 1e4);
    if (root.has("seed"))
        settings.seed = static_cast<std::uint32_t>(root.at("seed").number(0, kMostSeed));
    recipe.wear_mask = read_file_name(root, "wear_mask", folder);
    recipe.direction_image = read_file_name(root, "direction_image", folder);
    if (root.has("direction_is_double_angle")) {
        const JsonPlace place = root.at("direction_is_double_angle");
        if (!place.value().is_boolean()) place.fail("true or false");
        recipe.direction_is_double_angle = place.value().get<bool>();
    }
    const JsonPlace layers = root.at("layers");
    layers.require_array(16);
    for (std::size_t i = 0; i < layers.size(); ++i)
        settings.layers.push_back(read_layer(layers.at(i)));
    return recipe;
}

}  // namespace

std::string scratch_recipe_text(const ScratchRecipe& recipe, const ScratchReport& report,
                                const std::string& command, const fs::path& folder) {
    ordered_json out = recipe_json(recipe, folder);
    out["made"] = {{"version", version()},
                   {"command", command},
                   {"process", name_of(kScratchProcess)},
                   {"height_png_black_mm", report.low_mm},
                   {"height_png_white_mm", report.high_mm},
                   {"rms_slope", report.rms_slope}};
    return out.dump(2) + "\n";
}

std::string scratch_recipe_key(const ScratchRecipe& recipe) {
    ordered_json out = recipe_json(recipe, {});
    out["program"] = version();
    for (const fs::path& file : {recipe.wear_mask, recipe.direction_image})
        if (!file.empty()) out["files"].push_back(file_stamp(file));
    return fmt::format("{:016x}",
                       hash_of(out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)));
}

ScratchRecipe load_scratch_recipe(const fs::path& file_or_folder) {
    std::error_code error;
    const fs::path file =
        fs::is_directory(file_or_folder, error) ? file_or_folder / "scratch.json" : file_or_folder;
    const std::string name = file.string();
    const nlohmann::json document = parse_json(name, read_text_file(file, kMostBytes));
    try {
        ScratchRecipe recipe = read_recipe(JsonPlace(name, document), file.parent_path());
        check_scratch_settings(recipe.settings, name);
        return recipe;
    } catch (const UsageError& fault) {
        throw Error(fault.what());  // the error is in the file, not in the command
    }
}

}  // namespace burnish
