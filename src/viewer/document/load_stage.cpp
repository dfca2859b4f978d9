#include "viewer/document/load_stage.hpp"

#include <fmt/format.h>

#include <utility>

#include "burnish/error.hpp"
#include "core/text.hpp"
#include "stage/stage_parts.hpp"
#include "viewer/document/viewer_section.hpp"

namespace burnish::viewer {

Stage load_stage(const Document& document, const Progress& progress) {
    if (document.input.empty())
        throw UsageError("input", "", "a model, a scene file or builtin:sphere", "none");
    require_valid(document);
    progress.step("model", 0.0);
    Stage stage = open_stage(document.input, document.values);
    progress.step("materials", 0.5);
    take_remarks(stage, stage.materials.apply(stage.scene, stage.values,
                                              values_of_materials(document, stage)));
    remember_meshes(stage);
    find_odd_normal_maps(stage);
    stage.scene.lights = drawn_lights(document, stage.file.scene.lights);
    progress.step("environment", 0.8);
    stage.environment = load_environment_of(stage, document.input, document.environment,
                                            stage.warnings.environment);
    set_values_of_picture(stage, false);
    warn_of_idle_values(stage.values, stage.environment, stage.scene.lights, stage.warnings.values);
    for (std::string& line : warnings_of_missing(document, stage))
        stage.warnings.values.push_back(std::move(line));
    hide_instances(stage, document.hidden);
    stage.scene.warnings = all_warnings(stage);
    progress.step("environment", 1.0);
    return stage;
}

std::vector<Light> drawn_lights(const Document& document, const std::vector<Light>& of_input) {
    std::vector<Light> lights = document.lights ? *document.lights : of_input;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (document.dark.contains(static_cast<int>(i))) lights[i].intensity = 0;
    return lights;
}

std::map<int, ParameterValues> values_of_materials(const Document& document, const Stage& stage) {
    std::map<int, ParameterValues> values = document.material_values;
    const int count = static_cast<int>(stage.materials.base().size());
    std::erase_if(values,
                  [&](const auto& entry) { return entry.first < 0 || entry.first >= count; });
    return values;
}

std::vector<std::string> warnings_of_missing(const Document& document, const Stage& stage) {
    std::vector<std::string> lines;
    const std::size_t materials = stage.materials.base().size();
    const std::size_t parts = stage.scene.instances.size();
    for (const auto& [index, values] : document.material_values)
        if (index < 0 || index >= static_cast<int>(materials))
            lines.push_back(fmt::format("{} has {}: the values of material #{} change nothing",
                                        one_line(document.input), plural(materials, "material"),
                                        index));
    for (const int index : document.hidden)
        if (index < 0 || index >= static_cast<int>(parts))
            lines.push_back(fmt::format("{} has {}: there is no #{} to hide",
                                        one_line(document.input), plural(parts, "part"), index));
    return lines;
}

bool needs_load(const Document& from, const Document& to) {
    return from.input != to.input ||
           from.values.integer("triangles") != to.values.integer("triangles") ||
           from.values.is_set("triangles") != to.values.is_set("triangles");
}

Document with_state_of_input(Document document, const Stage& stage) {
    if (document.hidden.empty())
        document.hidden = {stage.file.hidden.begin(), stage.file.hidden.end()};
    if (!document.bookmarks.empty() || document.compare != Compare{}) return document;
    ViewerSection section = read_viewer_section(stage.file.viewer, document.input);
    if (!document.lights && document.dark.empty()) {
        std::vector<Light> lights = stage.file.scene.lights;
        for (const auto& [index, intensity] : section.dark) {
            if (static_cast<std::size_t>(index) >= lights.size()) continue;
            lights[static_cast<std::size_t>(index)].intensity = intensity;
            document.dark.insert(index);
        }
        if (!document.dark.empty()) document.lights = std::move(lights);
    }
    document.bookmarks = std::move(section.bookmarks);
    document.compare = std::move(section.compare);
    return document;
}

}  // namespace burnish::viewer
