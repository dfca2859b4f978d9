// A scene on the device that can be edited: slots with permanent numbers, and values derived from
// them.
//
// An edit takes effect as a whole or, when it throws, not at all. Data that an edit does not touch
// stays on the device. The context must be current.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/progress.hpp"
#include "burnish/scene.hpp"
#include "burnish/upload_counts.hpp"
#include "gpu/device/program.hpp"
#include "gpu/draw/ground.hpp"
#include "gpu/draw/shadow_maps.hpp"
#include "gpu/draw/surface_variant.hpp"
#include "gpu/upload/area_lights.hpp"
#include "gpu/upload/cloth_maps.hpp"
#include "gpu/upload/environment.hpp"
#include "gpu/upload/geometry.hpp"
#include "gpu/upload/lights.hpp"
#include "gpu/upload/tabulated_maps.hpp"
#include "gpu/upload/texture_upload.hpp"
#include "gpu/upload/visible_mesh.hpp"

namespace burnish::gpu {

// A program that a material was drawn with.
struct PreparedProgram {
    SurfaceVariant variant;
    bool resolve = false;            // resolve.frag, else surface.frag
    std::weak_ptr<Program> program;  // of the cache, which may have deleted it
};

struct MaterialSlot {
    Material material;
    std::uint64_t version = 0;  // version of its uniforms
    SurfaceVariant full, flat;  // without light and mesh; flat: without a normal map
    std::shared_ptr<const ClothMaps> cloth;
    std::shared_ptr<TabulatedMaps> tabulated;
    std::vector<PreparedProgram> programs;  // added as they are requested

    bool blended() const { return material.alpha_mode == AlphaMode::blend; }
};

struct MeshSlot {
    std::shared_ptr<MeshBuffers> buffers;
    Bounds bounds;
};

class DeviceScene {
  public:
    explicit DeviceScene(const Context& context);

    // Edits, as in Renderer.
    void set_scene(const Scene& scene, const Progress& progress);
    void set_environment(const std::shared_ptr<const PreparedEnvironment>& prepared);
    void set_lights(std::span<const Light> lights);
    void update_materials(std::span<const Material> materials, const Progress& progress);  // all
    void update_material(int id, const Material& material, const Progress& progress);
    // Those with coarse means take full ones, where the context's store has them now.
    void refine_cloths();
    int add_material(const Material& material, const Progress& progress);
    int add_texture(Texture texture);
    void update_texture(int id, Texture texture, const Progress& progress);
    int add_mesh(const Mesh& mesh);
    void update_mesh(int id, const Mesh& mesh);
    void set_coarse_mesh(int id, std::span<const std::uint32_t> indices);
    int add_instance(const Instance& instance);
    void update_instance(int id, const Instance& instance);
    void remove_instance(int id);
    void set_visibility(const Visibility* visibility);

    // Access for drawing.
    MaterialSlot& material(int id) { return materials_[static_cast<std::size_t>(id)]; }
    // The material as `method` draws it; none: its own. Made when it is first asked for, and kept
    // until the material changes. Throws as an edit.
    MaterialSlot& material(int id, std::optional<Method> method);
    const MaterialSlot& material(int id) const { return materials_[static_cast<std::size_t>(id)]; }
    std::span<MaterialSlot> materials() { return materials_; }
    const MeshBuffers& mesh(int id) const { return *meshes_[static_cast<std::size_t>(id)].buffers; }
    bool has_visibility() const { return !visible_.empty(); }
    // Draws the triangles of an item; `visibility`: with what its vertices see.
    void draw(const DrawItem& item, bool coarse, bool visibility) const;
    const std::vector<DrawItem>& items() const { return items_; }
    const Bounds& bounds() const { return bounds_; }
    std::size_t triangles(bool coarse = false) const;  // of all instances
    bool any_tabulated() const;
    TextureStore& textures() { return textures_; }
    const LightUniforms& lights() const { return lights_; }
    AreaLightUniforms& area_lights() { return area_lights_; }
    const AreaLightUniforms& area_lights() const { return area_lights_; }
    ShadowMaps& shadows() { return shadows_; }
    const ShadowMaps& shadows() const { return shadows_; }
    Ground& ground() { return ground_; }
    EnvironmentMaps* environment() const { return environment_.get(); }

    UploadCounts uploads() const;

  private:
    using Instances = std::vector<std::optional<Instance>>;
    struct Placement;
    MaterialSlot make_slot(const Material& material, TextureStore::Slots& textures,
                           const Progress& progress);
    MeshSlot make_mesh(const Mesh& mesh);
    Placement placement(const Instances& instances, const std::vector<MeshSlot>& meshes,
                        std::size_t materials) const;
    void place(Placement placement) noexcept;
    void set_instances(Instances instances);
    std::size_t checked(int id, std::size_t count, const char* what) const;

    const Context& context_;
    std::string name_ = "scene";
    TextureStore textures_;
    std::vector<MaterialSlot> materials_;
    std::map<std::pair<int, Method>, MaterialSlot> under_methods_;  // of materials_
    std::vector<MeshSlot> meshes_;
    Instances instances_;
    std::vector<std::shared_ptr<const VisibleMesh>> visible_;  // by instance; empty: of none
    std::vector<Light> light_list_;
    // The ground finds its sky lights in it.
    std::shared_ptr<const Environment> environment_source_;
    std::unique_ptr<EnvironmentMaps> environment_;

    std::vector<DrawItem> items_;  // of the instances that exist
    Bounds bounds_;
    LightUniforms lights_;
    AreaLightUniforms area_lights_;
    ShadowMaps shadows_;
    Ground ground_;
    UploadCounts uploads_;
};

}  // namespace burnish::gpu
