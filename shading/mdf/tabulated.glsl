// Distributions given as tables: src/scene/ndf_grid.hpp has their layout. Whoever has the tables looks
// values up; here is where, and what the BRDF k_s F D / (4 g(i) g(o)) makes of them. The perturbation
// is that of every lobe: D is read at perturb_point, g at perturb_direction.

// atan(y / x) in quarter turns, 0 to 1, of x and y that are not negative; 0 of two zeros. A minimax
// polynomial of our own, 7e-7 relative: every texel of every pixel takes six of these, and an atan of all
// quadrants is dearer.
FN Float quarter_turns(Float x, Float y) {
    Float t = min(x, y) / max(max(x, y), kTiny);
    Float w = t * t;
    Float high = -Float(0.0858621275) +
                 w * (Float(0.0533940592) + w * (-Float(0.023563209) + w * Float(0.00500598128)));
    Float low = Float(0.636619357) + w * (-Float(0.212163183) + w * (Float(0.126569448) + w * high));
    Float near = t * low;
    return choose(y > x, Float(1) - near, near);
}

// u = sqrt(2 theta / pi). From sine and cosine: near the pole a cosine alone knows nothing. Under
// normal-map the elevation is about n~ and the azimuth about n, as K11 Eq 2 has it.
FN Float tabulated_u(LobePoint q) {
    return sqrt(quarter_turns(max(q.z, Float(0)), sqrt(max(q.s2, Float(0)))));
}

// The azimuth in turns, 0 to 1; 0 at the pole.
FN Float tabulated_turns(Float x, Float y) {
    Float a = quarter_turns(abs(x), abs(y));
    a = choose(x < Float(0), Float(2) - a, a);
    return Float(0.25) * choose(y < Float(0), Float(4) - a, a);
}

// Where areas are stored: s = sqrt(1 - 2 theta / pi), 0 at the horizon and below.
FN Float tabulated_s(vec3 w) {
    Float rise = quarter_turns(sqrt(w.x * w.x + w.y * w.y), max(w.z, Float(0)));
    return sqrt(rise);
}

// |w| g(w/|w|) from what is stored, `more` = g - z. Frames that are not of unit rows (normal-map,
// rotate-approx) give longer or shorter w, and a Smith G1 asks for their ratios only: with
// G1 = z/g and z = n~.w, G1(i) G1(o) / (n~.i n~.o) = 1 / (|i| g |o| g).
FN Float tabulated_area(Float more, vec3 w) {
    Float l = length(w);
    // 1e-6: as ndf_area_lookup.
    return max(w.z + more * l, Float(1e-6) * l);
}

// Areas of tabulated_area; without Fresnel and colour. 0 where wi or wo is below the perturbed horizon.
FN Float tabulated_brdf(Float D, Float area_i, Float area_o, Float cos_i, Float cos_o) {
    Float f = min(D / max(Float(4) * area_i * area_o, kTiny), kMostValue);
    return choose(cos_i > Float(0) && cos_o > Float(0), f, Float(0));
}

// One normal over another: slopes add.
FN vec3 tabulated_normal(vec3 below, vec3 above) {
    return normalize(vec3(below.x * above.z + above.x * below.z,
                          below.y * above.z + above.y * below.z, below.z * above.z));
}
