// The axes of a surface point as a Frame (t tangent, b bitangent, n geometric normal; unit, in world
// space), and directions in the plane as (cos, sin).

// `direction` of b as seen from axes along a: the angles are added.
FN vec2 direction_added(vec2 a, vec2 b) {
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

// Directions that cancel under filtering leave less than the step of an 8-bit texel: no direction.
CONSTANT(kLeastDirection2, 1e-4)

// The direction of an anisotropy texel (red, green in [0, 1]) rotated by `rotation`. Texels that hold
// no direction are taken to point along the tangent.
FN vec2 stretch_direction(vec2 texel, vec2 rotation) {
    Float x = texel.x * Float(2) - Float(1);
    Float y = texel.y * Float(2) - Float(1);
    Float l2 = x * x + y * y;
    Bool known = l2 > kLeastDirection2;
    Float scale = Float(1) / sqrt(max(l2, kLeastDirection2));
    return direction_added(vec2(choose(known, x * scale, Float(1)), choose(known, y * scale, Float(0))),
                           rotation);
}

// The frame rotated counter-clockwise about n to `direction` (unit).
FN Frame frame_rotated(Frame f, vec2 direction) {
    Frame r;
    r.t = f.t * direction.x + f.b * direction.y;
    r.b = f.b * direction.x - f.t * direction.y;
    r.n = f.n;
    return r;
}

// `w` against axes that are rotated so.
FN vec3 seen_from_rotated(vec3 w, vec2 direction) {
    return vec3(w.x * direction.x + w.y * direction.y, w.y * direction.x - w.x * direction.y, w.z);
}

// Orthonormal axes from the interpolated normal and tangent. `handedness`: negative where the bitangent
// is mirrored (tangent.w, mirroring transforms counted in). `side`: -1 on back faces, which show the sheet
// from behind: the whole frame is turned over, so that a dent is a bump there. `to_eye`: unit.
FN Frame surface_frame(vec3 normal, vec3 tangent, Float handedness, Float side, vec3 to_eye) {
    Frame f;
    // kTiny: a zero normal (three normals that cancel) becomes the zero vector, bent to the eye below.
    vec3 n = normal * (side * (Float(1) / sqrt(max(dot(normal, normal), kTiny))));
    // An interpolated normal may look away from the eye at silhouettes, where no model is defined: it
    // is bent until the eye is above the horizon. 1e-4 rad is below a tenth of a pixel on any sphere.
    Float below = max(Float(1e-4) - dot(n, to_eye), Float(0));
    f.n = normalize(n + to_eye * below);
    vec3 t = tangent * side;
    t = t - f.n * dot(f.n, t);
    // kTiny: tangent_or_any leaves no vertex without one, but two may cancel between vertices.
    f.t = t * (Float(1) / sqrt(max(dot(t, t), kTiny)));
    f.b = cross(f.n, f.t) * choose(handedness * side < Float(0), -Float(1), Float(1));
    return f;
}

// The perturbation of a surface point: `n` against the surface's frame, `stretch` from its tangent to
// the lobe's x axis, `wo` against the frame rotated so. The normal is turned until it faces the eye.
FN Perturbation surface_perturbation(int method, vec3 n, vec2 stretch, Bool grooves_along_x,
                                     Bool conserving, vec3 wo) {
    return perturb_make(method, normal_facing(seen_from_rotated(n, stretch), wo), grooves_along_x,
                        conserving);
}
