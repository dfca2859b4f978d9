// What lies over a surface: sheen, and a coat over that. The functions return f times the cosine, each term by the
// normal of its own layer.

struct SurfaceLayers {
    CoatLayer coat;
    SheenLayer sheen;
};

// Both layers for one direction.
struct LayersSeen {
    CoatSeen coat;
    SheenSeen sheen;
};

// `n`: the normal of the surface below, by which the sheen's fibers stand.
FN LayersSeen layers_seen(SurfaceLayers l, vec3 n, vec3 w) {
    LayersSeen s;
    s.coat = coat_unseen();
    s.sheen = sheen_unseen();
    if (l.coat.present) { s.coat = coat_seen(l.coat, w); }
    if (l.sheen.present) { s.sheen = sheen_seen(l.sheen, dot(n, w)); }
    return s;
}

// What is left of the surface's own specular term, which reflects `color`, and of its diffuse term of albedo `rho`.
FN vec3 layers_over_specular(SurfaceLayers l, vec3 color, LayersSeen i, LayersSeen o) {
    vec3 left = vec3(Float(1), Float(1), Float(1));
    if (l.coat.present) { left = coat_over_specular(l.coat, color, i.coat, o.coat); }
    if (l.sheen.present) { left = left * sheen_over(l.sheen, i.sheen, o.sheen); }
    return left;
}

FN vec3 layers_over_diffuse(SurfaceLayers l, vec3 rho, LayersSeen i, LayersSeen o) {
    vec3 left = vec3(Float(1), Float(1), Float(1));
    if (l.coat.present) { left = coat_over_diffuse(l.coat, rho, i.coat, o.coat); }
    if (l.sheen.present) { left = left * sheen_over(l.sheen, i.sheen, o.sheen); }
    return left;
}

// The mean of the latter over light from everywhere.
FN vec3 layers_over_irradiance(SurfaceLayers l, vec3 rho, LayersSeen o) {
    vec3 left = vec3(Float(1), Float(1), Float(1));
    if (l.coat.present) { left = coat_over_irradiance(l.coat, rho, o.coat); }
    if (l.sheen.present) { left = left * sheen_over_irradiance(l.sheen, o.sheen); }
    return left;
}

// The light that the layers themselves reflect.
FN vec3 layers_eval(SurfaceLayers l, LayersSeen i, LayersSeen o, vec3 n, vec3 wi, vec3 wo) {
    vec3 f = vec3(Float(0), Float(0), Float(0));
    if (l.sheen.present) {
        f = sheen_eval(l.sheen, i.sheen, o.sheen, n, wi, wo);
        if (l.coat.present) { f = f * coat_over_diffuse(l.coat, l.sheen.color, i.coat, o.coat); }
    }
    if (l.coat.present) {
        Float coat = coat_eval(l.coat, wi, wo);
        f = f + vec3(coat, coat, coat);
    }
    return f;
}

// The whole: the surface's own terms under the layers, and the layers. `specular`: f cos of the specular term without
// its color; `diffuse`: f cos of the diffuse term without its albedo. `o`: layers_seen of wo.
FN vec3 layers_laid(SurfaceLayers l, LayersSeen o, vec3 n, vec3 color, Float specular, vec3 rho, Float diffuse,
                    vec3 wi, vec3 wo) {
    LayersSeen i = layers_seen(l, n, wi);
    vec3 f = layers_over_specular(l, color, i, o) * color * specular;
    f = f + layers_over_diffuse(l, rho, i, o) * rho * diffuse;
    return f + layers_eval(l, i, o, n, wi, wo);
}

