// Drawing one frame: surfaces, background, blended surfaces.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gpu/device/targets.hpp"
#include "gpu/draw/ground.hpp"
#include "gpu/draw/material_state.hpp"
#include "gpu/draw/renderer.hpp"
#include "gpu/draw/shadow_maps.hpp"
#include "gpu/upload/albedo_textures.hpp"
#include "gpu/upload/cloth_maps.hpp"
#include "gpu/upload/environment.hpp"
#include "gpu/upload/geometry.hpp"
#include "gpu/upload/lights.hpp"
#include "gpu/upload/tabulated_maps.hpp"
#include "scene/camera/view.hpp"
#include "burnish/render_settings.hpp"

namespace burnish::gpu {

// Everything of a scene that lives on the device.
struct DeviceScene {
    DeviceScene(Context& context, const Scene& scene, const Environment* environment);

    std::vector<Material> materials;
    std::vector<MeshBuffers> meshes;
    std::vector<DrawItem> items;
    Bounds bounds;
    Ground ground;
    TextureStore textures;
    LightUniforms lights;
    ShadowMaps shadows;
    std::optional<EnvironmentMaps> environment;
};

// One sub-pixel sample of one tile.
struct Frame {
    const RenderSettings* options = nullptr;
    View view;
    Tile tile;
    int sample = 0;
    ShadingVariant variant = ShadingVariant::full;
};

class Painter {
  public:
    Painter(Context& context, DeviceScene& scene);

    // Draws the frame into `targets`; the viewport is left at the tile's size.
    void paint(const Frame& frame, Targets& targets);
    // Adds it to the sum of `targets`.
    void accumulate(Targets& targets);

  private:
    void draw_casters(const glm::mat4& clip_from_world);
    void draw_shadows(const Frame& frame);
    bool shows_ground(const Frame& frame) const;
    void draw_ground_shadow(const Frame& frame);
    void paint_ground(const Frame& frame);
    void clear(const Frame& frame, Targets& targets);
    // Items that were shaded once a pixel are left out of `forward`.
    void paint_deferred(const Frame& frame, Targets& targets, std::vector<std::size_t>& forward);
    void write_gbuffer(const Frame& frame, const DrawItem& item);
    void resolve_material(const Frame& frame, Targets& targets, int material);
    void place(Program& program, const DrawItem& item);
    void paint_item(const Frame& frame, const DrawItem& item);
    void paint_gouraud(const Frame& frame, const DrawItem& item);
    void paint_background(const Frame& frame);
    void paint_blended(const Frame& frame);
    void set_common(Program& program, const Frame& frame);
    void set_surface(Program& program, const Frame& frame, int material);
    SurfaceVariant variant_for(const Frame& frame, int material, bool vertex_color) const;
    bool shows_environment(const Frame& frame) const;
    bool defers(const Frame& frame) const;
    bool casts_shadows(const Frame& frame) const;
    bool needs_position(const Frame& frame) const;
    bool needs_shape() const;  // of pixels on their textures: tabulated materials ask for it
    bool can_defer(const Frame& frame, const DrawItem& item) const;
    void draw_fullscreen(Program& program, float depth);

    DeviceScene& scene_;
    ProgramCache programs_;
    AlbedoTables albedos_;
    ClothMaps cloths_;
    TabulatedMaps tabulated_;
    VertexArray empty_;
};

}  // namespace burnish::gpu
