#include "reference/scene_print.hpp"

#include <cstring>
#include <span>
#include <string>
#include <type_traits>

#include "burnish/draft.hpp"
#include "burnish/tabulated_material.hpp"
#include "scene/material/texture_uses.hpp"

namespace burnish {
namespace {

// FNV-1a over words of 64 bits.
class Print {
  public:
    std::uint64_t value() const { return value_; }

    void bytes(const void* data, std::size_t size) {
        const auto* at = static_cast<const unsigned char*>(data);
        for (std::size_t i = 0; i < size; i += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, at + i, std::min<std::size_t>(8, size - i));
            value_ = (value_ ^ word) * 0x100000001b3ULL;
            value_ ^= value_ >> 29;
        }
    }
    // Numbers, enumerations and vectors of floats, which have no padding.
    template <typename... Values>
    void add(const Values&... values) {
        (one(values), ...);
    }
    template <typename T>
    void list(const std::vector<T>& values) {
        add(values.size());
        bytes(values.data(), values.size() * sizeof(T));
    }

  private:
    template <typename T>
    void one(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes(&value, sizeof value);
    }
    std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

void add_use(Print& p, const TextureUse& use) {
    p.add(use.texture, use.texcoord, use.transform, use.wrap_s, use.wrap_t, use.nearest);
}

void add_tabulated(Print& p, const TabulatedMaterial& t) {
    p.list(t.D);
    p.list(t.groove);
    p.list(t.exemplar);
    p.list(t.angle);
    p.list(t.diffuse.pixels);
    p.list(t.specular.pixels);
    p.list(t.normal.pixels);
    p.add(t.eta, t.width, t.height, t.grid.rings, t.grid.azimuths);
}

void add_cloth(Print& p, const Cloth& c) {
    p.add(c.yarns, c.crimp, c.bulge, c.gap, c.twist, c.fuzz, c.alpha);
    p.add(c.warp_color.value_or(glm::vec3(-1.0f)), c.weft_color.value_or(glm::vec3(-1.0f)));
    if (!c.draft) return;
    p.add(c.draft->ends, c.draft->picks);
    p.list(c.draft->warp_up);
    p.list(c.draft->warp_colors);
    p.list(c.draft->weft_colors);
}

void add_lobe(Print& p, const Material& m) {
    p.add(m.lobe.index());
    if (const GltfLobe* gltf = gltf_lobe_of(m)) p.add(gltf->roughness, gltf->anisotropy_strength);
    if (const auto alpha = stated_alpha(m)) p.add(*alpha);
    if (const Cloth* cloth = cloth_of(m)) add_cloth(p, *cloth);
    if (const Tabulated* tabulated = tabulated_of(m)) add_tabulated(p, *tabulated->material);
}

void add_material(Print& p, const Material& m) {
    for (const TextureUse* use : texture_uses(m)) add_use(p, *use);
    p.add(m.base_color, m.metallic, m.normal_scale, m.flip_green, m.normal_filter,
          m.occlusion_strength, m.emissive, m.alpha_mode, m.alpha_cutoff, m.double_sided);
    add_lobe(p, m);
    p.add(m.anisotropy_rotation, m.anisotropy_texture_turn, m.dielectric_f0, m.specular,
          m.specular_color, m.mdf, m.brdf, m.ks.value_or(-1.0f), m.lafortune_c, m.method,
          m.conserve, m.single_scattering);
    p.add(m.coat.strength, m.coat.roughness, m.coat.tint, m.coat.normal_scale, m.coat.flip_green,
          m.sheen.color, m.sheen.roughness);
    if (!m.conductor) return;
    p.add(m.conductor->eta, m.conductor->k);
    if (m.conductor->oxide) p.add(m.conductor->oxide->curve);
}

void add_mesh(Print& p, const Mesh& mesh) {
    p.list(mesh.positions);
    p.list(mesh.normals);
    p.list(mesh.tangents);
    p.list(mesh.texcoord0);
    p.list(mesh.texcoord1);
    p.list(mesh.colors);
    p.list(mesh.indices);
}

void add_light(Print& p, const Light& light) {
    p.add(light.type, light.color, light.intensity, light.position, light.direction, light.range,
          light.inner_cone, light.outer_cone, light.size, light.up, light.two_sided, light.visible);
    if (light.texture.image) p.list(light.texture.image->pixels);
}

}  // namespace

std::uint64_t scene_print(const Scene& scene, const Environment& environment, const Camera& camera,
                          const RenderSettings& s, int reflections) {
    Print p;
    for (const Mesh& mesh : scene.meshes) add_mesh(p, mesh);
    for (const Material& material : scene.materials) add_material(p, material);
    for (const Texture& t : scene.textures) {
        p.add(t.width, t.height, t.channels, t.type, t.color_space);
        p.list(t.texels);
    }
    for (const Instance& i : scene.instances) p.add(i.mesh, i.material, i.transform);
    for (const Light& light : scene.lights) add_light(p, light);
    p.add(environment.radiance.width);
    p.list(environment.radiance.pixels);
    p.list(environment.backdrop.pixels);
    p.add(camera.position, camera.target, camera.up, camera.orthographic, camera.yfov, camera.ymag);
    p.add(s.width, s.height, s.image_light == ImageLight::off, s.environment_intensity,
          s.environment_rotation, s.background, s.background_color, s.background_blur, s.shadows,
          s.ground, s.visibility, s.seed, reflections);
    return p.value();
}

}  // namespace burnish
