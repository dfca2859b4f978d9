// The points of a frame by which the light of the environment is sampled.

uniform int u_image_samples;
uniform uint u_frame;           // index of the sub-pixel sample in progress
uniform float u_total_samples;  // image samples of all frames
uniform uint u_seed;
uniform uint u_lattice_x;      // from one point of a frame to the next, in 2^-32
uniform uint u_lattice_y;
uniform vec4 u_lattice_cell;   // two edges of a cell between the points

// The points of a frame are a lattice (src/scene/light/point_lattice.hpp), the most even set of their
// number. The lattice of another frame is moved within its cell by a point of a sequence, so that all
// frames together are as evenly distributed as a single frame with all samples.
vec2 first_point(Rotation rotation) {
    Rotation none = Rotation(0u, 0u, 0u);
    vec2 within = point_of(u_frame, none);
    vec2 moved = within.x * u_lattice_cell.xy + within.y * u_lattice_cell.zw;
    // 2: an edge of the cell has no component below -1.
    return fract(vec2(unit_of(rotation.x), unit_of(rotation.y)) + moved + 2.0);
}

vec2 lattice_point(vec2 first, int i) {
    return fract(first + vec2(unit_of(uint(i) * u_lattice_x), unit_of(uint(i) * u_lattice_y)));
}
