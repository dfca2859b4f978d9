// Punctual lights as KHR_lights_punctual defines them: direction and falloff at a point.

struct LightAtPoint {
    vec3 wi;        // towards the light, unit
    Float falloff;  // irradiance per color times intensity, of a surface that faces the light
};

// Nothing is shaded closer to a light than a micrometer, squared.
CONSTANT(kLeastDistance2, 1e-12)

// (scale, offset) of the cone factor clamp(cos angle * scale + offset)^2, from the cosines of a spot's
// inner and outer angle. 0.001: as the extension has it.
FN vec2 spot_cone(Float cos_inner, Float cos_outer) {
    Float scale = Float(1) / max(cos_inner - cos_outer, Float(0.001));
    return vec2(scale, -cos_outer * scale);
}

// `place`: position, `placed` 1; or towards a directional light, `placed` 0. `axis`: the direction in
// which a spot shines; `cone`: of spot_cone, (0, 1) for lights without one. `inverse_range2`:
// 1/range^2, 0 for unbounded lights.
FN LightAtPoint light_at(vec3 place, Float placed, vec3 axis, vec2 cone, Float inverse_range2,
                         vec3 position) {
    vec3 to_light = place - position * placed;
    Float d2 = max(dot(to_light, to_light), kLeastDistance2);
    LightAtPoint l;
    l.wi = to_light * (Float(1) / sqrt(d2));
    Float reach = d2 * inverse_range2;
    Float window = clamp(Float(1) - reach * reach, Float(0), Float(1));
    Float spot = clamp(-dot(axis, l.wi) * cone.x + cone.y, Float(0), Float(1));
    l.falloff = window * spot * spot / d2;
    return l;
}
