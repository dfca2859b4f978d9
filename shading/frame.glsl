// Frames of tangent space and the words for directions in them. All vectors unit unless said.

CONSTANT(kPi, 3.14159265358979323846)

// Smaller than any length, square or weight that matters, and still normal when 1/kTiny is taken in
// single precision.
CONSTANT(kTiny, 1e-30)

struct Frame {
    vec3 t;
    vec3 b;
    vec3 n;
};

FN vec3 frame_to_local(Frame f, vec3 w) {
    return vec3(dot(f.t, w), dot(f.b, w), dot(f.n, w));
}

FN vec3 frame_to_outer(Frame f, vec3 v) {
    return f.t * v.x + f.b * v.y + f.n * v.z;
}

FN vec3 reflect_about(vec3 w, vec3 h) {
    return h * (Float(2) * dot(w, h)) - w;
}

// T projected on the plane of n, B = n x T. Singular only at n = +-e_x.
FN Frame frame_keep_tangent(vec3 n) {
    Float s = sqrt(max(n.y * n.y + n.z * n.z, kTiny));
    Float y = n.y * (Float(1) / s);
    Float z = n.z * (Float(1) / s);
    Frame f;
    f.t = vec3(s, -n.x * y, -n.x * z);
    f.b = vec3(Float(0), z, -y);
    f.n = n;
    return f;
}

// B projected, T = B x n: K12 Eq 4, and the push-forward of the tangent. Singular only at +-e_y.
FN Frame frame_keep_bitangent(vec3 n) {
    Float s = sqrt(max(n.x * n.x + n.z * n.z, kTiny));
    Float x = n.x * (Float(1) / s);
    Float z = n.z * (Float(1) / s);
    Frame f;
    f.t = vec3(z, Float(0), -x);
    f.b = vec3(-x * n.y, s, -n.y * z);
    f.n = n;
    return f;
}

// The shortest rotation from e_z to n: no preferred axis. Singular only at n = -e_z.
FN Frame frame_shortest_arc(vec3 n) {
    Float c = Float(1) / max(Float(1) + n.z, kTiny);
    Frame f;
    f.t = vec3(Float(1) - n.x * n.x * c, -n.x * n.y * c, -n.x);
    f.b = vec3(-n.x * n.y * c, Float(1) - n.y * n.y * c, -n.y);
    f.n = n;
    return f;
}
