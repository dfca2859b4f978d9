// What it means to open a file: from paths, as the command line or a drop gives them, to a document.
// Files are told by content.
//
// Threads: functions may be called from any thread. Lifetime: what they return refers to nothing
// else.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viewer/document/document.hpp"

namespace burnish::viewer {

// What the viewer shows without an argument: a sphere of brushed, scratched steel in the studio.
Document first_document();

// The document with this file opened in it:
// - a model, builtin:<mesh> or scene file becomes the input; what belongs to the former input
//   (materials, lights, parts, camera, bookmarks) goes, and before a scene file all values;
// - a lat-long picture (.hdr, .exr or another picture twice as wide as high whose name states no
//   role of a map), builtin:studio and its like become the environment;
// - another picture becomes the map that its name states (color, roughness ... ), a normal map when
//   it states none;
// - a .wif file becomes the weave, a measured material (of `burnish capture fit`, .bsdf) the
//   tabulated material, a folder of `burnish scratch` the scratch map, another folder of maps the
//   set of maps.
// Maps and materials go onto `material` (an index of the scene), or onto all materials; where
// nothing is open, onto builtin:sphere. Paths become absolute. Throws Error for what is none of
// these, with what is expected; a rig without a fitted material beside it says how to make one.
// `notes`, if any, receives what was chosen where there was a choice, one line each.
Document opened(Document document, const std::string& path,
                std::optional<int> material = std::nullopt,
                std::vector<std::string>* notes = nullptr);

// Whether the file is a rig with no fitted material beside it: what `opened` refuses, and what can be
// fitted first.
bool is_unfitted_rig(const std::string& path);

// All files opened, models and scene files first; without any, first_document().
Document document_for(std::span<const std::string> paths,
                      std::vector<std::string>* notes = nullptr);

}  // namespace burnish::viewer
