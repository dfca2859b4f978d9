// Albedo tables on the device, which hold the energy of --image-light prefiltered.
#pragma once

#include <map>

#include "burnish/shading_names.hpp"
#include "gpu/device/handles.hpp"

namespace burnish::gpu {

// One texture a model and distribution, each made when first bound.
class AlbedoTables {
  public:
    void bind(Brdf brdf, Mdf mdf);

  private:
    std::map<int, GlTexture> tables_;
};

}  // namespace burnish::gpu
