// A reference for directions that a normal map makes invalid, for the study of
// docs/theory/invalid-directions.md. Double precision, in the unperturbed tangent space; unit vectors.
#pragma once

#include <algorithm>
#include <cmath>

#include "burnish/f64.hpp"

namespace burnish::test {

using f64::vec3;

// Schuessler, Heitz, Hanika & Dachsbacher, "Microfacet-based Normal Mapping for Robust
// Monte Carlo Path Tracing", ACM TOG 36(6), 2017. The surface is made of facets with normal n~ and
// of mirrors that stand upright, against the tilt, so that the mean of both is the surface's
// normal. Light walks from facet to facet: what travels along -w meets n~'s facet with the share of
// its area (two_facets_share) and is scattered by the material, or a mirror and is turned by it; it
// leaves along w with two_facets_masking(w), else it meets the next one.
struct TwoFacets {
    vec3 n;        // n~
    vec3 upright;  // the normal of the mirrors: horizontal, against the tilt of n~
    double sine;   // of the tilt
};

inline TwoFacets two_facets_make(vec3 n) {
    TwoFacets f;
    f.n = n;
    f.sine = std::sqrt(n.x * n.x + n.y * n.y);
    double scale = -1.0 / std::max(f.sine, f64::kTiny);
    f.upright = f.sine > f64::kTiny ? vec3(n.x * scale, n.y * scale, 0.0) : vec3(-1.0, 0.0, 0.0);
    return f;
}

// Projected areas that w sees of the facets (x) and of the mirrors (y), times n~z.
inline f64::vec2 two_facets_areas(TwoFacets f, vec3 w) {
    return f64::vec2(std::max(f64::dot(f.n, w), 0.0),
                     f.sine * std::max(f64::dot(f.upright, w), 0.0));
}

// Share of the facets in what w sees; the rest is mirrors.
inline double two_facets_share(TwoFacets f, vec3 w) {
    f64::vec2 a = two_facets_areas(f, w);
    return a.x / std::max(a.x + a.y, f64::kTiny);
}

// Share of what a facet or mirror sends along w that leaves the surface.
inline double two_facets_masking(TwoFacets f, vec3 w) {
    f64::vec2 a = two_facets_areas(f, w);
    return std::min(std::max(w.z, 0.0) * f.n.z / std::max(a.x + a.y, f64::kTiny), 1.0);
}

inline vec3 two_facets_mirrored(TwoFacets f, vec3 w) {
    return w - f.upright * (2.0 * f64::dot(f.upright, w));
}

}  // namespace burnish::test
