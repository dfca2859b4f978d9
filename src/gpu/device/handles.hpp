// Owners of OpenGL names: created on construction, deleted on destruction, movable but not
// copyable. The context that created them must be current.
#pragma once

#include <utility>

#include "gpu/device/gl.hpp"

namespace burnish::gpu {

template <typename Kind>
class Handle {
  public:
    Handle() { Kind::create(&name_); }
    ~Handle() {
        if (name_ != 0) Kind::destroy(&name_);
    }
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    GLuint get() const { return name_; }

  private:
    GLuint name_ = 0;
};

struct BufferKind {
    static void create(GLuint* name) { glGenBuffers(1, name); }
    static void destroy(GLuint* name) { glDeleteBuffers(1, name); }
};
struct VertexArrayKind {
    static void create(GLuint* name) { glGenVertexArrays(1, name); }
    static void destroy(GLuint* name) { glDeleteVertexArrays(1, name); }
};
struct TextureKind {
    static void create(GLuint* name) { glGenTextures(1, name); }
    static void destroy(GLuint* name) { glDeleteTextures(1, name); }
};
struct SamplerKind {
    static void create(GLuint* name) { glGenSamplers(1, name); }
    static void destroy(GLuint* name) { glDeleteSamplers(1, name); }
};
struct FramebufferKind {
    static void create(GLuint* name) { glGenFramebuffers(1, name); }
    static void destroy(GLuint* name) { glDeleteFramebuffers(1, name); }
};

using Buffer = Handle<BufferKind>;
using VertexArray = Handle<VertexArrayKind>;
using GlTexture = Handle<TextureKind>;
using Sampler = Handle<SamplerKind>;
using Framebuffer = Handle<FramebufferKind>;

// Throws Error when OpenGL has an error pending; `doing` names the operation.
void check_gl(const char* doing);

}  // namespace burnish::gpu