// Light reflected by a surface under layers, times the cosines.
FN vec3 layered_eval(SurfaceMaterial m, SurfaceLayers l, LayersSeen o, Perturbation p, LobeValues v, vec3 wi,
                     vec3 wo) {
    Float cos_i = max(dot(p.n, wi), Float(0));
    Float cos_o = max(dot(p.n, wo), Float(0));
    Float diffuse = Float(0);
    if (m.has_diffuse) {
        diffuse = diffuse_eval(m.brdf, m.dielectric_f0, m.dielectric_f90, cos_i, cos_o) * cos_i;
        diffuse = choose(cos_i > Float(0) && cos_o > Float(0), diffuse, Float(0));
    }
    return layers_laid(l, o, p.n, specular_color(m, half_angle_cosine(wi, wo)),
                       specular_eval(m, p, v, wi, wo) * cos_i, m.diffuse, diffuse, wi, wo);
}

FN vec3 layered_eval(SurfaceMaterial m, SurfaceLayers l, Perturbation p, vec3 wi, vec3 wo) {
    return layered_eval(m, l, layers_seen(l, p.n, wo), p, no_lobe_values(), wi, wo);
}

// The probabilities with which layered_sample draws from the coat and from the sheen; the rest is the surface's. They
// are the shares of light from everywhere that each reflects, and at least 0.1 of a layer that is there.
struct LayerShares {
    Float coat;
    Float sheen;
};

FN LayerShares layer_shares(SurfaceMaterial m, SurfaceLayers l, Perturbation p, vec3 wo) {
    Float cos_o = max(dot(p.n, wo), Float(0));
    Float below = luminance(specular_color(m, cos_o));
    if (m.has_diffuse) {
        below = below + luminance(m.diffuse) * diffuse_albedo(m.brdf, m.dielectric_f0, m.dielectric_f90, cos_o);
    }
    LayersSeen o = layers_seen(l, p.n, wo);
    LayerShares s;
    s.coat = Float(0);
    s.sheen = Float(0);
    if (l.sheen.present) {
        Float left = sheen_leaves(l.sheen, o.sheen);
        Float sheen = luminance(l.sheen.color) * min(o.sheen.albedo, Float(1));
        s.sheen = clamp(sheen / max(sheen + left * below, kTiny), Float(0.1), Float(0.9));
        below = sheen + left * below;
    }
    if (l.coat.present) {
        Float coat = l.coat.cover * o.coat.albedo;
        Float under = luminance(coat_share(l.coat, o.coat.through)) * below;
        s.coat = clamp(coat / max(coat + under, kTiny), Float(0.1), Float(0.9));
        s.sheen = s.sheen * (Float(1) - s.coat);
    }
    return s;
}

// The density of layered_sample per steradian.
FN Float layered_pdf(SurfaceMaterial m, SurfaceLayers l, Perturbation p, vec3 wi, vec3 wo) {
    LayerShares s = layer_shares(m, l, p, wo);
    Float pdf = (Float(1) - s.coat - s.sheen) * surface_pdf(m, p, wi, wo);
    if (l.coat.present) { pdf = pdf + s.coat * coat_pdf(l.coat, wi, wo); }
    if (l.sheen.present) { pdf = pdf + s.sheen * sheen_pdf(p.n, wi); }
    return min(pdf, kMostValue);
}

// As surface_sample, of the surface and its layers; for models without tables.
FN vec3 layered_sample(SurfaceMaterial m, SurfaceLayers l, Perturbation p, vec3 wo, vec2 xi, Float select,
                       OUT(Float) pdf) {
    LayerShares s = layer_shares(m, l, p, wo);
    Float below = Float(1) - s.coat - s.sheen;
    vec3 wi = p.n;
    Bool drawn = true;
    Float density = Float(1);
    if (select < below) {
        wi = surface_direction(m, p, p.n, wo, xi, select / below, drawn);
    } else if (select < below + s.sheen) {
        wi = sheen_sample(p.n, xi, density);
    } else {
        wi = coat_sample(l.coat, wo, xi, density);
    }
    drawn = drawn && density > Float(0);
    pdf = choose(drawn, layered_pdf(m, l, p, wi, wo), Float(0));
    return wi;
}
