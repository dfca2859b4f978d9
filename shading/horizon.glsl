// Directions that a strong normal map makes invalid: a view or a light below the horizon of the
// perturbed normal n~ or of the surface. What is done about them and why: docs/theory/invalid-directions.md.
// Everything in the unperturbed tangent space; unit vectors, n~z > 0, wo.z > 0.

// How near to n~'s horizon a view may come before n~ is turned towards it: 84.3 degrees.
CONSTANT(kFacingCosine, 0.1)

// Real time: n~ turned towards wo, in their common plane, so that it faces it. The new cosine
// c' = c for c >= t, t/2 + c^2/(2 t) for 0 < c < t, t/2 below is continuously differentiable; with
// t = min(kFacingCosine, wo.z) an unperturbed normal is never turned, whatever the view.
FN vec3 normal_facing(vec3 n, vec3 wo) {
    Float c = dot(n, wo);
    // 1e-4: cosines of interpolated normals at silhouettes reach 0 and below.
    Float t = max(min(kFacingCosine, wo.z), Float(1e-4));
    Float low = max(c, Float(0));
    Float facing = Float(0.5) * (t + low * low / t);
    vec3 across = n - wo * c;
    // c > -1 because n.z and wo.z are positive; the guard is for wo.z <= 0.
    Float scale = sqrt((Float(1) - facing * facing) / max(dot(across, across), Float(1e-12)));
    return choose(c < t, normalize(wo * facing + across * scale), n);
}

// The reference: Schuessler, Heitz, Hanika & Dachsbacher, "Microfacet-based Normal Mapping for Robust
// Monte Carlo Path Tracing", ACM TOG 36(6), 2017. The surface is made of facets with normal n~ and of
// mirrors that stand upright, against the tilt, so that the mean of both is the surface's normal.
// Light walks from facet to facet: what travels along -w meets n~'s facet with the share of its area
// (two_facets_share) and is scattered by the material, or a mirror and is turned by it; it leaves
// along w with two_facets_masking(w), else it meets the next one.
struct TwoFacets {
    vec3 n;        // n~
    vec3 upright;  // the normal of the mirrors: horizontal, against the tilt of n~
    Float sine;    // of the tilt
};

FN TwoFacets two_facets_make(vec3 n) {
    TwoFacets f;
    f.n = n;
    f.sine = sqrt(n.x * n.x + n.y * n.y);
    Float scale = Float(-1) / max(f.sine, kTiny);
    f.upright = choose(f.sine > kTiny, vec3(n.x * scale, n.y * scale, Float(0)),
                       vec3(Float(-1), Float(0), Float(0)));
    return f;
}

// Projected areas that w sees of the facets (x) and of the mirrors (y), times n~z.
FN vec2 two_facets_areas(TwoFacets f, vec3 w) {
    return vec2(max(dot(f.n, w), Float(0)), f.sine * max(dot(f.upright, w), Float(0)));
}

// Share of the facets in what w sees; the rest is mirrors.
FN Float two_facets_share(TwoFacets f, vec3 w) {
    vec2 a = two_facets_areas(f, w);
    return a.x / max(a.x + a.y, kTiny);
}

// Share of what a facet or mirror sends along w that leaves the surface.
FN Float two_facets_masking(TwoFacets f, vec3 w) {
    vec2 a = two_facets_areas(f, w);
    return min(max(w.z, Float(0)) * f.n.z / max(a.x + a.y, kTiny), Float(1));
}

FN vec3 two_facets_mirrored(TwoFacets f, vec3 w) {
    return w - f.upright * (Float(2) * dot(f.upright, w));
}
