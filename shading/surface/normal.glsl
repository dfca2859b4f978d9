// From what normal maps store to perturbed normals n~ and to variances of slopes. Normals are unit
// vectors of the tangent space (x tangent, y bitangent, z geometric normal).

// Normals are held to n.z >= 0.03 of the larger of |n.x| and |n.y|. The steepest tilt is thus
// atan(1/0.03) = 88.3 degrees along an axis: short of 90 degrees, where the frames of the methods are
// singular (perturb.glsl).
CONSTANT(kLeastNormalZ, 0.03)

// Not unit.
FN vec3 normal_held(vec3 v) {
    return vec3(v.x, v.y, max(v.z, kLeastNormalZ * max(abs(v.x), abs(v.y))));
}

// `slope_x` = n.x/n.z and `slope_y` = n.y/n.z: the negated slopes of the height.
FN vec3 normal_of_slopes(Float slope_x, Float slope_y) {
    return normalize(normal_held(vec3(slope_x, slope_y, Float(1))));
}

// (n.x/n.z, n.y/n.z) of a direction out of the surface, not necessarily unit: v.z > 0.
FN vec2 slopes_of_normal(vec3 v) {
    vec3 held = normal_held(v);
    Float inverse_z = Float(1) / held.z;
    return vec2(held.x * inverse_z, held.y * inverse_z);
}

// What a texel's channels in [0, 1] encode: 2 c - 1. Not unit.
FN vec3 vector_of_texel(vec3 texel) {
    return texel * Float(2) - vec3(Float(1), Float(1), Float(1));
}

// The same of two channels: z is what is left of 1.
FN vec3 vector_of_texel(vec2 texel) {
    Float x = texel.x * Float(2) - Float(1);
    Float y = texel.y * Float(2) - Float(1);
    return vec3(x, y, sqrt(max(Float(1) - (x * x + y * y), Float(0))));
}

// `v`: of vector_of_texel. `scale`: the map's strength along x and y; y negative where green points down.
// A v that does not point out of the surface (zero, NaN, v.z <= 0) gives the unperturbed normal.
FN vec3 normal_of_vector(vec3 v, vec2 scale) {
    v = choose(v.z > Float(0), v, vec3(Float(0), Float(0), Float(1)));
    return normalize(normal_held(vec3(v.x * scale.x, v.y * scale.y, v.z)));
}

// One normal over another: slopes add.
FN vec3 normal_over(vec3 below, vec3 above) {
    return normalize(vec3(below.x * above.z + above.x * below.z,
                          below.y * above.z + above.y * below.z, below.z * above.z));
}

// By how much the lobe about `n` is to be widened along the tangent and the bitangent, where the map's
// slopes vary by `variance` (docs/theory/normal-filtering.md): a step ds of the slope rotates n by ds nz^2 in the
// direction of the tilt and by ds nz across it, here resolved along the axes.
// At most 1: beyond, lobes of alpha > sqrt(2) all look alike, and it is the widest whose normaliser is
// accurate.
FN vec2 variance_about(vec3 n, vec2 variance, vec2 scale) {
    Float z2 = n.z * n.z;
    Float x = variance.x * scale.x * scale.x * z2 * (Float(1) - n.x * n.x);
    Float y = variance.y * scale.y * scale.y * z2 * (Float(1) - n.y * n.y);
    return vec2(min(x, Float(1)), min(y, Float(1)));
}

// The same of the lobe that `method` moves. Slopes add under slope-shift: the variance is that of the lobe's own slopes,
// as it is. stretch narrows facets by nz along the tilt, and a step of the slope moves them by ds nz in the lobe's.
FN vec2 variance_under(int method, vec3 n, vec2 variance, vec2 scale) {
    vec2 v = variance_about(n, variance, scale);
    if (method_moves_facets(method)) {
        Float z2 = method == kMethodStretch ? n.z * n.z : Float(1);
        v = vec2(min(variance.x * scale.x * scale.x * z2, Float(1)),
                 min(variance.y * scale.y * scale.y * z2, Float(1)));
    }
    return v;
}

// The variances along `direction` (unit) and across it; what varies together is not kept.
FN vec2 variance_along(vec2 variance, vec2 direction) {
    Float xx = direction.x * direction.x;
    Float yy = direction.y * direction.y;
    return vec2(variance.x * xx + variance.y * yy, variance.x * yy + variance.y * xx);
}

// The direction whose x and y are stored, held to the same tilt; not unit where it is steep.
FN vec3 vector_of_disk(Float x, Float y) {
    return vec3(x, y, max(sqrt(max(Float(1) - (x * x + y * y), Float(0))), kLeastNormalZ));
}
