// The part of ScriptRunner that changes what a scene is made of.
#include <fmt/format.h>
#include <imgui.h>

#include "burnish/error.hpp"
#include "viewer/document/scene_lists.hpp"
#include "viewer/window/script_runner.hpp"

namespace burnish::viewer {

int ScriptRunner::required_object(const std::string& word) const {
    const std::vector<ObjectRow> rows = object_rows(app_.document(), app_.editor.stage());
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].name == word || word == fmt::format("#{}", i)) return static_cast<int>(i);
    fail(fmt::format("expected an object of the scene, found {}", shown(word)));
}

void ScriptRunner::change_light(const SceneCommand& command) {
    const std::vector<Light> lights = all_lights(app_.document(), app_.editor.stage());
    const auto index = static_cast<std::size_t>(command.index);
    if (index >= lights.size())
        fail(fmt::format("expected the number of a light up to {}, found {}", lights.size(),
                         index + 1));
    Light light = lights[index];
    if (command.color) light.color = *command.color;
    if (command.light) {
        light = *command.light;
        light.color = lights[index].color;
        if (!command.has_intensity) light.intensity = lights[index].intensity;
    }
    app_.change_light(command.index, light);
    app_.editor.close_step();
}

// Of the frames, the first shows ImGui where the mouse is, the second presses, the last lets go.
int frames_of(const MouseCommand& c) {
    return c.frames + 3;
}

void ScriptRunner::feed_mouse_command() {
    ImGuiIO& io = ImGui::GetIO();
    const MouseCommand& c = *mouse_command_;
    const int last = frames_of(c) - 1;
    const bool over = mouse_frame_ > last;
    io.KeyShift = !over && c.modifier == "shift";
    io.KeyCtrl = !over && c.modifier == "ctrl";
    io.KeyAlt = !over && c.modifier == "alt";
    if (c.button < 0) {
        // One frame of the mouse alone, so that ImGui knows where it is.
        io.MouseWheel = mouse_frame_ == 1 ? static_cast<float>(c.dy) : 0.0f;
        io.MouseWheelH = mouse_frame_ == 1 ? static_cast<float>(c.dx) : 0.0f;
    } else {
        io.MouseDown[c.button] = mouse_frame_ >= 1 && mouse_frame_ < last;
        if (mouse_frame_ >= 2 && mouse_frame_ < last)
            *mouse_ += glm::dvec2(c.dx, c.dy) / static_cast<double>(c.frames);
        io.MousePos = {static_cast<float>(mouse_->x), static_cast<float>(mouse_->y)};
    }
    if (over) mouse_command_.reset();
    ++mouse_frame_;
}

// ImGui takes the text in the frame after all that is there was selected, and the key after that.
void ScriptRunner::feed_type_command() {
    ImGuiIO& io = ImGui::GetIO();
    const auto hold = [&](ImGuiKey key, bool down) { io.KeysDown[io.KeyMap[key]] = down; };
    const int frame = type_frame_++;
    io.KeyCtrl = frame == 0;
    hold(ImGuiKey_A, frame == 0);
    if (frame == 1) io.AddInputCharactersUTF8(type_command_->text.c_str());
    hold(ImGuiKey_Enter, frame == 2 && type_command_->enter);
    if (frame == 3) type_command_.reset();
}

void ScriptRunner::change_scene(const SceneCommand& c) {
    using Does = SceneCommand::Does;
    switch (c.does) {
        case Does::select_material:
            return app_.select_material(c.name.empty() ? std::nullopt
                                                       : std::optional(required_material(c.name)));
        case Does::show_object:
        case Does::hide_object:
            return app_.show_object(required_object(c.name), c.does == Does::show_object);
        case Does::solo_object:
            return app_.solo_object(required_object(c.name));
        case Does::frame_object:
            return app_.frame_object(required_object(c.name));
        case Does::show_all_objects:
            return app_.show_all_objects();
        case Does::add_light:
            return app_.add_light(c.type);
        case Does::switch_light_on:
        case Does::switch_light_off:
            return app_.switch_light(c.index, c.does == Does::switch_light_on);
        case Does::remove_light:
            return app_.remove_light(c.index);
        case Does::change_light:
            return change_light(c);
        case Does::show_background:
        case Does::hide_background:
            return app_.show_background(c.does == Does::show_background);
        case Does::add_bookmark:
            return app_.keep_view(c.name);
        case Does::go_to_bookmark:
            return app_.go_to_view(c.name);
        case Does::delete_bookmark:
            return app_.delete_view(c.name);
        case Does::rename_bookmark:
            return app_.rename_view(c.name, c.to);
        case Does::open_recovered:
            return app_.recover(App::Recovery::open);
        case Does::leave_recovered:
            return app_.recover(App::Recovery::later);
        case Does::delete_recovered:
            return app_.recover(App::Recovery::remove);
        case Does::reset_device:
            return app_.window.pretend_reset();
    }
}

}  // namespace burnish::viewer
