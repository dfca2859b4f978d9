// Woven cloth from afar: the two families of yarns, each as the mean over the normals of its surface
// (docs/theory/cloth.md). Directions against the family's axes: x along the yarn, z out of the cloth. A yarn at a
// point needs nothing from here: it is a surface whose normal and stretch weave_point gives.

// Normals that stand for a family's: two along the yarn, where slopes pile up at their ends, times three
// across, where the sine of the tilt is spread evenly: the points and weights of Gauss and Legendre.
const int kClothNodes = 6;

// Not unit. `moments`: root mean squares of the normals along and across the yarn, and the mean of z.
FN vec3 cloth_node(vec3 moments, int i) {
    // sqrt(3) sqrt(3/5) root mean squares.
    Float across = Float(i % 3 - 1) * (Float(1.3416408) * moments.y);
    return vec3(choose(i < 3, moments.x, -moments.x), across, moments.z);
}

FN Float cloth_node_weight(int i) {
    return choose(i % 3 == 1, Float(4) / Float(18), Float(2.5) / Float(18));
}

// Mean of f cos over the family for a white base.
FN Float cloth_diffuse(SurfaceMaterial m, vec3 moments, vec3 wi, vec3 wo) {
    Float sum = Float(0);
    for (int i = 0; i < kClothNodes; ++i) {
        vec3 n = cloth_node(moments, i);
        Float cos_i = max(dot(n, wi), Float(0));
        Float cos_o = max(dot(n, wo), Float(0));
        sum = sum + cloth_node_weight(i) * 
                  diffuse_eval(m.brdf, m.dielectric_f0, m.dielectric_f90, cos_i, cos_o) * cos_i;
    }
    return sum;
}

// Mean of f cos without Fresnel, for the models that have no half vectors to tabulate over.
FN Float cloth_specular_of_nodes(SurfaceMaterial m, int method, Bool grooves_along_x, Bool conserving,
                                 vec3 moments, vec3 wi, vec3 wo) {
    Float sum = Float(0);
    for (int i = 0; i < kClothNodes; ++i) {
        vec3 n = normal_facing(normalize(cloth_node(moments, i)), wo);
        Perturbation p = perturb_make(method, n, grooves_along_x, conserving);
        Float f = specular_eval(m, p, no_lobe_values(), wi, wo);
        sum = sum + cloth_node_weight(i) * f * max(dot(p.n, wi), Float(0));
    }
    return sum;
}

// Where a family's table is read for half vector h, in [-1, 1]^2 along and across the yarn. `width_x`,
// `width_y`: its widths. 1e-3: the table ends at 190 widths.
FN vec2 cloth_table_place(vec3 h, Float width_x, Float width_y) {
    Float scale = Float(1) / max(h.z, Float(1e-3));
    return vec2(weave_table_coordinate(h.x * scale, width_x),
                weave_table_coordinate(h.y * scale, width_y));
}

// Mean of f cos without Fresnel, from the table's value at the half vector: `factor`, the mean of
// brdf_lobe_factor, and (mean_x, mean_y) of the mean normal of what reflects there, whose masking and
// cosines are taken.
FN Float cloth_specular_of_table(SurfaceMaterial m, Float factor, Float mean_x, Float mean_y, vec3 wi,
                                 vec3 wo) {
    vec3 up = vec3(Float(0), Float(0), Float(1));
    vec3 mean = vec3(mean_x, mean_y, sqrt(max(Float(1) - (mean_x * mean_x + mean_y * mean_y), Float(0))));
    Perturbation p = perturb_make(kMethodNone, up, true, false);
    p.n = normal_facing(mean, wo);
    Float f = brdf_of_factor(m.brdf, m.lobe, factor, p, wi, wo);
    return choose(wi.z + wo.z > Float(0), f * max(dot(p.n, wi), Float(0)), Float(0));
}

// Mean of f cos of the family, `specular` being one of the two above.
FN vec3 cloth_eval(SurfaceMaterial m, Float specular, vec3 moments, vec3 wi, vec3 wo) {
    vec3 f = specular_fresnel(m, half_angle_cosine(wi, wo)) * specular;
    if (m.has_diffuse) { f = f + m.diffuse * cloth_diffuse(m, moments, wi, wo); }
    return f;
}

// The family is sampled as one flat surface whose lobe is as wide as all of its fibres' together: `wide`
// holds that lobe, its x axis along the fibres. `twist`: (cos, sin) from the yarn to the fibres.
FN Float cloth_pdf(SurfaceMaterial wide, vec2 twist, vec3 wi, vec3 wo) {
    Perturbation p = perturb_make(kMethodNone, vec3(Float(0), Float(0), Float(1)), true, false);
    return surface_pdf(wide, p, seen_from_rotated(wi, twist), seen_from_rotated(wo, twist));
}

FN vec3 cloth_sample(SurfaceMaterial wide, vec2 twist, vec3 wo, vec2 xi, Float select, OUT(Float) pdf) {
    Perturbation p = perturb_make(kMethodNone, vec3(Float(0), Float(0), Float(1)), true, false);
    vec3 wi = surface_sample(wide, p, seen_from_rotated(wo, twist), xi, select, pdf);
    return seen_from_rotated(wi, vec2(twist.x, -twist.y));
}
