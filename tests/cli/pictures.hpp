// Pictures for tests that measure them: a stage set as the command line sets it, drawn by the real
// renderer.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/renderer.hpp"
#include "burnish/stage.hpp"

namespace burnish::test {

// One for the whole program; nullptr, and the reason in `gl_trouble`, where there is no OpenGL.
gpu::Context* gl_context();
const std::string& gl_trouble();

// A sample file, or "" when the sample data is not there.
std::filesystem::path sample(const std::string& below_data);
std::string sample_model(const std::string& name);  // data/models/NAME/glTF-Binary/NAME.glb

using Settings = std::vector<std::pair<std::string, std::string>>;  // parameter, text

// What `burnish render INPUT --env ENVIRONMENT --light LIGHT ... --parameter text ...` shows,
// without shadows unless a setting asks for them: what the pictures are compared with has none.
Stage stage_of(const std::string& input, const std::string& environment,
               const std::vector<std::string>& lights, const Settings& settings);

// The camera of a screenshot, fitted off line: a pinhole with its principal point in the middle of
// a part of the screenshot of this size.
struct FittedCamera {
    glm::dvec3 eye, target;
    double focal_px;
    int width, height;
};

// Where the camera sees a place: pixels right of and below the principal point, and how many pixels
// a metre there is.
struct Projection {
    glm::dvec2 offset_px;
    double px_per_metre;
};
Projection project(const FittedCamera& camera, glm::dvec3 place);

// A model as its screenshot shows it. The lights are those of the glTF Sample Viewer for files
// without any: a key light of 1 lux from (-1/2, sqrt(1/2), 1/2) and a fill light of half of that
// from behind, against it.
Stage stage_of_screenshot(const std::string& model, const FittedCamera& camera);

// Linear, RGBA.
Image picture_of(const Stage& stage);

// Shown on a display, 0..255 in steps of 1/255.
Image shown_in_steps(const Image& linear, ToneMap tone_map);

}  // namespace burnish::test

#define BURNISH_REQUIRE_GL() \
    if (!burnish::test::gl_context()) GTEST_SKIP() << burnish::test::gl_trouble()
#define BURNISH_REQUIRE_SAMPLE(path) \
    if (path.empty()) GTEST_SKIP() << "no sample data (set BURNISH_DATA)"
