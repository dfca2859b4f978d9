// Readers of the commands that change what a scene is made of.
//
// Threads: functions of their arguments. They throw as WordReader does.
#pragma once

#include "viewer/script/script.hpp"
#include "viewer/script/script_words.hpp"

namespace burnish::viewer {

SceneCommand read_material_command(WordReader& words);
SceneCommand read_object_command(WordReader& words);
SceneCommand read_lights_command(WordReader& words);
SceneCommand read_background_command(WordReader& words);
SceneCommand read_bookmark_command(WordReader& words);
SceneCommand read_recover_command(WordReader& words);
SceneCommand read_simulate_command(WordReader& words);

}  // namespace burnish::viewer
