// What the viewer remembers from one start to the next, and its autosaved scenes. Everything lies in
// $XDG_STATE_HOME/burnish, else ~/.local/state/burnish.
//
// Threads: one at a time. Lifetime: what functions return refers to nothing else.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "burnish/stage.hpp"
#include "viewer/document/document.hpp"
#include "viewer/motion/navigation.hpp"

namespace burnish::viewer {

inline constexpr std::size_t kMostRecent = 12;

struct Remembered {
    int width = 1280, height = 720;  // of the window, in screen coordinates, 320 to 16384
    std::optional<int> x, y;         // of its upper left corner; none: the window system decides
    bool maximized = false;
    std::map<std::string, bool> panels;  // by name: whether it is open
    Navigation navigation = Navigation::viewer;
    bool touchpad = false;            // two fingers orbit
    std::vector<std::string> recent;  // files, the latest first, kMostRecent at most
    bool operator==(const Remembered&) const = default;
};

// Puts the file first; a file that is there already moves. Paths become absolute but for builtin:.
void add_recent(Remembered& remembered, const std::string& path);

// The folder; it need not exist. Empty where neither XDG_STATE_HOME (absolute) nor HOME says one.
std::filesystem::path state_folder();

// view.json of `folder`. Never throws: where there is none the defaults are returned, and where it is
// broken too, with one line in `warnings`.
Remembered load_remembered(const std::filesystem::path& folder, std::vector<std::string>& warnings);
// Makes the folder where it is missing. Throws Error.
void save_remembered(const std::filesystem::path& folder, const Remembered& remembered);

// The autosave file of this process in `folder`: autosave-<host>-<pid>-<start of the process>.json.
std::filesystem::path autosave_path(const std::filesystem::path& folder);
// Writes the scene there, whole or not at all. `scene`: what it is (SceneName::path). Throws Error.
void autosave(const std::filesystem::path& folder, const Document& document, const Stage& stage,
              const std::string& scene);
// To be called at an orderly end. Never throws.
void remove_autosave(const std::filesystem::path& folder);

// What a document is called: its input, or, of a recovered one, the scene that was autosaved.
struct SceneName {
    std::string path;  // absolute or builtin:<name>; "": nothing is open
    bool recovered = false;
};
// Never throws.
SceneName scene_name(const Document& document, const Stage& stage);

// The scene file that "Save scene" proposes: the scene itself, "part.json" beside a model "part.glb", else
// scene.json in the present folder.
std::string proposed_scene_file(const SceneName& scene);

struct LeftBehind {
    std::filesystem::path file;  // a scene file
    std::filesystem::file_time_type written;
    std::string scene;  // as SceneName::path; "": the file does not say
};
// For the person: "The scene: /models/part.glb" and "Kept: 2026-11-30 16:53", a line each.
std::string text_of_offer(const LeftBehind& left);
// Autosave files of processes of this host that no longer live, the latest first. Never throws.
std::vector<LeftBehind> autosaves_left_behind(const std::filesystem::path& folder);

}  // namespace burnish::viewer
