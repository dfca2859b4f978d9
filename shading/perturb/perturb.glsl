// What a perturbed normal n~ does to a lobe: the methods of docs/theory/papers.md, term by term.
//
// All directions are in the tangent space of the unperturbed surface (x tangent, y bitangent,
// z normal); n~ is unit. A method is a map from the half vector h to the LobePoint where the
// unperturbed distribution is evaluated, a map for the directions that shadowing sees, and the
// normal that cosines use.

// Where an unperturbed distribution is evaluated. Unit but for slope-shift and stretch, whose D has the factor
// inverse_length^4: distributions of slopes (Beckmann, GGX) have it of themselves, as their formulas are of degree -4
// in (x, y, z). The others ask for lobe_point_unit.
struct LobePoint {
    Float x;       // tangent part: azimuth and slopes come from (x, y)
    Float y;
    Float z;       // cosine to the pole times the length, > 0 where weight > 0
    Float s2;      // 1 - z^2 of the unit direction, kept apart because 1 - z*z loses the lobe's core
    Float weight;  // 0 where the method says D = 0, else 1 (or the factor that conserves energy)
    Float inverse_length;  // 1 / |(x, y, z)|
};

// Of unit length, the factor in its weight.
FN LobePoint lobe_point_unit(LobePoint q) {
    Float l2 = q.inverse_length * q.inverse_length;
    q.x = q.x * q.inverse_length;
    q.y = q.y * q.inverse_length;
    q.z = q.z * q.inverse_length;
    q.weight = q.weight * (l2 * l2);
    q.inverse_length = Float(1);
    return q;
}

struct Perturbation {
    int method;
    Frame frame;       // rows that map h and w; for rotate-approx not normalised (K12 Eq 11); of slope-shift
                       // and stretch those of facet_map_inverse, which map h alone
    Float stretch;     // s2 = stretch (x^2 + y^2)
    vec3 n;            // the normal of cosines and of the diffuse term
    Float conserve;    // factor of deform-smooth: 1 as published
    Float gain;        // facet_map_gain of slope-shift and stretch, else 1
};

// maths: (4 - |d|^2) / (4 - 2 |d|^2) makes deform-smooth keep its energy to 2 % up to 60 degrees.
FN Float deform_smooth_conserving_factor(vec3 n) {
    Float d2 = n.x * n.x + n.y * n.y;
    return (Float(4) - d2) / (Float(4) - Float(2) * d2);
}

// `grooves_along_x`: the grain runs along the tangent (the axis of the smaller alpha, the larger
// exponent); only follow-grain asks. `conserving`: deform-smooth in its energy-conserving form.
FN Perturbation perturb_make(int method, vec3 n, Bool grooves_along_x, Bool conserving) {
    Perturbation p;
    p.method = method;
    p.stretch = Float(1);
    p.n = n;
    p.conserve = Float(1);
    p.gain = Float(1);
    if (method == kMethodNone || method == kMethodNormalMap) {
        p.frame.t = vec3(Float(1), Float(0), Float(0));
        p.frame.b = vec3(Float(0), Float(1), Float(0));
        p.frame.n = n;  // K11 Eq 2, K12 Eq 2: only the normal is replaced
        if (method == kMethodNone) {
            p.frame.n = vec3(Float(0), Float(0), Float(1));
            p.n = p.frame.n;
        }
    } else if (method == kMethodGramSchmidt) {
        p.frame = frame_keep_tangent(n);
    } else if (method == kMethodRotateExact) {
        p.frame = frame_keep_bitangent(n);
    } else if (method == kMethodRotateApprox) {
        // K12 Eq 9 and 11: row 2 is w' x u' = (-nx ny, 1 - ny^2, -ny nz) and row 3 is n~.h; the
        // printed signs and the printed n~.n~ are wrong (docs/theory/papers.md).
        Float s2 = n.x * n.x + n.z * n.z;
        p.frame.t = vec3(n.z, Float(0), -n.x);
        p.frame.b = vec3(-n.x * n.y, s2, -n.y * n.z);
        p.frame.n = n;
        p.stretch = Float(1) / max(s2, kTiny);
    } else if (method == kMethodFollowGrain) {
        // A groove along unit g runs along (g, -(g.d)/n~z) on the displaced surface. For g on an
        // axis that is one of the two Gram-Schmidt frames.
        Frame along_x = frame_keep_bitangent(n);
        Frame along_y = frame_keep_tangent(n);
        p.frame.t = choose(grooves_along_x, along_x.t, along_y.t);
        p.frame.b = choose(grooves_along_x, along_x.b, along_y.b);
        p.frame.n = n;
    } else if (method_moves_facets(method)) {
        p.frame = facet_map_inverse(method, n);
        p.gain = facet_map_gain(method, n);
    } else {
        // rotate-arc; the deformations have no closed shadowing of their own and take this frame.
        p.frame = frame_shortest_arc(n);
        if (method == kMethodDeformSmooth) {
            p.conserve = choose(conserving, deform_smooth_conserving_factor(n), Float(1));
        }
    }
    return p;
}

