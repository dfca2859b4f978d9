// Data of the shader of woven cloth (shaders/lib/cloth.glsl): the cells of the draft, coverage and
// color of each family of yarns (maps/weave/cloth_levels.hpp), and the mean lobe of each family.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "burnish/scene.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"
#include "maps/weave/weave_mean.hpp"

namespace burnish::gpu {

// Whether yarns of one family differ in color.
bool has_yarn_colors(const Cloth& cloth);

class ClothMaps {
  public:
    // For a material with `cloth`. Throws Error when the draft is larger than the device's
    // textures.
    explicit ClothMaps(const Material& material);

    // Whether the maps of this material would be the same.
    bool serves(const Material& material) const;
    // Binds the textures and sets the uniforms of shaders/lib/cloth.glsl; serves(material) must be
    // true.
    void bind(Program& program, const Material& material) const;

  private:
    Material material_;  // the material of the maps
    GlTexture cells_, weft_, warp_, lobes_;
    WeaveMean weft_mean_, warp_mean_;  // without their tables
    glm::vec4 wide_lobe_[2];
    glm::vec3 warp_color_{1.0f}, weft_color_{1.0f};
};

}  // namespace burnish::gpu
