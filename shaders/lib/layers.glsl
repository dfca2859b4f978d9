// What layers do to light: the loops over lights and the light of the environment call these functions, which do
// nothing where there are no layers. shading/surface/layers.glsl is the rest.

// Light reflected, times the cosines. Only the horizon of n~ counts, and for a coat that of its own normal.
vec3 reflected_cos(Shading m, Perturbation p, vec3 wi, vec3 wo) {
#ifdef LAYERS
    return layered_eval(m.surface, m.layers, m.seen, p, lobe_values(m, p, wi, wo), wi, wo);
#else
    return surface_eval(m.surface, p, lobe_values(m, p, wi, wo), wi, wo) * max(dot(p.n, wi), 0.0);
#endif
}

// What is left of the specular term of `color` for light from wi.
vec3 specular_left(Shading m, Perturbation p, vec3 color, vec3 wi) {
#ifdef LAYERS
    return layers_over_specular(m.layers, color, layers_seen(m.layers, p.n, wi), m.seen);
#else
    return vec3(1.0);
#endif
}

// The same where one direction stands for the lobe: that of a mirror.
vec3 mirror_left(Shading m, Perturbation p, vec3 wo) {
#ifdef LAYERS
    vec3 color = specular_color(m.surface, max(dot(p.n, wo), 0.0));
    return specular_left(m, p, color, reflect_about(wo, p.n));
#else
    return vec3(1.0);
#endif
}

// What is left of the diffuse term under light from everywhere.
vec3 diffuse_left(Shading m) {
#ifdef LAYERS
    return layers_over_irradiance(m.layers, m.surface.diffuse, m.seen);
#else
    return vec3(1.0);
#endif
}

#ifdef COAT_NORMAL_MAP
Frame frame_of(Surface s);
#endif

#ifdef COAT
// The coat with its normal against the axes `a`, turned to the eye.
CoatLayer coat_facing(Shading m, Surface s, Frame a, vec3 wo) {
#ifdef COAT_NORMAL_MAP
    vec3 n = frame_to_local(a, frame_to_outer(frame_of(s), m.coat_n));
    return coat_turned(m.layers.coat, normal_facing(n, wo));
#else
    return m.layers.coat;
#endif
}
#endif

// What leaves of light that the surface emits, which goes through the coat once.
vec3 emission_left(Shading m, Surface s, Frame a) {
#ifdef COAT
    vec3 wo = frame_to_local(a, s.to_eye);
    CoatLayer coat = coat_facing(m, s, a, wo);
    return coat_share(coat, coat_seen(coat, wo).through);
#else
    return vec3(1.0);
#endif
}

#ifdef LAYERS
// Turns the coat's normal into the axes `a` of the lobe below it and towards the eye. Before anything else is asked.
void lay_over(inout Shading m, Surface s, Frame a, Perturbation p, vec3 wo) {
#ifdef COAT
    m.layers.coat = coat_facing(m, s, a, wo);
#endif
    m.seen = layers_seen(m.layers, p.n, wo);
}

#if IMAGE_LIGHT > 0
#if IMAGE_LIGHT == 1
// A layer is smooth, or very wide: it needs fewer samples than an anisotropic lobe.
const int kSamplesALayerSample = 4;

int layer_samples() { return max(u_image_samples / kSamplesALayerSample, 1); }

vec3 layer_radiance(Surface s, Frame a, vec3 wi, float pdf, int samples) {
    float total = u_total_samples * float(samples) / float(u_image_samples);
    vec3 towards = frame_to_outer(a, wi);
    float lod = environment_lod(1.0 / (total * max(pdf, kTiny)));
    return seen_radiance(s, towards, environment_radiance(towards, lod));
}
#endif

#ifdef COAT
vec3 coat_image(Surface s, Shading m, Frame a, vec3 wo) {
    CoatLayer coat = m.layers.coat;
#if IMAGE_LIGHT == 1
    Rotation rotation = rotation_of_pixel(s.pixel, u_seed + 2u);
    int samples = layer_samples();
    vec3 sum = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        float pdf;
        vec3 wi = coat_sample(coat, wo, point_of(u_frame * uint(samples) + uint(i), rotation), pdf);
        float weight = coat_eval(coat, wi, wo) / max(pdf, kTiny);
        vec3 term = layer_radiance(s, a, wi, pdf, samples) * weight;
        sum += pdf > 0.0 ? finite_radiance(term) : vec3(0.0);
    }
    return sum / float(samples);
#else
    vec3 towards = frame_to_outer(a, reflect_about(wo, coat.at.n));
    // Within the plane of incidence the lobe is as wide as alpha, across it by the cosine narrower: the look-up is as
    // wide as their mean.
    float alpha2 = coat.lobe.p0 * coat.lobe.p0 * max(dot(coat.at.n, wo), 0.0);
    vec3 radiance =
        lobe_radiance(environment_direction(towards), lobe_lod(alpha2));
    return seen_radiance(s, towards, radiance * u_environment_scale) *
           (coat.cover * m.seen.coat.albedo);
#endif
}
#endif

#ifdef SHEEN
vec3 sheen_image(Surface s, Shading m, Frame a, Perturbation p, vec3 wo) {
    SheenLayer sheen = m.layers.sheen;
#if IMAGE_LIGHT == 1
    Rotation rotation = rotation_of_pixel(s.pixel, u_seed + 3u);
    int samples = layer_samples();
    vec3 sum = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        float pdf;
        vec3 wi = sheen_sample(p.n, point_of(u_frame * uint(samples) + uint(i), rotation), pdf);
        LayersSeen seen = layers_seen(m.layers, p.n, wi);
        vec3 f = sheen_eval(sheen, seen.sheen, m.seen.sheen, p.n, wi, wo);
#ifdef COAT
        f *= coat_over_diffuse(m.layers.coat, sheen.color, seen.coat, m.seen.coat);
#endif
        sum += finite_radiance(layer_radiance(s, a, wi, pdf, samples) * f / pdf);
    }
    return sum / float(samples);
#else
    // Wide: light from the hemisphere about a direction between the normal and the horizon beyond it.
    vec3 n = normalize(p.n + reflect_about(wo, p.n));
    vec3 f = sheen.color * min(m.seen.sheen.albedo, 1.0);
#ifdef COAT
    f *= coat_over_irradiance(m.layers.coat, sheen.color, m.seen.coat);
#endif
    return seen_irradiance(s, frame_to_outer(a, n)) * f;
#endif
}
#endif

// The light of the environment that the layers reflect themselves.
vec3 layers_image(Surface s, Shading m, Frame a, Perturbation p, vec3 wo) {
    vec3 sum = vec3(0.0);
#ifdef COAT
    float open = 1.0;
#ifdef HAS_OCCLUSION_MAP
    float occlusion = occlusion_left(s, frame_to_outer(a, m.layers.coat.at.n), occlusion_at(s));
    open = specular_occlusion(occlusion, max(dot(m.layers.coat.at.n, wo), 0.0), m.layers.coat.lobe);
#endif
    sum += coat_image(s, m, a, wo) * open;
#endif
#ifdef SHEEN
    sum += sheen_image(s, m, a, p, wo) * occlusion_left(s, frame_to_outer(a, p.n), occlusion_at(s));
#endif
    return sum;
}
#endif
#endif
