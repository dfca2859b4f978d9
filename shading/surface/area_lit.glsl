// A surface under a light with an area. Lambert's law is integrated exactly. The specular lobe is mapped to a
// cosine distribution (brdf/cosine_map.glsl), under every method, and the outline of the light with it; what of f cos
// the map does not hold (masking, cosines, Fresnel) is smooth and is taken at the mean of the lit part.
// docs/theory/area-lights.md has the derivation and the errors. Directions and places in the unperturbed tangent
// space of the lobe, seen from the point.

// The lobe of a surface for one view: the same for all lights.
struct AreaLobe {
    Lobe base;        // lobe_for_sampling: what mapped_half maps
    LobeMapping map;
    vec3 axis;        // of phong and lafortune
    vec3 row_x;       // the linear map of directions to cosines that is nearest to the lobe, by its inverse's rows
    vec3 row_y;
    vec3 row_z;
};

// Width of phong and lafortune relative to that of GGX of their alpha, fitted (docs/theory/image-light.md).
CONSTANT(kCosineLobeWidth, 0.9)

// The inverse of the matrix with these columns, as rows.
FN AreaLobe with_inverse(AreaLobe lobe, vec3 x, vec3 y, vec3 z) {
    vec3 yz = cross(y, z);
    Float det = dot(x, yz);
    // kTiny: a lobe of alpha 1e-3 has 1e-6.
    Float scale = Float(1) / choose(abs(det) > kTiny, det, kTiny);
    lobe.row_x = yz * scale;
    lobe.row_y = cross(z, x) * scale;
    lobe.row_z = cross(x, y) * scale;
    return lobe;
}

// Half the derivative of the reflected direction when the half vector h turns by `turn`.
FN vec3 reflected_turn(vec3 wo, vec3 h, vec3 turn) {
    return h * dot(wo, turn) + turn * dot(wo, h);
}

// The derivative of directions by the points of the disk of the cosine, at the middle of the visible normals of GGX
// (Dupuy & Benyoub 2023; docs/theory/image-light.md, "Places of the look-ups").
FN AreaLobe area_lobe_of_half_vectors(Lobe drawn, Perturbation p, vec3 wo) {
    AreaLobe lobe;
    lobe.base = lobe_for_sampling(drawn, p);
    lobe.map = mapping_of(p);
    lobe.axis = p.n;
    Float ax = lobe_alpha_x(lobe.base);
    Float ay = lobe_alpha_y(lobe.base);
    vec3 w = vec3(ax * dot(lobe.map.x, wo), ay * dot(lobe.map.y, wo), max(dot(lobe.map.z, wo), Float(0)));
    w = w * (Float(1) / sqrt(max(dot(w, w), kTiny)));
    MappedHalf at = mapped_half(lobe.map, p, vec3(ax * w.x, ay * w.y, Float(1) + w.z));
    // A share r^2 of the cap c.z > -w.z lies within sqrt(2 (1 + w.z)) r of its middle, for small r, and that of the
    // cosine within r. 2: a direction turns by twice reflected_turn.
    Float reach = Float(2) * sqrt(Float(2) * (Float(1) + w.z));
    vec3 x = half_turn(at, lobe.map, p, vec3(ax * reach, Float(0), Float(0)));
    vec3 y = half_turn(at, lobe.map, p, vec3(Float(0), ay * reach, Float(0)));
    return with_inverse(lobe, reflected_turn(wo, at.h, x), reflected_turn(wo, at.h, y), reflect_about(wo, at.h));
}

FN AreaLobe area_lobe_of_cosine(CosineLobe cosine, Lobe drawn, Perturbation p, vec3 wo) {
    AreaLobe lobe;
    lobe.base = drawn;
    lobe.map = mapping_of(p);
    lobe.axis = cosine_lobe_direction(cosine, p, wo);
    Frame f = frame_about(lobe.axis);
    Float width = Float(2) * kCosineLobeWidth * alpha_from_cosine_exponent(cosine.n);
    return with_inverse(lobe, f.t * width, f.b * width, lobe.axis);
}

FN AreaLobe area_lobe(SurfaceMaterial m, Perturbation p, vec3 wo) {
    if (brdf_is_cosine_lobe(m.brdf)) { return area_lobe_of_cosine(m.cosine, m.lobe, p, wo); }
    return area_lobe_of_half_vectors(m.lobe, p, wo);
}

