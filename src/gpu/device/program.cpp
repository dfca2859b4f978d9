#include "gpu/device/program.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <utility>
#include <vector>

#include "burnish/error.hpp"
#include "gpu/device/handles.hpp"

namespace burnish::gpu {
namespace {

// The first line of a log that contains "error"; the first line otherwise.
std::string first_error(const std::string& log) {
    std::size_t from = log.find("error");
    if (from == std::string::npos) from = 0;
    from = log.rfind('\n', from) == std::string::npos ? 0 : log.rfind('\n', from) + 1;
    return log.substr(from, log.find('\n', from) - from);
}

// Replaces the file number of #line, with which compilers begin a message ("7:12(3): error ...",
// "7(12) : error ..."), by the file's name.
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

GLuint send_stage(GLenum type, const ShaderStage& stage) {
    const GLuint shader = glCreateShader(type);
    const char* text = stage.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    return shader;
}

void require_compiled(GLuint shader, const ShaderStage& stage) {
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done != 0) return;
    std::array<char, 4096> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
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

struct Program::Stages {
    ShaderStage vertex, fragment;
    GLuint vertex_shader = 0, fragment_shader = 0;

    Stages(ShaderStage v, ShaderStage f)
        : vertex(std::move(v)),
          fragment(std::move(f)),
          vertex_shader(send_stage(GL_VERTEX_SHADER, vertex)),
          fragment_shader(send_stage(GL_FRAGMENT_SHADER, fragment)) {}
    ~Stages() {
        glDeleteShader(vertex_shader);
        glDeleteShader(fragment_shader);
    }
    Stages(const Stages&) = delete;
    Stages& operator=(const Stages&) = delete;
};

Program::Program() = default;

Program::Program(const ShaderStage& vertex, const ShaderStage& fragment) {
    send(vertex, fragment);
    try {
        finish();
    } catch (...) {
        glDeleteProgram(program_);
        throw;
    }
}

std::unique_ptr<Program> Program::start(const ShaderStage& vertex, const ShaderStage& fragment) {
    std::unique_ptr<Program> program(new Program);
    program->send(vertex, fragment);
    return program;
}

void Program::send(const ShaderStage& vertex, const ShaderStage& fragment) {
    unfinished_ = std::make_unique<Stages>(vertex, fragment);
    program_ = glCreateProgram();
    glAttachShader(program_, unfinished_->vertex_shader);
    glAttachShader(program_, unfinished_->fragment_shader);
    glLinkProgram(program_);
}

bool Program::is_compiled() const {
    if (is_finished()) return true;
    GLint done = 0;
    glGetProgramiv(program_, GL_COMPLETION_STATUS_KHR, &done);
    return done != 0;
}

void Program::finish() {
    if (is_finished()) return;
    require_compiled(unfinished_->vertex_shader, unfinished_->vertex);
    require_compiled(unfinished_->fragment_shader, unfinished_->fragment);
    GLint done = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &done);
    if (done == 0) {
        std::array<char, 4096> log{};
        glGetProgramInfoLog(program_, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw Error("shaders " + unfinished_->vertex.files.front() + " and " +
                    unfinished_->fragment.files.front() +
                    " do not link: " + first_error(log.data()));
    }
    unfinished_.reset();
}

Program::~Program() {
    glDeleteProgram(program_);
}

void Program::use() {
    static std::atomic<std::uint64_t> uses{0};
    last_use_ = ++uses;
    glUseProgram(program_);
}

bool Program::take(UniformGroup group, std::uint64_t version) {
    return std::exchange(versions_[static_cast<std::size_t>(group)], version) != version;
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

void Program::swap(Program& other) noexcept {
    std::swap(program_, other.program_);
    std::swap(unfinished_, other.unfinished_);
    std::swap(locations_, other.locations_);
    std::swap(versions_, other.versions_);
}

void ProgramCache::reload() {
    ProgramCache fresh(dialect_, parallel_);
    for (const auto& [key, program] : programs_) {
        const std::size_t first = key.find('\n'), second = key.find('\n', first + 1);
        fresh.start(std::string_view(key).substr(0, first),
                    std::string_view(key).substr(first + 1, second - first - 1),
                    key.substr(second + 1));
    }
    for (const auto& [key, program] : fresh.programs_) program->finish();
    for (const auto& [key, program] : programs_) program->swap(*fresh.programs_.at(key));
}

std::shared_ptr<Program> ProgramCache::start(std::string_view vertex, std::string_view fragment,
                                             const std::string& defines) {
    const std::string key = std::string(vertex) + "\n" + std::string(fragment) + "\n" + defines;
    const auto found = programs_.find(key);
    if (found != programs_.end()) return found->second;
    const std::string folder = "shaders/";
    std::shared_ptr<Program> program =
        Program::start(assemble_stage(dialect_, defines, folder + std::string(vertex)),
                       assemble_stage(dialect_, defines, folder + std::string(fragment)));
    return programs_.emplace(key, std::move(program)).first->second;
}

Program& ProgramCache::get(std::string_view vertex, std::string_view fragment,
                           const std::string& defines) {
    const std::shared_ptr<Program> program = start(vertex, fragment, defines);
    program->finish();
    return *program;  // the cache holds it
}

void ProgramCache::trim() {
    if (programs_.size() <= most_) return;
    std::vector<std::uint64_t> uses;
    uses.reserve(programs_.size());
    for (const auto& [key, program] : programs_) uses.push_back(program->last_use());
    const auto oldest_kept = uses.begin() + static_cast<std::ptrdiff_t>(uses.size() - most_);
    std::ranges::nth_element(uses, oldest_kept);
    const std::uint64_t bound = *oldest_kept;
    std::erase_if(programs_,
                  [bound](const auto& entry) { return entry.second->last_use() < bound; });
}

std::uint64_t new_uniform_version() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

}  // namespace burnish::gpu
