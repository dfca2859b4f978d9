// The member "viewer" of a scene file: bookmarks, compare settings, and what an autosaved scene was. `burnish render` passes over
// it.
//
// Threads: functions may be called from any thread.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "viewer/document/document.hpp"

namespace burnish::viewer {

struct ViewerSection {
    std::vector<Bookmark> bookmarks;
    Compare compare;
    std::map<int, float>
        dark;           // lights that are off, by index, and their intensities when they are on
    std::string scene;  // of an autosaved scene: what it was, an absolute path or builtin:<name>
};

// Reads the text of the member; "" gives the defaults. Files that it names are relative to the folder of
// `file`. Throws Error naming `file` and the key.
ViewerSection read_viewer_section(const std::string& text, const std::string& file);

// Null where everything is as by default. `lights`: all, with their own intensities. `file_name`: a file as
// the scene file states it.
nlohmann::ordered_json viewer_section(
    const Document& document, const std::vector<Light>& lights,
    const std::function<std::string(const std::string&)>& file_name);

}  // namespace burnish::viewer
