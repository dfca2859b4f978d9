#include "burnish/material_textures.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "burnish/f32.hpp"
#include "burnish/image_io.hpp"
#include "core/constants.hpp"
#include "export/gltf_material_text.hpp"

namespace burnish {

namespace {

constexpr float kBrightestDielectric = 0.17f;  // diamond, of refractive index 2.42

using Rgb = std::array<float, 3>;

Rgb rgb_at(const Image& image, std::size_t texel) {
    const float* p = image.pixels.data() + 3 * texel;
    return {p[0], p[1], p[2]};
}

float luminance(const Rgb& c) {
    return f32::luminance(f32::vec3(c[0], c[1], c[2]));
}

// a m^2 + (d + s - 2 a) m + a - s = 0 with a = f0, which has one root from 0 to 1 when s is above f0.
float metallic_of(float d, float s, float f0) {
    const double a = static_cast<double>(f0);
    const double b = static_cast<double>(d) + static_cast<double>(s) - 2 * a;
    const double c = a - static_cast<double>(s);
    return static_cast<float>(std::clamp((std::sqrt(b * b - 4 * a * c) - b) / (2 * a), 0.0, 1.0));
}

bool is_outside(const TabulatedMaterial& m, std::size_t texel) {
    return m.exemplar[texel] == TabulatedMaterial::kNoExemplar;
}

}  // namespace

bool is_dielectric(const Rgb& specular) {
    return luminance(specular) <= kBrightestDielectric;
}

float dielectric_f0_of(const TabulatedMaterial& m) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t t = 0; t < m.texels(); ++t) {
        if (is_outside(m, t)) continue;
        const Rgb s = rgb_at(m.specular, t);
        if (!is_dielectric(s)) continue;
        sum += static_cast<double>(luminance(s));
        ++count;
    }
    return count > 0 ? static_cast<float>(sum / static_cast<double>(count)) : kGltfF0;
}

MetallicColor metallic_color(const Rgb& diffuse, const Rgb& specular, float f0) {
    MetallicColor out;
    if (is_dielectric(specular)) {
        for (std::size_t c = 0; c < 3; ++c) out.base[c] = std::clamp(diffuse[c], 0.0f, 1.0f);
        return out;
    }
    const float m = metallic_of(luminance(diffuse), luminance(specular), f0);
    out.metallic = m;
    for (std::size_t c = 0; c < 3; ++c) {
        const float metal = specular[c] - f0 * (1.0f - m);
        const float base =
            ((1.0f - m) * diffuse[c] + m * metal) / ((1.0f - m) * (1.0f - m) + m * m);
        out.base[c] = std::clamp(base, 0.0f, 1.0f);
    }
    return out;
}

AnisotropicRoughness anisotropic_roughness(const LobeFit& lobe) {
    const double along = std::clamp(lobe.alpha_along, 0.0, 1.0);
    const double across = std::clamp(lobe.alpha_across, along, 1.0);
    AnisotropicRoughness out;
    out.roughness = static_cast<float>(std::sqrt(along));
    // At roughness 1 the lobe cannot be stretched.
    if (along < 1.0) out.strength = static_cast<float>(std::sqrt((across - along) / (1.0 - along)));
    return out;
}

double groove_at(const TabulatedMaterial& m, const std::vector<LobeFit>& lobes, std::size_t texel) {
    const double angle = lobes[m.exemplar[texel]].groove + static_cast<double>(m.angle[texel]);
    const double wrapped = angle - kPi * std::floor(angle / kPi);
    return wrapped < kPi ? wrapped : 0.0;  // rounding can give pi
}

Image base_color_texture(const TabulatedMaterial& m, bool masked) {
    Image out(m.width, m.height, masked ? 4 : 3);
    float* to = out.pixels.data();
    const float f0 = dielectric_f0_of(m);
    for (std::size_t t = 0; t < m.texels(); ++t) {
        const bool outside = is_outside(m, t);
        const MetallicColor color =
            outside ? MetallicColor{}
                    : metallic_color(rgb_at(m.diffuse, t), rgb_at(m.specular, t), f0);
        for (const float c : color.base) *to++ = srgb_from_linear(c);
        if (masked) *to++ = outside ? 0.0f : 1.0f;
    }
    return out;
}

Image metallic_roughness_texture(const TabulatedMaterial& m, const std::vector<LobeFit>& lobes) {
    Image out(m.width, m.height, 3, 1.0f);
    const float f0 = dielectric_f0_of(m);
    for (std::size_t t = 0; t < m.texels(); ++t) {
        if (is_outside(m, t)) continue;
        out.pixels[3 * t + 1] = anisotropic_roughness(lobes[m.exemplar[t]]).roughness;
        out.pixels[3 * t + 2] =
            metallic_color(rgb_at(m.diffuse, t), rgb_at(m.specular, t), f0).metallic;
    }
    return out;
}

Image normal_texture(const TabulatedMaterial& m) {
    Image out(m.width, m.height, 3);
    for (std::size_t t = 0; t < m.texels(); ++t) {
        const Rgb n = is_outside(m, t) ? Rgb{0.0f, 0.0f, 1.0f} : rgb_at(m.normal, t);
        for (std::size_t c = 0; c < 3; ++c) out.pixels[3 * t + c] = 0.5f + 0.5f * n[c];
    }
    return out;
}

Image anisotropy_texture(const TabulatedMaterial& m, const std::vector<LobeFit>& lobes) {
    Image out(m.width, m.height, 3, 0.5f);
    std::vector<glm::vec2> above(static_cast<std::size_t>(m.width), glm::vec2(1.0f, 0.0f));
    std::size_t t = 0;
    for (int row = 0; row < m.height; ++row) {
        glm::vec2 left = above.front();
        for (auto& up : above) {
            float* to = out.pixels.data() + 3 * t;
            to[2] = 0.0f;
            if (!is_outside(m, t)) {
                const double stretch = groove_at(m, lobes, t) + kPi / 2;
                glm::vec2 d(std::cos(stretch), std::sin(stretch));
                if (glm::dot(d, left + up) < 0.0f) d = -d;
                left = up = d;
                to[0] = 0.5f + 0.5f * d.x;
                to[1] = 0.5f + 0.5f * d.y;
                to[2] = anisotropic_roughness(lobes[m.exemplar[t]]).strength;
            }
            ++t;
        }
    }
    return out;
}

}  // namespace burnish
