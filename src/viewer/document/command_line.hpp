// The `burnish render` command that draws what the viewer shows.
//
// Threads: functions may be called from any thread.
#pragma once

#include <string>
#include <vector>

#include "burnish/stage.hpp"
#include "viewer/document/document.hpp"

namespace burnish::viewer {

struct CommandLine {
    // Words after "burnish": {"render", "model.glb", "--alpha-x", "0.2", "-o", "picture.png"}.
    std::vector<std::string> words;
    // True: flags cannot say everything that differs from the input (materials of their own, hidden
    // parts, lights with a color, a range or a cone): `words` name the scene file, which has to be saved
    // there first.
    bool needs_scene = false;
    std::string reason;  // why, for the person who copies it: "materials of their own"; else ""
    std::string text() const;  // "burnish render ...", quoted for a POSIX shell
};

// `stage`: of this document. `scene_file`: where the scene is saved if one is needed. `picture`: the
// file after -o.
CommandLine render_command(const Document& document, const Stage& stage,
                           const std::string& scene_file, const std::string& picture);

// The word of --light that gives this light, within 1e-6 of its direction; "" where there is none.
std::string light_word(const Light& light);

}  // namespace burnish::viewer
