// The text of a shader stage, assembled from the embedded files of shading/ and shaders/:
//
//   #version, precision (ES), defines, then the stage with its #include lines expanded.
//
// `#include "shading"` stands for the prelude and all texts of shading/ in the order of
// shading/all.hpp; `#include "shaders/lib/x.glsl"` for one file. When the environment variable
// BURNISH_SHADER_DIR names a folder, files that lie below it (<dir>/shaders/surface.frag,
// <dir>/shading/frame.glsl) are read from there instead: shaders can be edited without a build.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish::gpu {

struct ShaderText {
    std::string_view name;  // "shading/frame.glsl", "shaders/surface.frag"
    std::string_view text;
};

std::span<const ShaderText> shader_texts();   // all embedded texts
std::span<const ShaderText> shading_texts();  // the prelude and shading/, in order

enum class ShaderDialect { gl330, es300 };

struct ShaderStage {
    std::string text;
    std::vector<std::string> files;  // by number in the compiler's messages
};

// `defines`: whole lines. Throws Error for a file that does not exist.
ShaderStage assemble_stage(ShaderDialect dialect, std::string_view defines, std::string_view name);

// As assemble_stage, for a stage that is not a file of shaders/ (tests).
ShaderStage assemble_text(ShaderDialect dialect, std::string_view defines, std::string_view name,
                          std::string_view text);

}  // namespace burnish::gpu
