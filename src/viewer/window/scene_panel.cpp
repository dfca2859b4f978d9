// Lights, environment, parts and bookmarks; methods to compare; messages.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "burnish/stage.hpp"
#include "core/text.hpp"
#include "scene/camera/angles.hpp"
#include "viewer/window/app_parts.hpp"
#include "viewer/window/panels.hpp"

namespace burnish::viewer {
namespace {

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
    changed |=
        ImGui::SliderFloat(light.type == LightType::directional ? "lux" : "candela",
                           &light.intensity, 0.0f, 1000.0f, "%.3g", ImGuiSliderFlags_Logarithmic);
    changed |= ImGui::ColorEdit3("color", &light.color.x, ImGuiColorEditFlags_Float);
    return changed;
}

void lights(App& app) {
    std::vector<Light> lights = app.scene().lights;
    bool changed = false;
    int removed = -1;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        static constexpr const char* kKinds[] = {"directional", "point", "spot"};
        const std::string title =
            fmt::format("{} {}", kKinds[static_cast<std::size_t>(lights[i].type)], i + 1);
        if (ImGui::RadioButton(title.c_str(), app.light == static_cast<int>(i)))
            app.light = static_cast<int>(i);
        ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight());
        if (ImGui::SmallButton("x")) removed = static_cast<int>(i);
        if (app.light == static_cast<int>(i)) {
            ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.6f);
            changed |= light_rows(lights[i]);
            ImGui::PopItemWidth();
        }
        ImGui::PopID();
    }
    if (removed >= 0) lights.erase(lights.begin() + removed);
    bool added = false;
    if (lights.size() < 16) {
        if (ImGui::SmallButton("add a light")) {
            lights.push_back(parse_light("30,45"));
            app.light = static_cast<int>(lights.size()) - 1;
            added = true;
        }
    }
    if (app.document().lights) {
        ImGui::SameLine();
        if (ImGui::SmallButton("lights of the file"))
            app.edit({}, "lights", [](Document& d) { d.lights.reset(); });
    }
    if (changed || removed >= 0 || added)
        app.edit(changed ? "light" : "", "lights", [&](Document& d) { d.lights = lights; });
    if (!ImGui::IsAnyItemActive() && changed) app.editor.close_step();
}

void environment(App& app) {
    const std::string& now = app.document().environment;
    std::string name = now;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##environment", now.empty() ? "builtin:studio" : now.c_str())) {
        for (const char* word : {"builtin:studio", "builtin:white", "builtin:black", "none"})
            if (ImGui::Selectable(word, name == word)) name = word;
        for (const std::string& path : app.remembered.recent)
            if (path.ends_with(".hdr") || path.ends_with(".exr"))
                if (ImGui::Selectable(path.c_str())) name = path;
        ImGui::EndCombo();
    }
    if (name != now) app.edit({}, "environment", [&](Document& d) { d.environment = name; });
    ImGui::TextDisabled("drop an .hdr or .exr for another");
}

void parts(App& app) {
    const Scene& scene = app.scene();
    if (scene.instances.size() < 2) return;
    if (!ImGui::CollapsingHeader("Parts")) return;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const int id = static_cast<int>(i);
        bool shown = !app.document().hidden.contains(id);
        const int mesh = scene.instances[i].mesh;
        const std::string name = mesh >= 0 ? scene.meshes[static_cast<std::size_t>(mesh)].name
                                           : std::string("hidden part");
        if (ImGui::Checkbox(fmt::format("{} {}", i, name).c_str(), &shown))
            app.edit({}, "parts", [&](Document& d) {
                if (shown)
                    d.hidden.erase(id);
                else
                    d.hidden.insert(id);
            });
        ImGui::PopID();
    }
}

void bookmarks(App& app) {
    if (!ImGui::CollapsingHeader("Bookmarks of the camera")) return;
    const std::vector<Bookmark> all = app.document().bookmarks;
    for (std::size_t i = 0; i < all.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(all[i].name.c_str(), false, 0,
                              {ImGui::GetContentRegionAvail().x - 2 * ImGui::GetFrameHeight(), 0}))
            app.edit({}, "bookmark", [&](Document& d) {
                viewer::set_camera(d, all[i].position, all[i].target, all[i].fov_deg);
            });
        ImGui::SameLine();
        if (ImGui::SmallButton("x"))
            app.edit({}, "bookmarks", [&](Document& d) {
                d.bookmarks.erase(d.bookmarks.begin() + static_cast<std::ptrdiff_t>(i));
            });
        ImGui::PopID();
    }
    if (ImGui::SmallButton("keep this view")) {
        const Camera& camera = app.editor.stage().camera;
        app.edit({}, "bookmarks", [&](Document& d) {
            d.bookmarks.push_back({fmt::format("view {}", d.bookmarks.size() + 1), camera.position,
                                   camera.target, fov_deg_of(camera)});
        });
    }
}

}  // namespace

