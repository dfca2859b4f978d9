// The map from base half vectors to half vectors of a perturbed lobe, and its derivative: what a method does
// to the neighborhood of a point of the lobe. Used where a lobe is integrated as a whole
// (docs/theory/image-light.md, docs/theory/area-lights.md).

// The linear part of the map: the columns of a matrix B; h is along B m. Rotations are orthogonal. normal-map
// is a shear: x and y stay, and n~.h replaces m.z. Of slope-shift and stretch it is L (perturb/facet_map.glsl).
struct LobeMapping {
    vec3 x;
    vec3 y;
    vec3 z;
};

FN LobeMapping mapping_of(Perturbation p) {
    LobeMapping map;
    if (p.method == kMethodNormalMap) {
        // 0.05: tilts up to 87 degrees.
        Float s = Float(1) / max(p.n.z, Float(0.05));
        map.x = vec3(Float(1), Float(0), -p.n.x * s);
        map.y = vec3(Float(0), Float(1), -p.n.y * s);
        map.z = vec3(Float(0), Float(0), s);
    } else if (method_moves_facets(p.method)) {
        map.x = facet_moved(p.method, p.n, vec3(Float(1), Float(0), Float(0)));
        map.y = facet_moved(p.method, p.n, vec3(Float(0), Float(1), Float(0)));
        map.z = p.n;
    } else {
        Frame f = frame_for_sampling(p);
        map.x = f.t;
        map.y = f.b;
        map.z = f.n;
    }
    return map;
}

FN Bool method_deforms(int method) {
    return method == kMethodDeformLinear || method == kMethodDeformSmooth;
}

// Whether the method is a rotation, so that the lobe keeps its shape and its energy.
FN Bool method_turns(int method) {
    return method != kMethodNormalMap && !method_deforms(method) && !method_moves_facets(method);
}

// The component of `v` perpendicular to the unit vector h.
FN vec3 beside(vec3 h, vec3 v) {
    return v - h * dot(h, v);
}

// A base vector m, its unit half vector h, and the scale of derivatives.
struct MappedHalf {
    vec3 m;       // unit
    vec3 h;
    Float scale;  // 1/length before normalization
};

FN MappedHalf mapped_half(LobeMapping map, Perturbation p, vec3 m) {
    Float scale = Float(1) / sqrt(max(dot(m, m), kTiny));
    MappedHalf r;
    r.m = m * scale;
    r.scale = scale;
    if (method_deforms(p.method)) {
        r.h = perturb_forward(p, r.m);
    } else {
        vec3 h = map.x * m.x + map.y * m.y + map.z * m.z;
        r.scale = Float(1) / sqrt(max(dot(h, h), kTiny));
        r.h = h * r.scale;
    }
    return r;
}

// Derivative of h when m, not yet of unit length, moves by `move`. The deformations move points p of the disk
// by (1 - k) d or r d, where |q + (r - r^2) d| = 1 - r^2 (perturb/perturb.glsl, perturb/forward.glsl).
FN vec3 half_turn(MappedHalf at, LobeMapping map, Perturbation p, vec3 move) {
    vec3 turn = vec3(Float(0), Float(0), Float(0));
    if (method_deforms(p.method)) {
        vec3 dq = beside(at.m, move) * at.scale;
        Float fall = Float(0);
        if (p.method == kMethodDeformLinear) {
            fall = -(at.m.x * dq.x + at.m.y * dq.y) /
                   sqrt(max(at.m.x * at.m.x + at.m.y * at.m.y, kTiny));
        } else {
            Float r = sqrt(deform_rim_fraction(p.n, at.h));
            Float ux = at.m.x + (r - r * r) * p.n.x;
            Float uy = at.m.y + (r - r * r) * p.n.y;
            Float unit = Float(1) / sqrt(max(ux * ux + uy * uy, kTiny));
            ux = ux * unit;
            uy = uy * unit;
            Float slope = (Float(1) - Float(2) * r) * (ux * p.n.x + uy * p.n.y) + Float(2) * r;
            // 1e-3: reached at a tilt of 90 degrees.
            fall = -(ux * dq.x + uy * dq.y) / max(slope, Float(1e-3));
        }
        Float px = dq.x + p.n.x * fall;
        Float py = dq.y + p.n.y * fall;
        // 0.01: half a degree above the horizon.
        turn = vec3(px, py, -(at.h.x * px + at.h.y * py) / max(at.h.z, Float(0.01)));
    } else {
        turn = beside(at.h, map.x * move.x + map.y * move.y + map.z * move.z) * at.scale;
    }
    return turn;
}

// The solid angle of half vectors for one of base vectors, at a base vector given with unit length.
FN Float mapped_area(MappedHalf at, LobeMapping map, Perturbation p) {
    Float area = Float(1);
    if (method_deforms(p.method)) {
        // 0.01: as above. 1e-3: where deform-smooth folds.
        area = at.m.z / (max(at.h.z, Float(0.01)) * max(deform_jacobian(p.method, p.n, at.h), Float(1e-3)));
    } else {
        area = abs(dot(cross(map.x, map.y), map.z)) * (at.scale * at.scale * at.scale);
    }
    return area;
}
