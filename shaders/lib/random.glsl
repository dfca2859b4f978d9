// Low-discrepancy points with a separate rotation for every pixel. All arithmetic is in 32-bit
// integers modulo 1, so that points are as evenly distributed at index 10^6 as at index 0.

// C. Wellons, "Hash function prospector" (lowbias32).
uint hash_of(uint x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

// A Cranley-Patterson rotation: one offset per coordinate.
struct Rotation {
    uint x;
    uint y;
    uint z;
};

Rotation rotation_of_pixel(uvec2 pixel, uint seed) {
    Rotation r;
    r.x = hash_of(pixel.x ^ hash_of(pixel.y ^ hash_of(seed)));
    r.y = hash_of(r.x + 0x9e3779b9u);
    r.z = hash_of(r.y + 0x9e3779b9u);
    return r;
}

// The upper 24 bits, which a float represents exactly, as a number in [0, 1). Through int: see
// pack.glsl.
float unit_of(uint bits) {
    return float(int(bits >> 8)) * (1.0 / 16777216.0);
}

// Point `index` of the R2 sequence (Roberts 2018: multiples of 1/g and 1/g^2, g^3 = g + 1).
vec2 point_of(uint index, Rotation r) {
    return vec2(unit_of(index * 3242174889u + r.x), unit_of(index * 2447445414u + r.y));
}

// A third coordinate: multiples of sqrt(7), which correlate neither with those nor with a lattice.
float select_of(uint index, Rotation r) {
    return unit_of(index * 2773480763u + r.z);
}

// The same beside lattices, whose point i stays within its cell in all frames: the frames of one cell are spread by
// the golden ratio. An index that counted on from frame to frame would give a cell of 16 points three values.
float select_of(uint frame, uint i, Rotation r) {
    return unit_of(frame * 2654435769u + i * 2773480763u + r.z);
}
