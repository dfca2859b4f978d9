// A dialog that asks for the name of a file to open or to save.
//
// Threads: the main thread.
#pragma once

#include <string>

#include "viewer/window/app.hpp"

namespace burnish::viewer {

enum class Ask { none, open, scene, picture, turntable, gltf, maps, compared, environment, value };

// Shows the dialog from the next frame on, with `path` in its line. `parameter`: the one that a file is
// chosen for (Ask::value).
void ask_for(Ask ask, std::string path, std::string parameter = {});
bool is_asking();
void draw_dialog(App& app);

}  // namespace burnish::viewer
