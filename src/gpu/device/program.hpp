// A linked shader program and its uniforms. The context that it was made in must be current.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "gpu/device/gl.hpp"
#include "gpu/device/shader_source.hpp"

namespace burnish::gpu {

// Uniforms that are set together and stay in a program until another version of the group is set.
enum class UniformGroup { frame, material };

class Program {
  public:
    // Throws Error with the first message of the compiler, its file and line.
    Program(const ShaderStage& vertex, const ShaderStage& fragment);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    // Sends the stages to the compiler without waiting for it. Call finish() before any other
    // function.
    static std::unique_ptr<Program> start(const ShaderStage& vertex, const ShaderStage& fragment);
    bool is_finished() const { return unfinished_ == nullptr; }
    // Whether finish() would return without waiting. Requires KHR_parallel_shader_compile.
    bool is_compiled() const;
    void finish();  // throws as the constructor
    void swap(Program& other) noexcept;

    void use();
    // Rises from use to use of all programs of the process; 0 before the first.
    std::uint64_t last_use() const { return last_use_; }

    // Returns true when the program does not hold `version` of the group, and records that version.
    // The caller then sets the uniforms of the group. Versions are never 0 and differ between
    // renderers.
    bool take(UniformGroup group, std::uint64_t version);

    // Sets a uniform of the program in use; uniforms that the compiler has removed are ignored.
    void set(const char* name, int value);
    void set(const char* name, unsigned value);
    void set(const char* name, float value);
    void set(const char* name, glm::vec2 value);
    void set(const char* name, glm::ivec2 value);
    void set(const char* name, glm::vec3 value);
    void set(const char* name, glm::vec4 value);
    void set(const char* name, const glm::mat3& value);
    void set(const char* name, const glm::mat4& value);
    void set(const char* name, std::span<const float> values);
    void set(const char* name, std::span<const glm::vec2> values);
    void set(const char* name, std::span<const glm::vec3> values);
    void set(const char* name, std::span<const glm::vec4> values);
    void set(const char* name, std::span<const glm::mat4> values);

  private:
    struct Stages;  // stages of a program that is not finished, for error messages
    Program();
    void send(const ShaderStage& vertex, const ShaderStage& fragment);
    GLint location(const char* name);

    GLuint program_ = 0;
    std::unique_ptr<Stages> unfinished_;
    std::map<std::string, GLint, std::less<>> locations_;
    std::array<std::uint64_t, 2> versions_{};
    std::uint64_t last_use_ = 0;
};

// A number that no other version has had in this process.
std::uint64_t new_uniform_version();

// Programs by stages and defines. A program that software renderers have run holds about 4 MB of machine
// code, so that the number of programs is bounded. Part of a context (context.hpp).
class ProgramCache {
  public:
    // `parallel`: the device has KHR_parallel_shader_compile.
    ProgramCache(ShaderDialect dialect, bool parallel) : dialect_(dialect), parallel_(parallel) {}

    // Stages: names below shaders/. Compiles the program if it is missing. Throws Error when it
    // does not compile. The program lives until a call of trim() or the end of the cache.
    Program& get(std::string_view vertex, std::string_view fragment, const std::string& defines);
    // As get, without waiting for the compiler: call finish() before use.
    std::shared_ptr<Program> start(std::string_view vertex, std::string_view fragment,
                                   const std::string& defines);

    // Deletes the programs that were not used for longest while there are more than the limit.
    void trim();
    void set_limit(std::size_t most) { most_ = most; }

    // Compiles every program again from the texts as they are now (BURNISH_SHADER_DIR). Throws Error
    // with the first that does not compile, and all programs are then what they were.
    void reload();

    bool parallel() const { return parallel_; }
    std::size_t size() const { return programs_.size(); }  // number of programs compiled

  private:
    ShaderDialect dialect_;
    bool parallel_;
    // More than the window prepares for the next change of a scene of two materials.
    std::size_t most_ = 64;
    std::map<std::string, std::shared_ptr<Program>> programs_;
};

}  // namespace burnish::gpu
