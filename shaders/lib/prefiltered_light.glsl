// The specular term under the environment by a few look-ups of the lobe map along the major axis of
// the reflected lobe. docs/theory/image-light.md derives it and tabulates its error.
//
// Half vectors are base vectors m mapped by the method. Base vectors are those of GGX visible from
// wo. In the space where the lobe is a hemisphere they are the bisectors of w, the view, and points
// c that cover the cap c.z > -w.z uniformly (Dupuy & Benyoub 2023). A look-up is a point of the cap
// on the line through its middle that the reflection stretches most.

// Number of look-ups, each an equal share of the lobe; the largest distance of a look-up from the
// middle of the cap, relative to its rim; and the ratio of the width of a look-up to the width of
// the lobe across the axis. The latter two are fitted on spheres under two real environments
// (docs/theory/image-light.md). A round look-up is narrower than the lobe, because neighbors would
// otherwise blur along the axis.
const int kLookUps = 7;
const float kReach = 0.95;
const float kWidth = 0.6;

// Energy factor of the method at a half vector: f cos dwi of the deformed lobe divided by that of
// the rotated lobe, for which the albedo table holds. Base vectors are drawn in proportion to
// (go.m) D(m) dm; the deformed lobe reflects D(m) (wo.h) dh.
float energy_at(MappedHalf at, Perturbation p, vec3 go, float wo_h) {
    if (!method_deforms(p.method)) { return 1.0; }
    float det = deform_jacobian(p.method, p.n, at.h);
    // 0.05, 4: limits at grazing angles.
    float area = at.m.z / (max(at.h.z, 0.05) * max(det, 0.05));
    return p.conserve * clamp(wo_h / max(dot(go, at.m), 0.05) * area, 0.0, 4.0);
}

// Scalar product of the derivatives of wi / 2 that the derivatives a and b of the half vector
// cause: d wi / 2 = (wo.a) h + (wo.h) a.
float reflected_dot(vec3 wo, float wo_h, vec3 a, vec3 b) {
    return dot(wo, a) * dot(wo, b) + wo_h * wo_h * dot(a, b);
}

// The line through the middle of the cap: its direction, and the extent of the look-ups along it,
// relative to a lobe without a minor axis.
struct MajorAxis {
    vec2 along;
    float spread;
};

MajorAxis major_axis(vec3 wo, vec3 h, vec3 dx, vec3 dy) {
    float wo_h = dot(wo, h);
    float xx = reflected_dot(wo, wo_h, dx, dx);
    float xy = reflected_dot(wo, wo_h, dx, dy);
    float yy = reflected_dot(wo, wo_h, dy, dy);
    float middle = 0.5 * (xx + yy);
    float half_difference = 0.5 * (xx - yy);
    float reach = sqrt(half_difference * half_difference + xy * xy);
    float cosine = half_difference / max(reach, kTiny);
    float side = sqrt(max(0.5 - 0.5 * cosine, 0.0));
    MajorAxis axis;
    axis.along = vec2(sqrt(max(0.5 + 0.5 * cosine, 0.0)), xy < 0.0 ? -side : side);
    axis.spread = sqrt(clamp(2.0 * reach / max(middle + reach, kTiny), 0.0, 1.0));
    return axis;
}

// Rotations: look-ups are computed in the rotated axes, where h = m.
vec3 image_specular(Surface s, Shading m, Frame a, Perturbation p, vec3 wo) {
    Lobe lobe = lobe_for_sampling(m.surface.lobe, p);
    float ax = lobe_alpha_x(lobe);
    float ay = lobe_alpha_y(lobe);
    LobeMapping map = mapping_of(p);
    vec3 v = vec3(dot(map.x, wo), dot(map.y, wo), dot(map.z, wo));
    vec3 go = method_turns(p.method) ? v : perturb_direction(p, wo);
    Frame axes = a;
    if (method_turns(p.method)) {
        axes.t = frame_to_outer(a, map.x);
        axes.b = frame_to_outer(a, map.y);
        axes.n = frame_to_outer(a, map.z);
        map.x = vec3(1.0, 0.0, 0.0);
        map.y = vec3(0.0, 1.0, 0.0);
        map.z = vec3(0.0, 0.0, 1.0);
    }
    vec3 eye = method_turns(p.method) ? v : wo;
    // Without masking all normals count, visible or not.
    vec3 w = brdf_masks(BRDF) ? normalize(vec3(ax * v.x, ay * v.y, v.z)) : vec3(0.0, 0.0, 1.0);
    MappedHalf middle = mapped_half(map, p, vec3(ax * w.x, ay * w.y, 1.0 + w.z));
    MajorAxis axis = major_axis(eye, middle.h, half_turn(middle, map, p, vec3(ax, 0.0, 0.0)),
                                half_turn(middle, map, p, vec3(0.0, ay, 0.0)));
    vec3 across = vec3(-ax * axis.along.y, ay * axis.along.x, 0.0);
    Frame world = axes;
    axes.t = environment_direction(axes.t);
    axes.b = environment_direction(axes.b);
    axes.n = environment_direction(axes.n);
    float masking = 1.0 + smith_lambda(lobe, go);
    vec3 sum = vec3(0.0);
    float energy = 0.0;
    for (int i = 0; i < kLookUps; ++i) {
        float place = (float(2 * i + 1) / float(kLookUps) - 1.0) * (kReach * axis.spread);
        float area = place * place;
        // z = 1 - (1 + w.z) area; sqrt(1 - z^2) = place sqrt((1 + w.z) (1 + z)).
        float fall = (1.0 + w.z) * area;
        float r = place * sqrt(max((1.0 + w.z) * (2.0 - fall), 0.0));
        vec3 base = vec3(ax * (r * axis.along.x + w.x), ay * (r * axis.along.y + w.y),
                         1.0 - fall + w.z);
        MappedHalf at = mapped_half(map, p, base);
        float wo_h = dot(eye, at.h);
        vec3 wi = at.h * (2.0 * wo_h) - eye;
        vec3 turn = half_turn(at, map, p, across);
        // The cap is scaled here by 2 cos(half the angle from its middle) relative to a unit step.
        float blur2 = reflected_dot(eye, wo_h, turn, turn) * (1.0 - area) * (2.0 + 2.0 * w.z);
        vec3 gi = method_turns(p.method) ? wi : perturb_direction(p, wi);
        float share = brdf_masks(BRDF) ? masking / (masking + smith_lambda(lobe, gi))
                              : min(gi.z / max(go.z, 1e-3), 1.0);
        share = gi.z > 0.0 && wo_h > 0.0 ? share : 0.0;
        vec3 radiance = lobe_radiance(frame_to_outer(axes, wi), lobe_lod(kWidth * kWidth * blur2));
        radiance = seen_radiance(s, frame_to_outer(world, wi), radiance * u_environment_scale);
        sum += specular_color(m.surface, wo_h) * radiance * (share * energy_at(at, p, go, wo_h));
        energy += share;
    }
    // 1e-3: below the share of any look-up when the view is above the horizon.
    float scale = albedo_at(albedo_place_of(m.surface.lobe, p, wo)) / max(energy, 1e-3);
    return dot(p.n, wo) > 0.0 ? sum * scale : vec3(0.0);
}
