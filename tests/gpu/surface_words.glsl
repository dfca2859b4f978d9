// Functions that surface_parity_test.cpp compares between GLSL, float and double: dialect text like
// that of shading/, compiled by all three. a, b: unit directions above the surface; n: unit, tilted
// by up to 53 degrees; xi, select: uniform in [0, 1).

// ---- whole surfaces --------------------------------------------------------------------------------

FN SurfaceMaterial parity_material(int brdf, int mdf, int fresnel, Bool has_diffuse) {
    Lobe lobe = lobe_from_alpha(brdf_mdf(brdf, mdf), Float(0.2), Float(0.5));
    SurfaceMaterial m = surface_material(brdf, lobe, -Float(1),
                                         vec3(-Float(1.1), -Float(0.9), Float(0.8)), Float(0.05));
    m.fresnel = fresnel;
    m.has_diffuse = has_diffuse;
    m = surface_colored(m, vec3(Float(0.7), Float(0.5), Float(0.3)), Float(0.25));
    if (fresnel == kFresnelConductor) {
        m.eta = vec3(Float(0.2), Float(0.9), Float(1.4));
        m.k = vec3(Float(3.9), Float(2.4), Float(1.6));
    } else if (fresnel == kFresnelCurve) {
        m.curve.normal = vec3(Float(0.2), Float(0.5), Float(0.9));
        m.curve.pole = vec3(Float(0.3), -Float(0.2), Float(0.1));
        m.curve.pole2 = vec3(Float(0.02), Float(0.01), -Float(0.03));
        m.curve.c0 = vec3(Float(0.5), -Float(1.5), Float(0.1));
        m.curve.c1 = vec3(-Float(2), Float(3), Float(0.2));
        m.curve.c2 = vec3(Float(1), -Float(2), -Float(0.4));
    } else if (fresnel == kFresnelDielectric) {
        m.eta.x = Float(1.5);
        m.k.x = fresnel_inverse_at_normal(Float(1.5));
    }
    return m;
}

FN LobeValues parity_values(vec2 xi, Float select) {
    LobeValues v;
    v.D = select;
    v.area_i = Float(0.2) + xi.x;
    v.area_o = Float(0.2) + xi.y;
    v.density = xi.x;
    v.density_round = xi.y;
    return v;
}

FN Perturbation parity_perturbation(SurfaceMaterial m, int method, vec3 n) {
    return perturb_make(method, n, lobe_grooves_along_x(m.lobe.mdf, m.lobe.p0, m.lobe.p1), true);
}

FN vec3 parity_eval(SurfaceMaterial m, int method, vec3 a, vec3 b, vec3 n, vec2 xi, Float select) {
    return surface_eval(m, parity_perturbation(m, method, n), parity_values(xi, select), a, b);
}

FN Float parity_pdf(SurfaceMaterial m, int method, vec3 a, vec3 b, vec3 n, vec2 xi, Float select) {
    return surface_pdf(m, parity_perturbation(m, method, n), parity_values(xi, select), a, b);
}

// The zero vector for a rejected draw.
FN vec3 parity_direction(SurfaceMaterial m, int method, vec3 a, vec3 b, vec3 n, vec2 xi,
                         Float select) {
    Bool drawn = false;
    vec3 wi = surface_direction(m, parity_perturbation(m, method, n), a, b, xi, select, drawn);
    return choose(drawn, wi, vec3(Float(0), Float(0), Float(0)));
}

// ---- words -------------------------------------------------------------------------------------------

const int kParityWords = 19;

FN vec3 parity_texels(int word, vec3 a, vec3 b, vec3 n, vec2 xi, Float select) {
    vec3 texel = (a + vec3(Float(1), Float(1), Float(1))) * Float(0.5);
    vec2 scale = vec2(Float(2) * xi.x, -Float(2) * xi.y);
    vec3 r = vec3(Float(0), Float(0), Float(0));
    if (word == 0) {
        r = normal_of_vector(vector_of_texel(texel), scale);
    } else if (word == 1) {
        r = normal_of_vector(vector_of_texel(vec2(texel.x, texel.y)), scale);
    } else if (word == 2) {
        r = normal_over(normal_of_slopes(Float(4) * xi.x, -Float(4) * xi.y), vector_of_disk(n.x, n.y));
    } else if (word == 3) {
        vec2 v = variance_along(variance_about(n, xi, scale), stretch_direction(xi, vec2(Float(0.6), Float(0.8))));
        vec2 s = slopes_of_normal(n);
        r = vec3(v.x, v.y, s.x + s.y);
    } else if (word == 4) {
        Lobe lobe = lobe_of_roughness(kMdfGgx, xi.x, xi.y);
        r = vec3(lobe.p0, lobe.p1, specular_occlusion(select, b.z, lobe));
    } else {
        vec2 d = stretch_direction(xi, vec2(Float(0.6), Float(0.8)));
        r = seen_from_rotated(n, d);
    }
    return r;
}

