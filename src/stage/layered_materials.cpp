#include "burnish/layered_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "burnish/conductors.hpp"
#include "burnish/error.hpp"
#include "burnish/fit_tangents.hpp"
#include "burnish/progress.hpp"
#include "core/text.hpp"
#include "stage/map_notes.hpp"
#include "stage/material_parameters.hpp"
#include "stage/material_warnings.hpp"
#include "stage/physical_size.hpp"

namespace burnish {
namespace {

void erase_all(ParameterValues& values, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) values.erase(name);
}

// Whether a folder of maps says what the parameter says: all of a material but the model, and how its
// maps lie.
bool is_replaced_by_maps(const Parameter& p) {
    if (p.group != ParameterGroup::material) return false;
    static constexpr std::string_view kKept[] = {
        "mdf",           "brdf",         "method", "process", "conserve", "single_scattering",
        "normal_filter", "double_sided", "maps"};
    return std::find(std::begin(kKept), std::end(kKept), p.name) == std::end(kKept);
}

// Values of the lower layer that a set of maps in the upper layer replaces: the maps hold absolute
// values, so that the factors of the lower layer do not count.
void erase_mapped(ParameterValues& lower, const ParameterValues& upper) {
    struct Row {
        std::string_view map;
        std::vector<std::string_view> replaced;
    };
    static const std::vector<std::string_view> roughness_names = {
        "alpha_x", "alpha_y", "e_x", "e_y", "cosine_exponent", "roughness", "orm_map"};
    static const Row rows[] = {{"base_color_map", {"base_color", "metal", "oxide"}},
                               {"metallic_map", {"metallic", "metal", "oxide", "orm_map"}},
                               {"anisotropy_map", {"anisotropy", "anisotropy_rotation"}},
                               {"height_map", {"normal_scale", "flip_green"}},
                               {"ao_map", {"orm_map"}}};
    for (const Row& row : rows)
        if (names_one(upper, row.map))
            for (const std::string_view name : row.replaced) lower.erase(name);
    for (const std::string_view map : {"roughness_map", "glossiness_map", "orm_map"})
        if (names_one(upper, map))
            for (const std::string_view name : roughness_names)
                if (name != map) lower.erase(name);
    if (names_one(upper, "roughness_map")) lower.erase("glossiness_map");
    if (names_one(upper, "glossiness_map")) lower.erase("roughness_map");
    if (!names_one(upper, "maps")) return;
    // A folder is a whole material.
    for (const Parameter& parameter : parameter_table())
        if (is_replaced_by_maps(parameter)) lower.erase(parameter.name);
}

// Erases the values of the lower layer that the upper layer replaces.
void erase_replaced(ParameterValues& lower, const ParameterValues& upper,
                    const std::optional<glm::vec2>& lower_alpha) {
    erase_mapped(lower, upper);
    if (upper.is_set("normal_map") || upper.is_set("scratch"))
        erase_all(lower, {"normal_scale", "flip_green", "uv_scale"});
    if (upper.is_set("scratch") && static_cast<ScratchDirection>(upper.choice(
                                       "scratch_direction")) == ScratchDirection::follow)
        lower.erase("anisotropy_rotation");
    // The method follows from the process, unless it is stated beside it.
    if (upper.is_set("process") && !upper.is_set("method")) lower.erase("method");
    if (names_one(upper, "metal")) lower.erase("metallic");
    if (upper.is_set("metal") &&
        (!names_one(upper, "metal") || oxide_of(upper.text("metal")).empty()))
        lower.erase("oxide");
    if (names_one(upper, "weave")) {
        erase_all(lower, {"metal", "metallic", "oxide"});
        if (!lower_alpha) erase_all(lower, {"roughness", "anisotropy"});
    } else if (upper.is_set("weave")) {
        for (const Parameter& parameter : parameter_table())
            if (parameter.belongs_to == "weave") lower.erase(parameter.name);
    }
}

double within_table(std::string_view name, float value) {
    const Parameter& parameter = *find_parameter(name);
    return std::clamp(static_cast<double>(value), parameter.low, parameter.high);
}

// The halves (x, y) of a roughness pair that the values contain, as alphas or as exponents.
struct Halves {
    bool x, y;
};
Halves halves_of(const ParameterValues& values) {
    return {values.is_set("alpha_x") || values.is_set("e_x"),
            values.is_set("alpha_y") || values.is_set("e_y")};
}

// Writes a pair of which `upper` has one half as alphas. A single half in `lower` means both, so it
// supplies the other half only when `upper` has a different half.
void complete_pair(ParameterValues& values, const ParameterValues& lower,
                   const ParameterValues& upper, glm::vec2 lower_alpha) {
    const Halves above = halves_of(upper), below = halves_of(lower);
    if (above.x == above.y) return;
    if (below.x == above.x && below.y == above.y) return;
    const glm::vec2 pair = roughness_pair(upper, lower_alpha).value_or(lower_alpha);
    erase_all(values, {"e_x", "e_y"});
    values.set_value("alpha_x", within_table("alpha_x", pair.x));
    values.set_value("alpha_y", within_table("alpha_y", pair.y));
}

}  // namespace

