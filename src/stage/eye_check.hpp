// A camera that flags have put inside the model.
#pragma once

#include <string>
#include <vector>

#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// Whether the eye is inside the model: most rays from it meet the back of a surface first. Inside a
// room, a cup or the hole of a torus they meet fronts.
bool is_inside_model(const Scene& scene, glm::vec3 eye);

// Appends a warning where camera_zoom or camera_distance put the eye inside the model, or
// camera_position inside one whose back faces are not drawn. A camera of a model's file is as it is
// meant to be and never warned of.
void warn_of_eye_inside(const Scene& scene, const ParameterValues& values, const Camera& camera,
                        std::vector<std::string>& warnings);

}  // namespace burnish
