// The roughness pair of glTF: perceptual roughness and the strength of KHR_materials_anisotropy.

// KHR_materials_anisotropy squares roughness. Below 1e-3 a lobe is a hundred times narrower than the sun
// is wide, and 1/alpha^4 of GGX's tail still fits single precision.
CONSTANT(kLowestAlpha, 1e-3)

// (alpha along the stretch, alpha across it); roughness and anisotropy in [0, 1].
FN vec2 alpha_of_roughness(Float roughness, Float anisotropy) {
    Float alpha = max(roughness * roughness, kLowestAlpha);
    return vec2(max(mix(alpha, Float(1), anisotropy * anisotropy), kLowestAlpha), alpha);
}

FN Lobe lobe_of_roughness(int mdf, Float roughness, Float anisotropy) {
    vec2 alpha = alpha_of_roughness(roughness, anisotropy);
    return lobe_from_alpha(mdf, alpha.x, alpha.y);
}
