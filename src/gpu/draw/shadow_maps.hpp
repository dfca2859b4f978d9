// Depth maps of the lights: one for a directional light or a spot, six for a point light. A light with an
// area has one that looks at the whole scene, or six where it is within it; its maps are drawn from another point
// of the light for every sub-pixel sample, so that the mean over the samples is the soft shadow.
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

// 24 matrices take 96 of the 224 vectors that ES 3.0 guarantees a fragment shader. Lights get maps
// in their order; lights for which no maps are left cast no shadow.
inline constexpr int kMostShadowMaps = 24;

class ShadowMaps {
  public:
    // `bounds`: box of all shadow casters and receivers. Nothing is created on the device before
    // begin().
    ShadowMaps(std::span<const Light> lights, const Bounds& bounds);

    // Takes over the images of `before`. Others in number or size are allocated in their place; without
    // maps they stay for the next light.
    void take_device(ShadowMaps& before);

    int count() const { return static_cast<int>(maps_.size()); }

    // Which of the drawn instances cast shadows, and whether by their coarse triangles. Others than
    // before: every map has to be drawn again.
    void set_casters(std::vector<bool> casters, bool coarse);
    void invalidate();  // every map has to be drawn again
    // Whether the map is as begin() and the drawing after it have left it for this offset, so that it
    // need not be drawn: a map depends on the lights and the scene, with which the object is made anew,
    // and not on the camera.
    bool holds(int index, glm::dvec2 offset) const;

    // Makes map `index` the target, clears it and sets the state to draw into it. The offset of the
    // sub-pixel sample (pixel_offsets) shifts the map by as many texels, so that the average over
    // samples has soft edges. Returns the clip_from_world of the map.
    glm::mat4 begin(int index, glm::dvec2 offset);

    // The uniforms of shaders/lib/lights.glsl and the texture.
    void bind(Program& program) const;

  private:
    struct Map {
        glm::mat4 clip_from_world{1.0f};
        float texel = 0.0f;  // side in the world at distance 1; constant for a directional light
        int area = -1;  // number of the light with an area, whose maps are made for each sample
        int face = -1;  // -1: towards the middle of the scene
    };
    struct Device {
        GlTexture texture;
        Sampler sampler;
        Framebuffer target;
        int side = 0, layers = 0;  // as allocated
    };
    void add_light(const Light& light);
    void add_area_light(const Light& light);
    // The map of a light with an area from this point of it.
    glm::mat4 clip_of_area(const Map& map, const glm::vec3& point) const;
    bool has_images() const;
    void make_images();

    Bounds bounds_;
    std::vector<Map> maps_;
    std::vector<glm::vec2> of_light_;  // first map or -1, number of maps
    std::vector<Light> area_lights_;
    std::vector<glm::vec2> of_area_light_;          // the same of lights with an area
    std::vector<glm::vec3> area_points_;            // where their maps are drawn from
    std::vector<glm::mat4> current_;                // as last drawn, with the shift
    std::vector<std::optional<glm::dvec2>> drawn_;  // offset of each map's last drawing
    std::vector<bool> casters_;
    bool coarse_ = false;
    int side_ = 0;
    std::optional<Device> device_;
};

}  // namespace burnish::gpu
