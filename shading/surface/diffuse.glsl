// The diffuse term of a white base under a dielectric interface, per steradian without the cosine, and
// what occlusion leaves of light. Cosines are those of n~; no frame enters.

// What the interface lets through to the base, as Schlick has it.
FN Float diffuse_through(Float f0, Float f90, Float cosine) {
    return Float(1) - fresnel_schlick(f0, f90, cosine);
}

// (1 - F(n~.wi)) (1 - F(n~.wo)) / pi: each factor is at most 1 - F, so that together with the specular
// term no energy is gained. The 2000 model of Ashikhmin and Shirley has a term of its own, coupled to
// the specular one by its reflectance; tables were fitted beside Lambert's law.
FN Float diffuse_eval(int brdf, Float f0, Float f90, Float cos_i, Float cos_o) {
    Float f = Float(0);
    if (brdf == kBrdfTabulated) {
        f = Float(1) / kPi;
    } else if (brdf == kBrdfAshikhminShirley) {
        f = ashikhmin_shirley_diffuse(Float(1), f0, cos_i, cos_o);
    } else {
        f = diffuse_through(f0, f90, cos_o) * diffuse_through(f0, f90, cos_i) / kPi;
    }
    return f;
}

FN Float diffuse_eval(int brdf, Float f0, Float cos_i, Float cos_o) {
    return diffuse_eval(brdf, f0, Float(1), cos_i, cos_o);
}

// Int diffuse_eval cos dwi over the hemisphere of n~, exactly. The cosine-weighted mean of Schlick's term
// is f0 + (f90 - f0)/21.
FN Float diffuse_albedo(int brdf, Float f0, Float f90, Float cos_o) {
    Float albedo = Float(1);
    if (brdf == kBrdfTabulated) {
        albedo = Float(1);
    } else if (brdf == kBrdfAshikhminShirley) {
        albedo = (Float(1) - f0) * ashikhmin_shirley_through(cos_o);
    } else {
        albedo = (Float(21) - Float(20) * f0 - f90) / Float(21) * diffuse_through(f0, f90, cos_o);
    }
    return albedo;
}

FN Float diffuse_albedo(int brdf, Float f0, Float cos_o) {
    return diffuse_albedo(brdf, f0, Float(1), cos_o);
}

// The share of the reflected environment that an occlusion in [0, 1] leaves (Lagarde & de Rousiers,
// "Moving Frostbite to PBR", 2014): a smooth surface loses less than a rough one, most where it is seen
// head-on in a deep place.
FN Float specular_occlusion(Float occlusion, Float cos_o, Lobe lobe) {
    Float alpha = sqrt(lobe_alpha_x(lobe) * lobe_alpha_y(lobe));
    Float exponent = pow(Float(2), -Float(16) * min(alpha, Float(1)) - Float(1));
    Float open = pow(max(cos_o + occlusion, Float(0)), exponent);
    return clamp(open - Float(1) + occlusion, Float(0), Float(1));
}