// The side of a square as large as the lobe, at distance 1: directions that the linear map gives the cosine.
FN Float area_lobe_width(AreaLobe lobe) {
    Float det = abs(dot(cross(lobe.row_x, lobe.row_y), lobe.row_z));
    return sqrt(kPi / max(det, kTiny));
}

// Where a direction lies among those of the cosine.
struct CosinePlace {
    vec3 u;       // not unit
    Float share;  // half vectors for one of the base lobe, times the cosine ratio: of the deformations
};

// The power z^n about the axis: of what is within an angle, 1 - z^(n+1).
FN vec3 cosine_of_power(vec3 axis, Float n, vec3 wi) {
    Frame f = frame_about(axis);
    vec3 local = frame_to_local(f, wi);
    // kTiny: behind the axis there is nothing, and the map ends at the horizon.
    Float g = min(-(n + Float(1)) * log(max(local.z, kTiny)), kMostCosineMapExponent);
    Float square = choose(g < Float(1e-3), g + Float(0.5) * g * g, exp(g) - Float(1));
    Float scale = sqrt(square / max(local.x * local.x + local.y * local.y, kTiny));
    return vec3(local.x * scale, local.y * scale, Float(1));
}

// `towards`: not unit.
FN CosinePlace cosine_place(SurfaceMaterial m, Perturbation p, AreaLobe lobe, vec3 towards, vec3 wo) {
    vec3 wi = towards * (Float(1) / sqrt(max(dot(towards, towards), kTiny)));
    CosinePlace place;
    place.share = Float(1);
    if (brdf_is_cosine_lobe(m.brdf)) {
        place.u = cosine_of_power(lobe.axis, m.cosine.n, wi);
    } else {
        vec3 h = wi + wo;  // GGX and linear methods look at its direction alone
        if (m.lobe.mdf != kMdfGgx || method_deforms(p.method)) { h = half_vector(h, p.n); }
        place.u = cosine_from_half(m.lobe, perturb_point(p, h));
        // 1e-3: where deform-smooth folds.
        if (method_deforms(p.method)) {
            place.share = Float(1) / max(deform_jacobian(p.method, p.n, h), Float(1e-3));
        }
    }
    return place;
}

// The part of a light that is added up: vectors of edge_light, and of the cosine's the shares under a deformation.
struct AreaSum {
    vec3 cosine;
    Float deformed;
    vec3 diffuse;
};

FN AreaSum with_arc(AreaSum sum, CosinePlace a, CosinePlace b) {
    vec3 light = edge_light(a.u, b.u);
    sum.cosine = sum.cosine + light;
    sum.deformed = sum.deformed + light.z * (Float(0.5) * (a.share + b.share));
    return sum;
}

FN vec3 nearest_cosine(AreaLobe lobe, vec3 v) {
    return vec3(dot(lobe.row_x, v), dot(lobe.row_y, v), dot(lobe.row_z, v));
}

FN Float inverse_length(vec3 v) {
    return Float(1) / sqrt(max(dot(v, v), kTiny));
}

// An edge of the light is a curve among the cosine's directions: it is drawn in four parts that are alike in angle
// under the linear map.
FN AreaSum with_curve(AreaSum sum, SurfaceMaterial m, Perturbation p, AreaLobe lobe, vec3 a, vec3 b, vec3 wo) {
    if (m.has_diffuse) { sum.diffuse = sum.diffuse + edge_light(a, b); }
    vec3 from = a * inverse_length(nearest_cosine(lobe, a));
    vec3 to = b * inverse_length(nearest_cosine(lobe, b));
    vec3 middle = from + to;
    middle = middle * inverse_length(nearest_cosine(lobe, middle));
    CosinePlace start = cosine_place(m, p, lobe, from, wo);
    CosinePlace early = cosine_place(m, p, lobe, from + middle, wo);
    CosinePlace half_way = cosine_place(m, p, lobe, middle, wo);
    CosinePlace late = cosine_place(m, p, lobe, middle + to, wo);
    CosinePlace end = cosine_place(m, p, lobe, to, wo);
    sum = with_arc(with_arc(sum, start, early), early, half_way);
    return with_arc(with_arc(sum, half_way, late), late, end);
}

