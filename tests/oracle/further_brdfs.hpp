// The reflectance models beyond the microfacet ones: oracle::brdf_eval answers for these names too.
//
// Sources: Phong 1975, Ward 1992, Duer's form of it, Lafortune et al. 1997, Cook & Torrance 1982,
// Ashikhmin, Premoze & Shirley 2000, He, Torrance, Sillion & Greenberg 1991; normalisations and
// corrections as in docs/theory/papers.md. As in oracle.hpp, everything is literal, slow, in `long double`
// and shares no code with `shading/` or `src/`.

#pragma once

#include <array>
#include <string>
#include <vector>

#include "oracle.hpp"

namespace burnish::oracle {

// phong ward ward-duer lafortune cook-torrance ashikhmin-premoze-shirley he
// ashikhmin-shirley-diffuse
const std::vector<std::string>& further_brdf_names();

// Parameters, unused ones ignored; i and o unit, i.z > 0 and o.z > 0:
//   phong                      ks, alpha            0^0 = 0 here: nothing where o.r <= 0
//   ward, ward-duer            ks, alpha_x, alpha_y
//   lafortune                  ks, Cx, Cy, Cz, n    nothing where the bracket is <= 0
//   cook-torrance              ks, m, F0
//   ashikhmin-premoze-shirley  e_x, e_y, F0
//   he                         sigma, tau, F0       lengths in wavelengths; directional diffuse
//   only
long double further_brdf_eval(const std::string& brdf, const std::array<long double, 5>& p, Vec3 i,
                              Vec3 o);

// Schlick's F0 + (1 - F0) (1 - cosine)^5.
long double schlick(long double f0, long double cosine);

// The diffuse term of Ashikhmin & Shirley 2000, Eq 5, with diffuse and specular reflectance.
long double ashikhmin_shirley_diffuse(long double diffuse, long double specular, Vec3 i, Vec3 o);

// ---------------------------------------------------------------- Ashikhmin, Premoze & Shirley

// g(k) = Int D(h) (h.k) dw over h.k > 0 and h_z > 0, for the Ashikhmin-Shirley lobe with
// Int D (n.h) dw = 1. k unit, k_z >= 0. Relative error below 1e-12 for exponents in [0, 10000].
long double aps_g(long double e_x, long double e_y, Vec3 k);

// Int_0^theta sin^2(t) cos^e(t) dt, theta given by its sine and cosine.
long double sin2_cos_power_integral(long double e, long double sin_theta, long double cos_theta);

// ---------------------------------------------------------------- He et al.

// tau cot(theta) / (2 sigma): what shadowing and the effective roughness see of a direction.
long double he_slope_ratio(long double sigma, long double tau, Vec3 k);

// Eq 24-25 with the exponential that the printed Eq 25 lacks (the authors' errata): Smith 1967 for
// Gaussian slopes, without the condition that the point faces k.
long double he_shadowing(long double slope_ratio);

// Eq 80-83: the root x = z0 / sigma of sqrt(pi/2) x = (K_i + K_o) / 4 exp(-x^2 / 2), and
// sigma_e = sigma / sqrt(1 + x^2).
long double he_z0_over_sigma(long double k_sum);
long double he_effective_sigma(long double sigma, long double tau, Vec3 i, Vec3 o);

// ln of sum_{m >= 1} g^m e^-g / (m! m) exp(-b / m), g > 0, b >= 0, to a few times 1e-17.
long double he_log_series(long double g, long double b);

}  // namespace burnish::oracle
