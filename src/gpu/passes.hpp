// Drawing one frame: surfaces, background, blended surfaces.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gpu/baked_geometry.hpp"
#include "gpu/environment.hpp"
#include "gpu/geometry.hpp"
#include "gpu/lights.hpp"
#include "gpu/material_state.hpp"
#include "gpu/renderer.hpp"
#include "gpu/targets.hpp"
#include "gpu/view.hpp"

namespace burnish::gpu {

// Everything of a scene that lives on the device.
struct DeviceScene {
    DeviceScene(Context& context, const Scene& scene, const Environment* environment);

    std::vector<Material> materials;
    std::vector<MeshBuffers> meshes;
    std::vector<DrawItem> items;
    Bounds bounds;
    TextureStore textures;
    LightUniforms lights;
    std::optional<EnvironmentMaps> environment;
    // The items the visibility pass can take, and the others in scene order.
    std::optional<BakedGeometry> baked;
    std::vector<std::size_t> not_baked;
    std::size_t baked_triangles = 0;
};

// One sub-pixel sample of one tile.
struct Frame {
    const RenderOptions* options = nullptr;
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
    void clear(const Frame& frame, Targets& targets);
    void paint_baked(const Frame& frame, Targets& targets);
    void resolve_material(const Frame& frame, Targets& targets, int material);
    void paint_item(const Frame& frame, std::size_t index);
    void paint_gouraud(const Frame& frame, std::size_t index);
    void paint_background(const Frame& frame);
    void paint_blended(const Frame& frame);
    void set_common(Program& program, const Frame& frame);
    SurfaceVariant variant_for(const Frame& frame, int material, bool vertex_color) const;
    bool shows_environment(const Frame& frame) const;
    bool uses_baked(const Frame& frame) const;
    void draw_fullscreen(Program& program, float depth);

    DeviceScene& scene_;
    ProgramCache programs_;
    VertexArray empty_;
};

}  // namespace burnish::gpu
