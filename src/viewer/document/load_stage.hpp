// From a document to a stage, all of it at once. It may run on a thread of its own.
//
// Threads: functions may be called from any thread. Lifetime: what they return refers to nothing
// else.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/stage.hpp"
#include "viewer/document/document.hpp"

namespace burnish::viewer {

// The stage that the document describes. Reports the stages "model", "materials" and "environment";
// a cancellation is noticed between them. Throws as set_stage does, and UsageError for what
// require_valid refuses. Materials and instances that the input does not have (any more) are passed
// over with a warning.
Stage load_stage(const Document& document, const Progress& progress = {});

// Whether going from one document to the other reads the input anew; all other changes are quick
// enough for the thread that draws, but for pictures and measured materials that are not yet here.
bool needs_load(const Document& from, const Document& to);

// The document with what the input says and the document leaves empty: hidden parts, bookmarks and
// compare settings of a scene file. Throws Error for a broken "viewer" section.
Document with_state_of_input(Document document, const Stage& stage);

// The lights that are drawn: those of the document, else `of_input`; dark ones have the intensity 0.
std::vector<Light> drawn_lights(const Document& document, const std::vector<Light>& of_input);

// The document's values for the materials that the stage has, and lines about those and about hidden
// parts that it does not have.
std::map<int, ParameterValues> values_of_materials(const Document& document, const Stage& stage);
std::vector<std::string> warnings_of_missing(const Document& document, const Stage& stage);

}  // namespace burnish::viewer
