// Random and edge cases on which to compare an implementation with the oracle.
//
// Every number is exactly a double, so that an implementation in double sees the very inputs that
// the oracle sees. For a float implementation round to float first and give the oracle the rounded
// values. The same seed gives the same cases on every platform with the same `long double`.

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "oracle.hpp"

namespace burnish::oracle {

// One question to mdf_eval. n.z > 0 always; n and h are of any length, mostly unit to rounding.
//   kind    how h was chosen
//   alive   near the perturbed lobe's peak, in proportion to D             (half of all cases)
//   flank   where D is small but not nothing
//   far     anywhere on the sphere
//   pole    h = n
//   peak    h = n~, coordinate by coordinate
//   grazing h_z = 1e-3 .. 1e-9
//   below   h_z < 0: zero for none and the deformations, not always for the rotations
struct MdfCase {
    std::string mdf;
    long double p0 = 0;  // e_x or alpha_x: exponents 0 .. 10000, alphas 0.01 .. 1
    long double p1 = 0;
    std::string method;
    Vec3 n;  // tilt 0 .. 85 degrees, often exactly n, at 85 degrees, on an axis or tiny
    Vec3 h;
    std::string kind;
};

// `n` cases. Distributions and methods take turns, so that n = 36 k has k cases of every pair.
std::vector<MdfCase> mdf_cases(unsigned seed, std::size_t n);

// One question to brdf_eval.
//   kind    how o was chosen, i being random
//   alive   h drawn from the lobe, o the mirror image of i in it           (half of all cases)
//   far     anywhere on the hemisphere
//   mirror  h = n
//   retro   o = i
//   grazing o_z, and sometimes i_z, = 1e-3 .. 1e-9
//   below   i_z < 0 or o_z < 0: the value is zero
struct BrdfCase {
    std::string brdf;
    std::array<long double, 5> p{};
    Vec3 i;
    Vec3 o;
    std::string kind;
};

// `n` cases. Models take turns.
std::vector<BrdfCase> brdf_cases(unsigned seed, std::size_t n);

// `n` cases of one of the models of further_brdfs.hpp or of ggx-separable. Exponents 0 .. 10000,
// alphas 0.01 .. 1, |Cx|, |Cy|, |Cz| <= 2 with |(Cx ix, Cy iy, Cz iz)| near 1 or below where n is
// large, sigma 0.001 .. 5 (g 1e-4 .. 4000), tau 0.1 .. 1000. Kinds as above, and
//   skimming i, o or both 89.9 degrees from n
std::vector<BrdfCase> further_cases(const std::string& brdf, unsigned seed, std::size_t n);

}  // namespace burnish::oracle
