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

void ScriptRunner::feed_mouse_command() {
    ImGuiIO& io = ImGui::GetIO();
    const MouseCommand& c = *mouse_command_;
    const bool over = mouse_frame_ >= kMouseFrames;
    io.KeyShift = !over && c.modifier == "shift";
    io.KeyCtrl = !over && c.modifier == "ctrl";
    io.KeyAlt = !over && c.modifier == "alt";
    if (c.button < 0) {
        // One frame of the mouse alone, so that ImGui knows where it is.
        io.MouseWheel = mouse_frame_ == 1 ? static_cast<float>(c.dy) : 0.0f;
        io.MouseWheelH = mouse_frame_ == 1 ? static_cast<float>(c.dx) : 0.0f;
    } else {
        io.MouseDown[c.button] = mouse_frame_ >= 1 && mouse_frame_ + 1 < kMouseFrames;
        // Between pressing and letting go.
        if (mouse_frame_ >= 2 && mouse_frame_ + 1 < kMouseFrames)
            *mouse_ += glm::dvec2(c.dx, c.dy) / static_cast<double>(kMouseFrames - 3);
        io.MousePos = {static_cast<float>(mouse_->x), static_cast<float>(mouse_->y)};
    }
    if (over) mouse_command_.reset();
    ++mouse_frame_;
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
