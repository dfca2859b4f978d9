// BRDFs over a perturbed lobe of half vectors: specular only, per steradian, without the cosine and without Fresnel
// (which the caller multiplies, evaluated at wi.h). Directions in the unperturbed tangent space.

// `sum`: wi + wo. Where they cancel both stand at the horizon of n, opposite one another.
FN vec3 half_vector(vec3 sum, vec3 n) {
    Float l2 = dot(sum, sum);
    return choose(l2 > kTiny, sum * (Float(1) / sqrt(max(l2, kTiny))), n);
}

// What a model takes from its lobe at a point of it, in the model's own scale: D, or Ward's exponential.
FN Float brdf_lobe_factor(int brdf, Lobe lobe, LobePoint q) {
    if (brdf == kBrdfAshikhminShirley) { return lobe.paper_norm * lobe_shape(lobe, q); }
    if (brdf == kBrdfWard || brdf == kBrdfWardDuer) { return ward_factor(lobe, q); }
    return lobe.projected_norm * lobe_shape(lobe, q);
}

// The rest of the model around `factor`: masking and cosines. 0 where wi or wo is below the perturbed
// horizon.
FN Float brdf_of_factor(int brdf, Lobe lobe, Float factor, Perturbation p, vec3 wi, vec3 wo) {
    vec3 sum = wi + wo;
    Float sum_length = sqrt(max(dot(sum, sum), kTiny));
    Float cos_i = dot(p.n, wi);
    Float cos_o = dot(p.n, wo);
    Float low_i = max(cos_i, kLeastCosine);
    Float low_o = max(cos_o, kLeastCosine);
    Float wi_h = max(Float(0.5) * sum_length, kLeastCosine);  // exactly wi.h, without cancellation
    Float f = Float(0);
    if (brdf == kBrdfAshikhminShirley) {
        // Ashikhmin & Shirley 2000 Eq 4: sqrt((e_x+1)(e_y+1))/(8 pi) is K11 Eq 1's prefactor over 4.
        f = factor / (Float(4) * wi_h * max(low_i, low_o));
    } else if (brdf == kBrdfWardGmd) {
        // |i+o|^2 exp(-tan^2)/(pi ax ay (i+o)_z^4) = D_beckmann / (4 (i.h)^2).
        f = factor / (Float(4) * wi_h * wi_h);
    } else if (brdf == kBrdfWard) {
        f = factor / (Float(4) * (sqrt(low_i) * sqrt(low_o)));
    } else if (brdf == kBrdfWardDuer) {
        f = factor / (Float(4) * (low_i * low_o));
    } else if (brdf == kBrdfCookTorrance) {
        Float g = v_cavity_G(dot(p.n, half_vector(sum, p.n)), low_i, low_o, wi_h);
        f = factor * g / (Float(4) * low_i * low_o);
    } else {
        vec3 gi = perturb_direction(p, wi);
        vec3 go = perturb_direction(p, wo);
        Float g = Float(0);
        if (brdf == kBrdfMicrofacetSeparable) {
            g = smith_G1(lobe, gi) * smith_G1(lobe, go);
        } else {
            g = smith_G2(lobe, gi, go);
        }
        f = factor * g / (Float(4) * low_i * low_o);
    }
    return choose(cos_i > Float(0) && cos_o > Float(0), min(f, kMostValue), Float(0));
}

// `lobe` is of brdf_mdf. 0 where wi or wo is below the perturbed horizon.
FN Float brdf_eval(int brdf, Lobe lobe, Perturbation p, vec3 wi, vec3 wo) {
    LobePoint q = perturb_point(p, half_vector(wi + wo, p.n));
    return brdf_of_factor(brdf, lobe, brdf_lobe_factor(brdf, lobe, q), p, wi, wo);
}

// The cosine between the half vector and wi or wo: that of half the angle between them.
FN Float half_angle_cosine(vec3 wi, vec3 wo) {
    return sqrt(max(Float(0.5) + Float(0.5) * dot(wi, wo), Float(0)));
}
