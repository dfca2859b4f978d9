// Pictures for tests that measure them: a stage set as the command line sets it, drawn by the real
// renderer.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/stage.hpp"
#include "gpu/context.hpp"
#include "gpu/renderer.hpp"

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

// Linear, RGBA.
Image picture_of(const Stage& stage);

// Shown on a display, 0..255 in steps of 1/255.
Image shown_in_steps(const Image& linear, ToneMap tone_map);

}  // namespace burnish::test

#define BURNISH_REQUIRE_GL() \
    if (!burnish::test::gl_context()) GTEST_SKIP() << burnish::test::gl_trouble()
#define BURNISH_REQUIRE_SAMPLE(path) \
    if (path.empty()) GTEST_SKIP() << "no sample data (set BURNISH_DATA)"