// What a light of radiance 1 reflects towards the eye, and the directions of its middle as each term sees it.
struct AreaReflection {
    vec3 specular;
    vec3 diffuse;
    vec3 towards_specular;  // unit
    vec3 towards_diffuse;
};

// f over the base distribution at a base half vector whose image is `at`. Of models with masking D is the same in both
// under rotations; under slope-shift and stretch it is that times 1/(|L^-1 h|^4 det L), with |L^-1 h| = at.scale.
FN Float half_vector_ratio(SurfaceMaterial m, Perturbation p, AreaLobe lobe, MappedHalf at, LobePoint q, vec3 wi,
                           vec3 wo) {
    Float ratio = Float(0);
    if (brdf_masks(m.brdf) && method_turns(p.method) && p.method != kMethodRotateApprox) {
        ratio = brdf_of_factor(m.brdf, m.lobe, Float(1), p, wi, wo);
    } else if (brdf_masks(m.brdf) && method_moves_facets(p.method)) {
        Float inverse2 = Float(1) / (at.scale * at.scale);
        ratio = brdf_of_factor(m.brdf, m.lobe, p.gain * (inverse2 * inverse2), p, wi, wo);
    } else {
        Float D = lobe.base.projected_norm * lobe_shape(lobe.base, q);
        // 1e-20: 1e-9 of the least peak of a lobe is farther out than any light that shows.
        ratio = choose(D > Float(1e-20), brdf_eval(m.brdf, m.lobe, p, wi, wo) / max(D, Float(1e-20)), Float(0));
    }
    return ratio;
}

// f cos for one of the cosine map, at a base half vector; `wi`: what it reflects to. The share of the deformations is
// counted elsewhere.
FN vec3 half_vector_rest(SurfaceMaterial m, Perturbation p, AreaLobe lobe, vec3 base, vec3 wo, OUT(vec3) wi) {
    MappedHalf at;
    if (method_turns(p.method)) {
        at.m = base;
        at.h = lobe.map.x * base.x + lobe.map.y * base.y + lobe.map.z * base.z;
        at.scale = Float(1);
    } else {
        at = mapped_half(lobe.map, p, base);
    }
    LobePoint q = lobe_point_of(at.m);
    Float wo_h = max(dot(wo, at.h), Float(0));
    wi = reflect_about(wo, at.h);
    Float area = Float(1);
    if (method_deforms(p.method)) {
        area = q.z / max(at.h.z, Float(0.01));
    } else if (p.method == kMethodNormalMap || method_moves_facets(p.method)) {
        area = mapped_area(at, lobe.map, p);
    }
    Float cosines = max(dot(p.n, wi), Float(0)) / max(q.z, kLeastCosine);
    Float rest = half_vector_ratio(m, p, lobe, at, q, wi, wo) * Float(4) * wo_h * area * cosines;
    return specular_color(m, half_angle_cosine(wi, wo)) * rest;
}

// Beyond GGX the slopes of u are stretched, and their mean lies too far out: by nothing for a small light, by 0.68 for
// one that covers half of the lobe (Beckmann: a mean slope of 1/sqrt(pi) where the map has sqrt(ln 2)).
CONSTANT(kStretchedMean, 0.32)

FN Float stretched_mean(Float lit) {
    return Float(1) - kStretchedMean * min(Float(2) * lit, Float(1));
}

// Of models without a masking term f cos bends within the lobe: its mean over four points around
// the mean, as far away as the part of the lobe that is lit is wide. The factor is fitted to the bias of these models.
CONSTANT(kSpread, 0.86)