FN vec3 parity_frames(int word, vec3 a, vec3 b, vec3 n, vec2 xi, Float select) {
    vec3 r = vec3(Float(0), Float(0), Float(0));
    if (word == 6) {
        r = surface_frame(a * Float(2), n, xi.x - Float(0.5), Float(1), b).b;
    } else if (word == 7) {
        r = tangent_or_any(a, choose(select < Float(0.5), n, vec3(Float(0), Float(0), Float(0))));
    } else if (word == 8) {
        LightAtPoint l = light_at(a * Float(3), Float(1), -n, spot_cone(Float(0.9), Float(0.3)),
                                  Float(0.05), b);
        r = vec3(l.wi.x, l.wi.y, l.falloff);
    } else {
        Perturbation p = surface_perturbation(kMethodFollowGrain, n, vec2(Float(0.6), Float(0.8)),
                                              true, false, b);
        r = p.frame.t + p.n;
    }
    return r;
}

FN vec3 parity_light(int word, vec3 a, vec3 b, vec2 xi, Float select) {
    vec3 r = vec3(Float(0), Float(0), Float(0));
    vec3 color = vec3(Float(3) * xi.x * select, Float(2) * xi.y, select);
    if (word < 14) {
        r = display_color(word - 10, color);
    } else if (word == 14) {
        r = vec3(linear_from_srgb(xi.x), luminance(color), fresnel_rise(Float(1) + xi.y, Float(2), a.z));
    } else {
        r = vec3(diffuse_eval(kBrdfMicrofacet, select, a.z, b.z), diffuse_albedo(kBrdfMicrofacet, select, b.z),
                 diffuse_albedo(kBrdfAshikhminShirley, select, b.z));
    }
    return r;
}

FN vec3 parity_tables(int word, vec3 a, vec3 b, vec3 n, vec2 xi, Float select) {
    vec3 r = vec3(Float(0), Float(0), Float(0));
    vec3 moments = vec3(Float(0.2), Float(0.3), Float(0.9));
    if (word == 16) {
        LobePoint q = lobe_point_of(n);
        TablePlace p = table_place(40, 12, tabulated_row(q, 12), tabulated_turns(q.x, q.y) + select);
        // A value that is continuous across columns and rows, as those of tables are.
        r = vec3(table_value(p, xi.x, xi.y, select, b.z), Float(p.row) + p.along,
                 tabulated_area(xi.x, a) + tabulated_area_row(b, 16));
    } else if (word == 17) {
        TableDraw draw;
        draw.ring = int(xi.x * Float(12));
        draw.column = int(xi.y * Float(40));
        draw.along = select;
        draw.across = Float(1) - select;
        r = tabulated_half_vector(draw, 40, 12, Float(0.2));
    } else {
        SurfaceMaterial m = parity_material(kBrdfMicrofacet, kMdfGgx, kFresnelSchlick, true);
        Float specular = cloth_specular_of_table(m, select, Float(0.2) * xi.x, -Float(0.3) * xi.y, a, b);
        r = cloth_eval(m, specular, moments, a, b);
        m.brdf = kBrdfPhong;
        r.x = cloth_specular_of_nodes(m, kMethodFollowGrain, true, false, moments, a, b);
        vec2 place = cloth_table_place(n, Float(0.3), Float(0.2));
        r.y = r.y + place.x + place.y;
    }
    return r;
}

FN vec3 parity_word(int word, vec3 a, vec3 b, vec3 n, vec2 xi, Float select) {
    vec3 r = vec3(Float(0), Float(0), Float(0));
    if (word < 6) {
        r = parity_texels(word, a, b, n, xi, select);
    } else if (word < 10) {
        r = parity_frames(word, a, b, n, xi, select);
    } else if (word < 16) {
        r = parity_light(word, a, b, xi, select);
    } else {
        r = parity_tables(word, a, b, n, xi, select);
    }
    return r;
}
