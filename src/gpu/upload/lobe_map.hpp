// An environment blurred by round lobes of growing width, for --image-light prefiltered.
#pragma once

#include "gpu/device/gl.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"

namespace burnish::gpu {

// Level l of a cube map holds the radiance filtered by an isotropic GGX lobe of alpha
// `first_alpha() 2^l` about each direction; level 0 is the environment itself. The texels of a
// level are half as wide as its lobe, so that bilinear look-ups are smooth.
class LobeMap {
  public:
    // `radiance`: a cube map of `size` texels a side with its mips. `program` (fullscreen.vert,
    // prefilter.frag) must be set up to read it. Needs no depth buffer; leaves its own framebuffer
    // bound and the viewport changed. Throws Error when the device cannot render to half floats.
    LobeMap(Program& program, int size, GLuint empty_vertex_array);

    GLuint texture() const { return texture_.get(); }
    float first_alpha() const { return first_alpha_; }

  private:
    GlTexture texture_;
    float first_alpha_;
};

}  // namespace burnish::gpu
