// Materials, objects, lights, environment and bookmarks; messages.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "burnish/stage.hpp"
#include "core/text.hpp"
#include "scene/camera/angles.hpp"
#include "viewer/document/scene_lists.hpp"
#include "viewer/window/file_dialog.hpp"
#include "viewer/window/panels.hpp"

namespace burnish::viewer {
namespace {

// Lists longer than this scroll.
constexpr std::size_t kMostRows = 8;

// A list of `rows` rows in a table of its own; EndTable is due where it is true.
bool begin_list(const char* id, int columns, std::size_t rows) {
    const float row = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y +
                      2 * ImGui::GetStyle().FramePadding.y;
    const bool scrolls = rows > kMostRows;
    return ImGui::BeginTable(id, columns,
                             ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg |
                                 ImGuiTableFlags_NoPadOuterX |
                                 (scrolls ? ImGuiTableFlags_ScrollY : 0),
                             {0, scrolls ? row * (static_cast<float>(kMostRows) + 0.5f) : 0.0f});
}

// The text as far as the cell goes, whole in a tooltip; clicked: true.
bool cell_selectable(const std::string& text, bool selected) {
    const bool clicked = ImGui::Selectable(fmt::format("{}##row", text).c_str(), selected,
                                           ImGuiSelectableFlags_AllowItemOverlap);
    const bool cut = ImGui::CalcTextSize(text.c_str()).x > ImGui::GetItemRectSize().x;
    if (cut && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
    return clicked;
}

// --- materials ------------------------------------------------------------------------------------

ImVec4 swatch_of(const glm::vec3& linear) {
    const auto display = [](float v) {
        return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
    };
    return {display(linear.x), display(linear.y), display(linear.z), 1};
}

void material_tip(const MaterialRow& row, std::size_t i) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::SetTooltip("%s\n%s, %s\nin scripts: #%zu%s", row.name.c_str(), row.kind.c_str(),
                      plural(static_cast<std::size_t>(row.objects), "object").c_str(), i,
                      row.has_texture ? "\nits base color has a texture" : "");
}

void materials(App& app) {
    const std::vector<MaterialRow> rows = material_rows(app.editor.stage());
    if (!begin_list("materials", 4, rows.size())) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const float side = ImGui::GetTextLineHeight();
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::ColorButton("##color", swatch_of(rows[i].color),
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                           {1.6f * side, side});
        material_tip(rows[i], i);
        ImGui::TableNextColumn();
        const bool selected = app.material == static_cast<int>(i);
        // Clicked again: all materials.
        if (cell_selectable(rows[i].name, selected))
            app.select_material(selected ? std::nullopt : std::optional(static_cast<int>(i)));
        material_tip(rows[i], i);
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", rows[i].kind.c_str());
        ImGui::TableNextColumn();
        ImGui::TextDisabled("x %d", rows[i].objects);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("objects that use it");
        ImGui::PopID();
    }
    ImGui::EndTable();
}

// --- objects --------------------------------------------------------------------------------------

std::string short_count(std::size_t n) {
    if (n >= 10000000) return fmt::format("{} M", n / 1000000);
    return n >= 10000 ? fmt::format("{} k", n / 1000) : std::to_string(n);
}

// Names of materials often differ at their ends.
std::string end_of(const std::string& name) {
    constexpr std::size_t kMost = 9;
    return name.size() > kMost ? ".." + name.substr(name.size() - kMost + 2) : name;
}

void object_row(App& app, const ObjectRow& row, int index) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    bool shown = row.shown;
    if (ImGui::Checkbox("##shown", &shown)) app.show_object(index, shown);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("drawn or not");
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    if (cell_selectable(fmt::format("{} {}", index, row.name), app.object == index))
        app.frame_object(index);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s\n%s, material %s\nin scripts: #%d\na click selects and frames it",
                          row.name.c_str(), plural(row.triangles, "triangle").c_str(),
                          material_name(app.scene(), row.material).c_str(), index);
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", short_count(row.triangles).c_str());
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", end_of(material_name(app.scene(), row.material)).c_str());
    ImGui::TableNextColumn();
    if (ImGui::SmallButton("solo")) app.solo_object(index);
}

void objects(App& app) {
    const std::vector<ObjectRow> rows = object_rows(app.document(), app.editor.stage());
    if (begin_list("objects", 5, rows.size())) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed);
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
        ImGuiListClipper clipper;  // scenes have thousands
        clipper.Begin(static_cast<int>(rows.size()));
        while (clipper.Step())
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                ImGui::PushID(i);
                object_row(app, rows[static_cast<std::size_t>(i)], i);
                ImGui::PopID();
            }
        ImGui::EndTable();
    }
    if (!app.document().hidden.empty() && ImGui::SmallButton("show all")) app.show_all_objects();
}

