#include "gpu/upload/lobe_map.hpp"

#include <algorithm>

#include "burnish/error.hpp"
#include "gpu/device/texture_units.hpp"

namespace burnish::gpu {
namespace {

// Samples per texel. 96 leave 1 % of ripple beside a sun of 0.5 degrees. The first level, whose
// lobe is 2 texels wide, needs no more than its neighborhood.
constexpr int kKernelSamples = 96;
constexpr int kFirstKernelSamples = 32;

void define_levels(int size) {
    GLint level = 0;
    for (int side = size; side >= 1; side /= 2, ++level) {
        for (GLenum face = 0; face < 6; ++face) {
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, GL_RGBA16F, side, side, 0,
                         GL_RGBA, GL_HALF_FLOAT, nullptr);
        }
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, level - 1);
}

}  // namespace

// A texel of a face spans about pi/2 / size radians; a lobe spans twice its alpha in directions.
LobeMap::LobeMap(Program& program, int size, GLuint empty_vertex_array)
    : first_alpha_(1.5707963f / static_cast<float>(size)) {
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture_.get());
    define_levels(size);
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
    Framebuffer target;
    glBindFramebuffer(GL_FRAMEBUFFER, target.get());
    glBindVertexArray(empty_vertex_array);
    GLint level = 0;
    float alpha = first_alpha_;
    for (int side = size; side >= 1; side /= 2, alpha *= 2.0f, ++level) {
        glViewport(0, 0, side, side);
        program.set("u_kernel_alpha", level == 0 ? 0.0f : alpha);
        program.set("u_kernel_samples", level == 0   ? 1
                                        : level == 1 ? kFirstKernelSamples
                                                     : kKernelSamples);
        for (int face = 0; face < 6; ++face) {
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                   GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face),
                                   texture_.get(), level);
            if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
                throw Error("render", "image_light", "a device that renders to half floats",
                            "none: use importance");
            }
            program.set("u_face", face);
            glDrawArrays(GL_TRIANGLES, 0, 3);
        }
    }
    glBindVertexArray(0);
    check_gl("blurring the environment");
}

}  // namespace burnish::gpu
