// Material textures on the device: formats, mipmaps and samplers.
#pragma once

#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "burnish/scene.hpp"
#include "gpu/device/context.hpp"
#include "gpu/device/handles.hpp"

namespace burnish::gpu {

// What is put in place of texels that are not finite, so that filtering cannot spread them.
enum class TexelRepair { zero, flat_normal };

// Whether a material reads its normal map as slopes and their variances (maps/slope_mips.hpp).
bool wants_slopes(const Material& material);

class TextureStore {
  public:
    // Uploads the textures that a material uses. 8-bit colour is decoded from sRGB by the hardware;
    // 16 bits stay 16 bits on the desktop; what has no filterable format of its own becomes half
    // float. Throws Error naming the texture when it is broken or too large for the device.
    TextureStore(const Context& context, const Scene& scene);

    // `use` must have a texture, `slopes` where wants_slopes(): a normal map as slopes.
    void bind(GLuint unit, const TextureUse& use, bool slopes);
    int channels(const TextureUse& use) const;
    float log2_side(const TextureUse& use, bool slopes) const;  // of the longer side in texels

  private:
    GLuint sampler_for(const TextureUse& use);

    struct Uploaded {
        GlTexture texture;
        int channels = 0;
        float log2_side = 0.0f;
    };
    const Uploaded& uploaded(const TextureUse& use, bool slopes) const;

    std::map<int, Uploaded> textures_;
    std::map<int, Uploaded> slopes_;  // normal maps of materials that filter them by moments
    std::map<std::tuple<Wrap, Wrap, bool>, Sampler> samplers_;
    float anisotropy_ = 1.0f;
};

}  // namespace burnish::gpu
