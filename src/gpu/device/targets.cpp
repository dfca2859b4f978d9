#include "gpu/device/targets.hpp"

#include <vector>

#include "burnish/error.hpp"
#include "gpu/device/draw_state.hpp"
#include "gpu/device/texture_units.hpp"

namespace burnish::gpu {
namespace {

void define_texture(GLuint texture, ColorFormat format, GLenum layout, int width, int height) {
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format.internal), width, height, 0, layout,
                 format.type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void attach(GLuint target, GLuint color, GLuint depth) {
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    if (depth != 0) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depth,
                               0);
    }
}

bool complete() {
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace

ColorFormat probe_color_format(const Context& context) {
    // Blending into 32-bit floats is an extension on ES; into 16-bit floats it is not.
    const bool blends = !context.is_es() || context.has_extension("GL_EXT_float_blend");
    const ColorFormat formats[] = {{GL_RGBA32F, GL_FLOAT}, {GL_RGBA16F, GL_HALF_FLOAT}};
    for (const ColorFormat& format : formats) {
        if (format.internal == GL_RGBA32F && !blends) continue;
        GlTexture texture;
        Framebuffer target;
        define_texture(texture.get(), format, GL_RGBA, 4, 4);
        attach(target.get(), texture.get(), 0);
        const bool works = complete();
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        while (glGetError() != GL_NO_ERROR) {
        }
        if (works) return format;
    }
    throw Error(context.renderer() + " cannot render to floating-point images");
}

Targets::Targets(const Context& context, int width, int height) : width_(width), height_(height) {
    const ColorFormat color = probe_color_format(context);
    define_texture(frame_.get(), color, GL_RGBA, width, height);
    define_texture(depth_.get(), {GL_DEPTH24_STENCIL8, GL_UNSIGNED_INT_24_8}, GL_DEPTH_STENCIL,
                   width, height);
    attach(frame_target_.get(), frame_.get(), depth_.get());
    bool usable = complete();
    for (int i = 0; i < 2; ++i) {
        define_texture(sum_[i].get(), {GL_RGBA32F, GL_FLOAT}, GL_RGBA, width, height);
        attach(sum_target_[i].get(), sum_[i].get(), 0);
        usable = usable && complete();
    }
    check_gl("making images to draw into");
    if (!usable) {
        throw Error(context.renderer() + " cannot render to images of " + std::to_string(width) +
                    " x " + std::to_string(height) + " pixels");
    }
}

void Targets::bind_frame() const {
    glBindFramebuffer(GL_FRAMEBUFFER, frame_target_.get());
}

void Targets::add_to_gbuffer(std::optional<GlTexture>& image, GLenum place, bool words) {
    if (image) return;
    image.emplace();
    const ColorFormat format =
        words ? ColorFormat{GL_RGBA32UI, GL_UNSIGNED_INT} : ColorFormat{GL_RGBA32F, GL_FLOAT};
    define_texture(image->get(), format, words ? GL_RGBA_INTEGER : GL_RGBA, width_, height_);
    glBindFramebuffer(GL_FRAMEBUFFER, gbuffer_->target.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, image->get(), 0);
}

void Targets::bind_gbuffer(bool with_position, bool with_shape, bool with_visibility) {
    if (!gbuffer_) {
        gbuffer_.emplace();
        define_texture(gbuffer_->words.get(), {GL_RGBA32UI, GL_UNSIGNED_INT}, GL_RGBA_INTEGER,
                       width_, height_);
        attach(gbuffer_->target.get(), gbuffer_->words.get(), depth_.get());
    }
    if (with_position) add_to_gbuffer(gbuffer_->position, GL_COLOR_ATTACHMENT1, false);
    if (with_shape) add_to_gbuffer(gbuffer_->shape, GL_COLOR_ATTACHMENT2, false);
    if (with_visibility) {
        add_to_gbuffer(gbuffer_->seen[0], GL_COLOR_ATTACHMENT3, true);
        add_to_gbuffer(gbuffer_->seen[1], GL_COLOR_ATTACHMENT4, true);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, gbuffer_->target.get());
    // Only the images that this frame needs: an attached image costs time even if it is not
    // written.
    const auto output = [](bool on, GLenum place) { return on ? place : GLenum{GL_NONE}; };
    const GLenum outputs[] = {GL_COLOR_ATTACHMENT0, output(with_position, GL_COLOR_ATTACHMENT1),
                              output(with_shape, GL_COLOR_ATTACHMENT2),
                              output(with_visibility, GL_COLOR_ATTACHMENT3),
                              output(with_visibility, GL_COLOR_ATTACHMENT4)};
    glDrawBuffers(with_visibility ? 5 : with_shape ? 3 : with_position ? 2 : 1, outputs);
    if (!complete()) throw Error("the device cannot render to several float images at once");
}

void Targets::bind_gbuffer_textures(Program& program) const {
    const auto bind = [&](GLuint unit, GLuint texture, const char* name) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, texture);
        program.set(name, static_cast<int>(unit));
    };
    bind(kPackedUnit, gbuffer_->words.get(), "u_packed");
    if (gbuffer_->position) bind(kPositionUnit, gbuffer_->position->get(), "u_position");
    if (gbuffer_->shape) bind(kShapeUnit, gbuffer_->shape->get(), "u_shape");
    if (gbuffer_->seen[0]) bind(kSeenUnits, gbuffer_->seen[0]->get(), "u_seen0");
    if (gbuffer_->seen[1]) bind(kSeenUnits + 1, gbuffer_->seen[1]->get(), "u_seen1");
}

