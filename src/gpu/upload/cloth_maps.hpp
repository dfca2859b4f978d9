// Data of the shader of woven cloth (shaders/lib/cloth.glsl): the cells of the draft, coverage and
// color of each family of yarns (maps/weave/cloth_levels.hpp), and the mean lobe of each family.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>

#include "burnish/scene.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"
#include "maps/weave/weave_mean.hpp"

namespace burnish::gpu {

// Whether yarns of one family differ in color.
bool has_yarn_colors(const Cloth& cloth);

// What the means of a material with `cloth` depend on.
ClothLobe cloth_lobe_of(const Material& material);

class ClothMaps {
  public:
    // For a material with `cloth`, and means of its lobe. Throws Error when the draft is larger than the
    // device's textures.
    ClothMaps(const Material& material, std::shared_ptr<const ClothMeans> means);

    // Whether the maps of this material with these means would be the same.
    bool serves(const Material& material, const std::shared_ptr<const ClothMeans>& means) const;
    bool is_coarse() const { return means_->detail == WeaveDetail::coarse; }
    // Binds the textures and sets the uniforms of shaders/lib/cloth.glsl; serves(material) must be
    // true.
    void bind(Program& program, const Material& material) const;

  private:
    Material material_;  // the material of the maps
    GlTexture cells_, weft_, warp_, lobes_;
    std::shared_ptr<const ClothMeans> means_;
    glm::vec4 wide_lobe_[2];
    glm::vec3 warp_color_{1.0f}, weft_color_{1.0f};
};

}  // namespace burnish::gpu
