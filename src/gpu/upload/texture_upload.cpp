#include "gpu/upload/texture_upload.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <string>
#include <type_traits>

#include "burnish/error.hpp"
#include "gpu/device/texture_units.hpp"
#include "image/image_io.hpp"
#include "maps/normal/slope_mips.hpp"

namespace burnish::gpu {
namespace {

std::size_t bytes_of(TexelType type) {
    return type == TexelType::u8 ? 1 : type == TexelType::u16 ? 2 : 4;
}

void require_sound(const Texture& texture, int max_size) {
    const bool shape =
        texture.width > 0 && texture.height > 0 && texture.channels >= 1 && texture.channels <= 4;
    if (!shape || texture.texels.size() != static_cast<std::size_t>(texture.width) *
                                               static_cast<std::size_t>(texture.height) *
                                               static_cast<std::size_t>(texture.channels) *
                                               bytes_of(texture.type)) {
        throw Error(texture.name, "texture", "as many texels as width and height say",
                    "another number");
    }
    if (texture.width > max_size || texture.height > max_size) {
        throw Error(texture.name, "texture",
                    "at most " + std::to_string(max_size) + " pixels a side on this device",
                    std::to_string(texture.width) + " x " + std::to_string(texture.height));
    }
}

struct Format {
    GLenum internal, layout, type;
};

// Texels as they are handed to OpenGL.
struct Pixels {
    std::vector<std::byte> converted;  // empty: the texture's own
    const void* data = nullptr;
    Format format{};
};

template <typename T>
T opaque() {
    return std::is_floating_point_v<T> ? T(1) : std::numeric_limits<T>::max();
}

// One value of four channels a texel: grey is spread, alpha filled in. `convert`: T to U.
template <typename T, typename U, typename Convert>
std::vector<std::byte> to_four_channels(const Texture& texture, Convert convert) {
    const std::size_t count =
        static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
    const auto n = static_cast<std::size_t>(texture.channels);
    std::vector<std::byte> out(count * 4 * sizeof(U));
    for (std::size_t i = 0; i < count; ++i) {
        T in[4] = {};
        std::memcpy(in, texture.texels.data() + i * n * sizeof(T), n * sizeof(T));
        const T alpha = n == 4 ? in[3] : n == 2 ? in[1] : opaque<T>();
        const T rgb[3] = {in[0], n >= 3 ? in[1] : in[0], n >= 3 ? in[2] : in[0]};
        const U texel[4] = {convert(rgb[0], false), convert(rgb[1], false), convert(rgb[2], false),
                            convert(alpha, true)};
        std::memcpy(out.data() + i * sizeof(texel), texel, sizeof(texel));
    }
    return out;
}

Pixels u8_pixels(const Texture& texture) {
    const auto keep = [](std::uint8_t v, bool) { return v; };
    const bool srgb = texture.color_space == ColorSpace::srgb;
    Pixels p;
    if (srgb || texture.channels == 3) {
        p.format = {static_cast<GLenum>(srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8), GL_RGBA,
                    GL_UNSIGNED_BYTE};
        if (texture.channels != 4) {
            p.converted = to_four_channels<std::uint8_t, std::uint8_t>(texture, keep);
        }
    } else if (texture.channels == 4) {
        p.format = {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    } else {
        p.format = texture.channels == 1 ? Format{GL_R8, GL_RED, GL_UNSIGNED_BYTE}
                                         : Format{GL_RG8, GL_RG, GL_UNSIGNED_BYTE};
    }
    return p;
}

Pixels half_of_u16(const Texture& texture) {
    const bool srgb = texture.color_space == ColorSpace::srgb;
    Pixels p;
    p.format = {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
    p.converted = to_four_channels<std::uint16_t, std::uint16_t>(
        texture, [srgb](std::uint16_t v, bool alpha) {
            const float value = static_cast<float>(v) / 65535.0f;
            return glm::packHalf1x16(srgb && !alpha ? linear_from_srgb(value) : value);
        });
    return p;
}

Pixels u16_pixels(const Texture& texture, bool es) {
    if (es || texture.color_space == ColorSpace::srgb) return half_of_u16(texture);
    Pixels p;
    if (texture.channels >= 3) {
        p.format = {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT};
        if (texture.channels == 3) {
            p.converted = to_four_channels<std::uint16_t, std::uint16_t>(
                texture, [](std::uint16_t v, bool) { return v; });
        }
    } else {
        p.format = texture.channels == 1 ? Format{GL_R16, GL_RED, GL_UNSIGNED_SHORT}
                                         : Format{GL_RG16, GL_RG, GL_UNSIGNED_SHORT};
    }
    return p;
}

Pixels f32_pixels(const Texture& texture, bool es, TexelRepair repair) {
    Pixels p;
    // ES filters half floats, not floats, the largest of which is 65504. It is the brightest that a
    // pixel can be, and sums of such texels (filters, mips) stay far from infinity, whose
    // differences would be NaN. Normals lie in [0, 1]: within 16 their squares stay far from
    // overflow, whatever scale is put on them.
    p.format = {static_cast<GLenum>(es ? GL_RGBA16F : GL_RGBA32F), GL_RGBA, GL_FLOAT};
    const bool normals = repair == TexelRepair::flat_normal;
    const float limit = normals ? 16.0f : 65504.0f;
    p.converted = to_four_channels<float, float>(texture, [limit](float v, bool) {
        return std::isfinite(v) ? std::clamp(v, -limit, limit) : std::nanf("");
    });
    for (std::size_t i = 0; i < p.converted.size(); i += 4 * sizeof(float)) {
        float texel[4];
        std::memcpy(texel, p.converted.data() + i, sizeof(texel));
        if (std::isfinite(texel[0] + texel[1] + texel[2] + texel[3])) continue;
        const float flat = normals ? 0.5f : 0.0f;
        const float replaced[4] = {flat, flat, 2 * flat, 1.0f};
        std::memcpy(p.converted.data() + i, replaced, sizeof(replaced));
    }
    return p;
}

Pixels pixels_of(const Texture& texture, bool es, TexelRepair repair) {
    Pixels p = texture.type == TexelType::u8    ? u8_pixels(texture)
               : texture.type == TexelType::u16 ? u16_pixels(texture, es)
                                                : f32_pixels(texture, es, repair);
    p.data = p.converted.empty() ? texture.texels.data() : p.converted.data();
    return p;
}

GlTexture upload(const Texture& texture, const Pixels& pixels) {
    GlTexture made;
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D, made.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(pixels.format.internal), texture.width,
                 texture.height, 0, pixels.format.layout, pixels.format.type, pixels.data);
    if (pixels.format.layout == GL_RED || pixels.format.layout == GL_RG) {
        const GLint alpha = pixels.format.layout == GL_RED ? GL_ONE : GL_GREEN;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, GL_RED);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_B, GL_RED);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_A, alpha);
    }
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 0);
    check_gl(("uploading " + texture.name).c_str());
    return made;
}

