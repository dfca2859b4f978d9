// A plane under the model that shows nothing but the shadow on it: the background is multiplied by
// what the model leaves of the light that the plane alone would get.
//
// The shadow is drawn on a square of the plane, seen from above, once for a scene and its
// environment: the model flattened onto the plane along each light (J. Blinn, "Me and My (Fake)
// Shadow", 1988). Lamps are points, so their shadows are sharp but for the texels of the square.
// The environment is sky_lights(): a wide sky gives a soft shadow, darkest where the model stands,
// a sun a hard one. A shadow has the colour of the light that is left. The ground returns no light
// to the model. Masked surfaces cast the shadow of all their triangles, blended ones none.
#pragma once

#include <functional>
#include <glm/mat4x4.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "burnish/scene.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"
#include "gpu/upload/lights.hpp"
#include "scene/light/sky_lights.hpp"

namespace burnish::gpu {

// Takes a point to where its shadow falls on the plane y = height: `light` is a position and 1, or
// the direction towards it and 0. w <= 0 for what is no nearer to the plane than the light.
glm::mat4 flattened(const glm::vec4& light, float height);

class Ground {
  public:
    // `model`: its box; the plane touches it from below. `triangles`: of the model, whose number
    // limits that of the sky lights. `environment` may be null.
    Ground(const Bounds& model, std::size_t triangles, const Environment* environment);

    Bounds bounds() const;  // of the square that is drawn
    // Whether an eye (View::eye) is above the plane; from below there is no ground.
    bool faces(const glm::vec4& eye) const;

    struct Sky {
        float intensity = 1.0f;
        float rotation = 0.0f;  // radians about +y
        bool operator==(const Sky&) const = default;
    };
    // Draws all that casts a shadow by shadow.frag with this clip_from_world.
    using DrawCasters = std::function<void(const glm::mat4&)>;
    // Makes the shadow unless it is made for this sky. Changes framebuffer, viewport and raster
    // state.
    void require(ProgramCache& programs, GLuint empty_vertex_array, const LightUniforms& lights,
                 const Sky& sky, const DrawCasters& draw_casters);
    // Multiplies what has been drawn; `transparent`: the shadow's coverage is left in alpha. Depth
    // is tested. `clip_from_world` of the view.
    void paint(ProgramCache& programs, GLuint empty_vertex_array, const LightUniforms& lights,
               const glm::mat4& clip_from_world, bool transparent) const;

  private:
    struct Device {
        GlTexture mask;  // depth: nearer than the far plane where a shadow falls
        GlTexture blocked;
        Framebuffer mask_target, blocked_target;
        Sampler sampler;
    };
    void make_device();
    void set_place(Program& program, const LightUniforms& lights) const;
    // One light's shadow into `blocked`; `light` -1: `sky`.
    void add(ProgramCache& programs, GLuint empty_vertex_array, const LightUniforms& lights,
             int light, const SkyLight& sky, const DrawCasters& draw_casters);

    Bounds model_;
    glm::vec3 center_{0.0f};  // on the plane
    float half_ = 1.0f;       // of the square's side
    std::vector<SkyLight> sky_lights_;
    glm::vec3 sky_irradiance_{0.0f};
    float scale_ = 1.0f;  // what is stored is irradiance times this
    std::optional<Sky> made_for_;
    std::optional<Device> device_;
};

}  // namespace burnish::gpu
