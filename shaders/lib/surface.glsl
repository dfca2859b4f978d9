// A point of a surface as rasterisation gives it, and its axes.

struct Surface {
    vec3 position;    // world space
    vec3 to_eye;      // unit
    vec3 normal;      // interpolated, not unit
    vec4 tangent;     // interpolated; w: sign of the bitangent, mirrored transforms counted in
    vec4 uv;          // set 0 in xy, set 1 in zw; one transformed set in xy unless UV_PER_TEXTURE
    float footprint;  // log2 of the pixel's size on uv.xy (FOOTPRINT_GIVEN only)
#if defined(FOOTPRINT_GIVEN) && defined(TABULATED)
    vec4 shape;       // of the pixel on uv.xy: its step to the right in xy, upwards in zw
#endif
    vec4 color;       // vertex colour
    bool front;
    uvec2 pixel;      // in the whole picture, whatever the tile
};

struct Axes {
    vec3 x;
    vec3 y;
    vec3 z;
};

// Unit tangent, bitangent and geometric normal. A back face shows the sheet from behind: the whole
// frame is turned over, so that a dent is a bump there.
Axes surface_axes(Surface s, vec3 wo) {
    float side = s.front ? 1.0 : -1.0;
    Axes a;
    // kTiny: a zero normal (three normals that cancel) becomes the zero vector, bent to wo below.
    a.z = s.normal * (side * inversesqrt(max(dot(s.normal, s.normal), kTiny)));
    // An interpolated normal may look away from the eye at silhouettes, where no model is defined:
    // bend it until wo is above the horizon. 1e-4 is below a tenth of a pixel's turn on any sphere.
    float below = max(1e-4 - dot(a.z, wo), 0.0);
    a.z = normalize(a.z + wo * below);
    vec3 t = s.tangent.xyz * side;
    t = t - a.z * dot(a.z, t);
    // kTiny: surface.vert leaves no tangent without a direction, but two may cancel between vertices.
    a.x = t * inversesqrt(max(dot(t, t), kTiny));
    a.y = cross(a.z, a.x) * (s.tangent.w * side < 0.0 ? -1.0 : 1.0);
    return a;
}

// The axes turned counter-clockwise about z by the angle of `direction` (unit).
Axes turned(Axes a, vec2 direction) {
    Axes r;
    r.x = a.x * direction.x + a.y * direction.y;
    r.y = a.y * direction.x - a.x * direction.y;
    r.z = a.z;
    return r;
}

vec3 to_axes(Axes a, vec3 w) {
    return vec3(dot(a.x, w), dot(a.y, w), dot(a.z, w));
}

vec3 from_axes(Axes a, vec3 v) {
    return a.x * v.x + a.y * v.y + a.z * v.z;
}
