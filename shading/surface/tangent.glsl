// A tangent of a vertex: t (unit or 0), or where it is missing or along the normal any direction
// perpendicular to it. Not unit. `normal`: unit or 0.
FN vec3 tangent_or_any(vec3 normal, vec3 t) {
    vec3 across = t - normal * dot(normal, t);
    vec3 spare = choose(abs(normal.x) < Float(0.5), vec3(Float(1), Float(0), Float(0)),
                        vec3(Float(0), Float(1), Float(0)));
    spare = spare - normal * dot(normal, spare);
    // 1e-10: 6e-4 degrees from the normal.
    return choose(dot(across, across) > Float(1e-10), t, spare);
}
