// Material textures on the device: formats, mipmaps and samplers.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/progress.hpp"
#include "burnish/scene.hpp"
#include "gpu/device/handles.hpp"

namespace burnish::gpu {

// How shaders read a texture. Texels that are not finite are replaced, so that filtering cannot
// spread them: `plain` by 0, `normal` by a flat normal. `slopes`: slopes and their variances
// (maps/normal/slope_mips.hpp).
enum class TextureForm { plain, normal, slopes };

// Whether a material reads its normal map as slopes.
bool wants_slopes(const Material& material);

// Texels and how they are to be read are equal; names may differ.
bool same_texels(const Texture& a, const Texture& b);

// The textures of a scene by their numbers, each uploaded in the forms that materials ask for. A
// copy of the texels is kept: a material that is changed may ask for another form. 8-bit color is
// decoded from sRGB by the hardware; 16 bits stay 16 bits on the desktop; what has no filterable
// format of its own becomes half float.
class TextureStore {
  public:
    struct Slot {
        std::shared_ptr<const Texture> source;
        std::array<std::shared_ptr<const GlTexture>, 3>
            forms;  // by TextureForm; null: not asked for
    };
    using Slots = std::vector<Slot>;  // copies share what is on the device

    explicit TextureStore(const Context& context);

    const Slots& slots() const { return slots_; }
    void set_slots(Slots slots) noexcept { slots_ = std::move(slots); }

    // Uploads what the material reads and `slots` lack. Throws Error naming the texture when there
    // is none of this number, when it is broken or too large for the device; Interrupted. What was
    // uploaded before stays in `slots`.
    void require(Slots& slots, const Material& material, const Progress& progress);
    void require(const Material& material, const Progress& progress) {
        require(slots_, material, progress);
    }
    bool uses(const Material& material, int texture) const;

    // `use` must have a texture, which was required in this form.
    void bind(GLuint unit, const TextureUse& use, TextureForm form);
    static int channels(const Slots& slots, const TextureUse& use);
    float log2_side(const TextureUse& use) const;  // of the longer side in texels

    int uploads() const { return uploads_; }  // of this store so far

  private:
    struct Need {
        std::size_t texture;
        TextureForm form;
    };
    std::vector<Need> needs_of(const Material& material, const Slots& slots) const;
    static const GlTexture& uploaded(const Slots& slots, const TextureUse& use, TextureForm form);
    GLuint sampler_for(const TextureUse& use);

    bool es_;
    int max_size_;
    Slots slots_;
    std::map<std::tuple<Wrap, Wrap, bool>, Sampler> samplers_;
    float anisotropy_ = 1.0f;
    int uploads_ = 0;
};

}  // namespace burnish::gpu