void scene_panel(App& app) {
    const Scene& scene = app.scene();
    std::size_t triangles = 0;
    for (const Instance& i : scene.instances)
        if (i.mesh >= 0)
            triangles += scene.meshes[static_cast<std::size_t>(i.mesh)].indices.size() / 3;
    ImGui::TextWrapped("%s", app.document().input.c_str());
    ImGui::TextDisabled("%s, %s", plural(triangles, "triangle").c_str(),
                        plural(scene.materials.size(), "material").c_str());
    if (ImGui::CollapsingHeader("Lights", ImGuiTreeNodeFlags_DefaultOpen)) lights(app);
    if (ImGui::CollapsingHeader("Environment", ImGuiTreeNodeFlags_DefaultOpen)) environment(app);
    parts(app);
    bookmarks(app);
    if (ImGui::CollapsingHeader("View", ImGuiTreeNodeFlags_DefaultOpen)) {
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

void compare_panel(App& app) {
    Compare compare = app.document().compare;
    ImGui::TextWrapped("The same camera, light and exposure under two to four methods.");
    for (std::size_t i = 0; i < compare_mode_names().size(); ++i) {
        const std::string name(compare_mode_names()[i]);
        if (i != 0 && i != 3) ImGui::SameLine();  // two rows fit the panel
        if (ImGui::RadioButton(name.c_str(), compare.mode == static_cast<CompareMode>(i)))
            compare.mode = static_cast<CompareMode>(i);
    }
    ImGui::Spacing();
    if (ImGui::Button(app.before ? "let \"before\" go" : "hold this as \"before\""))
        app.before ? app.release() : app.hold();
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "compares materials and models as they are now with what you change next");
    ImGui::Spacing();
    for (std::size_t i = 0; i < compare.methods.size() && !app.before; ++i) {
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.75f);
        if (ImGui::BeginCombo("##method", std::string(name_of(compare.methods[i])).c_str())) {
            for (std::size_t m = 0; m < method_names().size(); ++m) {
                const auto method = static_cast<Method>(m);
                const bool used =
                    std::ranges::find(compare.methods, method) != compare.methods.end();
                if (ImGui::Selectable(std::string(method_names()[m]).c_str(),
                                      compare.methods[i] == method,
                                      used ? ImGuiSelectableFlags_Disabled : 0))
                    compare.methods[i] = method;
            }
            ImGui::EndCombo();
        }
        if (compare.methods.size() > kLeastCompared) {
            ImGui::SameLine();
            if (ImGui::SmallButton("x")) {
                compare.methods.erase(compare.methods.begin() + static_cast<std::ptrdiff_t>(i));
                compare.dividers.clear();
            }
        }
        ImGui::PopID();
    }
    if (!app.before && compare.methods.size() < kMostCompared && ImGui::SmallButton("one more")) {
        for (const Method m : {Method::gram_schmidt, Method::deform_smooth, Method::rotate_exact,
                               Method::none, Method::normal_map, Method::follow_grain})
            if (std::ranges::find(compare.methods, m) == compare.methods.end()) {
                compare.methods.push_back(m);
                compare.dividers.clear();
                break;
            }
    }
    if (compare.mode == CompareMode::difference) {
        auto gain = static_cast<float>(compare.gain);
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.6f);
        if (ImGui::SliderFloat("gain", &gain, 0.5f, 64, "%.3g", ImGuiSliderFlags_Logarithmic))
            compare.gain = static_cast<double>(gain);
    }
    if (compare.mode == CompareMode::flip)
        ImGui::TextWrapped(
            "FLIP (Andersson et al. 2020): the difference that a person sees between two "
            "pictures shown by turns, 0 to 1, at 67 pixels a degree.");
    if (compare.mode == CompareMode::difference || compare.mode == CompareMode::flip)
        ImGui::TextDisabled("of the first two methods; mean %.4f", app.compared.mean());
    if (compare != app.document().compare)
        app.edit("compare", "compare", [&](Document& d) { d.compare = compare; });
}

void message_panel(App& app) {
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
