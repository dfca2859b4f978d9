// A quantity behind the picture as a color (SurfaceView of burnish/render_settings.hpp). Included after
// shade.glsl. FURNACE: the albedo, which display.frag shows as a color, because a mean of colors of noisy
// albedos is not the color of their mean.

#ifdef FURNACE

vec3 surface_view(Surface s) {
    return finite_radiance(reflected_by_surface(s, shading_of_visible(s), frame_of(s)));
}

#else

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
const int kViewMoments = 10;
const int kViewNotFinite = 12;
const int kViewHighlightError = 13;
const int kViewOpenness = 14;

// The largest angle that the view of the highlight error tells apart.
const float kMostHighlightError = 0.78539816;  // 45 degrees

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
    vec2 variance = variance_under(METHOD, m.n, texel.zw, u_normal_scale);
    return sqrt(max(max(variance.x, variance.y), 0.0));
#else
    return 0.0;
#endif
}

#if defined(HAS_NORMAL_MAP) && defined(NORMAL_MOMENTS)
uniform sampler2D u_slope_covariance;  // its mips lie over those of u_normal_map
#endif

// Moments of the slopes that the mip of the normal map covers. Red and green: the standard deviations
// along the tangent and the bitangent; blue: the root of the covariance, with its sign, from -1 to 1.
// All on a scale of square roots, on which a deviation of 0.01 is still seen.
vec3 color_of_moments(Surface s) {
    vec3 moments = vec3(0.0);
#if defined(HAS_NORMAL_MAP) && defined(NORMAL_MOMENTS)
    moments.xy = MAP_AT(u_normal_map, 2).zw * u_normal_scale * u_normal_scale;
    moments.z = MAP_AT(u_slope_covariance, 2).r * u_normal_scale.x * u_normal_scale.y;
#endif
    vec3 shown = sqrt(sqrt(abs(moments)));
    return shown_as(vec3(shown.xy, 0.5 + 0.5 * sign(moments.z) * shown.z));
}

vec3 color_of_finiteness(vec3 radiance) {
    float sum = radiance.r + radiance.g + radiance.b;
    bool finite = sum >= -3e38 && sum <= 3e38;  // false for NaN
    return finite ? shown_as(vec3(0.25)) : vec3(1.0, 0.0, 1.0);
}

vec3 surface_view(Surface s) {
    Shading m = shading_of_visible(s);
    Frame a = frame_of(s);
    if (u_view == kViewNotFinite) { return color_of_finiteness(emission_at(s) + reflected_by_surface(s, m, a)); }
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
    if (u_view == kViewMoments) { return color_of_moments(s); }
    if (u_view == kViewOpenness) {
#ifdef VISIBILITY
        return color_of_number(1.0 - blocked_about(s.blocked, frame_to_outer(lobe, p.n)));
#else
        return color_of_number(1.0);
#endif
    }
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

#endif
