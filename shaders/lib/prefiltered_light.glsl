// The specular term under the environment by a few look-ups of the lobe map along the major axis of
// the reflected lobe. docs/image-light.md derives it and tabulates its error.
//
// Half vectors are base vectors m mapped by the method. Base vectors are those of GGX visible from wo:
// in the space where the lobe is a hemisphere they halve the angle between w, the view, and points c
// that fill the cap c.z > -w.z evenly (Dupuy & Benyoub 2023). A look-up is a point of the cap on the
// line through its middle that the reflection stretches most.

// Equal shares of the lobe. Fitted on spheres under two real environments (docs/image-light.md): how
// far towards the rim of the cap the outermost reach, and the width of what is read against that of the
// lobe beside the axis. A round lobe is narrower than it, or neighbours would blur along the axis.
const int kLookUps = 7;
const float kReach = 0.95;
const float kWidth = 0.6;

uniform sampler3D u_albedo;  // albedo_table.hpp

// The linear part of the map from base half vectors to half vectors: the columns of a matrix B, h along
// B m. Rotations turn; normal-map shears: x and y stay and n~.h takes the place of m.z.
struct LobeMapping {
    vec3 x;
    vec3 y;
    vec3 z;
};

LobeMapping mapping_of(Perturbation p) {
    LobeMapping map;
    if (p.method == kMethodNormalMap) {
        // 0.05: tilts of 87 degrees.
        float s = 1.0 / max(p.n.z, 0.05);
        map.x = vec3(1.0, 0.0, -p.n.x * s);
        map.y = vec3(0.0, 1.0, -p.n.y * s);
        map.z = vec3(0.0, 0.0, s);
    } else {
        Frame f = frame_for_sampling(p);
        map.x = f.t;
        map.y = f.b;
        map.z = f.n;
    }
    return map;
}

// Half vector (not unit) of base vector m (not unit).
vec3 mapped(LobeMapping map, Perturbation p, vec3 m) {
    if (p.method == kMethodDeformLinear || p.method == kMethodDeformSmooth) {
        return perturb_forward(p, normalize(m));
    }
    return map.x * m.x + map.y * m.y + map.z * m.z;
}

// The part of `v` perpendicular to the unit vector h.
vec3 beside(vec3 h, vec3 v) {
    return v - h * dot(h, v);
}

// a.b of the turns of the reflected direction, halved, that turns a and b of the half vector cause:
// d wi / 2 = (wo.a) h + (wo.h) a.
float reflected_dot(vec3 wo, float wo_h, vec3 a, vec3 b) {
    return dot(wo, a) * dot(wo, b) + wo_h * wo_h * dot(a, b);
}

// The line through the middle of the cap: its direction, and how far along it look-ups spread beside
// a lobe that has no minor axis.
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

// Albedo for a view v in the lobe's own space.
float albedo_towards(float ax, float ay, vec3 v) {
    float l = inversesqrt(max(dot(v, v), kTiny));
    float x2 = v.x * v.x;
    float y2 = v.y * v.y;
    float flat2 = max(x2 + y2, kTiny);
    float along2 = (ax * ax * x2 + ay * ay * y2) / flat2;
    float across2 = ax * ax + ay * ay - along2;
    vec3 place = vec3(sqrt(sqrt(vec2(along2, max(across2, 0.0)))), v.z * l);
    vec3 nodes = vec3(textureSize(u_albedo, 0));
    return textureLod(u_albedo, (clamp(place, 0.0, 1.0) * (nodes - 1.0) + 0.5) / nodes, 0.0).r;
}

// Rotations: the look-ups are worked out against the turned axes, where h = m.
bool turns(Perturbation p) {
    return p.method != kMethodNormalMap && p.method != kMethodDeformLinear &&
           p.method != kMethodDeformSmooth;
}

// The models with a Smith term.
bool masks() {
    return BRDF == kBrdfMicrofacet || BRDF == kBrdfMicrofacetSeparable;
}

vec3 image_specular(Surface s, Shading m, Axes a, Perturbation p, vec3 wo) {
    Lobe lobe = lobe_for_sampling(m.lobe, p);
    float ax = lobe_alpha_x(lobe);
    float ay = lobe_alpha_y(lobe);
    LobeMapping map = mapping_of(p);
    vec3 v = vec3(dot(map.x, wo), dot(map.y, wo), dot(map.z, wo));
    vec3 go = turns(p) ? v : perturb_direction(p, wo);
    Axes axes = a;
    if (turns(p)) {
        axes.x = from_axes(a, map.x);
        axes.y = from_axes(a, map.y);
        axes.z = from_axes(a, map.z);
        map.x = vec3(1.0, 0.0, 0.0);
        map.y = vec3(0.0, 1.0, 0.0);
        map.z = vec3(0.0, 0.0, 1.0);
    }
    vec3 eye = turns(p) ? v : wo;
    // Without masking all normals count, seen or not.
    vec3 w = masks() ? normalize(vec3(ax * v.x, ay * v.y, v.z)) : vec3(0.0, 0.0, 1.0);
    vec3 h = normalize(mapped(map, p, vec3(ax * w.x, ay * w.y, 1.0 + w.z)));
    MajorAxis axis = major_axis(eye, h, beside(h, map.x * ax), beside(h, map.y * ay));
    vec3 across = map.y * (ay * axis.along.x) - map.x * (ax * axis.along.y);
    axes.x = environment_direction(axes.x);
    axes.y = environment_direction(axes.y);
    axes.z = environment_direction(axes.z);
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
        vec3 hk = mapped(map, p, base);
        float scale = inversesqrt(max(dot(hk, hk), kTiny));
        hk *= scale;
        float wo_h = dot(eye, hk);
        vec3 wi = hk * (2.0 * wo_h) - eye;
        vec3 turn = beside(hk, across * scale);
        // The cap is 2 cos(half the angle from its middle) as wide here as a unit step.
        float blur2 = reflected_dot(eye, wo_h, turn, turn) * (1.0 - area) * (2.0 + 2.0 * w.z);
        vec3 gi = turns(p) ? wi : perturb_direction(p, wi);
        float share = masks() ? masking / (masking + smith_lambda(lobe, gi))
                              : min(gi.z / max(go.z, 1e-3), 1.0);
        share = gi.z > 0.0 && wo_h > 0.0 ? share : 0.0;
        vec3 radiance = lobe_radiance(from_axes(axes, wi), lobe_lod(kWidth * kWidth * blur2));
        sum += specular_fresnel(m, wo_h) * radiance * share;
        energy += share;
    }
    // 1e-3: less than any look-up's share where the view is above the horizon.
    float scale = albedo_towards(ax, ay, go) / max(energy, 1e-3);
    return dot(p.n, wo) > 0.0 ? sum * (scale * u_environment_scale) : vec3(0.0);
}
