// One microfacet distribution with its parameters: (e_x, e_y) for ashikhmin-shirley, (alpha_x,
// alpha_y) for the others, and the factors that turn its shape into a value.

struct Lobe {
    int mdf;
    Float p0;
    Float p1;
    Float paper_norm;      // as the papers write D: K11 Eq 1, K12 Eq 3 (peak 1), projected for the rest
    Float projected_norm;  // Int D (n.h) dw = 1, unperturbed
};

FN Lobe lobe_make(int mdf, Float p0, Float p1) {
    Lobe lobe;
    lobe.mdf = mdf;
    lobe.p0 = p0;
    lobe.p1 = p1;
    if (mdf == kMdfAshikhminShirley) {
        lobe.paper_norm = mdf_ashikhmin_shirley_solid_norm(p0, p1);
        lobe.projected_norm = mdf_ashikhmin_shirley_projected_norm(p0, p1);
    } else if (mdf == kMdfWard) {
        lobe.paper_norm = Float(1);
        lobe.projected_norm = mdf_ward_projected_norm(p0, p1);
    } else {
        lobe.paper_norm = Float(1) / (kPi * p0 * p1);
        lobe.projected_norm = lobe.paper_norm;
    }
    return lobe;
}

// e = 2/alpha^2 - 2, clamped at 0: one roughness pair drives every distribution.
FN Float exponent_from_alpha(Float alpha) {
    return max(Float(2) / (alpha * alpha) - Float(2), Float(0));
}

FN Float alpha_from_exponent(Float e) {
    return sqrt(Float(2) / (e + Float(2)));
}

FN Lobe lobe_from_alpha(int mdf, Float alpha_x, Float alpha_y) {
    if (mdf == kMdfAshikhminShirley) {
        return lobe_make(mdf, exponent_from_alpha(alpha_x), exponent_from_alpha(alpha_y));
    }
    return lobe_make(mdf, alpha_x, alpha_y);
}

// The roughness pair as Beckmann and GGX understand it.
FN Float lobe_alpha_x(Lobe lobe) {
    if (lobe.mdf == kMdfAshikhminShirley) { return alpha_from_exponent(lobe.p0); }
    return lobe.p0;
}

FN Float lobe_alpha_y(Lobe lobe) {
    if (lobe.mdf == kMdfAshikhminShirley) { return alpha_from_exponent(lobe.p1); }
    return lobe.p1;
}

// Grooves run along the axis of the larger exponent or the smaller alpha; x when they are equal.
FN Bool lobe_grooves_along_x(int mdf, Float p0, Float p1) {
    if (mdf == kMdfAshikhminShirley) { return p0 >= p1; }
    return p0 <= p1;
}

// Unnormalised value at a point of the lobe's own space, weight included.
FN Float lobe_shape(Lobe lobe, LobePoint q) {
    Float shape = Float(0);
    if (lobe.mdf == kMdfAshikhminShirley || lobe.mdf == kMdfWard) { q = lobe_point_unit(q); }
    if (lobe.mdf == kMdfAshikhminShirley) {
        shape = mdf_ashikhmin_shirley_shape(lobe.p0, lobe.p1, q);
    } else if (lobe.mdf == kMdfWard) {
        shape = mdf_ward_shape(lobe.p0, lobe.p1, q);
    } else if (lobe.mdf == kMdfBeckmann) {
        shape = mdf_beckmann_shape(lobe.p0, lobe.p1, q);
    } else {
        shape = mdf_ggx_shape(lobe.p0, lobe.p1, q);
    }
    return q.weight * shape;
}

// D as the papers normalise it.
FN Float lobe_paper_D(Lobe lobe, Perturbation p, vec3 h) {
    return lobe.paper_norm * lobe_shape(lobe, perturb_point(p, h));
}

// D with the unperturbed lobe normalised to Int D (n.h) dw = 1: what BRDFs use.
FN Float lobe_D(Lobe lobe, Perturbation p, vec3 h) {
    return lobe.projected_norm * lobe_shape(lobe, perturb_point(p, h));
}
