#include "verify/process_plate.hpp"

namespace burnish::verify {
namespace {

vec3 without(vec3 v, vec3 n) {
    return f64::normalize(v - n * f64::dot(n, v));
}

// v turned by the rotation that takes z to n the shortest way, by Rodrigues' formula.
vec3 turned(vec3 v, vec3 n) {
    const vec3 axis = f64::cross(vec3{0, 0, 1}, n);
    const double sine = f64::length(axis);
    if (sine == 0) return v;
    const vec3 k = axis * (1 / sine);
    return v * n.z + f64::cross(k, v) * sine + k * (f64::dot(k, v) * (1 - n.z));
}

// Grooves keep the shadow that they throw on the plate.
SurfaceMap embossed(const Subject& s, vec3 n) {
    SurfaceMap m;
    m.z = n;
    if (f64::lobe_grooves_along_x(s.mdf, s.p0, s.p1)) {
        m.x = f64::normalize(vec3{1, 0, -n.x / n.z});
        m.y = f64::cross(n, m.x);
    } else {
        m.y = f64::normalize(vec3{0, 1, -n.y / n.z});
        m.x = f64::cross(m.y, n);
    }
    return m;
}

bool moves_facets(int method) {
    return method == f64::kMethodSlopeShift || method == f64::kMethodStretch;
}

bool masks(int brdf) {
    return brdf == f64::kBrdfMicrofacet || brdf == f64::kBrdfMicrofacetSeparable;
}

const f64::Perturbation& flat() {
    static const f64::Perturbation p = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
    return p;
}

// Of an orthonormal map: the unperturbed model in the axes that the plate has now.
Radiance turned_plate(const Subject& s, const SurfaceMap& m, vec3 wo) {
    const auto local = [m](vec3 w) {
        return vec3{f64::dot(m.x, w), f64::dot(m.y, w), f64::dot(m.z, w)};
    };
    const f64::SurfaceMaterial material = material_of(s);
    return [=](vec3 wi) {
        return f64::specular_eval(material, flat(), f64::no_lobe_values(), local(wi), local(wo)) *
               std::max(f64::dot(m.z, wi), 0.0);
    };
}

// docs/theory/processes.md: D by P2, masking by P4.
Radiance moved_plate(const Subject& s, const SurfaceMap& m, vec3 wo) {
    const vec3 across = f64::cross(m.x, m.y);
    const double volume = f64::dot(across, m.z), area = f64::length(across);
    const vec3 n = across * (1 / area);
    const f64::Lobe lobe = f64::lobe_make(s.mdf, s.p0, s.p1);
    const bool separable = s.brdf == f64::kBrdfMicrofacetSeparable;
    // w by the vectors that x, y and z have become: the inverse of the map.
    const auto seen = [=](vec3 w) {
        return vec3{f64::dot(f64::cross(m.y, m.z), w), f64::dot(f64::cross(m.z, m.x), w),
                    f64::dot(across, w)} *
               (1 / volume);
    };
    return [=](vec3 wi) {
        const double cos_o = f64::dot(n, wo);
        if (!(f64::dot(n, wi) > 0 && cos_o > 0)) return 0.0;
        const vec3 h = f64::normalize(wi + wo);
        const vec3 q{f64::dot(m.x, h), f64::dot(m.y, h), f64::dot(m.z, h)};
        if (!(q.z > 0)) return 0.0;
        const double l = f64::length(q);
        const double D =
            f64::lobe_D(lobe, flat(), q * (1 / l)) * volume * volume / (l * l * l * l * area);
        const double G = separable ? f64::smith_G1(lobe, seen(wi)) * f64::smith_G1(lobe, seen(wo))
                                   : f64::smith_G2(lobe, seen(wi), seen(wo));
        return D * G / (4 * cos_o);
    };
}

}  // namespace

f64::SurfaceMaterial material_of(const Subject& s) {
    // ks below 0: a lobe of albedo 1 head-on. (-1, -1, 1): Lafortune's lobe about the mirror direction.
    return f64::surface_material(s.brdf, f64::lobe_make(s.mdf, s.p0, s.p1), -1.0, {-1, -1, 1}, 1.0);
}

SurfaceMap process_of(const Subject& s, vec3 n) {
    SurfaceMap m;
    const vec3 x{1, 0, 0}, y{0, 1, 0};
    switch (s.method) {
        case f64::kMethodNone:
            return m;
        case f64::kMethodGramSchmidt:
            m.x = without(x, n);
            return {m.x, f64::cross(n, m.x), n};
        case f64::kMethodRotateExact:
        case f64::kMethodRotateApprox:
            m.y = without(y, n);
            return {f64::cross(m.y, n), m.y, n};
        case f64::kMethodRotateArc:
            return {turned(x, n), turned(y, n), n};
        case f64::kMethodSlopeShift:
            return {{1, 0, -n.x / n.z}, {0, 1, -n.y / n.z}, {0, 0, 1}};
        case f64::kMethodStretch:
            return {{1, 0, -n.x / n.z}, {0, 1, -n.y / n.z}, n};
        default:
            return embossed(s, n);
    }
}

bool has_process_plate(const Subject& s) {
    return masks(s.brdf) || !moves_facets(s.method);
}

Radiance process_plate(const Subject& s, vec3 n, vec3 wo) {
    const SurfaceMap m = process_of(s, n);
    return moves_facets(s.method) ? moved_plate(s, m, wo) : turned_plate(s, m, wo);
}

}  // namespace burnish::verify
