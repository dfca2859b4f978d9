// What kind of lobe each reflection model has, and what it can do. `brdf`: kBrdf... of names.glsl.

// Phong and lafortune: a power of the cosine about a direction; there are no half vectors.
FN Bool brdf_is_cosine_lobe(int brdf) {
    return brdf == kBrdfPhong || brdf == kBrdfLafortune;
}

// The models whose areas g(w) of facets that w sees come from a table.
FN Bool brdf_takes_areas(int brdf) {
    return brdf == kBrdfTabulated || brdf == kBrdfAshikhminPremozeShirley;
}

// The models with a Smith term.
FN Bool brdf_masks(int brdf) {
    return brdf == kBrdfMicrofacet || brdf == kBrdfMicrofacetSeparable;
}

// The one rule of which model has a meaning under which method. A deformation acts on half vectors, and slope-shift and
// stretch on facets; phong and lafortune have neither. He's model is a closed theory of a rough surface about its own
// normal: it is for the unperturbed one.
FN Bool brdf_takes_method(int brdf, int method) {
    Bool takes = true;
    if (brdf_is_cosine_lobe(brdf)) {
        takes = method != kMethodDeformLinear && method != kMethodDeformSmooth && !method_moves_facets(method);
    } else if (brdf == kBrdfHe) {
        takes = method == kMethodNone;
    }
    return takes;
}

// The distribution a model is built on: its own, or `mdf` for the microfacet models. Phong and lafortune
// have none; GGX stands for it, whose parameters are the roughness pair as it is.
FN int brdf_mdf(int brdf, int mdf) {
    int own = mdf;
    if (brdf == kBrdfAshikhminShirley || brdf == kBrdfAshikhminPremozeShirley) {
        own = kMdfAshikhminShirley;
    } else if (brdf == kBrdfWardGmd || brdf == kBrdfWard || brdf == kBrdfWardDuer ||
               brdf == kBrdfCookTorrance || brdf == kBrdfHe) {
        own = kMdfBeckmann;
    } else if (brdf_is_cosine_lobe(brdf)) {
        own = kMdfGgx;
    }
    return own;
}
