// Woven cloth (CLOTH) at a point: shading/surface/weave.glsl over the draft's cells. CLOTH_COLORS:
// yarns of one family differ in color. Slot 0 of every pair is the weft, 1 the warp.
// docs/theory/cloth.md.

uniform highp usampler2D u_weave_cells;  // the bits of src/maps/weave/weave_cells.hpp, a texel a cell
uniform sampler2D u_weave_weft;  // coverage of a family: rgb color times coverage, a coverage
uniform sampler2D u_weave_warp;
uniform float u_weave_yarns;  // across the texture square
uniform vec3 u_weave_shape;   // crimp, bulge, gap
uniform vec2 u_weave_twist;   // (cos, sin) of the angle from a yarn to its fibers
uniform vec3 u_weave_colors[2];
uniform float u_weave_filter;  // 0: the mean over cells is never used

// Position in yarn spacings, and log2 of the pixel's size in yarn spacings.
struct ClothPlace {
    vec2 at;
    float size;
};

ClothPlace cloth_place(Surface s) {
    ClothPlace place;
    // v runs down the texture square. The first pick lies at its bottom, and picks follow one another
    // along the bitangent, which points up.
    place.at = vec2(s.uv.x, 1.0 - s.uv.y) * u_weave_yarns;
#ifdef FOOTPRINT_GIVEN
    place.size = s.footprint + log2(u_weave_yarns) + u_lod_bias;
#else
    vec2 dx = dFdx(place.at);
    vec2 dy = dFdy(place.at);
    place.size = 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), kTiny)) + u_lod_bias;
#endif
    return place;
}

// 0.5: keeps the quotient of whole numbers from being rounded below an integer.
ivec2 cloth_cell(vec2 whole) {
    vec2 repeat = vec2(textureSize(u_weave_cells, 0));
    vec2 turns = floor((whole + 0.5) / repeat);
    return ivec2(clamp(whole - repeat * turns, vec2(0.0), repeat - 1.0));
}

WeavePoint cloth_point(vec2 at, out ivec2 cell) {
    vec2 whole = floor(at);
    cell = cloth_cell(whole);
    int bits = int(texelFetch(u_weave_cells, cell, 0).r);
    WeaveShape shape;
    shape.crimp = u_weave_shape.x;
    shape.bulge = u_weave_shape.y;
    shape.gap = u_weave_shape.z;
    shape.twist = u_weave_twist;
    return weave_point(weave_cell_of_bits(bits), shape, at.x - whole.x - 0.5, at.y - whole.y - 0.5);
}

vec3 cloth_color(WeavePoint point, ivec2 cell) {
#ifdef CLOTH_COLORS
    vec4 weft = texelFetch(u_weave_weft, cell, 0);
    vec4 warp = texelFetch(u_weave_warp, cell, 0);
    vec4 here = mix(weft, warp, point.warp);
    return here.rgb / max(here.a, 1e-6);
#else
    return mix(u_weave_colors[0], u_weave_colors[1], point.warp);
#endif
}

// Changes `m`, the material of the cloth, to that of the yarn at a point. Returns the coverage: 0
// in a hole.
float put_yarn(inout Shading m, vec2 at) {
    ivec2 cell;
    WeavePoint point = cloth_point(at, cell);
    m.base_color *= cloth_color(point, cell);
    put_colors(m);
    m.direction = point.fiber;
    m.n = point.n;
    return point.cover;
}
