#include "scene/material/material_lobe.hpp"

#include <algorithm>
#include <glm/common.hpp>

namespace burnish {
namespace {

// shaders/lib/material.glsl says why.
constexpr float kLowestAlpha = 1e-3f;

}  // namespace

f32::Lobe lobe_of(const Material& material) {
    const int mdf = f32::brdf_mdf(static_cast<int>(material.brdf), static_cast<int>(material.mdf));
    const glm::vec2 alpha = alpha_of(material);
    const f32::Lobe lobe = f32::lobe_from_alpha(mdf, alpha.x, alpha.y);
    if (!material.cloth) return lobe;
    const float variance = material.cloth->fuzz * material.cloth->fuzz;
    return f32::widen_lobe(lobe, variance, variance);
}

glm::vec2 alpha_of(const Material& m) {
    if (m.alpha) return glm::max(*m.alpha, glm::vec2(kLowestAlpha));
    const float alpha = std::max(m.roughness * m.roughness, kLowestAlpha);
    const float strength = m.anisotropy_strength * m.anisotropy_strength;
    return {alpha + (1.0f - alpha) * strength, alpha};
}

}  // namespace burnish
