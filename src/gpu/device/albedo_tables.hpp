// Albedo tables on the device: compensated materials and --image-light prefiltered read them.
#pragma once

#include <map>

#include "burnish/shading_names.hpp"
#include "gpu/device/handles.hpp"

namespace burnish::gpu {

// One texture per model and distribution. Part of a context (context.hpp): a table serves all
// renderers.
class AlbedoTables {
  public:
    // Uploads the table if it is missing. albedo_table computes it, unless it did before.
    void require(Brdf brdf, Mdf mdf);
    bool has(Brdf brdf, Mdf mdf) const;
    // Binds a table that was required before to kAlbedoUnit.
    void bind(Brdf brdf, Mdf mdf) const;

  private:
    std::map<int, GlTexture> tables_;
};

}  // namespace burnish::gpu
