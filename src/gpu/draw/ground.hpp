// A plane under the model that shows only the shadow on it: the background is multiplied by the
// ratio of the light with the model to the light that the plane alone would get.
//
// The shadow is drawn on a square of the plane, seen from above, once for a scene and its
// environment: the model is flattened onto the plane along each light (J. Blinn, "Me and My (Fake)
// Shadow", 1988). Lamps are points, so their shadows are as sharp as the texels of the square. The
// Lights with an area are represented by points of theirs, whose shadows take away their part of the light's
// irradiance. The environment is represented by sky_lights(): a wide sky gives a soft shadow, darkest below the
// model; a sun gives a hard one. A shadow has the color of the remaining light. The ground reflects
// no light to the model. Masked surfaces cast the shadow of all their triangles, blended ones none.
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
#include "gpu/upload/area_lights.hpp"
#include "gpu/upload/lights.hpp"
#include "scene/light/sky_lights.hpp"

namespace burnish::gpu {

// Projects a point to its shadow on the plane y = height. `light` is a position and 1, or the
// direction towards it and 0. w <= 0 for a point no nearer to the plane than the light.
glm::mat4 flattened(const glm::vec4& light, float height);

// The lights of a scene, without and with an area.
struct GroundLights {
    const LightUniforms& points;
    const AreaLightUniforms& areas;
};

class Ground {
  public:
    // `model`: its bounding box; the plane touches it from below. `triangles`: number of triangles
    // of the model, which limits the number of sky lights. `environment` may be null.
    Ground(const Bounds& model, std::size_t triangles,
           std::shared_ptr<const Environment> environment);

    Bounds bounds() const;  // of the square
    // Whether an eye (View::eye) is above the plane; the ground is invisible from below.
    bool faces(const glm::vec4& eye) const;

    struct Sky {
        float intensity = 1.0f;
        float rotation = 0.0f;  // radians about +y
        bool coarse = false;    // by few lights and one drawing a lamp
        bool operator==(const Sky&) const = default;
    };
    // Draws all shadow casters by shadow.frag with this clip_from_world.
    using DrawCasters = std::function<void(const glm::mat4&)>;
    // Compiles the programs of require and paint.
    static void require_programs(ProgramCache& programs, const GroundLights& lights);
    // Makes the shadow unless it exists for this sky. Changes framebuffer, viewport and raster
    // state. When `progress` throws, the previous shadow stays.
    void require(ProgramCache& programs, GLuint empty_vertex_array, const GroundLights& lights,
                 const Sky& sky, const DrawCasters& draw_casters, const Progress& progress);
    // Call after a change of lights or casters: the next require makes the shadow again.
    void invalidate() { made_.reset(); }
    // A shadow that is not coarse serves where a coarse one would.
    bool is_made_for(const Sky& sky) const;
    // Multiplies the picture by the shadow; `transparent`: writes the shadow's coverage to alpha.
    // Depth is tested. `clip_from_world` is that of the view.
    void paint(ProgramCache& programs, GLuint empty_vertex_array, const GroundLights& lights,
               const glm::mat4& clip_from_world, bool transparent) const;

  private:
    struct Shadow {
        Shadow();
        Sky sky;
        float scale = 1.0f;  // stored values are irradiance times this
        GlTexture mask;      // depth: nearer than the far plane where a shadow falls
        GlTexture blocked;
        Framebuffer mask_target, blocked_target;
        Sampler sampler;
    };
    struct Tools;  // arguments of one drawing
    void find_sky_lights();
    void set_place(Program& program, const GroundLights& lights, float scale) const;
    // One drawing of casters: the light that they block.
    struct Blocked {
        glm::vec4 place{0.0f};  // of the light, as LightUniforms::place has it
        int light = -1;         // number of a light without an area
        int area = -1;          // of one with an area
        glm::vec3 sky{0.0f};    // irradiance of the sky's
        int draws = 1;          // shifted within a texel
        float share = 1.0f;     // of the light's irradiance
    };
    // Adds the shadow of one light, or of one point of it, to `blocked`.
    void add(const Tools& tools, Shadow& shadow, const Blocked& light) const;
    void add_areas(const Tools& tools, Shadow& shadow) const;

    Bounds model_;
    glm::vec3 center_{0.0f};  // on the plane
    float half_ = 1.0f;       // half the square's side
    std::size_t triangles_ = 0;
    std::shared_ptr<const Environment> environment_;     // kept until its lights are found
    std::vector<SkyLight> sky_lights_, few_sky_lights_;  // few: for coarse shadows
    glm::vec3 sky_irradiance_{0.0f};
    std::unique_ptr<Shadow> made_;
};

}  // namespace burnish::gpu
