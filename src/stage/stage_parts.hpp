// The steps of set_stage, for those who keep a stage and change it piece by piece.
//
// Threads: one at a time for each stage. Lifetime: what functions return refers to nothing else.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "burnish/stage.hpp"

namespace burnish {

// The input read, with its own materials and lights; `values` are over those of a scene file. Materials
// are not applied yet, nothing is hidden, and there is no environment. Throws Error where there is
// nothing to draw.
Stage open_stage(const std::string& input, const ParameterValues& values);

// The environment that is asked for, else that of the file, else the default one. Errors of the file's
// name `input`.
Environment load_environment_of(const Stage& stage, const std::string& input,
                                const std::string& asked, std::vector<std::string>& warnings);

// Settings, camera, exposure and tone map from stage.values. Nothing may be hidden: a framed camera
// shows all parts, whether they are drawn or not.
void set_values_of_picture(Stage& stage, bool all_around);

// Hides these instances of the scene and shows all others. Indices without an instance are passed
// over.
void hide_instances(Stage& stage, const std::set<int>& hidden);

// To be called after a change of the scene's meshes while nothing is hidden.
void remember_meshes(Stage& stage);

// Appends a line "name: why: nothing changes" for each value of the picture that other values, or
// their absence, make ineffective; `lights`: those that are drawn. Values of materials have lines of
// the same form (material_warnings.hpp).
void warn_of_idle_values(const ParameterValues& values, const Environment& environment,
                         const std::vector<Light>& lights, std::vector<std::string>& warnings);

// A line where "none" stands among other words of --light.
void warn_of_idle_lights(const std::vector<std::string>& lights,
                         std::vector<std::string>& warnings);

// Sets stage.warnings.materials, and scene.notes to those of the input with the remarks' own.
void take_remarks(Stage& stage, Remarks remarks);

// Finds stage.warnings.normal_maps anew: it looks at the texels of every normal map.
void find_odd_normal_maps(Stage& stage);

// All parts of the warnings in order, each line once: what scene.warnings is.
std::vector<std::string> all_warnings(const Stage& stage);

}  // namespace burnish
