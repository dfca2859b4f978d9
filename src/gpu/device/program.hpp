// A linked shader program and its uniforms.
#pragma once

#include <epoxy/gl.h>

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

#include "gpu/device/shader_source.hpp"

namespace burnish::gpu {

class Program {
  public:
    // Throws Error with the first message of the compiler, its file and line.
    Program(const ShaderStage& vertex, const ShaderStage& fragment);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const { glUseProgram(program_); }

    // Set on the program in use; a uniform that the compiler has removed is passed over.
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
    GLint location(const char* name);

    GLuint program_ = 0;
    std::map<std::string, GLint, std::less<>> locations_;
};

// Programs by stages and defines, each built when first asked for.
class ProgramCache {
  public:
    explicit ProgramCache(ShaderDialect dialect) : dialect_(dialect) {}
    // Stages: names below shaders/.
    Program& get(std::string_view vertex, std::string_view fragment, const std::string& defines);

  private:
    ShaderDialect dialect_;
    std::map<std::string, std::unique_ptr<Program>> programs_;
};

}  // namespace burnish::gpu
