// Half vectors of a distribution as directions of the cosine's: a map m -> u, u.z > 0, under which D(m) m.z dm becomes
// u.z du / pi. Polygons of u then integrate in closed form. The map of GGX is linear (the slopes over the alphas),
// which is what makes GGX a linearly transformed cosine of half vectors (Heitz et al. 2016). Those of the others
// stretch the slopes further: the share of half vectors beyond a slope is the same before and after. Exact for
// GGX, Beckmann and Ashikhmin-Shirley; Ward's distribution lacks a factor of the cosine. docs/theory/area-lights.md.

// Farther out there is no light, and exp(40) squared, as edges take it, is still a number in single precision.
CONSTANT(kMostCosineMapExponent, 40.0)

// The logarithm of the share of half vectors beyond the slope of q, negated.
FN Float cosine_map_exponent(Lobe lobe, LobePoint q) {
    if (lobe.mdf == kMdfAshikhminShirley || lobe.mdf == kMdfWard) { q = lobe_point_unit(q); }
    Float x = q.x / lobe.p0;
    Float y = q.y / lobe.p1;
    Float xy = x * x + y * y;
    Float g = Float(0);
    if (lobe.mdf == kMdfAshikhminShirley) {
        Float e = ashikhmin_shirley_exponent(lobe.p0, lobe.p1, q.x, q.y);
        g = -(e + Float(2)) * log_cosine(q.s2, q.z);
    } else if (lobe.mdf == kMdfWard) {
        g = Float(2) * xy / (Float(1) + q.z);
    } else {
        g = xy * slope_inverse_z2(q);
    }
    return min(g, kMostCosineMapExponent);
}

// Not unit.
FN vec3 cosine_from_half(Lobe lobe, LobePoint q) {
    Float x = q.x / lobe_alpha_x(lobe);
    Float y = q.y / lobe_alpha_y(lobe);
    vec3 u = vec3(x, y, q.z);
    if (lobe.mdf != kMdfGgx) {
        Float g = cosine_map_exponent(lobe, q);
        // e^g - 1 without cancellation: below 1e-3 g + g^2/2 is within 2e-7 of it.
        Float square = choose(g < Float(1e-3), g + Float(0.5) * g * g, exp(g) - Float(1));
        Float scale = sqrt(square / max(x * x + y * y, kTiny));
        u = vec3(x * scale, y * scale, Float(1));
    }
    return u;
}

// The half vector of u, unit; u.z > 0.
FN vec3 half_from_cosine(Lobe lobe, vec3 u) {
    Float x = lobe_alpha_x(lobe) * u.x;
    Float y = lobe_alpha_y(lobe) * u.y;
    vec3 m = vec3(x, y, u.z);
    if (lobe.mdf != kMdfGgx) {
        Float g = min(log((u.x * u.x + u.y * u.y) / max(u.z * u.z, kTiny) + Float(1)), kMostCosineMapExponent);
        Float flat2 = max(x * x + y * y, kTiny);
        // Of the slope: 1/alpha^2 in the direction of (x, y).
        Float k = (u.x * u.x + u.y * u.y) / flat2;
        Float z = Float(1);
        if (lobe.mdf == kMdfAshikhminShirley) {
            z = exp(-g / (ashikhmin_shirley_exponent(lobe.p0, lobe.p1, x, y) + Float(2)));
        } else if (lobe.mdf == kMdfWard) {
            // 0.01: where the distribution ends at the horizon.
            z = max(Float(1) - g / (Float(2) * max(k, kTiny)), Float(0.01));
        } else {
            z = Float(1) / sqrt(Float(1) + g / max(k, kTiny));
        }
        Float beyond = sqrt(max((Float(1) - z) * (Float(1) + z), Float(0)) / flat2);
        m = vec3(x * beyond, y * beyond, z);
    }
    return m * (Float(1) / sqrt(max(dot(m, m), kTiny)));
}
