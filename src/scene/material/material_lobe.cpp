#include "scene/material/material_lobe.hpp"

#include <glm/common.hpp>

namespace burnish {

f32::Lobe lobe_of(const Material& material) {
    const int mdf = f32::brdf_mdf(static_cast<int>(material.brdf), static_cast<int>(material.mdf));
    const glm::vec2 alpha = alpha_of(material);
    const f32::Lobe lobe = f32::lobe_from_alpha(mdf, alpha.x, alpha.y);
    const Cloth* cloth = cloth_of(material);
    if (!cloth) return lobe;
    const float variance = cloth->fuzz * cloth->fuzz;
    return f32::widen_lobe(lobe, variance, variance);
}

glm::vec2 alpha_of(const Material& m) {
    if (const auto alpha = stated_alpha(m)) return glm::max(*alpha, glm::vec2(f32::kLowestAlpha));
    const GltfLobe* gltf = gltf_lobe_of(m);
    const GltfLobe lobe = gltf ? *gltf : GltfLobe{};  // of a tabulated one nothing is read
    const f32::vec2 alpha = f32::alpha_of_roughness(lobe.roughness, lobe.anisotropy_strength);
    return {alpha.x, alpha.y};
}

}  // namespace burnish
