// What a point of a surface sees of its surroundings (docs/theory/visibility.md): the share of every direction
// that the scene blocks, as a function on the sphere, and the light that comes from what blocks it.
// Directions unit, in world space.

// A function on the sphere by its real spherical harmonics up to band 3. They are normalized to a mean
// square of 1, so that a coefficient is the mean of the function times its harmonic.
struct Harmonics {
    Float mean;  // band 0
    vec3 x1;     // band 1: x, y, z
    vec3 x2;     // band 2: xy, yz, zx
    vec2 y2;     // band 2: z^2, x^2 - y^2
    vec3 x3;     // band 3: x (5 z^2 - 1), y (5 z^2 - 1), z (5 z^2 - 3)
    vec3 y3;     // band 3: xyz, y (3 x^2 - y^2), x (x^2 - 3 y^2)
    Float z3;    // band 3: z (x^2 - y^2)
};

// The harmonics at w.
FN Harmonics harmonics_at(vec3 w) {
    Float xx = w.x * w.x;
    Float yy = w.y * w.y;
    Float five = Float(5) * w.z * w.z;
    Harmonics h;
    h.mean = Float(1);
    h.x1 = w * Float(1.7320508);                                        // sqrt(3)
    h.x2 = vec3(w.x * w.y, w.y * w.z, w.z * w.x) * Float(3.8729833);    // sqrt(15)
    h.y2 = vec2((Float(3) * w.z * w.z - Float(1)) * Float(1.1180340),   // sqrt(5)/2
                (xx - yy) * Float(1.9364917));                          // sqrt(15)/2
    Float outer = (five - Float(1)) * Float(1.6201852);                 // sqrt(42)/4
    h.x3 = vec3(w.x * outer, w.y * outer,
                w.z * (five - Float(3)) * Float(1.3228757));            // sqrt(7)/2
    h.y3 = vec3(w.x * w.y * w.z * Float(10.2469508),                    // sqrt(105)
                w.y * (Float(3) * xx - yy) * Float(2.0916501),          // sqrt(70)/4
                w.x * (xx - Float(3) * yy) * Float(2.0916501));
    h.z3 = w.z * (xx - yy) * Float(5.1234754);                          // sqrt(105)/2
    return h;
}

FN Float harmonics_product(Harmonics a, Harmonics b) {
    return a.mean * b.mean + dot(a.x1, b.x1) + dot(a.x2, b.x2) + a.y2.x * b.y2.x + a.y2.y * b.y2.y +
           dot(a.x3, b.x3) + dot(a.y3, b.y3) + a.z3 * b.z3;
}

// The share of the light from w that is blocked, in [0, 1].
FN Float blocked_towards(Harmonics blocked, vec3 w) {
    return clamp(harmonics_product(blocked, harmonics_at(w)), Float(0), Float(1));
}

// The cosine-weighted mean of the blocked share over the hemisphere about n: what a diffuse surface loses
// under constant light. A clamped cosine over pi passes the bands 0 to 3 times 1, 2/3, 1/4 and 0 (Ramamoorthi
// and Hanrahan 2001).
FN Float blocked_about(Harmonics blocked, vec3 n) {
    Harmonics h = harmonics_at(n);
    Float band1 = dot(blocked.x1, h.x1);
    Float band2 = dot(blocked.x2, h.x2) + blocked.y2.x * h.y2.x + blocked.y2.y * h.y2.y;
    return clamp(blocked.mean + band1 * Float(2) / Float(3) + band2 / Float(4), Float(0), Float(1));
}

// The mean direction, weighted by the cosine to n, from which light is not blocked; not unit, 0 where none is.
// Of bands 0 and 1: the integrals of w cos, w_n^2 cos and w_t^2 cos over the hemisphere are 2 pi/3 n, pi/2 and
// pi/4.
FN vec3 open_direction(Harmonics blocked, vec3 n) {
    vec3 slope = blocked.x1 * Float(1.7320508);
    Float along = dot(slope, n);
    return n * (max((Float(1) - blocked.mean) * Float(2) / Float(3) - along / Float(2), Float(0))) -
           (slope - n * along) * Float(0.25);
}

// The light from what blocks the view: radiance `color` (1 + slope.w) towards direction w. `sky`: the ratio of the
// irradiance of the vertex by the environment, with the shadows of its bright parts, to what open_direction gives.
struct Surroundings {
    vec3 color;
    vec3 slope;
    Float sky;
};

FN vec3 surroundings_towards(Surroundings s, vec3 w) {
    return s.color * max(Float(1) + dot(s.slope, w), Float(0));
}

// The cosine-weighted mean of the light from what blocks the hemisphere about n, `share` of it: about the
// direction 2/3 n, the mean of the hemisphere.
FN vec3 surroundings_about(Surroundings s, Float share, vec3 n) {
    return surroundings_towards(s, n * (Float(2) / Float(3))) * share;
}
