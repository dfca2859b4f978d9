// A document as a scene file that `burnish render` and the viewer show identically.
//
// Threads: functions may be called from any thread. Lifetime: what they return refers to nothing
// else.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/stage.hpp"
#include "viewer/document/document.hpp"

namespace burnish::viewer {

// The scene file, for the place `where`: file names are relative to its folder unless they share
// nothing with it but the root. Read by set_stage or load_stage it gives an equal scene, camera,
// environment and settings. `stage`: of this document. Throws Error for what no scene file can hold
// (require_valid).
std::string scene_text(const Document& document, const Stage& stage,
                       const std::filesystem::path& where);

// Written whole or not at all. Throws Error when it cannot be written. `cache`: folders of generated
// scratches, of which the scene gets copies of its own, so that it lives without the cache:
// "<name of the scene>.scratch/<name of the folder>" beside it. Without `cache` it names them where
// they are. `autosave_of`: what the scene is that is autosaved here (SceneName::path), for the offer to
// recover it; "": this is no autosave.
void save_scene(const Document& document, const Stage& stage, const std::filesystem::path& where,
                const std::filesystem::path& cache = {}, const std::string& autosave_of = {});

}  // namespace burnish::viewer
