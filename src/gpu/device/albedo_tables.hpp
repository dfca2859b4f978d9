// Albedo tables on the device, which --image-light prefiltered needs to conserve energy.
#pragma once

#include <map>
#include <vector>

#include "burnish/shading_names.hpp"
#include "gpu/device/handles.hpp"

namespace burnish::gpu {

// One texture per model and distribution. Part of a context (context.hpp): a table serves all
// renderers.
class AlbedoTables {
  public:
    // Makes the table if it is missing, from 6.3 million samples of the model.
    void require(Brdf brdf, Mdf mdf);
    // Takes the table that albedo_table(brdf, mdf) gave, perhaps on another thread.
    void put(Brdf brdf, Mdf mdf, const std::vector<float>& table);
    bool has(Brdf brdf, Mdf mdf) const;
    // Binds a table that was required before to kAlbedoUnit.
    void bind(Brdf brdf, Mdf mdf) const;

  private:
    std::map<int, GlTexture> tables_;
};

}  // namespace burnish::gpu
