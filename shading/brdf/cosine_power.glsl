// Lobes cos^n about an axis, for phong and lafortune: narrow ones (n to 1e6) without losing their
// core to rounding, and their sampling.

// 1 - exp(-t), t >= 0.
FN Float one_minus_exp(Float t) {
    // 0.01: the next term, t^5/120, is 1e-10 of the sum.
    Float series = t * (Float(1) - t / Float(2) * (Float(1) - t / Float(3) * (Float(1) - t / Float(4))));
    return choose(t < Float(0.01), series, Float(1) - exp(-t));
}

// cos^n of the angle between unit vectors; 0 from 90 degrees on. From the chord, not the dot
// product, whose rounding n would multiply.
FN Float cosine_power(vec3 a, vec3 b, Float n) {
    vec3 chord = a - b;
    Float d2 = dot(chord, chord);
    Float cosine = dot(a, b);
    Float s2 = max(d2 * (Float(1) - Float(0.25) * d2), Float(0));
    Float value = exp(n * log_cosine(s2, cosine));
    return choose(cosine > Float(0), value, Float(0));
}

// (n + 1)/(2 pi) cos^n: the density of cosine_power_sample.
FN Float cosine_power_pdf(vec3 axis, vec3 w, Float n) {
    return (n + Float(1)) / (Float(2) * kPi) * cosine_power(axis, w, n);
}

// Orthonormal rows about any unit axis: the shortest arc on the upper hemisphere, mirrored below.
FN Frame frame_about(vec3 axis) {
    Frame f = frame_shortest_arc(vec3(axis.x, axis.y, abs(axis.z)));
    Float side = choose(axis.z < Float(0), -Float(1), Float(1));
    f.t = vec3(f.t.x, f.t.y, side * f.t.z);
    f.b = vec3(f.b.x, f.b.y, side * f.b.z);
    f.n = axis;
    return f;
}

FN vec3 cosine_power_sample(vec3 axis, Float n, vec2 xi) {
    Float t = -log(max(Float(1) - xi.y, kTiny)) / (n + Float(1));
    Float z = exp(-t);
    Float s = sqrt(max(one_minus_exp(Float(2) * t), Float(0)));
    Float psi = Float(2) * kPi * xi.x;
    return frame_to_outer(frame_about(axis), vec3(s * cos(psi), s * sin(psi), z));
}

// Lambert's law about z.
FN vec3 cosine_sample(vec2 xi) {
    Float s = sqrt(xi.y);
    Float psi = Float(2) * kPi * xi.x;
    return vec3(s * cos(psi), s * sin(psi), sqrt(max(Float(1) - xi.y, Float(0))));
}

FN Float cosine_pdf(Float cosine) {
    return max(cosine, Float(0)) / kPi;
}
