// Sheen: fibers that stand out of a surface, such as velvet (KHR_materials_sheen). The distribution and the masking are
// those of Estevez & Kulla, "Production Friendly Microfacet Sheen BRDF", 2017. docs/theory/coats.md.

// The least roughness: at 0.07 alpha is 0.005, and sin^200 still has a width of 6 degrees.
CONSTANT(kLeastSheenRoughness, 0.07)

struct SheenLayer {
    Bool present;  // false: no sheen, at no cost
    vec3 color;
    Float most;    // the largest of its channels
    Float sharpness;  // 1/alpha
    Float l_a;     // the masking of sheen_l
    Float l_b;
    Float l_c;
    Float l_d;
    Float l_e;
    Float l_half;  // sheen_l(0.5)
    Float e0;      // the fit of sheen_albedo
    Float e1;
    Float e2;
    Float e3;
    Float e4;
    Float mean_albedo;  // cosine-weighted mean of the albedo, held to 1
};

// What sheen does with light of one direction.
struct SheenSeen {
    Float cosine;
    Float lambda;
    Float albedo;  // of a white sheen
};

// ln Lambda at cosines up to 1/2: the paper's curve.
FN Float sheen_l(SheenLayer s, Float x) {
    return s.l_a / (Float(1) + s.l_b * pow(x, s.l_c)) + s.l_d * x + s.l_e;
}

FN Float sheen_polynomial(Float l, Float c0, Float c1, Float c2, Float c3, Float c4, Float c5) {
    return c0 + l * (c1 + l * (c2 + l * (c3 + l * (c4 + l * c5))));
}

// The terms of sheen_albedo for the logarithm of a roughness. Fitted to quadrature (tests/shading/layers_test.cpp):
// within 0.014, and 1 % where the albedo is above 1.
FN SheenLayer sheen_with_fit(SheenLayer s, Float l) {
    s.e0 = sheen_polynomial(l, -Float(0.6579121), Float(0.2481199), -Float(0.549534), -Float(0.9466828),
                            -Float(0.3450226), -Float(0.03883049));
    s.e1 = sheen_polynomial(l, Float(4.706565), -Float(1.810605), -Float(4.045253), -Float(5.118729),
                            -Float(2.71094), -Float(0.4829321));
    s.e2 = sheen_polynomial(l, -Float(11.40459), Float(5.703193), Float(13.65587), Float(19.21968),
                            Float(10.55122), Float(1.894811));
    s.e3 = sheen_polynomial(l, Float(9.233859), -Float(8.299199), -Float(20.62202), -Float(28.90624),
                            -Float(16.068), -Float(2.866314));
    s.e4 = sheen_polynomial(l, -Float(3.424295), Float(4.589139), Float(9.381637), Float(14.08441),
                            Float(7.862198), Float(1.391252));
    return s;
}

// `roughness`: of KHR_materials_sheen, the root of alpha.
FN SheenLayer sheen_make(vec3 color, Float roughness) {
    Float r = clamp(roughness, kLeastSheenRoughness, Float(1));
    Float alpha = r * r;
    Float smooth_part = (Float(1) - alpha) * (Float(1) - alpha);
    SheenLayer s;
    s.present = true;
    s.color = color;
    s.most = max(max(color.x, color.y), color.z);
    s.sharpness = Float(1) / alpha;
    // The paper's table 1.
    s.l_a = mix(Float(21.5473), Float(25.3245), smooth_part);
    s.l_b = mix(Float(3.82987), Float(3.32435), smooth_part);
    s.l_c = mix(Float(0.19823), Float(0.16801), smooth_part);
    s.l_d = mix(-Float(1.97760), -Float(1.27393), smooth_part);
    s.l_e = mix(-Float(4.32054), -Float(4.85967), smooth_part);
    s.l_half = sheen_l(s, Float(0.5));
    // Within 0.001.
    s.mean_albedo = -Float(0.000331636) +
                    r * (Float(0.197299) + r * (Float(0.070113) + r * (Float(0.424003) - r * Float(0.387599))));
    return sheen_with_fit(s, log(r));
}

FN SheenLayer sheen_none() {
    SheenLayer s = sheen_make(vec3(Float(0), Float(0), Float(0)), Float(1));
    s.present = false;
    return s;
}

