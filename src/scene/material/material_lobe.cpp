#include "scene/material/material_lobe.hpp"

#include <glm/common.hpp>

namespace burnish {

f32::Lobe lobe_of(const Material& material) {
    const int mdf = f32::brdf_mdf(static_cast<int>(material.brdf), static_cast<int>(material.mdf));
    const glm::vec2 alpha = alpha_of(material);
    const f32::Lobe lobe = f32::lobe_from_alpha(mdf, alpha.x, alpha.y);
    if (!material.cloth) return lobe;
    const float variance = material.cloth->fuzz * material.cloth->fuzz;
    return f32::widen_lobe(lobe, variance, variance);
}

glm::vec2 alpha_of(const Material& m) {
    if (m.alpha) return glm::max(*m.alpha, glm::vec2(f32::kLowestAlpha));
    const f32::vec2 alpha = f32::alpha_of_roughness(m.roughness, m.anisotropy_strength);
    return {alpha.x, alpha.y};
}

}  // namespace burnish
