#include "rays/bounce_material.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include "burnish/draft.hpp"
#include "burnish/tabulated_material.hpp"
#include "burnish/visibility.hpp"
#include "image/texel_value.hpp"
#include "rays/vectors.hpp"
#include "scene/material/material_values.hpp"

namespace burnish {
namespace {

// 1 without a texture.
glm::vec3 mean_of(const TextureUse& use, std::span<const Texture> textures) {
    if (!use || static_cast<std::size_t>(use.texture) >= textures.size()) return glm::vec3(1.0f);
    return mean_color(textures[static_cast<std::size_t>(use.texture)]);
}

glm::vec3 mean_of(const Image& image) {
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
        const glm::vec3 texel(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]);
        if (!(texel.x >= 0.0f && texel.y >= 0.0f && texel.z >= 0.0f)) continue;
        sum += glm::dvec3(texel);
        count += 1.0;
    }
    return count > 0.0 ? glm::vec3(sum / count) : glm::vec3(0.0f);
}

glm::vec3 mean_of(const std::vector<glm::vec3>& colors, const glm::vec3& otherwise) {
    if (colors.empty()) return otherwise;
    glm::vec3 sum(0.0f);
    for (const glm::vec3& color : colors) sum += color;
    return sum / static_cast<float>(colors.size());
}

// Half of each family of yarns.
glm::vec3 cloth_color(const Cloth& cloth, const glm::vec3& otherwise) {
    const glm::vec3 warp = cloth.warp_color.value_or(mean_of(cloth.draft->warp_colors, otherwise));
    const glm::vec3 weft = cloth.weft_color.value_or(mean_of(cloth.draft->weft_colors, otherwise));
    return 0.5f * (warp + weft);
}

}  // namespace

glm::vec3 mean_color(const Texture& texture) {
    if (texture.empty()) return glm::vec3(1.0f);
    constexpr int kMost = 256;  // texels along a side
    const auto channels = static_cast<std::size_t>(texture.channels);
    const int step_x = std::max(texture.width / kMost, 1);
    const int step_y = std::max(texture.height / kMost, 1);
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (int y = 0; y < texture.height; y += step_y) {
        for (int x = 0; x < texture.width; x += step_x) {
            const std::size_t texel =
                (static_cast<std::size_t>(y) * static_cast<std::size_t>(texture.width) +
                 static_cast<std::size_t>(x)) *
                channels;
            for (int c = 0; c < 3; ++c) {
                const std::size_t channel = channels < 3 ? 0 : static_cast<std::size_t>(c);
                float value = texel_value(texture, texel + channel);
                if (texture.color_space == ColorSpace::srgb) value = f32::linear_from_srgb(value);
                sum[c] += std::isfinite(value) ? static_cast<double>(value) : 0.0;
            }
            count += 1.0;
        }
    }
    return glm::vec3(sum / count);
}

BounceMaterial bounce_material(const Material& material, std::span<const Texture> textures) {
    const auto values = material_values<f32::SurfaceMaterial>(material);
    const Cloth* cloth = cloth_of(material);
    const bool lobe_textures = cloth == nullptr && tabulated_of(material) == nullptr;
    const glm::vec3 orm =
        lobe_textures ? mean_of(material.metallic_roughness_texture, textures) : glm::vec3(1.0f);
    const glm::vec3 color = cloth != nullptr ? cloth_color(*cloth, glm::vec3(material.base_color))
                                             : to_glm(values.base_color) *
                                                   mean_of(material.base_color_texture, textures);
    const f32::SurfaceMaterial surface =
        f32::surface_colored(values.surface, {color.x, color.y, color.z}, values.metallic * orm.z);
    BounceMaterial out;
    out.diffuse = to_glm(surface.diffuse) * (surface.has_diffuse ? 1.0f : 0.0f);
    out.brdf = surface.brdf;
    out.dielectric_f0 = surface.dielectric_f0;
    out.dielectric_f90 = surface.dielectric_f90;
    out.specular = to_glm(f32::specular_fresnel(surface, 1.0f));
    if (const Tabulated* tabulated = tabulated_of(material)) {
        out.diffuse = mean_of(tabulated->material->diffuse);
        out.specular = mean_of(tabulated->material->specular);
    } else {
        const glm::vec2 alpha = alpha_of(material);
        const float rough = gltf_lobe_of(material) != nullptr ? orm.y * orm.y : 1.0f;
        out.alpha = std::clamp(std::sqrt(alpha.x * alpha.y) * rough, f32::kLowestAlpha, 1.0f);
    }
    if (has_coat(material)) {
        // What a clear coat lets through, and its own reflectance at normal incidence.
        const glm::vec3 left =
            glm::mix(glm::vec3(1.0f), 0.96f * material.coat.tint, material.coat.strength);
        out.diffuse *= left;
        out.specular = out.specular * left + 0.04f * material.coat.strength;
    }
    out.diffuse = glm::clamp(out.diffuse, 0.0f, 1.0f);
    out.specular = glm::clamp(out.specular, 0.0f, 1.0f);
    out.emitted = material.emissive * mean_of(material.emissive_texture, textures);
    return out;
}

Scene scene_for_visibility(const Scene& scene) {
    Scene out;
    out.name = scene.name;
    out.meshes = scene.meshes;
    out.materials = scene.materials;
    out.instances = scene.instances;
    for (const Texture& texture : scene.textures) {
        const glm::vec3 mean = mean_color(texture);
        Texture& one = out.textures.emplace_back();
        one.width = one.height = 1;
        one.channels = 3;
        one.type = TexelType::f32;
        one.texels.resize(3 * sizeof(float));
        for (int c = 0; c < 3; ++c) set_texel_value(one, static_cast<std::size_t>(c), mean[c]);
    }
    return out;
}

}  // namespace burnish