// Half floats hold the slopes of 8-bit maps, whose step is 1/127, with room to spare; finer maps
// keep floats where the device filters them.
GlTexture upload_slopes(const Texture& texture, bool es) {
    const bool half = es || texture.type == TexelType::u8;
    GlTexture made;
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D, made.get());
    GLint level = 0;
    for (const SlopeLevel& slopes : slope_mips(texture)) {
        glTexImage2D(GL_TEXTURE_2D, level++, half ? GL_RGBA16F : GL_RGBA32F, slopes.width,
                     slopes.height, 0, GL_RGBA, GL_FLOAT, slopes.texels.data());
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    check_gl(("uploading " + texture.name).c_str());
    return made;
}

float log2_longer_side(const Texture& texture) {
    return std::log2(static_cast<float>(std::max(texture.width, texture.height)));
}

GLint wrap_of(Wrap wrap) {
    return wrap == Wrap::repeat   ? GL_REPEAT
           : wrap == Wrap::mirror ? GL_MIRRORED_REPEAT
                                  : GL_CLAMP_TO_EDGE;
}

}  // namespace

bool wants_slopes(const Material& material) {
    // A tabulated lobe has no width to widen.
    return material.normal_texture && !tabulated_of(material) &&
           material.normal_filter == NormalFilter::moments;
}

