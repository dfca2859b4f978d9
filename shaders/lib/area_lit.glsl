// Surfaces under lights with an area. AREA_SAMPLED: lobes without a map to the cosine (tables, distributions that a
// normal map does not move) are lit by points of the light instead, others in every frame, so that stills converge.

#ifdef AREA_SAMPLED
uniform uint u_area_frame;
uniform uint u_area_seed;
const int kAreaPoints = 4;  // a light and frame

// Radiance from light i: points of the light as even as an R2 sequence.
vec3 lit_by_area_points(int i, AreaLight light, Shading m, Perturbation p, vec3 wo, Rotation rotation, uint first) {
    vec3 normal = cross(light.x, light.y);
    // 1e-3: a point nearer to the light than a thousandth of its side would be brighter than any mean.
    float area = 4.0 * length(normal);
    float near2 = 1e-6 * area;
    vec3 sum = vec3(0.0);
    for (int k = 0; k < kAreaPoints; ++k) {
        vec2 place = 2.0 * point_of(first + uint(k), rotation) - 1.0;
        if (area_shape(i) == kAreaDisc) { place = disc_place(place); }
        vec3 to = area_corner(light, place);
        float d2 = max(dot(to, to), near2);
        vec3 wi = to * inversesqrt(d2);
        float solid = abs(dot(normalize(normal), wi)) * area / d2;
        vec3 f = reflected_cos(m, p, wi, wo);
#ifdef AREA_TEXTURES
        f *= area_texture(i, light, wi, 0.0);
#endif
        sum += f * solid;
    }
    float share = area_shape(i) == kAreaDisc ? kPi / 4.0 : 1.0;
    return sum * (light.lit * share / float(kAreaPoints));
}
#endif

vec3 lit_by_area_lights(Surface s, Shading m, Frame a, Perturbation p, vec3 wo) {
    vec3 sum = vec3(0.0);
#ifdef AREA_SAMPLED
    Rotation rotation = rotation_of_pixel(s.pixel, u_area_seed);
#else
    AreaLobe lobe = area_lobe(m.surface, p, wo);
#ifdef LAYERS
    AreaLobe coat = lobe;
#ifdef COAT
    coat = area_lobe(coat_surface(m.layers.coat), m.layers.coat.at, wo);
#endif
#endif
#ifdef AREA_TEXTURES
    float width = area_lobe_width(lobe);
#endif
#endif
    for (int i = 0; i < AREA_COUNT; ++i) {
        AreaLight light = area_light_at(i, s.position, a);
        vec3 radiance = u_area_radiance[i].rgb;
        radiance *= area_reaches(i, s.position, a.n);
#ifdef AREA_SAMPLED
        uint first = u_area_frame * uint(kAreaPoints);
#ifdef TABULATED
        first = (u_area_frame * uint(m.taps) + uint(m.tap)) * uint(kAreaPoints);
#endif
        sum += radiance * lit_by_area_points(i, light, m, p, wo, rotation, first);
#else
        AreaReflection r = area_reflection(m.surface, p, lobe, light, area_shape(i), wo);
#ifdef LAYERS
        r = area_layered(r, m.surface, m.layers, m.seen, p, coat, light, area_shape(i), wo);
#endif
#ifdef AREA_TEXTURES
        // The lobe's width at the distance of the light; of the diffuse term a cosine's.
        float distance = length(light.middle);
        r.specular *= area_texture(i, light, r.towards_specular, width * distance);
        r.diffuse *= area_texture(i, light, r.towards_diffuse, distance);
#endif
        sum += radiance * (r.specular + r.diffuse);
#endif
    }
    return sum;
}
