// What buttons and scrolling do in the picture: as glTF viewers have it, or as Blender has it.
//
// Threads: functions of their arguments.
#pragma once

#include <span>
#include <string_view>
#include <utility>

namespace burnish::viewer {

enum class Navigation {
    viewer,  // a left drag orbits, a right one pans
    blender  // a middle drag orbits, with shift it pans, with ctrl it zooms; left clicks select
};
std::span<const std::string_view> navigation_names();  // in the order of the enumeration

// What the mouse does in the picture while a button is down.
enum class Drag { none, orbit, pan, zoom, light, environment, highlight };

struct Modifiers {
    bool shift = false, ctrl = false, alt = false;
};

// `button`: 0 left, 1 right, 2 middle.
Drag drag_of(Navigation navigation, int button, const Modifiers& held);

// What scrolling does. `touchpad`: two fingers orbit, with shift they pan, with ctrl they zoom, as in Blender;
// else scrolling zooms.
Drag scroll_of(bool touchpad, const Modifiers& held);

// For the list of keys: what is done with the mouse, and what it does.
std::span<const std::pair<const char*, const char*>> mouse_help(Navigation navigation,
                                                                bool touchpad);

}  // namespace burnish::viewer
