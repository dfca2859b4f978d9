// Lights with an area as uniforms of shaders/lib/area_lights.glsl.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "burnish/scene.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"
#include "scene/light/area_lights.hpp"

namespace burnish::gpu {

inline constexpr std::size_t kMostAreaLights = 8;

// The point of the light for a sub-pixel sample with this offset (pixel_offsets): the offsets of a series, which are
// tents, become points that are even over the light. (0, 0): its middle. A tube's lie on its axis and on
// the radius that is perpendicular to the axis and to the way to `seen`.
glm::vec3 area_point(const Light& light, glm::dvec2 offset, const glm::vec3& seen);

// The light in the picture: half the sides of its rectangle, or of the rectangle around its ellipse, as `eye`
// (View::eye) sees them, and whether it emits towards it.
struct Emitter {
    AreaAxes axes;
    bool lit = false;
};
Emitter emitter_seen(const Light& light, const glm::vec4& eye);

class AreaLightUniforms {
  public:
    // Takes those of `lights` that have an area, in their order. Throws Error for more than
    // kMostAreaLights, or for a texture without pixels.
    explicit AreaLightUniforms(std::span<const Light> lights);

    int count() const { return static_cast<int>(lights_.size()); }
    const std::vector<Light>& lights() const { return lights_; }
    bool any_texture() const { return !textures_.empty(); }
    // Uploads what is missing.
    void require_textures();
    // After require_textures.
    void set(Program& program) const;
    const glm::vec4& radiance(int i) const { return radiance_[static_cast<std::size_t>(i)]; }
    float layer(int i) const { return y_[static_cast<std::size_t>(i)].w; }  // of the texture, or -1
    void bind_textures(Program& program) const;

  private:
    std::vector<Light> lights_;
    std::vector<glm::vec4> middle_, x_, y_, radiance_;
    std::vector<std::shared_ptr<const Image>> textures_;  // by layer
    std::shared_ptr<GlTexture> array_;                    // null: not uploaded
};

}  // namespace burnish::gpu
