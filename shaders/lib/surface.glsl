// A point of a surface from rasterization.

struct Surface {
    vec3 position;    // world space
    vec3 to_eye;      // unit
    vec3 normal;      // interpolated, not unit
    vec4 tangent;     // interpolated; w: sign of the bitangent, including mirrored transforms
    vec4 uv;          // set 0 in xy, set 1 in zw; one transformed set in xy unless UV_PER_TEXTURE
    float footprint;  // log2 of the pixel's size on uv.xy (FOOTPRINT_GIVEN only)
#if defined(FOOTPRINT_GIVEN) && defined(TABULATED)
    vec4 shape;  // of the pixel on uv.xy: step to the right in xy, upwards in zw
#endif
    vec4 color;  // vertex color
#ifdef VISIBILITY
    Harmonics blocked;
    Surroundings around;
#endif
    bool front;
    uvec2 pixel;  // in the whole picture, independent of the tile
};
