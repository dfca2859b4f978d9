#include "viewer/document/editor.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "burnish/error.hpp"
#include "stage/stage_parts.hpp"
#include "viewer/document/load_stage.hpp"

namespace burnish::viewer {
namespace {

// Whether the two differ in a parameter of the group.
bool differ_in(ParameterGroup group, const ParameterValues& a, const ParameterValues& b) {
    for (const Parameter& parameter : parameter_table()) {
        if (parameter.group != group) continue;
        const auto in_a = a.set_values().find(parameter.name);
        const auto in_b = b.set_values().find(parameter.name);
        const bool has_a = in_a != a.set_values().end(), has_b = in_b != b.set_values().end();
        if (has_a != has_b || (has_a && in_a->second != in_b->second)) return true;
    }
    return false;
}

double aspect_of(const RenderSettings& settings) {
    return static_cast<double>(settings.width) / settings.height;
}

std::vector<std::optional<TangentSource>> tangents_of(const Scene& scene) {
    std::vector<std::optional<TangentSource>> sources;
    sources.reserve(scene.meshes.size());
    for (const Mesh& mesh : scene.meshes) sources.push_back(mesh.tangent_source);
    return sources;
}

std::vector<std::pair<int, bool>> normal_maps_of(const Scene& scene) {
    std::vector<std::pair<int, bool>> maps;
    for (const Material& material : scene.materials) {
        maps.emplace_back(cloth_of(material) ? -1 : material.normal_texture.texture,
                          material.flip_green);
        maps.emplace_back(material.coat.normal_texture.texture, material.coat.flip_green);
    }
    return maps;
}

}  // namespace

// What a document changes without materials: made before anything is touched.
struct Editor::Change {
    ParameterValues values;
    std::vector<Light> lights;
    RenderSettings settings;
    Camera camera;
    double exposure_ev = 0;
    ToneMap tone_map = ToneMap::khronos_neutral;
    std::optional<Environment> environment;  // none: it stays
    std::vector<std::string> environment_warnings, value_warnings;
};

// Every instance must be shown.
Editor::Change Editor::change_to(const Document& document) const {
    const Document& old = history_.present();
    require_one_roughness(document.values, true);
    require_valid(document);
    Change change;
    change.values = stage_.file.values;
    change.values.merge(document.values);
    change.lights = drawn_lights(document, stage_.file.scene.lights);
    change.settings = render_settings(change.values);
    change.exposure_ev = change.values.real("exposure");
    change.tone_map = static_cast<ToneMap>(change.values.choice("tone_map"));
    const bool same_view = change.settings.width == stage_.settings.width &&
                           change.settings.height == stage_.settings.height &&
                           change.settings.ground == stage_.settings.ground &&
                           !differ_in(ParameterGroup::camera, change.values, stage_.values);
    change.camera = same_view ? stage_.camera
                              : place_camera(stage_.scene, change.values,
                                             aspect_.value_or(aspect_of(change.settings)));
    change.environment_warnings = stage_.warnings.environment;
    if (document.environment != old.environment) {
        change.environment_warnings.clear();
        change.environment = load_environment_of(stage_, document.input, document.environment,
                                                 change.environment_warnings);
    }
    warn_of_idle_values(change.values,
                        change.environment ? *change.environment : stage_.environment,
                        change.lights, change.value_warnings);
    for (std::string& line : warnings_of_missing(document, stage_))
        change.value_warnings.push_back(std::move(line));
    return change;
}

void Editor::apply_materials(const Document& document, const ParameterValues& values) {
    const std::vector<std::optional<TangentSource>> tangents = tangents_of(stage_.scene);
    const std::vector<Material> materials = stage_.scene.materials;
    const std::size_t textures = stage_.scene.textures.size();
    const std::map<int, std::uint64_t> texture_changes = stage_.materials.texture_changes();
    const std::vector<int> meshes = stage_.shown_meshes;
    take_remarks(stage_, stage_.materials.apply(stage_.scene, values,
                                                values_of_materials(document, stage_)));
    if (stage_.scene.materials != materials) ++revisions_.materials;
    stage_.materials.free_unused(stage_.scene);
    if (stage_.scene.textures.size() != textures ||
        stage_.materials.texture_changes() != texture_changes)
        ++revisions_.textures;
    remember_meshes(stage_);
    if (meshes != stage_.shown_meshes || tangents != tangents_of(stage_.scene))
        ++revisions_.geometry;
    std::vector<std::pair<int, bool>> maps = normal_maps_of(stage_.scene);
    if (maps == checked_normal_maps_) return;
    checked_normal_maps_ = std::move(maps);
    find_odd_normal_maps(stage_);
}

void Editor::replace_warnings() {
    std::vector<std::string> lines = all_warnings(stage_);
    new_warnings_.clear();
    for (const std::string& line : lines)
        if (std::ranges::find(stage_.scene.warnings, line) == stage_.scene.warnings.end())
            new_warnings_.push_back(line);
    stage_.scene.warnings = std::move(lines);
}

// The materials come last of all that may fail: they are applied completely or not at all.
void Editor::update_to(const Document& document) {
    const Document old = history_.present();
    hide_instances(stage_, {});
    Change change;
    try {
        change = change_to(document);
        if (document.material_values != old.material_values ||
            differ_in(ParameterGroup::material, document.values, old.values))
            apply_materials(document, change.values);
    } catch (...) {
        hide_instances(stage_, old.hidden);
        throw;
    }
    if (change.lights != stage_.scene.lights) ++revisions_.lights;
    if (change.settings != stage_.settings) ++revisions_.settings;
    if (change.camera != stage_.camera) ++revisions_.camera;
    if (change.exposure_ev != stage_.exposure_ev || change.tone_map != stage_.tone_map ||
        robust_limit(change.values) != robust_limit(stage_.values))
        ++revisions_.display;
    if (change.environment) ++revisions_.environment;
    if (document.hidden != old.hidden) ++revisions_.geometry;
    stage_.values = std::move(change.values);
    stage_.scene.lights = std::move(change.lights);
    stage_.settings = change.settings;
    stage_.camera = change.camera;
    stage_.exposure_ev = change.exposure_ev;
    stage_.tone_map = change.tone_map;
    if (change.environment) stage_.environment = std::move(*change.environment);
    stage_.warnings.environment = std::move(change.environment_warnings);
    stage_.warnings.values = std::move(change.value_warnings);
    hide_instances(stage_, document.hidden);
    replace_warnings();
}

// Takes a stage in which its document hides what it hides.
void Editor::adopt(Stage stage) {
    stage_ = std::move(stage);
    if (aspect_) stage_.camera = camera_of(*aspect_);
    new_warnings_ = stage_.scene.warnings;
    checked_normal_maps_ = normal_maps_of(stage_.scene);
    for (std::uint64_t* revision :
         {&revisions_.scene, &revisions_.geometry, &revisions_.materials, &revisions_.textures,
          &revisions_.lights, &revisions_.environment, &revisions_.camera, &revisions_.settings,
          &revisions_.display})
        ++*revision;
}

// All instances count, as in change_to.
Camera Editor::camera_of(double aspect) {
    std::vector<int> meshes;
    for (const Instance& instance : stage_.scene.instances) meshes.push_back(instance.mesh);
    hide_instances(stage_, {});
    const Camera camera = place_camera(stage_.scene, stage_.values, aspect);
    for (std::size_t i = 0; i < meshes.size(); ++i) stage_.scene.instances[i].mesh = meshes[i];
    return camera;
}

void Editor::set_aspect(double aspect) {
    if (aspect_ == aspect) return;
    aspect_ = aspect;
    if (stage_.scene.instances.empty()) return;
    const Camera camera = camera_of(aspect);
    if (camera == stage_.camera) return;
    stage_.camera = camera;
    ++revisions_.camera;
}

void Editor::go_to(const Document& document) {
    if (!needs_load(history_.present(), document)) return update_to(document);
    adopt(document.input.empty() ? Stage{} : load_stage(document));
}

void Editor::open(Document document, const Progress& progress) {
    Stage stage = load_stage(document, progress);
    open_loaded(std::move(document), std::move(stage));
}

void Editor::open_loaded(Document document, Stage stage) {
    document = with_state_of_input(std::move(document), stage);
    hide_instances(stage, document.hidden);
    adopt(std::move(stage));
    history_ = History(std::move(document));
}

void Editor::set(Document document, std::string_view key, std::string_view name) {
    if (document == history_.present()) return;
    if (needs_load(history_.present(), document)) {
        Stage stage = load_stage(document);
        return set_loaded(std::move(document), std::move(stage), name);
    }
    update_to(document);
    history_.record(std::move(document), key, name);
}

void Editor::put_in_place(int material, int other) {
    stage_.materials.put_in_place(static_cast<std::size_t>(material),
                                  static_cast<std::size_t>(other));
    hide_instances(stage_, {});
    apply_materials(document(), stage_.values);
    hide_instances(stage_, document().hidden);
}

void Editor::set_loaded(Document document, Stage stage, std::string_view name) {
    if (document.input != history_.present().input)
        document = with_state_of_input(std::move(document), stage);
    hide_instances(stage, document.hidden);
    adopt(std::move(stage));
    history_.record(std::move(document), {}, name);
}

bool Editor::undo() {
    const std::shared_ptr<const Document> target = history_.undo_document();
    if (target) go_to(*target);
    return history_.undo();
}

bool Editor::redo() {
    const std::shared_ptr<const Document> target = history_.redo_document();
    if (target) go_to(*target);
    return history_.redo();
}

bool Editor::undo_loaded(Stage stage) {
    if (history_.can_undo()) adopt(std::move(stage));
    return history_.undo();
}

bool Editor::redo_loaded(Stage stage) {
    if (history_.can_redo()) adopt(std::move(stage));
    return history_.redo();
}

void Editor::reload(const Progress& progress) {
    if (!document().input.empty()) reloaded(load_stage(document(), progress));
}

void Editor::reloaded(Stage stage) {
    adopt(std::move(stage));
}

}  // namespace burnish::viewer
