// Functions on materials and scenes of every kind of model.
#include "burnish/scene.hpp"

#include <array>
#include <glm/common.hpp>
#include <utility>

namespace burnish {
namespace {

// Extends `bounds` by the box's eight transformed corners: a bound, not the tightest.
void include_box(const Bounds& box, const glm::mat4& transform, Bounds& bounds, bool& empty) {
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 local((corner & 1) ? box.high.x : box.low.x,
                              (corner & 2) ? box.high.y : box.low.y,
                              (corner & 4) ? box.high.z : box.low.z);
        const glm::vec3 world(transform * glm::vec4(local, 1.0f));
        bounds.low = empty ? world : glm::min(bounds.low, world);
        bounds.high = empty ? world : glm::max(bounds.high, world);
        empty = false;
    }
}

}  // namespace

std::span<const std::string_view> normal_filter_names() {
    static constexpr std::array<std::string_view, 2> kNames = {"mips", "moments"};
    return kNames;
}

std::optional<glm::vec2> stated_alpha(const Material& m) {
    if (const auto* lobe = std::get_if<AlphaLobe>(&m.lobe)) return lobe->alpha;
    if (const Cloth* cloth = cloth_of(m)) return cloth->alpha;
    return std::nullopt;
}

Material drawn_material(Material m) {
    const bool cloth = cloth_of(m) != nullptr, tabulated = tabulated_of(m) != nullptr;
    if (cloth) m.normal_texture = {};
    if (cloth || tabulated) m.anisotropy_texture = m.metallic_roughness_texture = {};
    if (!m.anisotropy_texture) m.anisotropy_texture_turn = 0.0f;
    if (!has_coat(m)) m.coat = {};
    if (!has_sheen(m)) m.sheen = {};
    if (tabulated) {
        m.base_color_texture = {};
        m.base_color = glm::vec4(1.0f, 1.0f, 1.0f, m.base_color.a);
        m.metallic = 0.0f;
        m.conductor.reset();
        m.specular = 1.0f;
        m.specular_color = glm::vec3(1.0f);
        m.specular_texture = m.specular_color_texture = {};
        m.mdf = Mdf::ggx;
        m.brdf = Brdf::microfacet_separable;
    }
    return m;
}

std::vector<Material> drawn_materials(std::vector<Material> materials) {
    for (Material& material : materials) material = drawn_material(std::move(material));
    return materials;
}

Method untextured_method(const Material& m) {
    const GltfLobe* lobe = gltf_lobe_of(m);
    const glm::vec2 alpha = stated_alpha(m).value_or(glm::vec2(0.0f));
    const bool isotropic = tabulated_of(m) == nullptr &&
                           (lobe ? lobe->anisotropy_strength == 0.0f : alpha.x == alpha.y);
    return m.method == Method::normal_map && isotropic ? Method::gram_schmidt : m.method;
}

Method drawn_method(const Material& m) {
    const bool textured = m.anisotropy_texture && cloth_of(m) == nullptr;
    return textured ? m.method : untextured_method(m);
}

Bounds bounds_of(const Scene& scene) {
    std::vector<Bounds> boxes;
    boxes.reserve(scene.meshes.size());
    for (const Mesh& mesh : scene.meshes) boxes.push_back(bounds_of(mesh));
    Bounds bounds;
    bool empty = true;
    for (const Instance& instance : scene.instances) {
        if (instance.mesh < 0) continue;
        const auto mesh = static_cast<std::size_t>(instance.mesh);
        if (!scene.meshes[mesh].positions.empty())
            include_box(boxes[mesh], instance.transform, bounds, empty);
    }
    return bounds;
}

}  // namespace burnish
