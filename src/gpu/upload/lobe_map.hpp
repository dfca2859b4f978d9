// An environment blurred by round lobes of growing width, for --image-light prefiltered.
#pragma once

#include "gpu/device/gl.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"

namespace burnish::gpu {

// Level l of a cube map holds radiance seen through an isotropic GGX lobe of alpha
// `first_alpha() 2^l` that faces its direction; level 0 is the environment itself. A level's texels
// are half as wide as its lobe, so that bilinear look-ups are smooth.
class LobeMap {
  public:
    // `radiance`: a cube map of `size` texels a side with its mips, which `program`
    // (fullscreen.vert, prefilter.frag) can read as it is set up. Needs no depth buffer; leaves its
    // own framebuffer bound and the viewport changed. Throws Error when the device cannot render to
    // half floats.
    LobeMap(Program& program, int size, GLuint empty_vertex_array);

    GLuint texture() const { return texture_.get(); }
    float first_alpha() const { return first_alpha_; }

  private:
    GlTexture texture_;
    float first_alpha_;
};

}  // namespace burnish::gpu