// Masking at a cosine in [0, 1]: the curve, and its point reflection about 1/2.
FN Float sheen_lambda(SheenLayer s, Float cosine) {
    Bool low = cosine < Float(0.5);
    Float l = sheen_l(s, choose(low, cosine, Float(1) - cosine));
    return exp(choose(low, l, Float(2) * s.l_half - l));
}

// Int f cos dwi of a white sheen as the paper has it. Above 1 where a smooth sheen is seen at grazing angles.
FN Float sheen_albedo(SheenLayer s, Float cosine) {
    Float x = sqrt(sqrt(cosine));
    Float sine = sqrt(max(Float(1) - cosine * cosine, Float(0)));
    // The largest sin^2 of a half vector is (1 + sine)/2.
    Float reach = Float(0.5) * s.sharpness * log(Float(0.5) + Float(0.5) * sine);
    return exp(reach + s.e0 + x * (s.e1 + x * (s.e2 + x * (s.e3 + x * s.e4))));
}

FN SheenSeen sheen_seen(SheenLayer s, Float cosine) {
    SheenSeen seen;
    seen.cosine = clamp(cosine, Float(0), Float(1));
    seen.lambda = sheen_lambda(s, seen.cosine);
    seen.albedo = sheen_albedo(s, seen.cosine);
    return seen;
}

FN SheenSeen sheen_unseen() {
    SheenSeen seen;
    seen.cosine = Float(0);
    seen.lambda = Float(0);
    seen.albedo = Float(0);
    return seen;
}

// f times the cosine to n of a white sheen. Where the paper's value reflects more than it receives it is divided by
// that, which keeps it reciprocal.
FN Float sheen_value(SheenLayer s, SheenSeen i, SheenSeen o, Float cos_h) {
    Float sin2 = clamp(Float(1) - cos_h * cos_h, Float(0), Float(1));
    Float D = (Float(2) + s.sharpness) * pow(sin2, Float(0.5) * s.sharpness) / (Float(2) * kPi);
    Float gained = max(max(i.albedo, o.albedo), Float(1));
    // f cos = D G / (4 cos_o). 1e-4: no view is nearer to the horizon (surface_frame).
    Float f = D / ((Float(1) + i.lambda + o.lambda) * (Float(4) * max(o.cosine, Float(1e-4))) * gained);
    return choose(i.cosine > Float(0) && o.cosine > Float(0), f, Float(0));
}

FN vec3 sheen_eval(SheenLayer s, SheenSeen i, SheenSeen o, vec3 n, vec3 wi, vec3 wo) {
    return s.color * sheen_value(s, i, o, dot(n, half_vector(wi + wo, n)));
}

// What sheen leaves of light that what is below reflects (KHR_materials_sheen, "albedo-scaling").
FN Float sheen_leaves(SheenLayer s, SheenSeen seen) {
    return max(Float(1) - s.most * min(seen.albedo, Float(1)), Float(0));
}

FN Float sheen_over(SheenLayer s, SheenSeen i, SheenSeen o) {
    return min(sheen_leaves(s, i), sheen_leaves(s, o));
}

// The cosine-weighted mean of sheen_over over wi. The mean of the larger of the two albedos is a norm of the one and the
// mean of the other, that of the third power: within 0.012 up to roughness 0.8, 0.03 at 1.
FN Float sheen_over_irradiance(SheenLayer s, SheenSeen o) {
    Float one = min(o.albedo, Float(1));
    Float larger = pow(one * one * one + s.mean_albedo * s.mean_albedo * s.mean_albedo, Float(1) / Float(3));
    return max(Float(1) - s.most * larger, Float(0));
}

// Directions are drawn evenly from the hemisphere of n: f cos is bounded, but for the grazing view.
FN vec3 sheen_sample(vec3 n, vec2 xi, OUT(Float) pdf) {
    Float z = xi.x;
    Float r = sqrt(max(Float(1) - z * z, Float(0)));
    Float phi = Float(2) * kPi * xi.y;
    pdf = Float(1) / (Float(2) * kPi);
    return frame_to_outer(frame_about(n), vec3(r * cos(phi), r * sin(phi), z));
}

FN Float sheen_pdf(vec3 n, vec3 wi) {
    return choose(dot(n, wi) > Float(0), Float(1) / (Float(2) * kPi), Float(0));
}
