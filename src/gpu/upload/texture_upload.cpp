#include "gpu/upload/texture_upload.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <string>
#include <type_traits>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "gpu/device/texture_units.hpp"
#include "maps/normal/slope_mips.hpp"
#include "scene/material/texture_uses.hpp"

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

// Texels in the form that OpenGL receives.
struct Pixels {
    std::vector<std::byte> converted;  // empty: the texture's own
    const void* data = nullptr;
    Format format{};
};

template <typename T>
T opaque() {
    return std::is_floating_point_v<T> ? T(1) : std::numeric_limits<T>::max();
}

// Four channels a texel: gray is repeated and alpha filled in, because WebGL 2 cannot swizzle.
// `convert`: T to U.
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
    const bool srgb = texture.color_space == ColorSpace::srgb;
    Pixels p;
    p.format = {static_cast<GLenum>(srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8), GL_RGBA, GL_UNSIGNED_BYTE};
    if (texture.channels != 4) {
        p.converted = to_four_channels<std::uint8_t, std::uint8_t>(
            texture, [](std::uint8_t v, bool) { return v; });
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
    p.format = {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT};
    if (texture.channels != 4) {
        p.converted = to_four_channels<std::uint16_t, std::uint16_t>(
            texture, [](std::uint16_t v, bool) { return v; });
    }
    return p;
}