FN vec3 specular_rest(SurfaceMaterial m, Perturbation p, AreaLobe lobe, vec3 u, Float lit, vec3 wo,
                      OUT(vec3) towards) {
    vec3 base = half_from_cosine(lobe.base, u);
    if (lobe.base.mdf != kMdfGgx) {
        Float keep = stretched_mean(lit);
        base = normalize(vec3(base.x * keep, base.y * keep, base.z));
    }
    vec3 rest = half_vector_rest(m, p, lobe, base, wo, towards);
    if (!brdf_masks(m.brdf)) {
        vec3 beside_wi = towards;
        Float reach = kSpread * sqrt(lit) * base.z;
        Float x = lobe_alpha_x(lobe.base) * reach;
        Float y = lobe_alpha_y(lobe.base) * reach;
        rest = half_vector_rest(m, p, lobe, normalize(vec3(base.x + x, base.y, base.z)), wo, beside_wi);
        rest = rest + half_vector_rest(m, p, lobe, normalize(vec3(base.x - x, base.y, base.z)), wo, beside_wi);
        rest = rest + half_vector_rest(m, p, lobe, normalize(vec3(base.x, base.y + y, base.z)), wo, beside_wi);
        rest = rest + half_vector_rest(m, p, lobe, normalize(vec3(base.x, base.y - y, base.z)), wo, beside_wi);
        rest = rest * Float(0.25);
    }
    return rest;
}

// The same of phong and lafortune.
FN vec3 cosine_rest(SurfaceMaterial m, Perturbation p, AreaLobe lobe, vec3 u, Float lit, vec3 wo,
                    OUT(vec3) towards) {
    Float slope2 = (u.x * u.x + u.y * u.y) / max(u.z * u.z, kTiny);
    Float z = exp(-log(Float(1) + slope2) / (m.cosine.n + Float(1)));
    Float beyond = sqrt(max((Float(1) - z) * (Float(1) + z), Float(0)) / max(u.x * u.x + u.y * u.y, kTiny));
    beyond = beyond * stretched_mean(lit);
    towards = normalize(frame_to_outer(frame_about(lobe.axis), vec3(u.x * beyond, u.y * beyond, z)));
    Float rest = cosine_lobe_peak(m.cosine, p, wo) * Float(2) * kPi / (m.cosine.n + Float(1));
    if (m.brdf == kBrdfLafortune) { rest = rest * max(dot(p.n, towards), Float(0)); }
    return specular_color(m, half_angle_cosine(towards, wo)) * rest;
}

FN AreaReflection area_reflection_of(SurfaceMaterial m, Perturbation p, AreaLobe lobe, AreaSum sum, Float lit, vec3 wo) {
    // The outline runs the other way round for a point behind a light with two sides.
    Float side = choose(sum.cosine.z < Float(0), -Float(1), Float(1));
    vec3 u = sum.cosine * side;
    Float share = u.z / (Float(2) * kPi);
    Float deformed = max(sum.deformed * side, Float(0)) / (Float(2) * kPi);
    Float seen = choose(dot(p.n, wo) > Float(0), lit, Float(0));
    // kTiny: no part of the light is above the horizon.
    u = choose(u.z > kTiny, u, vec3(Float(0), Float(0), Float(1)));
    AreaReflection r;
    r.towards_specular = p.n;
    vec3 rest = vec3(Float(0), Float(0), Float(0));
    share = clamp(share, Float(0), Float(1));
    if (brdf_is_cosine_lobe(m.brdf)) {
        rest = cosine_rest(m, p, lobe, u, share, wo, r.towards_specular);
    } else {
        rest = specular_rest(m, p, lobe, u, share, wo, r.towards_specular);
    }
    r.specular = rest * (seen * deformed);
    r.diffuse = vec3(Float(0), Float(0), Float(0));
    r.towards_diffuse = p.n;
    if (m.has_diffuse) {
        Float height = dot(p.n, sum.diffuse);
        vec3 all = sum.diffuse * choose(height < Float(0), -Float(1), Float(1));
        Float cos_i = clamp(abs(height) / sqrt(max(dot(all, all), kTiny)), Float(0), Float(1));
        // Lambert's law exactly; what the interface lets through, at the middle of the light.
        Float f = diffuse_eval(m.brdf, m.dielectric_f0, m.dielectric_f90, cos_i, max(dot(p.n, wo), Float(0)));
        r.diffuse = m.diffuse * (f * Float(0.5) * abs(height) * seen);
        r.towards_diffuse = choose(dot(all, all) > kTiny, all * (Float(1) / sqrt(max(dot(all, all), kTiny))), p.n);
    }
    return r;
}

