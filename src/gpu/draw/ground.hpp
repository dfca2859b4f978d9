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
#include <memory>
#include <utility>
#include <vector>

#include "burnish/progress.hpp"
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
    Ground(const Bounds& model, std::size_t triangles,
           std::shared_ptr<const Environment> environment);

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
    // Compiles what require and paint draw with.
    static void require_programs(ProgramCache& programs, const LightUniforms& lights);
    // Makes the shadow unless it is made for this sky. Changes framebuffer, viewport and raster
    // state. When `progress` throws, the shadow made before stays.
    void require(ProgramCache& programs, GLuint empty_vertex_array, const LightUniforms& lights,
                 const Sky& sky, const DrawCasters& draw_casters, const Progress& progress);
    // Lights or casters have changed: the next require makes the shadow again.
    void invalidate() { made_.reset(); }
    bool is_made_for(const Sky& sky) const { return made_ && made_->sky == sky; }
    // Multiplies what has been drawn; `transparent`: the shadow's coverage is left in alpha. Depth
    // is tested. `clip_from_world` of the view.
    void paint(ProgramCache& programs, GLuint empty_vertex_array, const LightUniforms& lights,
               const glm::mat4& clip_from_world, bool transparent) const;

  private:
    struct Shadow {
        Shadow();
        Sky sky;
        float scale = 1.0f;  // what is stored is irradiance times this
        GlTexture mask;      // depth: nearer than the far plane where a shadow falls
        GlTexture blocked;
        Framebuffer mask_target, blocked_target;
        Sampler sampler;
    };
    struct Tools;  // of one drawing
    void find_sky_lights();
    void set_place(Program& program, const LightUniforms& lights, float scale) const;
    // The shadow of one light into `blocked`; `light` -1: `sky`.
    void add(const Tools& tools, Shadow& shadow, int light, const SkyLight& sky) const;

    Bounds model_;
    glm::vec3 center_{0.0f};  // on the plane
    float half_ = 1.0f;       // of the square's side
    std::size_t triangles_ = 0;
    std::shared_ptr<const Environment> environment_;  // until its lights are found
    std::vector<SkyLight> sky_lights_;
    glm::vec3 sky_irradiance_{0.0f};
    std::unique_ptr<Shadow> made_;
};

}  // namespace burnish::gpu
