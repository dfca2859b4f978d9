// A clear coat: a layer of lacquer or oxide, whose face is a round GGX lobe of refractive index 1.5, over whatever
// lies below (docs/theory/coats.md). Directions unit, in the axes of the surface below it; its normal is its own.
// Its roughness does not blur what is seen through it.

// Schlick's reflectance at normal incidence and the square of the refractive index, 1.5: those of
// KHR_materials_clearcoat.
CONSTANT(kCoatF0, 0.04)
CONSTANT(kCoatIor2, 2.25)

// Mean length of the way through the coat, relative to its thickness, of light that Lambert's law scatters outside:
// Int 2 c dc / sqrt(1 - (1 - c^2)/ior^2) over [0, 1] = 2 ior^2 (1 - sqrt(1 - 1/ior^2)).
CONSTANT(kCoatMeanWay, 1.1459)

// The least transmittance of a tint: nothing is seen through a coat of less.
CONSTANT(kLeastTint, 1e-4)

struct CoatLayer {
    Bool present;      // false: no coat, at no cost
    Bool tinted;       // false: depth is 0
    Float cover;       // share of the surface that is coated, 0 to 1
    Lobe lobe;         // GGX, round
    Perturbation at;   // its normal
    vec3 depth;        // optical depth along its normal
    Float roughness2;  // of the fit of its albedo
    Float e0;
    Float e1;
    Float e2;
    Float e3;
    Float e4;
    Float mean_albedo;  // cosine-weighted mean of its albedo
    vec3 mean_through;  // transmittance along kCoatMeanWay
};

// What a coat does to light of one direction.
struct CoatSeen {
    Float albedo;  // the share that its face reflects
    vec3 through;  // the share that passes: 1 - albedo, less what is absorbed on the way
    vec3 tint;     // the latter alone
};

// The optical depth along the normal of a coat whose `tint` is what it lets through along its normal and back.
FN vec3 coat_depth(vec3 tint) {
    return vec3(-Float(0.5) * log(clamp(tint.x, kLeastTint, Float(1))),
                -Float(0.5) * log(clamp(tint.y, kLeastTint, Float(1))),
                -Float(0.5) * log(clamp(tint.z, kLeastTint, Float(1))));
}

// exp of the negated depth along a way `way` times as long as the thickness.
FN vec3 coat_transmittance(vec3 depth, Float way) {
    return vec3(exp(-depth.x * way), exp(-depth.y * way), exp(-depth.z * way));
}

FN Float coat_polynomial(Float r, Float c0, Float c1, Float c2, Float c3, Float c4) {
    return c0 + r * (c1 + r * (c2 + r * (c3 + r * c4)));
}

// The terms of coat_albedo for a roughness, the root of alpha. Fitted to quadrature of the lobe with its Fresnel
// factor (tests/shading/layers_test.cpp): within 0.007 for cosines from 0.1, 0.03 below.
FN CoatLayer coat_with_fit(CoatLayer c, Float roughness) {
    Float r = min(roughness, Float(1));
    c.roughness2 = r * r;
    c.e0 = coat_polynomial(r, -Float(0.0802346), -Float(0.5319167), -Float(9.953993), Float(13.19102),
                           -Float(5.102216));
    c.e1 = coat_polynomial(r, Float(1.045232), -Float(18.30805), Float(90.20772), -Float(132.0184),
                           Float(57.94876));
    c.e2 = coat_polynomial(r, -Float(3.577874), Float(97.72651), -Float(495.9711), Float(704.1214),
                           -Float(284.0535));
    c.e3 = coat_polynomial(r, Float(4.485369), -Float(140.4509), Float(731.9454), -Float(852.0415),
                           Float(269.8238));
    c.e4 = coat_polynomial(r, -Float(1.873737), Float(61.23273), -Float(312.3604), Float(274.1278),
                           -Float(93.34534));
    c.mean_albedo = coat_polynomial(r, Float(0.08497279), Float(0.04164611), -Float(0.3939938),
                                    Float(0.4525919), -Float(0.1664267));
    return c;
}

// `lobe`: GGX of two equal alphas. `n`: the coat's normal. `depth`: of coat_depth.
FN CoatLayer coat_make(Float cover, Lobe lobe, vec3 n, Bool tinted, vec3 depth) {
    CoatLayer c;
    c.present = true;
    c.tinted = tinted;
    c.cover = cover;
    c.lobe = lobe;
    c.at = perturb_make(kMethodRotateArc, n, true, false);
    c.depth = depth;
    c = coat_with_fit(c, sqrt(lobe.p0));
    c.mean_through = vec3(Float(1), Float(1), Float(1));
    if (tinted) { c.mean_through = coat_transmittance(depth, kCoatMeanWay); }
    return c;
}

FN CoatLayer coat_none() {
    CoatLayer c = coat_make(Float(0), lobe_make(kMdfGgx, Float(1), Float(1)),
                            vec3(Float(0), Float(0), Float(1)), false, vec3(Float(0), Float(0), Float(0)));
    c.present = false;
    return c;
}

