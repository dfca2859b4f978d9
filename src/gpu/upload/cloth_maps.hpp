// What the shader of woven cloth reads (shaders/lib/cloth.glsl): the draft's cells, where and in
// which colour each family of yarns shows, and what each reflects from afar.
#pragma once

#include <epoxy/gl.h>

#include <map>
#include <memory>
#include <vector>

#include "burnish/scene.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"
#include "maps/weave/weave_mean.hpp"

namespace burnish::gpu {

// Whether yarns differ in colour within a family.
bool has_yarn_colors(const Cloth& cloth);

// One level of a chain of halved images: of each texel rgb colour times share, a share of the area
// on which the family shows.
struct ClothLevel {
    int width = 0, height = 0;
    std::vector<glm::vec4> weft, warp;
};

// Level 0 has a texel a cell, the last one is a single texel. Each level is the one before averaged
// over areas, whatever its size, so that all have the same mean. Colours of the draft where it is
// said.
std::vector<ClothLevel> cloth_levels(const Draft& draft, float gap, glm::vec3 warp_color,
                                     glm::vec3 weft_color, bool warp_from_draft,
                                     bool weft_from_draft);

class ClothMaps {
  public:
    // Of the material with number `index`, made anew when it has changed. Throws Error when the
    // draft is larger than the device's textures.
    void bind(Program& program, int index, const Material& material);

  private:
    struct Made {
        Material material;  // what the maps were made for
        GlTexture cells, weft, warp, lobes;
        WeaveMean weft_mean, warp_mean;  // without their tables
        glm::vec4 wide_lobe[2];
        glm::vec3 warp_color{1.0f}, weft_color{1.0f};
    };
    static void make(Made& made, const Material& material);
    std::map<int, std::unique_ptr<Made>> made_;
};

}  // namespace burnish::gpu