// 1 - k of the deformations at p = (h.x, h.y), k = |C'p| / |C'R|: hz^2 / (1 - d.p + S), exact near
// the rim, where the ray and circle subtract (docs/theory/papers.md, K11 Eq 3). With v = p - d and b = d.v
// the denominator is n~z^2 + (S - b), and S - b is written without cancellation for either sign.
FN Float deform_rim_fraction(vec3 n, vec3 h) {
    Float vx = h.x - n.x;
    Float vy = h.y - n.y;
    Float v2 = vx * vx + vy * vy;
    Float n2 = n.z * n.z;
    Float b = n.x * vx + n.y * vy;
    Float s = sqrt(b * b + v2 * n2);
    Float s_minus_b = choose(b > Float(0), v2 * n2 / max(s + b, kTiny), s - b);
    // At most 1 but for rounding, which a tilt of 90 degrees makes boundless.
    return min(h.z * h.z / max(n2 + s_minus_b, kTiny), Float(1));
}

// K11 Eq 3 inverted exactly: q = p - (1-k) d, |q| = k.
FN LobePoint deform_linear_point(vec3 n, vec3 h) {
    Float m = deform_rim_fraction(n, h);
    LobePoint q;
    q.x = h.x - m * n.x;
    q.y = h.y - m * n.y;
    q.z = sqrt(max(m * (Float(2) - m), Float(0)));
    q.inverse_length = Float(1);
    q.s2 = q.x * q.x + q.y * q.y;
    q.weight = choose(h.z > Float(0), Float(1), Float(0));
    return q;
}

// K11 Eq 5: q = p - sqrt(1-k) d, which is not the inverse of Eq 4; outside the disk D = 0.
FN LobePoint deform_smooth_point(vec3 n, vec3 h) {
    Float r = sqrt(deform_rim_fraction(n, h));
    Float d2 = n.x * n.x + n.y * n.y;
    Float z2 = h.z * h.z + r * (Float(2) * (n.x * h.x + n.y * h.y) - r * d2);
    LobePoint q;
    q.x = h.x - r * n.x;
    q.y = h.y - r * n.y;
    q.z = sqrt(max(z2, Float(0)));
    q.inverse_length = Float(1);
    q.s2 = q.x * q.x + q.y * q.y;
    q.weight = choose(h.z > Float(0) && z2 > Float(0), Float(1), Float(0));
    return q;
}

// slope-shift and stretch: L^-1 h. Below a length of 0.5 there is none for a unit h.
FN LobePoint moved_facet_point(Perturbation p, vec3 h) {
    vec3 v = frame_to_local(p.frame, h);
    Float flat2 = v.x * v.x + v.y * v.y;
    Float inverse2 = Float(1) / max(flat2 + v.z * v.z, kTiny);
    LobePoint q;
    q.x = v.x;
    q.y = v.y;
    q.z = max(v.z, Float(0));
    q.s2 = flat2 * inverse2;
    q.weight = choose(v.z > Float(0), p.gain, Float(0));
    q.inverse_length = sqrt(inverse2);
    return q;
}

// Where the unperturbed D is evaluated for half vector h (unit).
FN LobePoint perturb_point(Perturbation p, vec3 h) {
    LobePoint q;
    if (p.method == kMethodDeformLinear) {
        q = deform_linear_point(p.n, h);
    } else if (p.method == kMethodDeformSmooth) {
        q = deform_smooth_point(p.n, h);
        q.weight = q.weight * p.conserve;
    } else if (method_moves_facets(p.method)) {
        q = moved_facet_point(p, h);
    } else {
        q.x = dot(p.frame.t, h);
        q.y = dot(p.frame.b, h);
        q.z = dot(p.frame.n, h);
        q.s2 = p.stretch * (q.x * q.x + q.y * q.y);
        if (p.method == kMethodNormalMap) {
            vec3 c = cross(p.n, h);
            q.s2 = dot(c, c);
        }
        q.weight = choose(q.z > Float(0), Float(1), Float(0));
        q.z = max(q.z, Float(0));
        q.inverse_length = Float(1);
    }
    return q;
}

// The direction that shadowing sees. Not unit for normal-map, rotate-approx, slope-shift and stretch: only the
// ratios x/z and y/z enter. Its z is n~.w.
FN vec3 perturb_direction(Perturbation p, vec3 w) {
    if (method_moves_facets(p.method)) { return facet_view(p.method, p.n, w); }
    return frame_to_local(p.frame, w);
}
