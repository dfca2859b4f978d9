// A quantity behind the picture as a color (SurfaceView of burnish/render_settings.hpp). Included after
// shade.glsl.

uniform int u_view;  // kView... below

const int kViewNormal = 1;
const int kViewPerturbedNormal = 2;
const int kViewTangent = 3;
const int kViewGrain = 4;
const int kViewAlphaX = 5;
const int kViewAlphaY = 6;
const int kViewTilt = 7;
const int kViewTextureCoordinates = 8;
const int kViewSlopeVariance = 9;
const int kViewNotFinite = 10;
const int kViewHighlightError = 11;

// The largest angle that the view of the highlight error tells apart.
const float kMostHighlightError = 0.78539816;  // 45 degrees

// Linear color that a display encodes to `encoded`.
vec3 shown_as(vec3 encoded) {
    vec3 c = clamp(encoded, 0.0, 1.0);
    return vec3(linear_from_srgb(c.r), linear_from_srgb(c.g), linear_from_srgb(c.b));
}

// From dark blue (0) by blue-green to light yellow (1): lightness rises all the way, so that the
// scale reads in gray and to color-blind eyes.
vec3 color_of_number(float number) {
    float x = clamp(number, 0.0, 1.0) * 3.0;
    vec3 low = mix(vec3(0.10, 0.07, 0.28), vec3(0.13, 0.36, 0.55), clamp(x, 0.0, 1.0));
    vec3 high = mix(vec3(0.24, 0.66, 0.53), vec3(0.98, 0.95, 0.60), clamp(x - 2.0, 0.0, 1.0));
    return shown_as(mix(low, high, clamp(x - 1.0, 0.0, 1.0)));
}

vec3 color_of_vector(vec3 v) { return shown_as(0.5 + 0.5 * v); }

// A hue that returns after half a turn, as grooves do; gray where nothing is anisotropic.
vec3 color_of_grain(Shading m) {
    float ax = lobe_alpha_x(m.surface.lobe);
    float ay = lobe_alpha_y(m.surface.lobe);
    float strength = abs(ax - ay) / max(ax + ay, 1e-6);
    float c2 = m.direction.x * m.direction.x - m.direction.y * m.direction.y;
    float s2 = 2.0 * m.direction.x * m.direction.y;
    vec2 twice = m.grooves_along_x ? vec2(c2, s2) : -vec2(c2, s2);
    // cos(2 a - k 120 degrees) for red, green, blue.
    vec3 hue = vec3(twice.x, -0.5 * twice.x + 0.8660254 * twice.y, -0.5 * twice.x - 0.8660254 * twice.y);
    return shown_as(0.5 + 0.5 * sqrt(strength) * hue);
}

vec3 color_of_place(vec2 uv) {
    vec2 unit = fract(uv);
    vec2 whole = floor(uv);
    float odd = mod(whole.x + whole.y, 2.0);
    return shown_as(vec3(unit, 0.15 + 0.35 * odd));
}

float slope_deviation(Surface s, Shading m) {
#if defined(HAS_NORMAL_MAP) && defined(NORMAL_MOMENTS)
    vec4 texel = MAP_AT(u_normal_map, 2);
    vec2 variance = variance_about(m.n, texel.zw, u_normal_scale);
    return sqrt(max(max(variance.x, variance.y), 0.0));
#else
    return 0.0;
#endif
}

vec3 radiance_of(Surface s, Shading m, Frame a) {
#ifdef CLOTH
    return emission_at(s) + reflected_by_cloth(s, m, a);
#elif defined(TABULATED)
    return emission_at(s) + reflected_by_texels(s, m, a);
#else
    return emission_at(s) + reflected(s, m, a);
#endif
}

vec3 color_of_finiteness(vec3 radiance) {
    float sum = radiance.r + radiance.g + radiance.b;
    bool finite = sum >= -3e38 && sum <= 3e38;  // false for NaN
    return finite ? shown_as(vec3(0.25)) : vec3(1.0, 0.0, 1.0);
}

vec3 surface_view(Surface s) {
    Shading m = shading_at(s);
#ifdef MASK
    if (m.alpha < u_alpha_cutoff) { discard; }
#endif
    Frame a = surface_frame(s.normal, s.tangent.xyz, s.tangent.w, s.front ? 1.0 : -1.0, s.to_eye);
    if (u_view == kViewNotFinite) { return color_of_finiteness(radiance_of(s, m, a)); }
    vec2 place = s.uv.xy;
#ifdef CLOTH
    put_yarn(m, cloth_place(s).at);
#elif defined(TABULATED)
    put_texel(m, floor(tabulated_uv(s) * vec2(textureSize(u_tabulated_texels, 0))));
#endif
    Frame lobe = a;
    Perturbation p = facing_perturbation(s, m, lobe);
    if (u_view == kViewNormal) { return color_of_vector(a.n); }
    if (u_view == kViewPerturbedNormal) { return color_of_vector(frame_to_outer(lobe, p.n)); }
    if (u_view == kViewTangent) { return color_of_vector(a.t); }
    if (u_view == kViewTilt) { return color_of_number(length(p.n.xy)); }
    if (u_view == kViewTextureCoordinates) { return color_of_place(place); }
    if (u_view == kViewSlopeVariance) { return color_of_number(slope_deviation(s, m)); }
    if (u_view == kViewHighlightError) {
        float angle = acos(clamp(dot(lobe_peak(p), p.n), -1.0, 1.0));
        return color_of_number(angle / kMostHighlightError);
    }
#ifdef TABULATED
    return shown_as(vec3(0.5));  // a table has neither axes nor roughness
#else
    if (u_view == kViewGrain) { return color_of_grain(m); }
    return color_of_number(u_view == kViewAlphaX ? lobe_alpha_x(m.surface.lobe)
                                                 : lobe_alpha_y(m.surface.lobe));
#endif
}
