// What a fitted material looks like under the lights of a rig, in the units of its pictures
// (docs/theory/capture-model.md). In double precision.
#pragma once

#include <vector>

#include "burnish/api.hpp"
#include "burnish/image.hpp"
#include "burnish/rig.hpp"
#include "burnish/tabulated_material.hpp"

namespace BURNISH_API burnish {

class Relighter {
  public:
    // Keeps a reference to the material.
    explicit Relighter(const TabulatedMaterial& material);

    // rho(i, o) of a texel, rgb, from unit directions in sample space; 0 below the horizon of its
    // normal and outside the mask.
    Vec3d brdf(std::size_t texel, const Vec3d& to_light, const Vec3d& to_eye) const;

    // I = rho (n.i) L cos^m / r^2 for every texel under the rig's light `light`, seen from its own
    // camera or the rig's. The texels lie where the rig's size of the sample puts them. The same
    // whatever the number of threads.
    Image picture(const Rig& rig, std::size_t light) const;

  private:
    const TabulatedMaterial& material_;
    std::vector<std::vector<float>> areas_;  // of ndf_areas, an exemplar each
};

}  // namespace burnish
