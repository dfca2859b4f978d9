// Depth maps of the lights: one for a directional light or a spot, six for a point light.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "burnish/scene.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"

namespace burnish::gpu {

// 24 matrices are 96 of the 224 vectors that ES 3.0 grants a fragment shader. Lights get maps in
// their order while there are any left; the others cast no shadow.
inline constexpr int kMostShadowMaps = 24;

class ShadowMaps {
  public:
    // `bounds`: what may cast or catch a shadow. Nothing is made on the device before begin().
    ShadowMaps(std::span<const Light> lights, const Bounds& bounds);

    // The images of the maps that these follow, where they have as many of the same size.
    void take_device(ShadowMaps& before);

    int count() const { return static_cast<int>(maps_.size()); }

    // Makes map `index` the target, cleared, with the state to draw into it, for sub-pixel sample
    // `sample`: every sample sees the light through texels shifted by a part of themselves, so that
    // many together have soft edges. Returns its clip_from_world.
    glm::mat4 begin(int index, int sample);

    // The uniforms of shaders/lib/lights.glsl and the texture.
    void bind(Program& program) const;

  private:
    struct Map {
        glm::mat4 clip_from_world{1.0f};
        float texel = 0.0f;  // side in the world at distance 1; of a directional light anywhere
    };
    struct Device {
        GlTexture texture;
        Sampler sampler;
        Framebuffer target;
    };
    void add_light(const Light& light, const Bounds& bounds);
    void make_device();

    std::vector<Map> maps_;
    std::vector<glm::vec2> of_light_;  // first map or -1, number of maps
    std::vector<glm::mat4> current_;   // as last drawn, shifted
    int side_ = 0;
    std::optional<Device> device_;
};

}  // namespace burnish::gpu
