#include "gpu/device/program.hpp"

#include <array>
#include <cctype>
#include <utility>

#include "burnish/error.hpp"
#include "gpu/device/handles.hpp"

namespace burnish::gpu {
namespace {

// The first line of a log that speaks of an error; else the first.
std::string first_error(const std::string& log) {
    std::size_t from = log.find("error");
    if (from == std::string::npos) from = 0;
    from = log.rfind('\n', from) == std::string::npos ? 0 : log.rfind('\n', from) + 1;
    return log.substr(from, log.find('\n', from) - from);
}

// Compilers begin a message with the number that #line gave the file: "7:12(3): error ...",
// "7(12) : error ...".
std::string with_file(const ShaderStage& stage, const std::string& message) {
    const std::size_t digit = message.find_first_of("0123456789");
    if (digit == std::string::npos) return message;
    std::size_t number = 0;
    for (std::size_t i = digit; i < message.size() && std::isdigit(message[i]) && number < 1000;
         ++i) {
        number = number * 10 + static_cast<std::size_t>(message[i] - '0');
    }
    return number < stage.files.size() ? stage.files[number] + " (file " + message + ")" : message;
}

GLuint compile(GLenum type, const ShaderStage& stage) {
    const GLuint shader = glCreateShader(type);
    const char* text = stage.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done != 0) return shader;
    std::array<char, 4096> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glDeleteShader(shader);
    throw Error("shader " + stage.files.front() + ": " + with_file(stage, first_error(log.data())));
}

}  // namespace

void check_gl(const char* doing) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    while (glGetError() != GL_NO_ERROR) {
    }
    if (error == GL_OUT_OF_MEMORY) throw Error(std::string(doing) + ": out of graphics memory");
    throw Error(std::string(doing) + ": OpenGL error " + std::to_string(error));
}

Program::Program(const ShaderStage& vertex, const ShaderStage& fragment) {
    const GLuint vertex_shader = compile(GL_VERTEX_SHADER, vertex);
    GLuint fragment_shader = 0;
    try {
        fragment_shader = compile(GL_FRAGMENT_SHADER, fragment);
    } catch (...) {
        glDeleteShader(vertex_shader);
        throw;
    }
    program_ = glCreateProgram();
    glAttachShader(program_, vertex_shader);
    glAttachShader(program_, fragment_shader);
    glLinkProgram(program_);
    glDeleteShader(vertex_shader);
    glDeleteShader(fragment_shader);
    GLint done = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &done);
    if (done != 0) return;
    std::array<char, 4096> log{};
    glGetProgramInfoLog(program_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glDeleteProgram(program_);
    throw Error("shaders " + vertex.files.front() + " and " + fragment.files.front() +
                " do not link: " + first_error(log.data()));
}

Program::~Program() {
    glDeleteProgram(program_);
}

GLint Program::location(const char* name) {
    const auto known = locations_.find(std::string_view(name));
    if (known != locations_.end()) return known->second;
    const GLint found = glGetUniformLocation(program_, name);
    locations_.emplace(name, found);
    return found;
}

void Program::set(const char* name, int value) {
    glUniform1i(location(name), value);
}
void Program::set(const char* name, unsigned value) {
    glUniform1ui(location(name), value);
}
void Program::set(const char* name, float value) {
    glUniform1f(location(name), value);
}
void Program::set(const char* name, glm::vec2 v) {
    glUniform2f(location(name), v.x, v.y);
}
void Program::set(const char* name, glm::ivec2 v) {
    glUniform2i(location(name), v.x, v.y);
}
void Program::set(const char* name, glm::vec3 v) {
    glUniform3f(location(name), v.x, v.y, v.z);
}
void Program::set(const char* name, glm::vec4 v) {
    glUniform4f(location(name), v.x, v.y, v.z, v.w);
}
void Program::set(const char* name, const glm::mat3& m) {
    glUniformMatrix3fv(location(name), 1, GL_FALSE, &m[0].x);
}
void Program::set(const char* name, const glm::mat4& m) {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, &m[0].x);
}
void Program::set(const char* name, std::span<const float> values) {
    glUniform1fv(location(name), static_cast<GLsizei>(values.size()), values.data());
}
void Program::set(const char* name, std::span<const glm::vec2> values) {
    if (values.empty()) return;
    glUniform2fv(location(name), static_cast<GLsizei>(values.size()), &values[0].x);
}
void Program::set(const char* name, std::span<const glm::vec3> values) {
    if (values.empty()) return;
    glUniform3fv(location(name), static_cast<GLsizei>(values.size()), &values[0].x);
}
void Program::set(const char* name, std::span<const glm::mat4> values) {
    if (values.empty()) return;
    glUniformMatrix4fv(location(name), static_cast<GLsizei>(values.size()), GL_FALSE,
                       &values[0][0].x);
}
void Program::set(const char* name, std::span<const glm::vec4> values) {
    if (values.empty()) return;
    glUniform4fv(location(name), static_cast<GLsizei>(values.size()), &values[0].x);
}

Program& ProgramCache::get(std::string_view vertex, std::string_view fragment,
                           const std::string& defines) {
    const std::string key = std::string(vertex) + "\n" + std::string(fragment) + "\n" + defines;
    auto found = programs_.find(key);
    if (found == programs_.end()) {
        const std::string folder = "shaders/";
        auto program = std::make_unique<Program>(
            assemble_stage(dialect_, defines, folder + std::string(vertex)),
            assemble_stage(dialect_, defines, folder + std::string(fragment)));
        found = programs_.emplace(key, std::move(program)).first;
    }
    return *found->second;
}

}  // namespace burnish::gpu
