#include "gpu/device/shader_source.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "burnish/error.hpp"

namespace burnish::gpu {
namespace {

constexpr std::string_view kInclude = "#include \"";

std::string text_on_disk(std::string_view name) {
    const char* folder = std::getenv("BURNISH_SHADER_DIR");
    if (folder == nullptr || *folder == '\0') return {};
    std::ifstream in(std::string(folder) + "/" + std::string(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string text_of(std::string_view name) {
    std::string edited = text_on_disk(name);
    if (!edited.empty()) return edited;
    for (const ShaderText& embedded : shader_texts()) {
        if (embedded.name == name) return std::string(embedded.text);
    }
    throw Error(name, "", "a shader text of this name", "none");
}

// Appends `text` line by line and expands each include once. #line directives lead messages of the
// compiler back to the file.
void append_expanded(ShaderStage& stage, std::string_view name, std::string_view text) {
    const std::size_t number = stage.files.size();
    stage.files.emplace_back(name);
    stage.text += "#line 1 " + std::to_string(number) + "\n";
    std::size_t line_number = 0;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        ++line_number;
        if (!line.starts_with(kInclude)) {
            stage.text.append(line).push_back('\n');
            continue;
        }
        const std::string_view rest = line.substr(kInclude.size());
        const std::string_view file = rest.substr(0, rest.find('"'));
        if (file == "shading") {
            for (const ShaderText& one : shading_texts()) {
                if (std::ranges::find(stage.files, one.name) != stage.files.end()) continue;
                append_expanded(stage, one.name, text_of(one.name));
            }
        } else if (std::ranges::find(stage.files, file) == stage.files.end()) {
            append_expanded(stage, file, text_of(file));
        }
        stage.text +=
            "#line " + std::to_string(line_number + 1) + " " + std::to_string(number) + "\n";
    }
}

}  // namespace

ShaderStage assemble_text(ShaderDialect dialect, std::string_view defines, std::string_view name,
                          std::string_view text) {
    ShaderStage stage;
    if (dialect == ShaderDialect::gl330) {
        stage.text = "#version 330 core\n";
    } else {
        stage.text =
            "#version 300 es\nprecision highp float;\nprecision highp int;\n"
            "precision highp sampler2D;\nprecision highp samplerCube;\n"
            "precision highp sampler3D;\nprecision highp sampler2DArrayShadow;\n";
    }
    stage.text += defines;
    append_expanded(stage, name, text);
    return stage;
}

ShaderStage assemble_stage(ShaderDialect dialect, std::string_view defines, std::string_view name) {
    return assemble_text(dialect, defines, name, text_of(name));
}

}  // namespace burnish::gpu
