// The frame of the window: menu, panels at both sides, the picture between them, the status bar, keys.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/text.hpp"
#include "viewer/document/value_in_effect.hpp"
#include "viewer/window/file_dialog.hpp"
#include "viewer/window/panels.hpp"
#include "viewer/window/theme.hpp"

namespace burnish::viewer {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoTitleBar |
                                    ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

// --- menu -----------------------------------------------------------------------------------------

std::string short_name(const std::string& path) {
    return path.starts_with("builtin:") ? path : std::filesystem::path(path).filename().string();
}

void file_menu(App& app) {
    if (ImGui::MenuItem("Open ...", "Ctrl+O")) press_key(app, "ctrl+o");
    if (ImGui::BeginMenu("Open recent", !app.remembered.recent.empty())) {
        const std::vector<std::string> recent = app.remembered.recent;
        for (const std::string& path : recent) {
            if (ImGui::MenuItem(short_name(path).c_str())) app.open({path});
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", path.c_str());
        }
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("Built in")) {
        for (const char* name : {"builtin:sphere", "builtin:torus", "builtin:cylinder",
                                 "builtin:plane", "builtin:drape", "builtin:pot"})
            if (ImGui::MenuItem(name)) app.open({name});
        ImGui::EndMenu();
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Save scene ...", "Ctrl+S")) press_key(app, "ctrl+s");
    if (ImGui::MenuItem("Save picture ...", "Ctrl+P")) press_key(app, "ctrl+p");
    if (ImGui::MenuItem("Save turntable ...")) ask_for(Ask::turntable, "turn.png");
    if (ImGui::MenuItem("Save maps ...")) ask_for(Ask::maps, "maps");
    if (ImGui::MenuItem("Export materials as glTF ...")) ask_for(Ask::gltf, "material");
    if (ImGui::MenuItem("Copy command line", "Ctrl+Shift+C")) app.copy_command_line();
    ImGui::Separator();
    if (ImGui::MenuItem("Quit", "Ctrl+Q")) app.window.close();
}

void edit_menu(App& app) {
    const History& history = app.editor.history();
    const std::string undo = fmt::format("Undo {}", history.undo_name());
    const std::string redo = fmt::format("Redo {}", history.redo_name());
    if (ImGui::MenuItem(undo.c_str(), "Ctrl+Z", false, history.can_undo())) app.undo();
    if (ImGui::MenuItem(redo.c_str(), "Ctrl+Y", false, history.can_redo())) app.redo();
    ImGui::Separator();
    if (ImGui::MenuItem("Reload shaders", "F5")) app.reload_shaders();
}

void view_menu(App& app) {
    if (ImGui::MenuItem("Frame everything", "F")) app.frame_all();
    if (ImGui::MenuItem("Camera of the file", "Home"))
        app.edit({}, "camera", [](Document& d) { unset_camera(d); });
    ImGui::MenuItem("Turntable", "T", &app.turntable);
    if (ImGui::BeginMenu("Navigation")) {
        Remembered& r = app.remembered;
        if (ImGui::MenuItem("as glTF viewers", nullptr, r.navigation == Navigation::viewer))
            r.navigation = Navigation::viewer;
        if (ImGui::MenuItem("as Blender", nullptr, r.navigation == Navigation::blender))
            r.navigation = Navigation::blender;
        ImGui::MenuItem("touchpad: two fingers orbit", nullptr, &r.touchpad);
        ImGui::EndMenu();
    }
    ImGui::Separator();
    for (std::size_t i = 0; i < surface_view_names().size(); ++i) {
        std::string name(surface_view_names()[i]);
        std::replace(name.begin(), name.end(), '-', ' ');
        if (ImGui::MenuItem(name.c_str(), nullptr, static_cast<std::size_t>(app.view) == i))
            app.view = static_cast<SurfaceView>(i);
    }
    ImGui::Separator();
    ImGui::MenuItem("All panels", "Tab", &app.show_panels);
    ImGui::MenuItem("Parameters", "1", &app.panels.parameters);
    ImGui::MenuItem("Scene", "2", &app.panels.scene);
    ImGui::MenuItem("Compare", "3", &app.panels.compare);
    ImGui::MenuItem("Lobe inspector", "4", &app.panels.inspector);
    ImGui::MenuItem("Messages", "5", &app.panels.messages);
    ImGui::MenuItem("Costs", "6", &app.panels.costs);
    ImGui::MenuItem("Scratches", "7", &app.panels.generator);
}

void compare_menu(App& app) {
    const Compare& now = app.document().compare;
    for (std::size_t i = 0; i < compare_mode_names().size(); ++i) {
        const auto mode = static_cast<CompareMode>(i);
        const std::string name(compare_mode_names()[i]);
        if (ImGui::MenuItem(name.c_str(), nullptr, now.mode == mode))
            app.edit({}, "compare", [&](Document& d) { d.compare.mode = mode; });
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Choose methods or materials ...", "3")) app.panels.compare = true;
    if (ImGui::MenuItem("Before and after: hold this", "H", app.holds_before()))
        press_key(app, "h");
}

float menu_bar(App& app) {
    float height = 0;
    if (!ImGui::BeginMainMenuBar()) return height;
    height = ImGui::GetWindowSize().y;
    if (ImGui::BeginMenu("File")) file_menu(app), ImGui::EndMenu();
    if (ImGui::BeginMenu("Edit")) edit_menu(app), ImGui::EndMenu();
    if (ImGui::BeginMenu("View")) view_menu(app), ImGui::EndMenu();
    if (ImGui::BeginMenu("Compare")) compare_menu(app), ImGui::EndMenu();
    if (ImGui::BeginMenu("Help")) {
        ImGui::MenuItem("Keys", "?", &app.panels.keys);
        ImGui::MenuItem("Guide: docs/guide/viewer.md", nullptr, false, false);
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
    return height;
}

// --- status bar -----------------------------------------------------------------------------------

void status_bar(App& app) {
    if (app.loading()) {
        const auto [stage, done] = app.loader().progress();
        ImGui::ProgressBar(static_cast<float>(done), {120 * static_cast<float>(app.ui_scale), 0},
                           "");
        ImGui::SameLine();
        ImGui::Text("%s: %s", short_name(app.loader().name()).c_str(), stage.c_str());
        ImGui::SameLine();
        if (ImGui::SmallButton("cancel")) app.loader().stop();
        return;
    }
    if (app.has_fresh_message()) {
        const Message& last = app.messages.back();
        ImGui::TextColored(
            last.is_error ? ImVec4{1.0f, 0.55f, 0.45f, 1} : ImVec4{0.95f, 0.88f, 0.7f, 1}, "%s",
            last.text.c_str());
        return;
    }
    if (const std::string missing = app.missing_files(); !missing.empty()) {
        ImGui::TextColored({1.0f, 0.55f, 0.45f, 1}, "%s", missing.c_str());
        return;
    }
    const char* orbit = app.remembered.navigation == Navigation::blender ? "middle drag" : "drag";
    const std::string hint =
        app.editor.history().can_undo()
            ? fmt::format(
                  "{}: orbit    shift+drag: put the highlight there    click: the lobe at a "
                  "point    ?: keys",
                  orbit)
            : fmt::format(
                  "A {} turns it. Shift+drag on the surface puts the highlight there. Drop "
                  "a model or a picture on the window.",
                  orbit);
    ImGui::TextDisabled("%s", hint.c_str());
    const int simple = app.picture.stand_ins();
    const std::string right =
        app.picture.at_rest() ? fmt::format("{} samples", app.picture.samples())
        : simple > 0          ? fmt::format("compiling shaders of {} materials", simple)
                     : fmt::format("{}/{} samples  {:.0f} %  {:.0f} fps", app.picture.samples(),
                                   app.picture.wanted_samples(), 100 * app.picture.scale(),
                                   app.frames_per_second);
    const float width = ImGui::CalcTextSize(right.c_str()).x;
    ImGui::SameLine(ImGui::GetWindowWidth() - width - 12 * static_cast<float>(app.ui_scale));
    ImGui::TextUnformatted(right.c_str());
}

void recovery(App& app) {
    if (!app.recovered || !app.asks_recovery) return;
    ImGui::OpenPopup("Recover");
    ImGui::SetNextWindowPos(
        {0.5f * ImGui::GetIO().DisplaySize.x, 0.5f * ImGui::GetIO().DisplaySize.y},
        ImGuiCond_Appearing, {0.5f, 0.5f});
    if (!ImGui::BeginPopupModal("Recover", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
    ImGui::TextUnformatted("The last session ended without saving. Its scene was kept.");
    ImGui::TextUnformatted(text_of_offer(*app.recovered).c_str());
    static constexpr std::pair<const char*, App::Recovery> kChoices[] = {
        {"Open it", App::Recovery::open},
        {"Later", App::Recovery::later},
        {"Delete it", App::Recovery::remove}};
    for (const auto& [text, choice] : kChoices) {
        if (ImGui::Button(text)) {
            app.recover(choice);
            ImGui::CloseCurrentPopup();
            break;
        }
        ImGui::SameLine();
    }
    ImGui::NewLine();
    ImGui::EndPopup();
}

// --- keys -----------------------------------------------------------------------------------------

struct KeyBinding {
    std::string_view keys, does;
    void (*run)(App&);
};

template <bool Panels::*Panel>
void toggle(App& app) {
    app.panels.*Panel = !(app.panels.*Panel);
}

void cycle_compare(App& app) {
    app.edit({}, "compare", [](Document& d) {
        d.compare.mode = static_cast<CompareMode>((static_cast<int>(d.compare.mode) + 1) % 5);
    });
}

void cycle_view(App& app) {
    app.view = static_cast<SurfaceView>((static_cast<std::size_t>(app.view) + 1) %
                                        surface_view_names().size());
}

void cycle_method(App& app) {
    const Parameter& p = *find_parameter("method");
    const auto now =
        value_in_effect(app.document(), app.editor.stage(), "method", app.material).value;
    const int index = now ? std::get<ParameterChoice>(*now).index : 0;
    app.set_parameter("method", ParameterChoice{(index + 1) % static_cast<int>(p.choices.size())});
    app.editor.close_step();
}

void next_object(App& app) {
    const int count = static_cast<int>(app.scene().instances.size());
    if (count > 0) app.frame_object(app.object ? (*app.object + 1) % count : 0);
}

// Behind the last one come all.
void next_material(App& app) {
    const int next = app.material ? *app.material + 1 : 0;
    const bool all = next >= static_cast<int>(app.scene().materials.size());
    app.select_material(all ? std::nullopt : std::optional(next));
}

void next_light(App& app) {
    const int count = static_cast<int>(app.scene().lights.size());
    if (count > 0) app.light = (app.light + 1) % count;
}

const std::vector<KeyBinding>& bindings() {
    static const std::vector<KeyBinding> all = {
        {"f", "frame everything", [](App& a) { a.frame_all(); }},
        {"home", "the camera of the file",
         [](App& a) { a.edit({}, "camera", [](Document& d) { unset_camera(d); }); }},
        {"t", "turntable", [](App& a) { a.turntable = !a.turntable; }},
        {"m", "next method", cycle_method},
        {"c", "next way to compare", cycle_compare},
        {"h", "hold this as \"before\", or let it go",
         [](App& a) { a.holds_before() ? a.release() : a.hold(); }},
        {"v", "next view of what is behind", cycle_view},
        {"b", "keep this view of the camera", [](App& a) { a.keep_view(""); }},
        {"n", "the next view that was kept", [](App& a) { a.next_view(); }},
        {"o", "the next object: select and frame it", next_object},
        {"x", "hide the selected object, or show it",
         [](App& a) {
             if (const auto object = a.object)
                 a.show_object(*object, a.document().hidden.contains(*object));
         }},
        {"s", "the selected object alone, or all",
         [](App& a) {
             if (const auto object = a.object) a.solo_object(*object);
         }},
        {"j", "the next material", next_material},
        {"l", "the next light", next_light},
        {"k", "the selected light off, or on",
         [](App& a) { a.switch_light(a.light, a.document().dark.contains(a.light)); }},
        {"e", "the environment as background, or a color",
         [](App& a) { a.show_background(!a.shows_background()); }},
        {"g", "the ground's shadow",
         [](App& a) {
             a.set_parameter("ground", !a.editor.stage().settings.ground);
             a.editor.close_step();
         }},
        {"[", "darker by 1/3 EV",
         [](App& a) {
             a.set_parameter("exposure", std::max(-20.0, a.editor.stage().exposure_ev - 1.0 / 3));
         }},
        {"]", "brighter by 1/3 EV",
         [](App& a) {
             a.set_parameter("exposure", std::min(20.0, a.editor.stage().exposure_ev + 1.0 / 3));
         }},
        {"tab", "panels away and back", [](App& a) { a.show_panels = !a.show_panels; }},
        {"1", "parameters", toggle<&Panels::parameters>},
        {"2", "scene", toggle<&Panels::scene>},
        {"3", "compare", toggle<&Panels::compare>},
        {"4", "lobe inspector", toggle<&Panels::inspector>},
        {"5", "messages", toggle<&Panels::messages>},
        {"6", "costs", toggle<&Panels::costs>},
        {"7", "generator of scratches", toggle<&Panels::generator>},
        {"?", "these keys", toggle<&Panels::keys>},
        {"ctrl+z", "undo", [](App& a) { a.undo(); }},
        {"ctrl+y", "redo", [](App& a) { a.redo(); }},
        {"ctrl+o", "open a file",
         [](App& a) {
             ask_for(Ask::open, std::filesystem::current_path().string() + "/");
             (void)a;
         }},
        {"ctrl+s", "save the scene",
         [](App& a) { ask_for(Ask::scene, proposed_scene_file(a.name_of_scene())); }},
        {"ctrl+p", "save the picture",
         [](App& a) {
             ask_for(Ask::picture, "picture.png");
             (void)a;
         }},
        {"ctrl+shift+c", "copy the command line", [](App& a) { a.copy_command_line(); }},
        {"f5", "reload shaders", [](App& a) { a.reload_shaders(); }},
        {"ctrl+q", "quit", [](App& a) { a.window.close(); }},
    };
    return all;
}

// GLFW's numbers of keys without a letter.
constexpr int kTab = 258, kHome = 268, kF5 = 294;

bool is_pressed(std::string_view keys) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool ctrl = keys.starts_with("ctrl+");
    if (ctrl) keys.remove_prefix(5);
    const bool shift = keys.starts_with("shift+");
    if (shift) keys.remove_prefix(6);
    if (io.KeyCtrl != ctrl) return false;
    if (keys == "?") {
        // Wherever the keyboard has it.
        return std::any_of(io.InputQueueCharacters.begin(), io.InputQueueCharacters.end(),
                           [](ImWchar c) { return c == '?'; });
    }
    if (io.KeyShift != shift) return false;
    int key = 0;
    if (keys == "tab")
        key = kTab;
    else if (keys == "home")
        key = kHome;
    else if (keys == "f5")
        key = kF5;
    else if (keys.size() == 1)
        key = keys[0] >= 'a' && keys[0] <= 'z' ? keys[0] - 32 : keys[0];
    return ImGui::IsKeyPressed(key, false);
}

void handle_keys(App& app) {
    if (ImGui::GetIO().WantTextInput || is_asking()) return;
    for (const KeyBinding& binding : bindings())
        if (is_pressed(binding.keys)) binding.run(app);
}

using PanelFunction = void (*)(App&);

// The panels of the right side share its place: opening one closes the others.
struct Tab {
    bool Panels::*open;
    const char* title;
    PanelFunction draw;
};
constexpr Tab kTabs[] = {{&Panels::scene, "Scene", scene_panel},
                         {&Panels::compare, "Compare", compare_panel},
                         {&Panels::inspector, "Lobe", inspector_panel},
                         {&Panels::generator, "Scratches", generator_panel},
                         {&Panels::costs, "Costs", costs_panel},
                         {&Panels::messages, "Log", message_panel}};

void leave_one_open(Panels& panels) {
    static Panels before;
    for (const Tab& tab : kTabs) {
        if (!(panels.*tab.open) || before.*tab.open) continue;
        for (const Tab& other : kTabs) panels.*other.open = &other == &tab;
        break;
    }
    bool found = false;
    for (const Tab& tab : kTabs) {
        if (found) panels.*tab.open = false;
        found = found || panels.*tab.open;
    }
    before = panels;
}

// Return the width that they take.
float left_side(App& app, float top, float width, float height) {
    if (!app.show_panels || !app.panels.parameters) return 0;
    ImGui::SetNextWindowPos({0, top});
    ImGui::SetNextWindowSize({width, height});
    if (ImGui::Begin("##left", nullptr, kFixed)) parameter_panel(app);
    ImGui::End();
    return width;
}

float right_side(App& app, float x, float top, float width, float height) {
    leave_one_open(app.panels);
    const bool open = std::ranges::any_of(kTabs, [&](const Tab& t) { return app.panels.*t.open; });
    if (!app.show_panels || !open) return 0;
    ImGui::SetNextWindowPos({x, top});
    ImGui::SetNextWindowSize({width, height});
    if (ImGui::Begin("##right", nullptr, kFixed)) {
        const Tab* shown = nullptr;
        const ImVec2 padding = ImGui::GetStyle().FramePadding;
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.5f * padding.x, padding.y});
        for (const Tab& tab : kTabs) {
            const bool on = app.panels.*tab.open;
            ImGui::PushStyleColor(
                ImGuiCol_Button,
                ImGui::GetStyleColorVec4(on ? ImGuiCol_TabActive : ImGuiCol_WindowBg));
            if (ImGui::Button(tab.title)) app.panels.*tab.open = !on;
            ImGui::PopStyleColor();
            ImGui::SameLine(0, 2);
            if (on) shown = &tab;
        }
        ImGui::PopStyleVar();
        ImGui::NewLine();
        ImGui::Separator();
        if (shown != nullptr) {
            if (ImGui::BeginChild(shown->title)) shown->draw(app);
            ImGui::EndChild();
        }
    }
    ImGui::End();
    return width;
}

}  // namespace

bool press_key(App& app, std::string_view keys) {
    for (const KeyBinding& binding : bindings())
        if (binding.keys == keys) {
            binding.run(app);
            return true;
        }
    return false;
}

void keys_panel(App& app) {
    const auto scale = static_cast<float>(app.ui_scale);
    ImGui::SetNextWindowPos(
        {0.5f * ImGui::GetIO().DisplaySize.x, 0.5f * ImGui::GetIO().DisplaySize.y},
        ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({860 * scale, 0});
    if (ImGui::Begin("Keys", &app.panels.keys,
                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings)) {
        const auto mouse = mouse_help(app.remembered.navigation, app.remembered.touchpad);
        std::vector<std::pair<std::string, std::string>> rows(mouse.begin(), mouse.end());
        for (const KeyBinding& binding : bindings()) rows.emplace_back(binding.keys, binding.does);
        const std::size_t half = (rows.size() + 1) / 2;
        if (ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit)) {
            for (std::size_t i = 0; i < half; ++i) {
                ImGui::TableNextRow();
                for (const std::size_t k : {i, i + half}) {
                    if (k >= rows.size()) continue;
                    ImGui::TableNextColumn();
                    ImGui::TextUnformatted(rows[k].first.c_str());
                    ImGui::TableNextColumn();
                    ImGui::TextDisabled("%s", rows[k].second.c_str());
                }
            }
            ImGui::EndTable();
        }
    }
    ImGui::End();
}

void draw_interface(App& app) {
    const Measures m = measures(static_cast<float>(app.ui_scale));
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    handle_keys(app);
    const float top = menu_bar(app);
    const float height = screen.y - top - m.status;
    const float left = left_side(app, top, m.left, height);
    // One width for all tabs: the picture stays where it is when another is opened.
    // In a small window it is as narrow as the left panel.
    const float side = std::clamp(screen.x - left - m.right, m.left, m.right);
    const float right = right_side(app, screen.x - side, top, side, height);
    app.picture_x = static_cast<int>(left);
    app.picture_y = static_cast<int>(top);
    app.picture_width = std::max(16, static_cast<int>(screen.x - left - right));
    app.picture_height = std::max(16, static_cast<int>(height));
    ImGui::SetNextWindowPos({0, screen.y - m.status});
    ImGui::SetNextWindowSize({screen.x, m.status});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8, 3});
    if (ImGui::Begin("##status", nullptr, kFixed | ImGuiWindowFlags_NoScrollbar)) status_bar(app);
    ImGui::End();
    ImGui::PopStyleVar();
    if (app.panels.keys) keys_panel(app);
    draw_dialog(app);
    recovery(app);
    picture_view(app);
}

}  // namespace burnish::viewer
