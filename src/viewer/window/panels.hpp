// The panels of the window. Each draws into the ImGui window that is begun; all changes go through App.
#pragma once

#include <string>
#include <string_view>

#include "viewer/window/app.hpp"

namespace burnish::viewer {

// The whole of a frame: menu, panels, picture, status bar.
void draw_interface(App& app);

void parameter_panel(App& app);
void scene_panel(App& app);
void compare_panel(App& app);
void inspector_panel(App& app);
void message_panel(App& app);
void keys_panel(App& app);
void costs_panel(App& app);
void generator_panel(App& app);

// The picture with its dividers, and the mouse in it.
void picture_view(App& app);

// Runs what a key does: "ctrl+z", "f", "?". False: no such key.
bool press_key(App& app, std::string_view keys);

}  // namespace burnish::viewer
