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

// The form in which shaders read a texture. Texels that are not finite are replaced, so that
// filtering cannot spread them: `plain` by 0, `normal` by a flat normal. `slopes`: slopes and their
// variances (maps/normal/slope_mips.hpp); `slope_covariance`: the covariances beside them.
enum class TextureForm { plain, normal, slopes, slope_covariance };

// Whether a material uses its normal map in the form of slopes.
bool wants_slopes(const Material& material);
// The same of the normal map of its coat.
bool wants_coat_slopes(const Material& material);

// Whether texels and sampling are equal; names may differ.
bool same_texels(const Texture& a, const Texture& b);

// The textures of a scene by number, each uploaded in the forms that materials need. A copy of the
// texels is kept, because a changed material may need another form. The hardware decodes 8-bit
// color from sRGB. 16-bit textures keep 16 bits on the desktop. Types without a filterable format
// of their own become half float.
class TextureStore {
  public:
    struct Slot {
        std::shared_ptr<const Texture> source;
        std::array<std::shared_ptr<const GlTexture>, 4>
            forms;  // by TextureForm; null: not uploaded
    };
    using Slots = std::vector<Slot>;  // copies share the data on the device

    explicit TextureStore(const Context& context);

    const Slots& slots() const { return slots_; }
    void set_slots(Slots slots) noexcept { slots_ = std::move(slots); }

    // Uploads the forms that the material reads and `slots` lack. Throws Error naming the texture
    // when the number does not exist, or the texture is broken or too large for the device; throws
    // Interrupted. Completed uploads stay in `slots`.
    void require(Slots& slots, const Material& material, const Progress& progress);
    void require(const Material& material, const Progress& progress) {
        require(slots_, material, progress);
    }
    // Also the covariances of its normal map, which must be in the form of slopes: only the view of the
    // moments reads them.
    void require_covariances(const Material& material, const Progress& progress);
    bool uses(const Material& material, int texture) const;

    // `use` must have a texture, and the form must have been required.
    void bind(GLuint unit, const TextureUse& use, TextureForm form);
    static int channels(const Slots& slots, const TextureUse& use);
    float log2_side(const TextureUse& use) const;  // of the longer side in texels

    int uploads() const { return uploads_; }  // of this store since its creation

  private:
    struct Need {
        std::size_t texture;
        TextureForm form;
    };
    std::vector<Need> needs_of(const Material& material, const Slots& slots) const;
    void require(Slots& slots, const Need& need, const Progress& progress);
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