ParameterValues values_over(const ParameterValues& lower, const ParameterValues& upper,
                            const std::optional<glm::vec2>& lower_alpha) {
    ParameterValues values = lower;
    erase_replaced(values, upper, lower_alpha);
    values.merge(upper);
    require_one_roughness(upper, false);
    if (lower_alpha) complete_pair(values, lower, upper, *lower_alpha);
    return values;
}

LayeredMaterials::LayeredMaterials(std::vector<Material> base, std::vector<SceneFile::Layer> layers)
    : base_(std::move(base)), layers_(std::move(layers)) {
    layers_.resize(base_.size());
}

void LayeredMaterials::put_in_place(std::size_t index, std::size_t other) {
    base_.at(index) = base_.at(other);
    layers_.at(index) = layers_.at(other);
}

// The values of one loaded material. Errors in the file's values name their place in the file, those
// of the uppermost layer the material.
ParameterValues LayeredMaterials::values_of(std::size_t index, Scene& scene,
                                            const ParameterValues& flags,
                                            const ParameterValues* upper) {
    const SceneFile::Layer& layer = layers_[index];
    const auto alpha_under = [&](const ParameterValues& values) {
        assets_.load(values, scene.textures, file_warnings_);
        return stated_alpha(apply_parameters(base_[index], values, assets_));
    };
    std::optional<glm::vec2> alpha;
    try {
        alpha = alpha_under(layer.values);
    } catch (const Interrupted&) {
        throw;
    } catch (const Error& error) {
        throw Error(layer.place + ": " + error.what());
    }
    ParameterValues values = values_over(layer.values, flags, alpha);
    if (upper == nullptr) {
        assets_.load(values, scene.textures, file_warnings_);
        return values;
    }
    alpha = alpha_under(values);
    try {
        values = values_over(values, *upper, alpha);
        assets_.load(values, scene.textures, file_warnings_);
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("{}: {}", one_line(base_[index].name), error.what()));
    }
    return values;
}

// What was taken for what from folders of maps, each line once.
std::vector<std::string> LayeredMaterials::notes_of(
    const std::vector<ParameterValues>& values) const {
    std::vector<std::string> notes;
    for (const ParameterValues& of_material : values)
        for (std::string& line : map_notes(of_material, assets_.maps(of_material)))
            append_once(notes, std::move(line));
    return notes;
}

Remarks LayeredMaterials::apply_layers(Scene& scene, const ParameterValues& flags,
                                       const std::map<int, ParameterValues>& upper) {
    std::vector<Material> materials;
    std::vector<ParameterValues> layered, sized;
    SizeReport sizes;
    file_warnings_.clear();
    assets_.begin_uses();
    for (std::size_t i = 0; i < base_.size(); ++i) {
        const auto own = upper.find(static_cast<int>(i));
        layered.push_back(values_of(i, scene, flags, own == upper.end() ? nullptr : &own->second));
        sized.push_back(layered.back());
        apply_physical_size(sized.back(), scene, i, assets_, sizes);
        materials.push_back(apply_parameters(base_[i], sized.back(), assets_));
    }
    Remarks remarks{file_warnings_, notes_of(sized)};
    append_sizes(sizes, scene, remarks);
    std::swap(scene.materials, materials);
    std::swap(values_, layered);
    append_warnings(scene, sized, remarks.warnings);
    for (const ParameterValues& values : sized)
        if (std::string line = warning_of_idle_flip(values, assets_.maps(values)); !line.empty())
            append_once(remarks.warnings, std::move(line));
    for (std::string& line : fit_tangents(scene)) remarks.warnings.push_back(std::move(line));
    return remarks;
}

void append_remarks(Remarks remarks, Scene& scene) {
    for (std::string& line : remarks.warnings) append_once(scene.warnings, std::move(line));
    for (std::string& line : remarks.notes) append_once(scene.notes, std::move(line));
}

Remarks LayeredMaterials::apply(Scene& scene, const ParameterValues& flags) {
    return apply(scene, flags, {});
}

Remarks LayeredMaterials::apply(Scene& scene, const ParameterValues& flags,
                                const std::map<int, ParameterValues>& upper) {
    if (!upper.empty() &&
        (upper.begin()->first < 0 || upper.rbegin()->first >= static_cast<int>(base_.size())))
        throw UsageError("material", "", fmt::format("an index below {}", base_.size()),
                         std::to_string(upper.begin()->first < 0 ? upper.begin()->first
                                                                 : upper.rbegin()->first));
    const MaterialAssets assets = assets_;
    const std::vector<std::string> file_warnings = file_warnings_;
    const std::size_t textures = scene.textures.size();
    try {
        return apply_layers(scene, flags, upper);
    } catch (...) {
        assets_ = assets;
        file_warnings_ = file_warnings;
        scene.textures.resize(textures);
        throw;
    }
}

void apply_material_parameters(Scene& scene, const ParameterValues& values) {
    append_remarks(LayeredMaterials(scene.materials).apply(scene, values), scene);
}

}  // namespace burnish