// How many corners lie above the horizon of n.
FN int corners_above(AreaLight light, int shape, vec3 n) {
    vec2 place = area_first_corner(shape);
    vec2 turn = area_corner_turn(shape);
    int corners = area_corners(shape);
    int above = 0;
    for (int i = 0; i < corners; ++i) {
        if (dot(n, area_corner(light, place)) > Float(0)) { ++above; }
        place = area_next_corner(place, turn);
    }
    return above;
}

// The outline is cut at the horizon of n~, which it crosses once downwards and once upwards; the horizon between the
// crossings is an edge as well, the last one.
FN AreaReflection area_reflection(SurfaceMaterial m, Perturbation p, AreaLobe lobe, AreaLight light, int shape,
                                  vec3 wo) {
    int corners = area_corners(shape);
    int above = corners_above(light, shape, p.n);
    // No edge of a light below the horizon or from behind, and the horizon only where it cuts the light.
    int edges = above == corners ? corners : corners + 1;
    if (above == 0 || light.lit == Float(0)) { edges = 0; }
    vec2 place = area_first_corner(shape);
    vec2 turn = area_corner_turn(shape);
    vec3 a = area_corner(light, place);
    Float height_a = dot(p.n, a);
    vec3 none = vec3(Float(0), Float(0), Float(0));
    vec3 leaves = p.n;
    vec3 enters = p.n;
    AreaSum sum;
    sum.cosine = none;
    sum.deformed = Float(0);
    sum.diffuse = none;
    for (int i = 0; i < edges; ++i) {
        Bool last = i == corners;
        place = area_next_corner(place, turn);
        vec3 b = area_corner(light, place);
        Float height_b = dot(p.n, b);
        Bool above_a = height_a > Float(0);
        Bool above_b = height_b > Float(0);
        vec3 crossing = edge_crossing(a, b, height_a, height_b);
        // An edge below the horizon shrinks to a point.
        Bool counts = above_a || above_b;
        vec3 from = choose(last, leaves, choose(counts, choose(above_a, a, crossing), p.n));
        vec3 to = choose(last, enters, choose(counts, choose(above_b, b, crossing), p.n));
        leaves = choose(above_a && !above_b, crossing, leaves);
        enters = choose(!above_a && above_b, crossing, enters);
        sum = with_curve(sum, m, p, lobe, from, to, wo);
        a = b;
        height_a = height_b;
    }
    return area_reflection_of(m, p, lobe, sum, light.lit, wo);
}

// ---- layers ------------------------------------------------------------------------------------------

// The face of a coat as a surface of its own.
FN SurfaceMaterial coat_surface(CoatLayer c) {
    return surface_material(kBrdfMicrofacet, c.lobe, -Float(1), vec3(-Float(1), -Float(1), Float(1)), kCoatF0);
}

// The surface's own terms under its layers, each factor at the middle of the light that the term sees, and the light
// that the layers reflect: the coat by a map of its own, the sheen as Lambert's law with its value at the middle.
// `coat`: area_lobe of coat_surface. `o`: layers_seen of wo.
FN AreaReflection area_layered(AreaReflection r, SurfaceMaterial m, SurfaceLayers l, LayersSeen o, Perturbation p,
                               AreaLobe coat, AreaLight light, int shape, vec3 wo) {
    vec3 color = specular_color(m, half_angle_cosine(r.towards_specular, wo));
    LayersSeen middle = layers_seen(l, p.n, r.towards_diffuse);
    r.specular = r.specular * layers_over_specular(l, color, layers_seen(l, p.n, r.towards_specular), o);
    r.diffuse = r.diffuse * layers_over_diffuse(l, m.diffuse, middle, o);
    if (l.sheen.present) {
        Float cos_i = max(dot(p.n, r.towards_diffuse), kLeastCosine);
        vec3 f = sheen_eval(l.sheen, middle.sheen, o.sheen, p.n, r.towards_diffuse, wo) * (kPi / cos_i);
        if (l.coat.present) { f = f * coat_over_diffuse(l.coat, l.sheen.color, middle.coat, o.coat); }
        r.diffuse = r.diffuse + f * area_cosine(light, shape, p.n);
    }
    if (l.coat.present) {
        AreaReflection face = area_reflection(coat_surface(l.coat), l.coat.at, coat, light, shape, wo);
        r.specular = r.specular + face.specular * l.coat.cover;
    }
    return r;
}
