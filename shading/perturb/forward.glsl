// The methods in the other direction, for sampling: perturb_forward maps a half vector of the
// unperturbed lobe to the one whose LobePoint it is, deform_jacobian is the change of solid angle.
// normal-map has no such map (brdf/sample.glsl).

// rotate-approx is drawn as the exact rotation, of a widened lobe (lobe_for_sampling).
FN Frame frame_for_sampling(Perturbation p) {
    if (p.method == kMethodRotateApprox) { return frame_keep_bitangent(p.n); }
    return p.frame;
}

FN LobePoint lobe_point_of(vec3 m) {
    LobePoint q;
    q.x = m.x;
    q.y = m.y;
    q.z = max(m.z, Float(0));
    q.s2 = m.x * m.x + m.y * m.y;
    q.weight = choose(m.z > Float(0), Float(1), Float(0));
    q.inverse_length = Float(1);
    return q;
}

FN vec3 disk_to_sphere(Float x, Float y) {
    return vec3(x, y, sqrt(max(Float(1) - x * x - y * y, Float(0))));
}

// K11 Eq 3: p = q + (1 - |q|) d, with 1 - |q| = z^2/(1 + |q|).
FN vec3 deform_linear_forward(vec3 n, vec3 m) {
    Float rim = m.z * m.z / (Float(1) + sqrt(m.x * m.x + m.y * m.y));
    return disk_to_sphere(m.x + rim * n.x, m.y + rim * n.y);
}

// The map of which K11 Eq 5 is the inverse: p = q + r d with |q + (r - r^2) d| = 1 - r^2, one root
// in [0, 1]. Newton steps kept inside a shrinking bracket.
FN vec3 deform_smooth_forward(vec3 n, vec3 m) {
    Float low = Float(0);
    Float high = Float(1);
    Float r = sqrt(m.z * m.z / (Float(1) + sqrt(m.x * m.x + m.y * m.y)));
    for (int i = 0; i < kDeformRootSteps; ++i) {
        Float x = m.x + (r - r * r) * n.x;
        Float y = m.y + (r - r * r) * n.y;
        Float radius = sqrt(max(x * x + y * y, kTiny));
        Float f = radius - (Float(1) - r * r);
        Float slope = (Float(1) - Float(2) * r) * (x * n.x + y * n.y) / radius + Float(2) * r;
        low = choose(f < Float(0), r, low);
        high = choose(f < Float(0), high, r);
        Float newton = r - f / choose(abs(slope) > kTiny, slope, kTiny);
        r = choose(newton >= low && newton <= high, newton, Float(0.5) * (low + high));
    }
    return disk_to_sphere(m.x + r * n.x, m.y + r * n.y);
}

// |dq/dp| of the two deformations at h: 1/(1 - d.e), and 1 + d.e/(2 sqrt(1-k) (1 - d.e)).
FN Float deform_jacobian(int method, vec3 n, vec3 h) {
    LobePoint q = deform_linear_point(n, h);
    Float k = sqrt(max(q.s2, kTiny));
    Float de = (n.x * q.x + n.y * q.y) / k;
    // 1e-6: |d| -> 1, a tilt of 90 degrees.
    Float low = max(Float(1) - de, Float(1e-6));
    if (method == kMethodDeformLinear) { return Float(1) / low; }
    Float root = sqrt(max(deform_rim_fraction(n, h), kTiny));
    return max(Float(1) + de / (Float(2) * root * low), Float(0));
}

// The image of base half vector m under a method (not for normal-map, which has none).
FN vec3 perturb_forward(Perturbation p, vec3 m) {
    vec3 h = m;
    if (p.method == kMethodDeformLinear) {
        h = deform_linear_forward(p.n, m);
    } else if (p.method == kMethodDeformSmooth) {
        h = deform_smooth_forward(p.n, m);
    } else if (method_moves_facets(p.method)) {
        h = normalize(facet_moved(p.method, p.n, m));
    } else {
        h = frame_to_outer(frame_for_sampling(p), m);
    }
    return h;
}

// The half vector of the base lobe's pole, where the perturbed lobe is highest; slope-shift, whose density changes
// within the lobe, is highest up to a width of the lobe squared beside it. normal-map reads the unperturbed axes, whose
// components vanish at the unperturbed normal: its highlight stays there but for less than the lobe's
// width, where the factor of the cosine to n~ grows faster than the lobe falls.
FN vec3 lobe_peak(Perturbation p) {
    vec3 pole = vec3(Float(0), Float(0), Float(1));
    vec3 peak = pole;
    if (p.method != kMethodNone && p.method != kMethodNormalMap) { peak = perturb_forward(p, pole); }
    return peak;
}
