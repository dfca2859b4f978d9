// Drawing one frame: surfaces, background, blended surfaces.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/progress.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "gpu/device/draw_state.hpp"
#include "gpu/device/section_timer.hpp"
#include "gpu/device/targets.hpp"
#include "gpu/draw/device_scene.hpp"
#include "scene/camera/view.hpp"
#include "scene/light/point_lattice.hpp"

namespace burnish::gpu {

// Whether programs are compiled for the number of lights, which is fastest, or take it as a
// uniform, so that adding a light compiles nothing.
enum class LightCount { compiled, at_run_time };

// One sub-pixel sample of one tile.
struct Frame {
    const RenderSettings* options = nullptr;
    View view;
    Tile tile;
    int sample = 0;
    glm::dvec2 offset{0.0};  // of the sample in its pixel, which `view` contains
    ShadingVariant variant = ShadingVariant::full;
    LightCount light_count = LightCount::compiled;
    // Materials whose program is not compiled are drawn by a simple one that all share.
    bool stands_in = false;
};

// Whether the frames are summed for a robust mean (RenderSettings::robust_limit).
bool is_robust(const RenderSettings& settings);

class Painter {
  public:
    Painter(Context& context, DeviceScene& scene);

    // Makes everything that frames with these settings need and that is missing: programs, albedo
    // tables, blurred environments, tables to draw from, the shadow on the ground (`ground`: it is
    // visible). Results that are complete stay when `progress` throws.
    void prepare(const Frame& frame, bool ground, const Progress& progress);

    // With Frame::stands_in, after prepare: compiles programs of materials until they have taken budget_s, one at
    // least unless it is 0. Returns the number of materials that the frame still stands in for.
    int compile_some(const Frame& frame, double budget_s);

    // Draws a prepared frame into `targets`; the viewport is left at the tile's size.
    void paint(const Frame& frame, Targets& targets);
    // Adds the frame to the sum of `targets`.
    void accumulate(const Frame& frame, Targets& targets);

    bool sees_ground(const Frame& frame);
    // Whether the simple program shows anything of this frame: it knows no other views, and no light with an area.
    bool can_stand_in(const Frame& frame) const;
    // Whether opaque surfaces are drawn deferred; `shape`: some of them are tabulated.
    bool defers(const Frame& frame, bool shape) const;
    SectionTimer& timer() { return timer_; }  // its sections are those of Pass
    SectionTimer::Scope timed(Pass pass) { return {timer_, static_cast<std::size_t>(pass)}; }
    GLuint empty_vertex_array() const { return empty_.get(); }

  private:
    MaterialSlot& slot_of(const Frame& frame, int material);
    // Properties of the scene that a frame needs, determined once.
    struct Needs {
        bool defers = false;
        bool shadows = false;   // of lights
        bool position = false;  // of surfaces, beside their normals
        bool shape = false;     // footprint on the texture: tabulated materials read it
        bool ground = false;
        bool visibility = false;     // vertices say what they see
        std::uint64_t frame = 0;     // version of the frame's uniforms
        std::uint64_t settings = 0;  // version of the settings that materials depend on
    };
    Needs needs_of(const Frame& frame);
    void start_programs(const Frame& frame, std::vector<Program*>& programs);
    void prepare_programs(const Frame& frame, const Progress& progress);
    void prepare_tables(const Frame& frame, const Progress& progress);
    void prepare_ground(const Frame& frame, const Progress& progress);

    SurfaceVariant variant_of(const Frame& frame, const MaterialSlot& slot, bool color) const;
    Program& surface_program(MaterialSlot& slot, const SurfaceVariant& variant, bool resolve,
                             bool wait);
    Program& gbuffer_program(const MaterialSlot& slot, bool wait);
    Program& gouraud_program(bool wait);
    Program& stand_in_program(const Frame& frame, bool wait);
    bool is_stood_in(const Frame& frame, const DrawItem& item);
    // The stage that sums the frames.
    static const char* accumulation_of(const RenderSettings& settings) {
        return is_robust(settings) ? "accumulate_robust.frag" : "accumulate.frag";
    }
    Program& plain_program(const char* vertex, const char* fragment, bool wait);
    bool can_defer(const Frame& frame, const DrawItem& item);
    bool shows_environment(const Frame& frame) const;
    bool lit_by_environment(const Frame& frame) const;
    bool sees_surroundings(const Frame& frame) const;
    bool shows_emitters(const Frame& frame) const;
    Program& emitter_program(bool wait);
    GroundLights ground_lights() const { return {scene_.lights(), scene_.area_lights()}; }
    static bool is_furnace(const Frame& frame);

    void draw_casters(const glm::mat4& clip_from_world, bool coarse);
    void draw_shadows(const Frame& frame);
    void clear(const Frame& frame, Targets& targets);
    // Items that deferred shading has drawn are removed from `forward`.
    void paint_deferred(const Frame& frame, Targets& targets, std::vector<std::size_t>& forward);
    void paint_forward(const Frame& frame, const std::vector<std::size_t>& items);
    void write_gbuffer(const Frame& frame, const DrawItem& item);
    void resolve_material(const Frame& frame, Targets& targets, int material,
                          const DrawState& state);
    void draw_item(Program& program, const DrawItem& item, bool coarse);
    void paint_item(const Frame& frame, const DrawItem& item);
    void paint_gouraud(const Frame& frame, const DrawItem& item);
    void paint_stand_in(const Frame& frame, const DrawItem& item);
    void paint_emitters(const Frame& frame);
    void paint_background(const Frame& frame);
    void paint_blended(const Frame& frame);
    void set_lattice(Program& program, int samples);
    void set_frame(Program& program, const Frame& frame);
    void set_surface(Program& program, const Frame& frame, int material);
    void draw_fullscreen(Program& program, float depth);

    Context& context_;
    DeviceScene& scene_;
    VertexArray empty_;
    SectionTimer timer_;
    int draw_buffers_ = 0;  // images that a stage can write at once
    PointLattice lattice_;  // of as many points
    int lattice_samples_ = 0;
    Needs needs_;              // needs of the frame in progress
    int bound_material_ = -1;  // material whose textures are bound
    std::pair<int, bool> material_settings_{0, false};
    std::uint64_t settings_version_ = 0;
};

}  // namespace burnish::gpu
