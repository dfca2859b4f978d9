#include "viewer/window/file_dialog.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/turntable.hpp"
#include "viewer/document/file_names.hpp"

namespace burnish::viewer {
namespace {

struct Dialog {
    Ask ask = Ask::none;
    std::string path;
    std::string failed;
    bool opened = false;
    int turn = 0;  // what turns on a turntable
    std::string parameter;
};

Dialog& dialog() {
    static Dialog one;
    return one;
}

const char* title_of(Ask ask) {
    switch (ask) {
        case Ask::open:
            return "Open a file";
        case Ask::scene:
            return "Save the scene";
        case Ask::picture:
            return "Save the picture";
        case Ask::turntable:
            return "Save a turntable of 48 frames";
        case Ask::gltf:
            return "Export the materials as glTF";
        case Ask::maps:
            return "Save the maps of scratches or of a weave";
        case Ask::compared:
            return "Compare with a material of a file";
        case Ask::environment:
            return "Light the scene with an environment";
        case Ask::value:
            return "Choose a file or a folder";
        case Ask::none:
            break;
    }
    return "";
}

void run_dialog(App& app, const Dialog& d) {
    if (d.ask == Ask::open) return app.open({d.path});
    if (d.ask == Ask::scene) return app.save_scene(d.path);
    if (d.ask == Ask::picture) return app.save_picture(d.path, std::nullopt);
    if (d.ask == Ask::turntable) return app.save_turntable(d.path, 48, static_cast<Turn>(d.turn));
    if (d.ask == Ask::maps) return app.save_maps(d.path);
    if (d.ask == Ask::environment) return app.set_environment(d.path);
    if (d.ask == Ask::compared) return app.compare_with_file(d.path);
    if (d.ask == Ask::value) {
        app.set_parameter(d.parameter, absolute_name(d.path));
        return app.editor.close_step();
    }
    app.save_gltf(d.path);
}

void draw_turns(Dialog& d) {
    ImGui::TextUnformatted("Turns:");
    for (int i = 0; i < static_cast<int>(turn_names().size()); ++i) {
        ImGui::SameLine();
        ImGui::RadioButton(std::string(turn_names()[static_cast<std::size_t>(i)]).c_str(), &d.turn,
                           i);
    }
    ImGui::SameLine();
    ImGui::TextDisabled("(films: .mp4, .webm, .apng)");
}

// Files and folders beside the path that begin as it does.
std::vector<std::string> completions(const std::string& path) {
    namespace fs = std::filesystem;
    std::vector<std::string> found;
    std::error_code error;
    const fs::path given(path.empty() ? "./" : path);
    const fs::path folder = given.has_parent_path() ? given.parent_path() : fs::path(".");
    const std::string begins = given.filename().string();
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        const std::string name = it->path().filename().string();
        if (name.starts_with('.') || !name.starts_with(begins)) continue;
        std::error_code ignored;
        found.push_back((folder / name).string() + (it->is_directory(ignored) ? "/" : ""));
        if (found.size() >= 200) break;
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace

void ask_for(Ask ask, std::string path, std::string parameter) {
    dialog() = {ask, std::move(path), {}, true, 0, std::move(parameter)};
}

bool is_asking() {
    return dialog().ask != Ask::none;
}

void draw_dialog(App& app) {
    Dialog& d = dialog();
    if (d.ask == Ask::none) return;
    if (d.opened) ImGui::OpenPopup(title_of(d.ask));
    const auto scale = static_cast<float>(app.ui_scale);
    ImGui::SetNextWindowSize({560 * scale, 380 * scale}, ImGuiCond_Appearing);
    ImGui::SetNextWindowPos(
        {0.5f * ImGui::GetIO().DisplaySize.x, 0.5f * ImGui::GetIO().DisplaySize.y},
        ImGuiCond_Appearing, {0.5f, 0.5f});
    bool open = true;
    if (!ImGui::BeginPopupModal(title_of(d.ask), &open)) {
        if (!d.opened) d.ask = Ask::none;
        return;
    }
    if (d.ask == Ask::turntable) draw_turns(d);
    if (d.ask == Ask::value) {
        std::string label = d.parameter;
        std::ranges::replace(label, '_', ' ');
        ImGui::TextDisabled("%s", label.c_str());
    }
    if (d.opened) ImGui::SetKeyboardFocusHere();
    d.opened = false;
    ImGui::SetNextItemWidth(-1);
    const bool entered = ImGui::InputText("##path", &d.path, ImGuiInputTextFlags_EnterReturnsTrue);
    const float bottom = 2.4f * ImGui::GetFrameHeightWithSpacing();
    if (ImGui::BeginChild("list", {0, -bottom}, true))
        for (const std::string& name : completions(d.path))
            if (ImGui::Selectable(name.c_str(), false, ImGuiSelectableFlags_DontClosePopups))
                d.path = name;
    ImGui::EndChild();
    ImGui::TextColored({0.95f, 0.6f, 0.5f, 1}, "%s", d.failed.c_str());
    const bool opens = d.ask == Ask::open || d.ask == Ask::compared || d.ask == Ask::environment ||
                       d.ask == Ask::value;
    const bool pressed = ImGui::Button(opens ? "Open" : "Save", {100 * scale, 0});
    ImGui::SameLine();
    const bool cancelled = ImGui::Button("Cancel", {100 * scale, 0}) || !open ||
                           ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (pressed || entered) {
        try {
            run_dialog(app, d);
            d.ask = Ask::none;
            ImGui::CloseCurrentPopup();
        } catch (const std::exception& error) {
            d.failed = one_line(error.what());
        }
    } else if (cancelled) {
        d.ask = Ask::none;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace burnish::viewer
