// The raster state of a draw, set as a whole, so that no draw depends on the draws before it. Saves
// and restores the state of a host program.
#pragma once

#include <array>
#include <optional>

#include "burnish/context.hpp"
#include "gpu/device/gl.hpp"

namespace burnish::gpu {

enum class Blend {
    none,
    premultiplied,  // source + (1 - source alpha) destination
    add,            // source + destination
    multiply        // source times destination
};

struct Stencil {
    bool write = false;  // true: write `value`; false: draw where the stencil equals `value`
    int value = 0;
};

struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;
};

struct DrawState {
    bool depth_test = true;
    bool depth_write = true;
    GLenum depth_function = GL_LEQUAL;
    bool depth_offset = false;  // for shadow maps
    Blend blend = Blend::none;
    bool cull = false;  // back faces
    bool mirrored = false;
    std::optional<Stencil> stencil = std::nullopt;
    std::optional<Rectangle> scissor = std::nullopt;
};

void apply(const DrawState& state);
// Sets the state that differs between the items of one pass.
void apply_culling(bool cull, bool mirrored);

// Saves the state of the host of an adopted context and sets the state that the renderer assumes;
// its destructor restores the host's state. Does nothing in a context of our own. The state is
// listed at Context::adopt_current.
class HostState {
  public:
    explicit HostState(const Context& context);
    ~HostState();
    HostState(const HostState&) = delete;
    HostState& operator=(const HostState&) = delete;

  private:
    void save();
    void restore() const;

    bool adopted_;
    bool es_;
    std::array<GLboolean, 7> enabled_{};
    std::array<GLint, 4> viewport_{}, scissor_{};
    std::array<GLboolean, 4> color_mask_{};
    GLboolean depth_mask_ = GL_TRUE;
    GLint draw_framebuffer_ = 0, read_framebuffer_ = 0;
    GLint blend_[6] = {};  // source and destination of color and alpha, equations of both
    GLint depth_function_ = GL_LESS;
    GLint stencil_[2][7] =
        {};  // front, back: function, value, masks of value and writes, operations
    GLint cull_face_ = GL_BACK, front_face_ = GL_CCW;
    GLfloat offset_[2] = {};
    GLint program_ = 0, vertex_array_ = 0, array_buffer_ = 0, pack_buffer_ = 0, unpack_buffer_ = 0;
    GLint active_texture_ = GL_TEXTURE0, pack_ = 4, unpack_ = 4, unpack_row_ = 0;
};

// Texture units that the renderer binds; their sampler objects are unbound at the end of a call.
inline constexpr GLuint kUsedUnits = 27;

}  // namespace burnish::gpu