// --- lights ---------------------------------------------------------------------------------------

// Draws one light; true when it has changed.
bool light_rows(Light& light) {
    bool changed = false;
    if (light.type == LightType::directional) {
        const DirectionAngles angles = angles_of(-glm::dvec3(light.direction));
        float at[2] = {static_cast<float>(angles.azimuth_deg),
                       static_cast<float>(angles.elevation_deg)};
        if (ImGui::DragFloat2("az, el", at, 0.5f, -360, 360, "%.1f deg")) {
            light.direction = -glm::vec3(direction_at({at[0], std::clamp(at[1], -90.0f, 90.0f)}));
            changed = true;
        }
    } else {
        changed |= ImGui::DragFloat3("place, m", &light.position.x, 0.02f);
    }
    if (has_area(light)) {
        const char* sides = light.type == LightType::tube ? "length, diameter" : "size, m";
        changed |= ImGui::DragFloat2(sides, &light.size.x, 0.005f, 1e-3f, 100.0f);
    }
    const char* unit = light.type == LightType::directional ? "lux"
                       : has_area(light)                    ? "cd/m2"
                                                            : "candela";
    changed |= ImGui::SliderFloat(unit, &light.intensity, 0.0f, 1000.0f, "%.3g",
                                  ImGuiSliderFlags_Logarithmic);
    changed |= ImGui::ColorEdit3("color", &light.color.x, ImGuiColorEditFlags_Float);
    return changed;
}

void lights(App& app) {
    const std::vector<Light> lights = all_lights(app.document(), app.editor.stage());
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const int index = static_cast<int>(i);
        ImGui::PushID(index);
        static constexpr const char* kKinds[] = {"directional", "point", "spot",
                                                 "rectangle",   "disc",  "tube"};
        bool on = !app.document().dark.contains(index);
        if (ImGui::Checkbox("##on", &on)) app.switch_light(index, on);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("on or off");
        ImGui::SameLine();
        const std::string title =
            fmt::format("{} {}", i + 1, kKinds[static_cast<std::size_t>(lights[i].type)]);
        if (ImGui::RadioButton(title.c_str(), app.light == index)) app.light = index;
        const float button = ImGui::GetFrameHeight();
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - button);
        const bool removed = ImGui::SmallButton("x");
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("remove");
        if (app.light == index && !removed) {
            Light changed = lights[i];
            ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.6f);
            if (light_rows(changed)) app.change_light(index, changed);
            if (ImGui::IsItemDeactivated()) app.editor.close_step();
            ImGui::PopItemWidth();
        }
        ImGui::PopID();
        if (removed) return app.remove_light(index);
    }
    ImGui::TextDisabled("add");
    ImGui::SameLine();
    if (ImGui::SmallButton("directional")) app.add_light(LightType::directional);
    ImGui::SameLine();
    if (ImGui::SmallButton("point")) app.add_light(LightType::point);
    if (!app.document().lights) return;
    ImGui::SameLine();
    if (ImGui::SmallButton("those of the file"))
        app.edit({}, "lights", [](Document& d) {
            d.lights.reset();
            d.dark.clear();
        });
}

// --- environment ----------------------------------------------------------------------------------

bool is_panorama_file(const std::string& path) {
    return path.ends_with(".hdr") || path.ends_with(".exr");
}

void environment_choice(App& app) {
    const std::string now = app.document().environment;
    std::string name = now;
    const std::string of_file = app.editor.stage().file.environment;
    const std::string used = !now.empty()      ? now
                             : of_file.empty() ? std::string(kDefaultEnvironment)
                                               : of_file;
    const std::string shown = std::filesystem::path(used).filename().string();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 4.2f * ImGui::GetFontSize());
    if (ImGui::BeginCombo("##environment", shown.c_str())) {
        if (ImGui::Selectable("of the file, else builtin:studio", now.empty())) name.clear();
        for (const char* word : {"builtin:studio", "builtin:white", "builtin:black", "none"})
            if (ImGui::Selectable(word, now == word)) name = word;
        for (const std::string& path : app.remembered.recent) {
            if (!is_panorama_file(path)) continue;
            if (ImGui::Selectable(std::filesystem::path(path).filename().c_str(), now == path))
                name = path;
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", path.c_str());
        }
        ImGui::EndCombo();
    }
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s%s", used.c_str(),
                          now.empty() ? " (of the file, or the default)" : "");
    if (name != now) app.set_environment(name);
    ImGui::SameLine();
    if (ImGui::Button("file ...", {-1, 0}))
        ask_for(Ask::environment, std::filesystem::current_path().string() + "/");
}

