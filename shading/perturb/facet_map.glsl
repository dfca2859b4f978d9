// The two methods that move the facets of a lobe by a linear map L, h along L m, because the process that made the
// bumps moves the surface by L^-T (docs/theory/processes.md): slope-shift adds the slope of the bump to that of every
// facet, stretch takes facets along with the tangents of the displaced surface. Scaled so that the normal of the
// plate becomes n~, unit: the density of half vectors is D0(q/|q|)/(|q|^4 det L), q = L^-1 h.

// A plain bool: the batched maths has registers for Bool.
FN bool method_moves_facets(int method) {
    return method == kMethodSlopeShift || method == kMethodStretch;
}

// Cosines of the tilt below it are taken to be this one: 1/cosine^3 still fits single precision beside any lobe. Normal
// maps end at 0.02 (surface/normal.glsl).
CONSTANT(kLeastFacetCosine, 1e-3)

// The rows of L^-1.
FN Frame facet_map_inverse(int method, vec3 n) {
    Float s = Float(1) / max(n.z, kLeastFacetCosine);
    Frame rows;
    rows.t = vec3(Float(1), Float(0), -n.x * s);
    rows.b = vec3(Float(0), Float(1), -n.y * s);
    rows.n = n;
    if (method == kMethodSlopeShift) {
        rows.t = rows.t * s;
        rows.b = rows.b * s;
        rows.n = vec3(Float(0), Float(0), s);
    }
    return rows;
}

// 1/det L; 0 where n~ points into the plate, which no bump does.
FN Float facet_map_gain(int method, vec3 n) {
    Float s = Float(1) / max(n.z, kLeastFacetCosine);
    Float gain = s;
    if (method == kMethodSlopeShift) { gain = s * s * s; }
    return choose(n.z > Float(0), gain, Float(0));
}

// L m, not unit.
FN vec3 facet_moved(int method, vec3 n, vec3 m) {
    vec3 moved = vec3(m.x, m.y, Float(0));
    if (method == kMethodSlopeShift) {
        moved = moved * max(n.z, kLeastFacetCosine) + n * m.z;
    } else {
        moved = moved + n * (m.z - (n.x * m.x + n.y * m.y));
    }
    return moved;
}

// L^T w, not unit: the area that facets m show to w is that of L m, so that the unmoved lobe seen from here is masked
// as the moved one is seen from w. Its z is n~.w.
FN vec3 facet_view(int method, vec3 n, vec3 w) {
    Float z = dot(n, w);
    vec3 v = vec3(w.x - n.x * z, w.y - n.y * z, z);
    if (method == kMethodSlopeShift) {
        Float shrink = max(n.z, kLeastFacetCosine);
        v = vec3(w.x * shrink, w.y * shrink, z);
    }
    return v;
}
