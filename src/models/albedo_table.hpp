// The directional albedo of a reflection model without Fresnel, as a table.
#pragma once

#include <vector>

#include "burnish/shading_names.hpp"

namespace burnish {

inline constexpr int kAlbedoAlphas = 16;
inline constexpr int kAlbedoCosines = 24;

// Int f cos dwi of the unperturbed model, F = 1, [cosine][alpha across][alpha along]: alpha along
// is the roughness towards the azimuth of the view, across the one perpendicular to it. Node i of n
// lies at sqrt(alpha) = i/(n-1) and at cosine i/(n-1), both held to 0.01 at least. Where the axes
// of the lobe are not those of the view the same two numbers serve, within 1 %. 1024 samples a
// node, the same on any number of threads.
std::vector<float> albedo_table(Brdf brdf, Mdf mdf);

}  // namespace burnish
