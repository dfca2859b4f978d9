#include "gpu/device/draw_state.hpp"

namespace burnish::gpu {
namespace {

void set_enabled(GLenum what, bool on) {
    if (on) {
        glEnable(what);
    } else {
        glDisable(what);
    }
}

// ES lacks the last two: its cube maps are seamless, and its framebuffers decide on encoding.
constexpr std::array<GLenum, 7> kSwitches = {
    GL_BLEND,     GL_DEPTH_TEST,          GL_STENCIL_TEST,    GL_SCISSOR_TEST,
    GL_CULL_FACE, GL_POLYGON_OFFSET_FILL, GL_FRAMEBUFFER_SRGB};
constexpr std::size_t kSwitchesOfEs = 6;

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

constexpr GLenum kStencilNames[2][7] = {
    {GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK, GL_STENCIL_WRITEMASK, GL_STENCIL_FAIL,
     GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS},
    {GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF, GL_STENCIL_BACK_VALUE_MASK,
     GL_STENCIL_BACK_WRITEMASK, GL_STENCIL_BACK_FAIL, GL_STENCIL_BACK_PASS_DEPTH_FAIL,
     GL_STENCIL_BACK_PASS_DEPTH_PASS}};

}  // namespace

void apply_culling(bool cull, bool mirrored) {
    set_enabled(GL_CULL_FACE, cull);
    glFrontFace(mirrored ? GL_CW : GL_CCW);
}

void apply(const DrawState& s) {
    set_enabled(GL_DEPTH_TEST, s.depth_test);
    glDepthMask(s.depth_write ? GL_TRUE : GL_FALSE);
    glDepthFunc(s.depth_function);
    set_enabled(GL_POLYGON_OFFSET_FILL, s.depth_offset);
    set_enabled(GL_BLEND, s.blend != Blend::none);
    switch (s.blend) {
        case Blend::none:
            break;
        case Blend::premultiplied:
            glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
            break;
        case Blend::add:
            glBlendFunc(GL_ONE, GL_ONE);
            break;
        case Blend::multiply:
            glBlendFunc(GL_ZERO, GL_SRC_COLOR);
            break;
    }
    apply_culling(s.cull, s.mirrored);
    set_enabled(GL_STENCIL_TEST, s.stencil.has_value());
    if (s.stencil) {
        glStencilFunc(s.stencil->write ? GL_ALWAYS : GL_EQUAL, s.stencil->value, 0xFF);
        glStencilOp(GL_KEEP, GL_KEEP, s.stencil->write ? GL_REPLACE : GL_KEEP);
    }
    set_enabled(GL_SCISSOR_TEST, s.scissor.has_value());
    if (s.scissor) glScissor(s.scissor->x, s.scissor->y, s.scissor->width, s.scissor->height);
}

HostState::HostState(const Context& context)
    : adopted_(context.is_adopted()), es_(context.is_es()) {
    if (!adopted_) return;
    save();
    if (!es_) glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_SCISSOR_TEST);
    glBlendEquation(GL_FUNC_ADD);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilMask(0xFF);
    glCullFace(GL_BACK);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

HostState::~HostState() {
    if (adopted_) restore();
}

void HostState::save() {
    const std::size_t switches = es_ ? kSwitchesOfEs : kSwitches.size();
    for (std::size_t i = 0; i < switches; ++i) enabled_[i] = glIsEnabled(kSwitches[i]);
    glGetIntegerv(GL_VIEWPORT, viewport_.data());
    glGetIntegerv(GL_SCISSOR_BOX, scissor_.data());
    glGetBooleanv(GL_COLOR_WRITEMASK, color_mask_.data());
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depth_mask_);
    draw_framebuffer_ = integer(GL_DRAW_FRAMEBUFFER_BINDING);
    read_framebuffer_ = integer(GL_READ_FRAMEBUFFER_BINDING);
    const GLenum blend[6] = {GL_BLEND_SRC_RGB,   GL_BLEND_DST_RGB,      GL_BLEND_SRC_ALPHA,
                             GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};
    for (int i = 0; i < 6; ++i) blend_[i] = integer(blend[i]);
    depth_function_ = integer(GL_DEPTH_FUNC);
    for (int face = 0; face < 2; ++face)
        for (int i = 0; i < 7; ++i) stencil_[face][i] = integer(kStencilNames[face][i]);
    cull_face_ = integer(GL_CULL_FACE_MODE);
    front_face_ = integer(GL_FRONT_FACE);
    glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &offset_[0]);
    glGetFloatv(GL_POLYGON_OFFSET_UNITS, &offset_[1]);
    program_ = integer(GL_CURRENT_PROGRAM);
    vertex_array_ = integer(GL_VERTEX_ARRAY_BINDING);
    array_buffer_ = integer(GL_ARRAY_BUFFER_BINDING);
    pack_buffer_ = integer(GL_PIXEL_PACK_BUFFER_BINDING);
    unpack_buffer_ = integer(GL_PIXEL_UNPACK_BUFFER_BINDING);
    active_texture_ = integer(GL_ACTIVE_TEXTURE);
    pack_ = integer(GL_PACK_ALIGNMENT);
    unpack_ = integer(GL_UNPACK_ALIGNMENT);
    unpack_row_ = integer(GL_UNPACK_ROW_LENGTH);
}

void HostState::restore() const {
    const auto name = [](GLint value) { return static_cast<GLuint>(value); };
    for (GLuint unit = 0; unit < kUsedUnits; ++unit) glBindSampler(unit, 0);
    const std::size_t switches = es_ ? kSwitchesOfEs : kSwitches.size();
    for (std::size_t i = 0; i < switches; ++i) set_enabled(kSwitches[i], enabled_[i] != GL_FALSE);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name(draw_framebuffer_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, name(read_framebuffer_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    glScissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
    glColorMask(color_mask_[0], color_mask_[1], color_mask_[2], color_mask_[3]);
    glDepthMask(depth_mask_);
    glBlendFuncSeparate(name(blend_[0]), name(blend_[1]), name(blend_[2]), name(blend_[3]));
    glBlendEquationSeparate(name(blend_[4]), name(blend_[5]));
    glDepthFunc(name(depth_function_));
    for (int face = 0; face < 2; ++face) {
        const GLenum side = face == 0 ? GL_FRONT : GL_BACK;
        const GLint* s = stencil_[face];
        glStencilFuncSeparate(side, name(s[0]), s[1], name(s[2]));
        glStencilMaskSeparate(side, name(s[3]));
        glStencilOpSeparate(side, name(s[4]), name(s[5]), name(s[6]));
    }
    glCullFace(name(cull_face_));
    glFrontFace(name(front_face_));
    glPolygonOffset(offset_[0], offset_[1]);
    glUseProgram(name(program_));
    glBindVertexArray(name(vertex_array_));
    glBindBuffer(GL_ARRAY_BUFFER, name(array_buffer_));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, name(pack_buffer_));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, name(unpack_buffer_));
    glActiveTexture(name(active_texture_));
    glPixelStorei(GL_PACK_ALIGNMENT, pack_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, unpack_);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, unpack_row_);
}

}  // namespace burnish::gpu
