// The member "viewer" of a scene file: bookmarks and compare settings. `burnish render` passes over
// it.
//
// Threads: functions may be called from any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "viewer/document/document.hpp"

namespace burnish::viewer {

struct ViewerSection {
    std::vector<Bookmark> bookmarks;
    Compare compare;
};

// Reads the text of the member; "" gives the defaults. Throws Error naming `file` and the key.
ViewerSection read_viewer_section(const std::string& text, const std::string& file);

// Null where everything is as by default.
nlohmann::ordered_json viewer_section(const Document& document);

}  // namespace burnish::viewer
