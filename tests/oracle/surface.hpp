// What a material means, derived a second time: what texels, lights and tone maps stand for and
// what a surface reflects, diffuse and specular together.
//
// Sources: glTF 2.0, KHR_materials_anisotropy, KHR_lights_punctual, IEC 61966-2-1, Narkowicz 2015,
// Khronos PBR Neutral 1.0, Lagarde & de Rousiers 2014, docs/theory/papers.md for the methods. As in
// oracle.hpp, everything is literal, slow, in `long double` and shares no code with `shading/` or
// `src/`.
#pragma once

#include <array>
#include <string>

#include "oracle.hpp"

namespace burnish::oracle {

// ---------------------------------------------------------------- display

long double srgb_encoded(long double linear);
long double srgb_decoded(long double encoded);
// name: linear reinhard aces khronos-neutral.
Vec3 tone_mapped(const std::string& name, Vec3 color);

// ---------------------------------------------------------------- texels

// The normal of a texel with channels in [0, 1] and the scale of its x and y; tilts along an axis
// end at atan(1/0.03). One that does not point out of the surface is (0, 0, 1).
Vec3 normal_of_texel(Vec3 texel, long double scale_x, long double scale_y);

// How far the unit normal of slopes (x, y) = (n.x/n.z, n.y/n.z) moves, squared, per squared step of
// the slope along x and along y: by differences.
std::array<long double, 2> normal_motion(long double slope_x, long double slope_y);

// The unit direction of an anisotropy texel (red, green) rotated by `angle`, through angles.
std::array<long double, 2> stretch(long double red, long double green, long double angle);

// ---------------------------------------------------------------- lights

// Irradiance of a surface that faces a light of unit intensity at distance d; range 0: unbounded.
long double attenuation(long double d, long double range);
// The factor of a spot at `angle` from its axis; inner and outer cone angles.
long double cone(long double angle, long double inner, long double outer);

// ---------------------------------------------------------------- reflectance

// Unpolarised, eta + i k against air, by complex amplitudes.
long double conductor(long double eta, long double k, long double cosine);

// {normal, pole, pole2, c0, c1, c2} as FresnelCurve of shading/ names them.
long double fresnel_curve(std::array<long double, 6> terms, long double cosine);

long double specular_occlusion(long double occlusion, long double cos_o, long double alpha);

// (1 - F(n.i)) (1 - F(n.o)) / pi with Schlick's F.
long double diffuse(long double f0, long double cos_i, long double cos_o);

// The specular term without Fresnel, per steradian, under a perturbed normal n: "ggx",
// "ggx-separable", "beckmann" (alpha_x, alpha_y); "ashikhmin-shirley" (e_x, e_y); "ward-gmd",
// "ward", "ward-duer", "cook-torrance" (alpha_x, alpha_y); "phong" (ks, n); "lafortune" (ks, Cx,
// Cy, Cz, n). D is that of mdf_eval (D_conserving), masking is that of mdf_transform's directions,
// the deformations' that of rotate-arc. 0 below the horizon of n, or for none of (0, 0, 1).
long double specular(const std::string& brdf, std::array<long double, 5> p,
                     const std::string& method, Vec3 n, Vec3 i, Vec3 o);

// Bilinear reading of values at rings u = (r + 1/2)/rings, azimuths 2 pi a/columns, held beyond the
// first and the last ring, in the direction (theta, phi) with u = sqrt(2 theta/pi).
long double table_value(const double* table, int rings, int columns, long double theta,
                        long double phi);

}  // namespace burnish::oracle
