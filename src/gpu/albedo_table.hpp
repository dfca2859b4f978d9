// The directional albedo of a reflection model without Fresnel, which holds the energy of
// --image-light prefiltered.
#pragma once

#include <epoxy/gl.h>

#include <map>
#include <vector>

#include "burnish/shading_names.hpp"
#include "gpu/handles.hpp"

namespace burnish::gpu {

inline constexpr int kAlbedoAlphas = 16;
inline constexpr int kAlbedoCosines = 24;

// Int f cos dwi of the unperturbed model, F = 1, [cosine][alpha across][alpha along]: alpha along
// is the roughness towards the azimuth of the view, across the one perpendicular to it. Node i of n
// lies at sqrt(alpha) = i/(n-1) and at cosine i/(n-1), both held to 0.01 at least. Where the axes
// of the lobe are not those of the view the same two numbers serve, within 1 %. 1024 samples a
// node, the same on any number of threads.
std::vector<float> albedo_table(Brdf brdf, Mdf mdf);

// Tables on the device, each made when first bound.
class AlbedoTables {
  public:
    void bind(Brdf brdf, Mdf mdf);

  private:
    std::map<int, GlTexture> tables_;
};

}  // namespace burnish::gpu
