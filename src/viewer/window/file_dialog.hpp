// A dialog that asks for the name of a file to open or to save.
//
// Threads: the main thread.
#pragma once

#include <string>

#include "viewer/window/app.hpp"

namespace burnish::viewer {

enum class Ask { none, open, scene, picture, turntable, gltf, maps, compared, environment };

// Shows the dialog from the next frame on, with `path` in its line.
void ask_for(Ask ask, std::string path);
bool is_asking();
void draw_dialog(App& app);

}  // namespace burnish::viewer
