// Render targets: the frame in progress with its depth, the triangle seen at each pixel, and the
// sum of frames.
#pragma once

#include <optional>
#include <vector>

#include "burnish/context.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"

namespace burnish::gpu {

// The renderable float format of the device: RGBA32F, or RGBA16F where that is the only one. Throws
// Error on a device with neither.
struct ColorFormat {
    GLenum internal;
    GLenum type;
};
ColorFormat probe_color_format(const Context& context);

class Targets {
  public:
    Targets(const Context& context, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    void bind_frame() const;  // color, depth and stencil
    // The images of gbuffer.frag with the same depth and stencil; created at the first call.
    void bind_gbuffer(bool with_position, bool with_shape, bool with_visibility);
    void bind_gbuffer_textures(Program& program) const;

    // `weighted`: a robust mean, whose sum of weights is kept beside it.
    void clear_sum(bool weighted);
    // Adds the frame to the sum. `program` is that of accumulate.frag, or of accumulate_robust.frag for
    // a weighted sum. A viewport must be set.
    void accumulate(Program& program, GLuint empty_vertex_array);
    // Draws the sum by `program`, that of display.frag, over the viewport of the bound framebuffer.
    void show_sum(Program& program, GLuint empty_vertex_array) const;
    // RGBA of the lower left width x height pixels, bottom row first.
    std::vector<float> read_sum(int width, int height) const;
    // The weights of these pixels in the same order; empty unless the sum is weighted.
    std::vector<float> read_weights(int width, int height) const;

  private:
    std::vector<float> read(GLenum image, int width, int height) const;
    void bind_sum(Program& program) const;
    void add_to_gbuffer(std::optional<GlTexture>& image, GLenum place, bool words);

    struct GBuffer {
        GlTexture words;
        std::optional<GlTexture> position, shape, seen[2];
        Framebuffer target;
    };

    int width_, height_;
    GlTexture frame_, depth_, sum_[2];
    Framebuffer frame_target_, sum_target_[2];
    std::optional<GBuffer> gbuffer_;
    std::optional<GlTexture> weights_[2];
    bool weighted_ = false;
    int current_ = 0;
};

}  // namespace burnish::gpu