TextureStore::TextureStore(const Context& context, const Scene& scene) {
    // The software renderer pays for every probe of an anisotropic fetch; jittered samples do the
    // same work there for nothing.
    if (!context.is_software() && context.has_extension("GL_EXT_texture_filter_anisotropic")) {
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &anisotropy_);
        anisotropy_ = std::clamp(anisotropy_, 1.0f, 8.0f);
    }
    const std::vector<Material> drawn = drawn_materials(scene.materials);
    const auto checked = [&](const TextureUse& use) -> const Texture& {
        if (static_cast<std::size_t>(use.texture) >= scene.textures.size()) {
            throw Error("material", "texture", "one of " + std::to_string(scene.textures.size()),
                        "number " + std::to_string(use.texture));
        }
        const Texture& texture = scene.textures[static_cast<std::size_t>(use.texture)];
        require_sound(texture, context.max_texture_size());
        return texture;
    };
    const auto require = [&](const TextureUse& use, TexelRepair repair) {
        if (!use || textures_.contains(use.texture)) return;
        const Texture& texture = checked(use);
        const Pixels pixels = pixels_of(texture, context.is_es(), repair);
        textures_.emplace(use.texture, Uploaded{upload(texture, pixels), texture.channels,
                                                log2_longer_side(texture)});
    };
    for (const Material& m : drawn) {
        const TextureUse& use = m.normal_texture;
        if (!wants_slopes(m)) {
            require(use, TexelRepair::flat_normal);
        } else if (!slopes_.contains(use.texture)) {
            const Texture& texture = checked(use);
            slopes_.emplace(use.texture, Uploaded{upload_slopes(texture, context.is_es()),
                                                  texture.channels, log2_longer_side(texture)});
        }
    }
    for (const Material& m : drawn) {
        for (const TextureUse* use :
             {&m.base_color_texture, &m.metallic_roughness_texture, &m.occlusion_texture,
              &m.emissive_texture, &m.anisotropy_texture}) {
            require(*use, TexelRepair::zero);
        }
    }
}

GLuint TextureStore::sampler_for(const TextureUse& use) {
    const auto [place, fresh] = samplers_.try_emplace({use.wrap_s, use.wrap_t, use.nearest});
    const GLuint sampler = place->second.get();
    if (!fresh) return sampler;
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, wrap_of(use.wrap_s));
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, wrap_of(use.wrap_t));
    glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, use.nearest ? GL_NEAREST : GL_LINEAR);
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER,
                        use.nearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
    if (anisotropy_ > 1.0f && !use.nearest) {
        glSamplerParameterf(sampler, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy_);
    }
    return sampler;
}

const TextureStore::Uploaded& TextureStore::uploaded(const TextureUse& use, bool slopes) const {
    const auto& all = slopes ? slopes_ : textures_;
    const auto found = all.find(use.texture);
    if (found != all.end()) return found->second;
    throw Error("material", "normal_filter", "the one it was uploaded with",
                slopes ? "moments" : "mips");
}

void TextureStore::bind(GLuint unit, const TextureUse& use, bool slopes) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, uploaded(use, slopes).texture.get());
    glBindSampler(unit, sampler_for(use));
}

int TextureStore::channels(const TextureUse& use) const {
    return uploaded(use, false).channels;
}

float TextureStore::log2_side(const TextureUse& use, bool slopes) const {
    return uploaded(use, slopes).log2_side;
}

}  // namespace burnish::gpu
