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
// (Ashikhmin-Shirley: of the lobe itself), s^2 = 1 - n~y^2. docs/theory/papers.md, K12 Eq 11.
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

// Where the base density is read for half vector h. `round`: about n~, read by normal-map alone.
struct BasePoints {
    LobePoint at;
    LobePoint round;
};

FN BasePoints base_points(Perturbation p, vec3 h) {
    BasePoints q;
    if (p.method == kMethodNormalMap) {
        q.at = lobe_point_of(h);
        q.round = lobe_point_of(frame_to_local(frame_shortest_arc(p.n), h));
    } else if (p.method == kMethodDeformLinear || p.method == kMethodDeformSmooth) {
        q.at = perturb_point(p, h);
        q.at.weight = choose(q.at.weight > Float(0), Float(1), Float(0));  // a density, not an energy
        q.round = q.at;
    } else if (method_moves_facets(p.method)) {
        q.at = lobe_point_unit(perturb_point(p, h));
        q.at.weight = choose(q.at.weight > Float(0), Float(1), Float(0));
        q.round = q.at;
    } else {
        q.at = lobe_point_of(frame_to_local(frame_for_sampling(p), h));
        q.round = q.at;
    }
    return q;
}

// The density of half vector h per solid angle, from the base density `base` at q.at and that of the round
// part at q.round.
FN Float perturbed_density(Perturbation p, vec3 h, BasePoints q, Float base, Float round) {
    Float density = base;
    if (p.method == kMethodNormalMap) {
        density = kMixtureBase * base + kMixtureRound * round + kMixtureCosine * q.round.z / kPi;
    } else if (p.method == kMethodDeformLinear || p.method == kMethodDeformSmooth) {
        density = base * deform_jacobian(p.method, p.n, h) * h.z / max(q.at.z, Float(1e-7));
    } else if (method_moves_facets(p.method)) {
        Float inverse = perturb_point(p, h).inverse_length;
        density = base * (p.gain * inverse * inverse * inverse);
    }
    return density;
}

// The half vector made of draws `base` and `round` from the two base distributions; `select` chooses the
// part of the normal-map mixture.
FN vec3 perturbed_sample(Perturbation p, vec3 base, vec3 round, vec2 xi, Float select) {
    vec3 h = base;
    if (p.method == kMethodNormalMap) {
        vec3 about_n = choose(select < kMixtureBase + kMixtureRound, round, cosine_sample(xi));
        h = choose(select < kMixtureBase, base,
                   frame_to_outer(frame_shortest_arc(p.n), about_n));
    } else {
        h = perturb_forward(p, base);
    }
    return h;
}

// A half vector of the perturbed lobe.
FN vec3 lobe_sample(Lobe lobe, Perturbation p, vec2 xi, Float select) {
    vec3 base = lobe_base_sample(lobe_for_sampling(lobe, p), xi);
    vec3 round = base;
    if (p.method == kMethodNormalMap) { round = lobe_base_sample(lobe_rounded(lobe), xi); }
    return perturbed_sample(p, base, round, xi, select);
}

// Its density per solid angle.
FN Float lobe_pdf(Lobe lobe, Perturbation p, vec3 h) {
    BasePoints q = base_points(p, h);
    Float base = lobe_base_pdf(lobe_for_sampling(lobe, p), q.at);
    Float round = Float(0);
    if (p.method == kMethodNormalMap) { round = lobe_base_pdf(lobe_rounded(lobe), q.round); }
    return perturbed_density(p, h, q, base, round);
}

// GGX turned by a rotation or moved by a linear map is sampled by the normals that wo sees where the model masks. Scaled
// by the roughness pair they are the normals of a hemisphere, and wo reflected off these fills the sphere evenly
// (Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps", CGF 42(8), 2023). Of that sphere
// only the cap that holds all reflections above the horizon of n~ is drawn from (Eto and Tokuyoshi,
// "Bounded VNDF Sampling for Smith-GGX Reflections", SIGGRAPH Asia 2023): the weight f cos/pdf is at
// most F G2/G1(wo), which is at most 1.
FN Bool samples_visible_normals(int brdf, Lobe lobe, Perturbation p) {
    return brdf_masks(brdf) && lobe.mdf == kMdfGgx && p.method != kMethodNormalMap &&
           p.method != kMethodRotateApprox && p.method != kMethodDeformLinear &&
           p.method != kMethodDeformSmooth;
}

// The cap is z >= -k w.z, w the scaled and normalized v. `v`: wo in the lobe's own space, v.z > 0; unit of rotations.
// The bound holds for the smaller alpha up to 1; beyond, the cap is the upper hemisphere. slope-shift and stretch
// reflect about moved normals, for which it does not hold: they draw from all normals that wo sees, k = 1.
FN Float visible_cap_bound(Lobe lobe, Perturbation p, vec3 v) {
    Float bound = Float(1);
    if (!method_moves_facets(p.method)) {
        Float a = min(min(lobe.p0, lobe.p1), Float(1));
        Float a2 = a * a;
        Float s = Float(1) + sqrt(v.x * v.x + v.y * v.y);
        Float s2 = s * s;
        bound = (Float(1) - a2) * s2 / (s2 + a2 * v.z * v.z);
    }
    return bound;
}

