// Sampling half vectors of a perturbed lobe, with the exact density per solid angle, and directions
// of a BRDF by reflection. Uniform numbers in [0, 1).
//
// Every method but normal-map is a map of the base half vector m: the sample is its image and the
// density the base density times dw_m/dw_h. normal-map is no such map (D reads azimuth about n and
// elevation about n~), so it is covered by a mixture whose density is exact all the same.

// Density of lobe_base_sample per solid angle.
FN Float lobe_base_pdf(Lobe lobe, LobePoint q) {
    if (lobe.mdf == kMdfWard) { return q.weight * mdf_ward_pdf(lobe.p0, lobe.p1, q); }
    return lobe.projected_norm * lobe_shape(lobe, q) * q.z;
}

FN vec3 lobe_base_sample(Lobe lobe, vec2 xi) {
    vec3 m = vec3(Float(0), Float(0), Float(1));
    if (lobe.mdf == kMdfAshikhminShirley) {
        m = mdf_ashikhmin_shirley_sample(lobe.p0, lobe.p1, xi);
    } else if (lobe.mdf == kMdfWard) {
        m = mdf_ward_sample(lobe.p0, lobe.p1, xi);
    } else if (lobe.mdf == kMdfBeckmann) {
        m = mdf_beckmann_sample(lobe.p0, lobe.p1, xi);
    } else {
        m = mdf_ggx_sample(lobe.p0, lobe.p1, xi);
    }
    return m;
}

// What rotate-approx really draws: the exact rotation of a lobe whose alphas are 1/s as large
// (Ashikhmin-Shirley: of the lobe itself), s^2 = 1 - n~y^2. docs/papers.md, K12 Eq 11.
FN Lobe lobe_for_sampling(Lobe lobe, Perturbation p) {
    if (p.method == kMethodRotateApprox && lobe.mdf != kMdfAshikhminShirley) {
        Float widen = sqrt(p.stretch);
        // 1e3: a lobe that wide is flat; reached only within 0.001 rad of n~ = +-e_y.
        return lobe_make(lobe.mdf, min(lobe.p0 * widen, Float(1e3)),
                         min(lobe.p1 * widen, Float(1e3)));
    }
    return lobe;
}

// Shares of the normal-map mixture: the lobe where it was, a round lobe about n~ as wide as the
// wider axis, and the cosine hemisphere about n~, which bounds the weight D cos/pdf by 10 pi max D.
CONSTANT(kMixtureBase, 0.5)
CONSTANT(kMixtureRound, 0.4)
CONSTANT(kMixtureCosine, 0.1)

FN Lobe lobe_rounded(Lobe lobe) {
    Float wide = max(lobe.p0, lobe.p1);
    if (lobe.mdf == kMdfAshikhminShirley) { wide = min(lobe.p0, lobe.p1); }
    return lobe_make(lobe.mdf, wide, wide);
}

FN Float normal_map_mixture_pdf(Lobe lobe, vec3 n, vec3 h) {
    Frame f = frame_shortest_arc(n);
    LobePoint about_n = lobe_point_of(frame_to_local(f, h));
    return kMixtureBase * lobe_base_pdf(lobe, lobe_point_of(h)) +
           kMixtureRound * lobe_base_pdf(lobe_rounded(lobe), about_n) +
           kMixtureCosine * about_n.z / kPi;
}

FN vec3 normal_map_mixture_sample(Lobe lobe, vec3 n, vec2 xi, Float select) {
    Frame f = frame_shortest_arc(n);
    if (select < kMixtureBase) { return lobe_base_sample(lobe, xi); }
    if (select < kMixtureBase + kMixtureRound) {
        return frame_to_outer(f, lobe_base_sample(lobe_rounded(lobe), xi));
    }
    return frame_to_outer(f, cosine_sample(xi));
}

// A half vector; `select` chooses the part of the normal-map mixture.
FN vec3 lobe_sample(Lobe lobe, Perturbation p, vec2 xi, Float select) {
    if (p.method == kMethodNormalMap) {
        return normal_map_mixture_sample(lobe, p.n, xi, select);
    }
    return perturb_forward(p, lobe_base_sample(lobe_for_sampling(lobe, p), xi));
}

// Its density per solid angle.
FN Float lobe_pdf(Lobe lobe, Perturbation p, vec3 h) {
    Float pdf = Float(0);
    if (p.method == kMethodNormalMap) {
        pdf = normal_map_mixture_pdf(lobe, p.n, h);
    } else if (p.method == kMethodDeformLinear || p.method == kMethodDeformSmooth) {
        LobePoint q = perturb_point(p, h);
        q.weight = choose(q.weight > Float(0), Float(1), Float(0));  // a density, not an energy
        pdf = lobe_base_pdf(lobe, q) * deform_jacobian(p.method, p.n, h) * h.z /
              max(q.z, Float(1e-7));
    } else {
        vec3 m = frame_to_local(frame_for_sampling(p), h);
        pdf = lobe_base_pdf(lobe_for_sampling(lobe, p), lobe_point_of(m));
    }
    return pdf;
}