void Targets::clear_sum(bool weighted) {
    weighted_ = weighted;
    const GLenum outputs[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    for (int i = 0; i < 2; ++i) {
        const bool made = weights_[i].has_value();
        if (weighted && !made)
            define_texture(weights_[i].emplace().get(), {GL_R32F, GL_FLOAT}, GL_RED, width_,
                           height_);
        glBindFramebuffer(GL_FRAMEBUFFER, sum_target_[i].get());
        if (weighted && !made)
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D,
                                   weights_[i]->get(), 0);
        glDrawBuffers(weighted ? 2 : 1, outputs);
        if (!complete()) throw Error("the device cannot render to two float images at once");
    }
    glBindFramebuffer(GL_FRAMEBUFFER, sum_target_[current_].get());
    apply(DrawState{});  // without scissor
    const float zero[4] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, zero);
    if (weighted) glClearBufferfv(GL_COLOR, 1, zero);
}

void Targets::bind_sum(Program& program) const {
    glActiveTexture(GL_TEXTURE0 + kSumUnit);
    glBindTexture(GL_TEXTURE_2D, sum_[current_].get());
    program.set("u_sum", static_cast<int>(kSumUnit));
    // A sampler that is not read still needs a texture of its kind: the sum again.
    glActiveTexture(GL_TEXTURE0 + kWeightsUnit);
    glBindTexture(GL_TEXTURE_2D, weighted_ ? weights_[current_]->get() : sum_[current_].get());
    program.set("u_weights", static_cast<int>(kWeightsUnit));
}

void Targets::accumulate(Program& program, GLuint empty_vertex_array) {
    glBindFramebuffer(GL_FRAMEBUFFER, sum_target_[1 - current_].get());
    apply(DrawState{.depth_test = false, .depth_write = false});
    program.use();
    bind_sum(program);
    glActiveTexture(GL_TEXTURE0 + kLatestUnit);
    glBindTexture(GL_TEXTURE_2D, frame_.get());
    program.set("u_latest", static_cast<int>(kLatestUnit));
    program.set("u_depth", 0.0f);
    glBindVertexArray(empty_vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    current_ = 1 - current_;
}

void Targets::show_sum(Program& program, GLuint empty_vertex_array) const {
    apply(DrawState{.depth_test = false, .depth_write = false});
    bind_sum(program);
    glBindSampler(kSumUnit, 0);
    glBindSampler(kWeightsUnit, 0);
    program.set("u_depth", 0.0f);
    glBindVertexArray(empty_vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

// RGBA, the one format of which ES can read every image of floats.
std::vector<float> Targets::read(GLenum image, int width, int height) const {
    std::vector<float> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                              4);
    glBindFramebuffer(GL_FRAMEBUFFER, sum_target_[current_].get());
    glReadBuffer(image);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels.data());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    return pixels;
}

std::vector<float> Targets::read_sum(int width, int height) const {
    return read(GL_COLOR_ATTACHMENT0, width, height);
}

std::vector<float> Targets::read_weights(int width, int height) const {
    if (!weighted_) return {};
    const std::vector<float> pixels = read(GL_COLOR_ATTACHMENT1, width, height);
    std::vector<float> weights(pixels.size() / 4);
    for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = pixels[4 * i];
    return weights;
}

}  // namespace burnish::gpu
