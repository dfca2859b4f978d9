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