Pixels f32_pixels(const Texture& texture, bool es, TextureForm form) {
    Pixels p;
    // ES filters half floats, whose largest value is 65504, but not floats. 65504 is the greatest
    // value of a pixel. Sums of such texels (filters, mips) stay far from infinity, whose
    // differences would be NaN. Normals lie in [0, 1]; with a limit of 16 their squares cannot
    // overflow at any scale.
    p.format = {static_cast<GLenum>(es ? GL_RGBA16F : GL_RGBA32F), GL_RGBA, GL_FLOAT};
    const bool normals = form == TextureForm::normal;
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

Pixels pixels_of(const Texture& texture, bool es, TextureForm form) {
    Pixels p = texture.type == TexelType::u8    ? u8_pixels(texture)
               : texture.type == TexelType::u16 ? u16_pixels(texture, es)
                                                : f32_pixels(texture, es, form);
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

GlTexture upload_covariances(const Texture& texture, bool es) {
    GlTexture made;
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D, made.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    const std::vector<SlopeLevel> levels = slope_mips(texture);
    GLint level = 0;
    for (const std::vector<float>& covariances : slope_covariances(levels)) {
        const SlopeLevel& size = levels[static_cast<std::size_t>(level)];
        glTexImage2D(GL_TEXTURE_2D, level++, es ? GL_R16F : GL_R32F, size.width, size.height, 0,
                     GL_RED, GL_FLOAT, covariances.data());
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

// Forms differ for float textures only, which may hold values that are not normals, and for two
// channels, which are x and y in a normal map but gray and alpha elsewhere. Other textures have one
// form for both uses.
TextureForm form_of(const Texture& texture, TextureForm wished) {
    const bool apart = texture.type == TexelType::f32 || texture.channels == 2;
    return wished == TextureForm::normal && !apart ? TextureForm::plain : wished;
}

// x and y of a normal map in red and green; blue is not read and is 0.
Texture with_third_channel(const Texture& xy) {
    Texture xyz = xy;
    xyz.channels = 3;
    const std::size_t each = bytes_of(xy.type);
    const std::size_t count = xy.texels.size() / (2 * each);
    xyz.texels.assign(3 * each * count, std::byte{0});
    for (std::size_t i = 0; i < count; ++i)
        std::memcpy(xyz.texels.data() + 3 * each * i, xy.texels.data() + 2 * each * i, 2 * each);
    return xyz;
}

GlTexture upload_as(TextureForm form, const Texture& texture, bool es) {
    if (form == TextureForm::slopes) return upload_slopes(texture, es);
    if (form == TextureForm::slope_covariance) return upload_covariances(texture, es);
    if (form == TextureForm::normal && texture.channels == 2) {
        const Texture xyz = with_third_channel(texture);
        return upload(xyz, pixels_of(xyz, es, form));
    }
    return upload(texture, pixels_of(texture, es, form));
}

}  // namespace

bool wants_slopes(const Material& material) {
    // A tabulated lobe has no width to widen.
    return material.normal_texture && !tabulated_of(material) &&
           material.normal_filter == NormalFilter::moments;
}

bool wants_coat_slopes(const Material& material) {
    return material.coat.normal_texture && material.normal_filter == NormalFilter::moments;
}

TextureStore::TextureStore(const Context& context)
    : es_(context.is_es()), max_size_(context.max_texture_size()) {
    // The software renderer pays for every probe of an anisotropic fetch, and jittered samples
    // filter equally well there at no cost.
    if (!context.is_software() && context.has_extension("GL_EXT_texture_filter_anisotropic")) {
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &anisotropy_);
        anisotropy_ = std::clamp(anisotropy_, 1.0f, 8.0f);
    }
}

std::vector<TextureStore::Need> TextureStore::needs_of(const Material& m,
                                                       const Slots& slots) const {
    std::vector<Need> needs;
    const auto add = [&](const TextureUse& use, TextureForm form) {
        if (!use) return;
        if (static_cast<std::size_t>(use.texture) >= slots.size()) {
            throw Error("material", "texture", "one of " + std::to_string(slots.size()),
                        "number " + std::to_string(use.texture));
        }
        const auto index = static_cast<std::size_t>(use.texture);
        needs.push_back({index, form_of(*slots[index].source, form)});
    };
    add(m.normal_texture, wants_slopes(m) ? TextureForm::slopes : TextureForm::normal);
    add(m.coat.normal_texture, wants_coat_slopes(m) ? TextureForm::slopes : TextureForm::normal);
    for (const TextureUse* use : texture_uses(m))
        if (use != &m.normal_texture && use != &m.coat.normal_texture)
            add(*use, TextureForm::plain);
    return needs;
}

void TextureStore::require(Slots& slots, const Material& material, const Progress& progress) {
    for (const Need& need : needs_of(material, slots)) require(slots, need, progress);
}

void TextureStore::require(Slots& slots, const Need& need, const Progress& progress) {
    Slot& slot = slots[need.texture];
    std::shared_ptr<const GlTexture>& uploaded = slot.forms[static_cast<std::size_t>(need.form)];
    if (uploaded) return;
    progress.step("textures", 0.0);
    const Texture& texture = *slot.source;
    require_sound(texture, max_size_);
    uploaded = std::make_shared<GlTexture>(upload_as(need.form, texture, es_));
    ++uploads_;
}

void TextureStore::require_covariances(const Material& material, const Progress& progress) {
    const auto texture = static_cast<std::size_t>(material.normal_texture.texture);
    require(slots_, {texture, TextureForm::slope_covariance}, progress);
}

bool TextureStore::uses(const Material& material, int texture) const {
    for (const Need& need : needs_of(material, slots_))
        if (need.texture == static_cast<std::size_t>(texture)) return true;
    return false;
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

const GlTexture& TextureStore::uploaded(const Slots& slots, const TextureUse& use,
                                        TextureForm form) {
    const Slot& slot = slots[static_cast<std::size_t>(use.texture)];
    return *slot.forms[static_cast<std::size_t>(form_of(*slot.source, form))];
}

void TextureStore::bind(GLuint unit, const TextureUse& use, TextureForm form) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, uploaded(slots_, use, form).get());
    glBindSampler(unit, sampler_for(use));
}

int TextureStore::channels(const Slots& slots, const TextureUse& use) {
    return slots[static_cast<std::size_t>(use.texture)].source->channels;
}

float TextureStore::log2_side(const TextureUse& use) const {
    return log2_longer_side(*slots_[static_cast<std::size_t>(use.texture)].source);
}

bool same_texels(const Texture& a, const Texture& b) {
    return a.width == b.width && a.height == b.height && a.channels == b.channels &&
           a.type == b.type && a.color_space == b.color_space && a.texels == b.texels;
}

}  // namespace burnish::gpu