// The models with a Smith term.
FN Bool brdf_masks(int brdf) {
    return brdf == kBrdfMicrofacet || brdf == kBrdfMicrofacetSeparable;
}

// GGX turned by a rotation is sampled by the normals that wo sees (Heitz, "Sampling the GGX
// Distribution of Visible Normals", JCGT 7(4), 2018) where the model masks: the weight f cos/pdf is
// F G2/G1(wo), at most 1.
FN Bool samples_visible_normals(int brdf, Lobe lobe, Perturbation p) {
    return brdf_masks(brdf) && lobe.mdf == kMdfGgx && p.method != kMethodNormalMap &&
           p.method != kMethodRotateApprox && p.method != kMethodDeformLinear && p.method != kMethodDeformSmooth;
}

// `v`: wo in the lobe's own space, unit, v.z > 0.
FN vec3 visible_normal_sample(Float alpha_x, Float alpha_y, vec3 v, vec2 xi) {
    vec3 w = normalize(vec3(alpha_x * v.x, alpha_y * v.y, v.z));
    Float across = w.x * w.x + w.y * w.y;
    // 1e-12: along the normal any tangent does.
    Float scale = Float(1) / sqrt(max(across, Float(1e-12)));
    vec3 t1 = choose(across > Float(1e-12), vec3(-w.y * scale, w.x * scale, Float(0)),
                     vec3(Float(1), Float(0), Float(0)));
    vec3 t2 = cross(w, t1);
    Float r = sqrt(xi.y);
    Float a = r * cos(Float(2) * kPi * xi.x);
    Float b = r * sin(Float(2) * kPi * xi.x);
    Float s = Float(0.5) * (Float(1) + w.z);
    b = (Float(1) - s) * sqrt(max(Float(1) - a * a, Float(0))) + s * b;
    Float c = sqrt(max(Float(1) - a * a - b * b, Float(0)));
    vec3 m = t1 * a + t2 * b + w * c;
    return normalize(vec3(alpha_x * m.x, alpha_y * m.y, max(m.z, Float(1e-9))));
}

FN Float visible_normal_pdf(Lobe lobe, Perturbation p, vec3 wo, vec3 h) {
    vec3 v = perturb_direction(p, wo);
    return choose(v.z > Float(0),
                  smith_G1(lobe, v) * max(dot(wo, h), Float(0)) * lobe_D(lobe, p, h) /
                      max(v.z, Float(1e-12)),
                  Float(0));
}

// wi by reflection of wo about a sampled half vector, and its density; pdf 0: throw the sample away.
// Where the lobe itself is sampled (everything but rotated GGX) the weight f cos/pdf is
// F G2 (wo.h)/((n~.wo) m.z), m the base half vector: bounded but for m.z -> 0, which the narrow lobes
// all but never draw. 99.9 % of weights are below 6 (Beckmann, Ward, Ashikhmin-Shirley) or 12 (GGX
// under rotate-approx and the deformations) over random views; normal-map: lobe_pdf.
FN vec3 brdf_sample(int brdf, Lobe lobe, Perturbation p, vec3 wo, vec2 xi, Float select, OUT(Float) pdf) {
    vec3 h = vec3(Float(0), Float(0), Float(1));
    Float density = Float(0);
    if (samples_visible_normals(brdf, lobe, p)) {
        vec3 v = perturb_direction(p, wo);
        v.z = max(v.z, Float(1e-6));  // below the horizon the density is 0, whatever is drawn
        h = frame_to_outer(p.frame, visible_normal_sample(lobe.p0, lobe.p1, v, xi));
        density = visible_normal_pdf(lobe, p, wo, h);
    } else {
        h = lobe_sample(lobe, p, xi, select);
        density = lobe_pdf(lobe, p, h);
    }
    Float wo_h = dot(wo, h);
    pdf = choose(wo_h > Float(0), min(density / max(Float(4) * wo_h, kTiny), kMostValue), Float(0));
    return reflect_about(wo, h);
}

FN Float brdf_pdf(int brdf, Lobe lobe, Perturbation p, vec3 wi, vec3 wo) {
    vec3 h = half_vector(wi + wo, p.n);
    Float density = Float(0);
    if (samples_visible_normals(brdf, lobe, p)) {
        density = visible_normal_pdf(lobe, p, wo, h);
    } else {
        density = lobe_pdf(lobe, p, h);
    }
    return min(density / max(Float(4) * dot(wo, h), kTiny), kMostValue);
}