void environment(App& app) {
    environment_choice(app);
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.6f);
    const ParameterValues& values = app.editor.stage().values;  // those of a scene file too
    auto turn = static_cast<float>(values.real("environment_rotation"));
    if (ImGui::SliderFloat("rotation", &turn, -180, 180, "%.1f deg"))
        app.set_parameter("environment_rotation", static_cast<double>(turn));
    if (ImGui::IsItemDeactivated()) app.editor.close_step();
    auto intensity = static_cast<float>(values.real("environment_intensity"));
    if (ImGui::SliderFloat("intensity", &intensity, 0, 10, "%.2f",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
        app.set_parameter("environment_intensity", static_cast<double>(intensity));
    if (ImGui::IsItemDeactivated()) app.editor.close_step();
    ImGui::PopItemWidth();
    bool background = app.shows_background();
    if (ImGui::Checkbox("shown as background", &background)) app.show_background(background);
}

// --- bookmarks ------------------------------------------------------------------------------------

void bookmarks(App& app) {
    const std::vector<Bookmark> all = app.document().bookmarks;
    static std::string renamed;  // what is typed, and over which name
    static std::string typed;
    const float wide = ImGui::GetContentRegionAvail().x - 4.6f * ImGui::GetFontSize();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string& name = all[i].name;
        ImGui::PushID(static_cast<int>(i));
        std::string text = renamed == name ? typed : name;
        ImGui::SetNextItemWidth(wide);
        if (ImGui::InputText("##name", &text)) {
            renamed = name;
            typed = text;
        }
        const bool done = ImGui::IsItemDeactivatedAfterEdit();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("type to rename");
        ImGui::SameLine();
        if (ImGui::SmallButton("go")) app.go_to_view(name);
        ImGui::SameLine();
        const bool removed = ImGui::SmallButton("x");
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("delete");
        ImGui::PopID();
        if (done) {
            renamed.clear();
            return app.rename_view(name, typed);
        }
        if (removed) return app.delete_view(name);
    }
    if (ImGui::SmallButton("keep this view")) app.keep_view("");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("B; N goes to the next one");
}

}  // namespace

void scene_panel(App& app) {
    const Scene& scene = app.scene();
    std::size_t triangles = 0;
    for (const Instance& i : scene.instances)
        if (i.mesh >= 0)
            triangles += scene.meshes[static_cast<std::size_t>(i.mesh)].indices.size() / 3;
    ImGui::TextUnformatted(app.title().c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", app.name_of_scene().path.c_str());
    ImGui::TextDisabled("%s, %s", plural(scene.instances.size(), "object").c_str(),
                        plural(triangles, "triangle").c_str());
    constexpr ImGuiTreeNodeFlags kOpen = ImGuiTreeNodeFlags_DefaultOpen;
    if (ImGui::CollapsingHeader("Materials", kOpen)) materials(app);
    if (ImGui::CollapsingHeader("Objects", scene.instances.size() > 1 ? kOpen : 0)) objects(app);
    if (ImGui::CollapsingHeader("Lights", kOpen)) lights(app);
    if (ImGui::CollapsingHeader("Environment", kOpen)) environment(app);
    if (ImGui::CollapsingHeader("Bookmarks of the camera", kOpen)) bookmarks(app);
    if (ImGui::CollapsingHeader("View", kOpen)) {
        ImGui::SetNextItemWidth(-1);
        if (ImGui::BeginCombo(
                "##view",
                std::string(surface_view_names()[static_cast<std::size_t>(app.view)]).c_str())) {
            for (std::size_t i = 0; i < surface_view_names().size(); ++i)
                if (ImGui::Selectable(std::string(surface_view_names()[i]).c_str(),
                                      static_cast<std::size_t>(app.view) == i))
                    app.view = static_cast<SurfaceView>(i);
            ImGui::EndCombo();
        }
    }
}

void message_panel(App& app) {
    if (const std::string missing = app.missing_files(); !missing.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, {1.0f, 0.6f, 0.5f, 1});
        ImGui::TextWrapped("true now: %s", missing.c_str());
        ImGui::PopStyleColor();
        ImGui::Separator();
    }
    for (auto it = app.messages.rbegin(); it != app.messages.rend(); ++it) {
        if (it->is_error) ImGui::PushStyleColor(ImGuiCol_Text, {1.0f, 0.6f, 0.5f, 1});
        ImGui::TextWrapped("%s", it->text.c_str());
        if (it->is_error) ImGui::PopStyleColor();
        ImGui::Separator();
    }
    if (!app.editor.warnings().empty()) {
        ImGui::TextDisabled("true of what is shown now:");
        for (const std::string& line : app.editor.warnings())
            ImGui::TextWrapped("%s", line.c_str());
    }
}

}  // namespace burnish::viewer
