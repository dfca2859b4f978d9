// Coat and sheen, derived a second time: literal, slow, in `long double`; shares no code with `shading/` or `src/`.
//
// Sources: KHR_materials_clearcoat (index 1.5, GGX, Schlick), Walter et al. 2007 (GGX), Heitz 2014 (correlated Smith),
// Snell and Beer for the way through the coat, Stokes 1862 for the light that goes to and fro, Estevez & Kulla 2017
// and KHR_materials_sheen for the sheen, KHR_materials_specular for the interface.
#pragma once

#include <array>

#include "oracle.hpp"

namespace burnish::oracle {

// f of the coat's face about normal n, alpha the square of its roughness, without the cosine.
long double coat_face(long double alpha, Vec3 n, Vec3 i, Vec3 o);
// Int f cos over the hemisphere, seen at `cosine` from the normal, by quadrature over the normals of facets.
long double coat_albedo(long double alpha, long double cosine);
// What is left along a way at `cosine` outside, of a coat that lets `tint` through along its normal and back.
long double coat_absorption(long double tint, long double cosine);
// Light that goes through a coat to a base that reflects `r` and back, with all that goes to and fro between them:
// the series, term by term. `e`: what the coat's face sends back; `t_i`, `t_o`: what passes.
long double to_and_fro(long double r, long double e, long double t_i, long double t_o);

// f of a white sheen without the cosine, by the extension's formulas with the masking of the paper.
long double sheen(long double alpha, Vec3 n, Vec3 i, Vec3 o);
long double sheen_albedo(long double alpha, long double cosine);

// KHR_materials_specular: F of the dielectric at cosine to the half vector.
long double dielectric_fresnel(long double ior, long double color, long double weight,
                               long double cosine);

}  // namespace burnish::oracle