// `cap`: visible_cap_bound.
FN vec3 visible_normal_sample(Float alpha_x, Float alpha_y, Float cap, vec3 v, vec2 xi) {
    vec3 w = normalize(vec3(alpha_x * v.x, alpha_y * v.y, v.z));
    Float bound = cap * w.z;
    Float z = (Float(1) - xi.y) * (Float(1) + bound) - bound;
    Float r = sqrt(max(Float(1) - z * z, Float(0)));
    vec3 m = w + vec3(r * cos(Float(2) * kPi * xi.x), r * sin(Float(2) * kPi * xi.x), z);
    // 1e-9: keeps the normal of w reflected to -w, which rounding makes of the cap's rim, defined.
    return normalize(vec3(alpha_x * m.x, alpha_y * m.y, max(m.z, Float(1e-9))));
}

// The density of draws per solid angle of h, for an h that visible_normal_sample can draw.
FN Float visible_normal_density(Lobe lobe, Perturbation p, vec3 wo, vec3 h) {
    vec3 v = perturb_direction(p, wo);
    Float x = lobe.p0 * v.x;
    Float y = lobe.p1 * v.y;
    Float seen = visible_cap_bound(lobe, p, v) * v.z + sqrt(x * x + y * y + v.z * v.z);
    return choose(v.z > Float(0),
                  Float(2) * max(dot(wo, h), Float(0)) * lobe_D(lobe, p, h) / max(seen, kTiny),
                  Float(0));
}

// The same for any h: 0 where the reflection lies outside the cap.
FN Float visible_normal_pdf(Lobe lobe, Perturbation p, vec3 wo, vec3 h) {
    vec3 v = perturb_direction(p, wo);
    vec3 w = normalize(vec3(lobe.p0 * v.x, lobe.p1 * v.y, v.z));
    vec3 m = frame_to_local(p.frame, h);
    vec3 n = normalize(vec3(m.x / lobe.p0, m.y / lobe.p1, m.z));
    Float z = Float(2) * dot(w, n) * n.z - w.z;
    return choose(z >= -visible_cap_bound(lobe, p, v) * w.z,
                  visible_normal_density(lobe, p, wo, h), Float(0));
}

// The half vector that a model draws, and its density per solid angle.
FN vec3 brdf_half_sample(int brdf, Lobe lobe, Perturbation p, vec3 wo, vec2 xi, Float select) {
    vec3 h = vec3(Float(0), Float(0), Float(1));
    if (samples_visible_normals(brdf, lobe, p)) {
        vec3 v = perturb_direction(p, wo);
        v.z = max(v.z, Float(1e-6));  // below the horizon the density is 0, whatever is drawn
        h = perturb_forward(p, visible_normal_sample(lobe.p0, lobe.p1, visible_cap_bound(lobe, p, v), v, xi));
    } else {
        h = lobe_sample(lobe, p, xi, select);
    }
    return h;
}

FN Float brdf_half_pdf(int brdf, Lobe lobe, Perturbation p, vec3 wo, vec3 h) {
    Float density = Float(0);
    if (samples_visible_normals(brdf, lobe, p)) {
        density = visible_normal_pdf(lobe, p, wo, h);
    } else {
        density = lobe_pdf(lobe, p, h);
    }
    return density;
}

// From the density of half vectors to that of reflected directions; wo_h = wo.h > 0.
FN Float reflected_pdf(Float density, Float wo_h) {
    return min(density / max(Float(4) * wo_h, kTiny), kMostValue);
}

// wi by reflection of wo about a sampled half vector, and its density; pdf 0: throw the sample away.
// Where the lobe itself is sampled (everything but rotated or moved GGX) the weight f cos/pdf is
// F G2 (wo.h)/((n~.wo) m.z), m the base half vector: bounded but for m.z -> 0, which the narrow lobes
// all but never draw. 99.9 % of weights are below 6 (Beckmann, Ward, Ashikhmin-Shirley) or 12 (GGX
// under rotate-approx and the deformations) over random views; normal-map: lobe_pdf.
FN vec3 brdf_sample(int brdf, Lobe lobe, Perturbation p, vec3 wo, vec2 xi, Float select,
                    OUT(Float) pdf) {
    vec3 h = brdf_half_sample(brdf, lobe, p, wo, xi, select);
    Float wo_h = dot(wo, h);
    Float density = Float(0);
    if (samples_visible_normals(brdf, lobe, p)) {
        density = visible_normal_density(lobe, p, wo, h);
    } else {
        density = lobe_pdf(lobe, p, h);
    }
    pdf = choose(wo_h > Float(0), reflected_pdf(density, wo_h), Float(0));
    return reflect_about(wo, h);
}

FN Float brdf_pdf(int brdf, Lobe lobe, Perturbation p, vec3 wi, vec3 wo) {
    vec3 h = half_vector(wi + wo, p.n);
    return reflected_pdf(brdf_half_pdf(brdf, lobe, p, wo, h), dot(wo, h));
}