// The coat with its normal turned to `n`.
FN CoatLayer coat_turned(CoatLayer c, vec3 n) {
    c.at = perturb_make(kMethodRotateArc, n, true, false);
    return c;
}

// Int f cos dwi of the coat's lobe where it covers the surface: the share that its face reflects of light from there.
FN Float coat_albedo(CoatLayer c, Float cosine) {
    Float cos_w = clamp(cosine, Float(0), Float(1));
    Float x = cos_w / (cos_w + Float(0.05) + c.roughness2);
    Float rough = exp(coat_polynomial(x, c.e0, c.e1, c.e2, c.e3, c.e4));
    // 0.99: keeps what passes above 0, which is divided by.
    return min(rough * fresnel_schlick(kCoatF0, cos_w), Float(0.99));
}

// Below the coat's horizon: as at the horizon. Only the horizon of n~ counts for what lies below, and a cut here would
// be seen as a dark rim of bumps.
FN CoatSeen coat_seen(CoatLayer c, vec3 w) {
    Float cosine = dot(c.at.n, w);
    CoatSeen s;
    s.albedo = coat_albedo(c, cosine);
    s.tint = vec3(Float(1), Float(1), Float(1));
    if (c.tinted) {
        Float cos_w = clamp(cosine, Float(0), Float(1));
        // The cosine of the refracted way.
        Float cos_t = sqrt(Float(1) - (Float(1) - cos_w * cos_w) / kCoatIor2);
        s.tint = coat_transmittance(c.depth, Float(1) / cos_t);
    }
    s.through = s.tint * (Float(1) - s.albedo);
    return s;
}

FN CoatSeen coat_unseen() {
    CoatSeen s;
    s.albedo = Float(0);
    s.through = vec3(Float(1), Float(1), Float(1));
    s.tint = s.through;
    return s;
}

FN vec3 divided(vec3 a, vec3 b) {
    return vec3(a.x / b.x, a.y / b.y, a.z / b.z);
}

// What becomes of 1 under the coat, of which `covered` arrives under the part that is there.
FN vec3 coat_share(CoatLayer c, vec3 covered) {
    Float bare = Float(1) - c.cover;
    return vec3(bare, bare, bare) + covered * c.cover;
}

// The factor of a base that reflects in the manner of a mirror, `color` each time. Light goes through the coat twice.
// What the coat sends back is reflected again: the sum over all times is that of a pile of plates (Stokes 1862).
// With the smaller of the two albedos the sum is reciprocal and, for color 1, the smaller of what the two directions
// let through, so that no energy is gained.
FN vec3 coat_over_specular(CoatLayer c, vec3 color, CoatSeen i, CoatSeen o) {
    Float back = min(i.albedo, o.albedo);
    vec3 again = vec3(min(color.x, Float(1)), min(color.y, Float(1)), min(color.z, Float(1))) * i.tint *
                 o.tint * back;
    return coat_share(c, divided(i.through * o.through, vec3(Float(1), Float(1), Float(1)) - again));
}

// What a diffuse base of albedo `rho` gains by the light that the coat sends back to it.
FN vec3 coat_diffuse_gain(CoatLayer c, vec3 rho) {
    vec3 again = rho * c.mean_through * c.mean_through * c.mean_albedo;
    return divided(vec3(Float(1), Float(1), Float(1)), vec3(Float(1), Float(1), Float(1)) - again);
}

// The factor of a diffuse base of albedo `rho`: with rho 1 and no tint all light returns.
FN vec3 coat_over_diffuse(CoatLayer c, vec3 rho, CoatSeen i, CoatSeen o) {
    return coat_share(c, i.through * o.through * coat_diffuse_gain(c, rho));
}

// The mean of that over light from everywhere.
FN vec3 coat_over_irradiance(CoatLayer c, vec3 rho, CoatSeen o) {
    return coat_share(c, o.through * c.mean_through * coat_diffuse_gain(c, rho) *
                             (Float(1) - c.mean_albedo));
}

// The light that the coat's face reflects: f times the cosine to the coat's normal.
FN Float coat_eval(CoatLayer c, vec3 wi, vec3 wo) {
    Float fresnel = fresnel_schlick(kCoatF0, half_angle_cosine(wi, wo));
    Float f = brdf_eval(kBrdfMicrofacet, c.lobe, c.at, wi, wo);
    return c.cover * fresnel * f * max(dot(c.at.n, wi), Float(0));
}

FN vec3 coat_sample(CoatLayer c, vec3 wo, vec2 xi, OUT(Float) pdf) {
    return brdf_sample(kBrdfMicrofacet, c.lobe, c.at, wo, xi, Float(0), pdf);
}

FN Float coat_pdf(CoatLayer c, vec3 wi, vec3 wo) {
    return brdf_pdf(kBrdfMicrofacet, c.lobe, c.at, wi, wo);
}
