// A material with its textures, read at a hit: what shaders/lib/material.glsl does for the renderer. Cloth is the yarn
// at a point, a tabulated material one of its texels: the mean over a pixel is that over its samples.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "burnish/scene.hpp"
#include "models/albedo_table.hpp"
#include "reference/point_surface.hpp"
#include "reference/surface_hit.hpp"
#include "reference/table_lobes.hpp"
#include "reference/texture_pyramid.hpp"
#include "scene/material/material_values.hpp"
#include "scene/material/texture_uses.hpp"

namespace burnish {

// The pyramids of a scene's textures, each made once in every form that materials read.
class PyramidStore {
  public:
    explicit PyramidStore(std::span<const Texture> textures) : textures_(textures) {}
    // Null where there is no texture. Throws Error for one that does not exist.
    std::shared_ptr<const TexturePyramid> get(const TextureUse& use, PyramidForm form);

  private:
    std::span<const Texture> textures_;
    std::vector<std::array<std::shared_ptr<const TexturePyramid>, 3>> made_;
};

// Threads: immutable. Lifetime: refers to the texels of the scene's textures.
class MaterialReader {
  public:
    // `material`: of drawn_material.
    MaterialReader(const Material& material, PyramidStore& pyramids);

    // `xi`: two numbers in [0, 1), which choose the texel of a tabulated material.
    PointSurface at(const SurfaceHit& hit, const glm::vec2& xi) const;
    // Coverage of a masked or blended surface; 1 of others.
    float alpha(const SurfaceHit& hit) const;
    bool reads_textures() const { return reads_textures_; }
    const Material& material() const { return m_; }

  private:
    // Of a point, before it is a PointSurface: `Shading` of material.glsl.
    struct Shading {
        f32::SurfaceMaterial& surface;
        f32::vec3 base_color{};
        float metallic = 0.0f;
        f32::vec2 direction{};
        f32::vec3 n{0.0f, 0.0f, 1.0f};
        f32::vec3 coat_n{0.0f, 0.0f, 1.0f};
    };
    bool has(MaterialTexture which) const {
        return pyramids_[static_cast<std::size_t>(which)] != nullptr;
    }
    glm::vec4 texel(MaterialTexture which, const SurfaceHit& hit) const;
    glm::vec4 base_color(const SurfaceHit& hit) const;
    void put_lobe(Shading& s, const SurfaceHit& hit) const;
    void put_specular(Shading& s, const SurfaceHit& hit) const;
    void put_normal(Shading& s, const SurfaceHit& hit) const;
    f32::SurfaceLayers layers_at(Shading& s, const SurfaceHit& hit) const;
    void put_yarn(Shading& s, PointSurface& out, const SurfaceHit& hit) const;
    void put_texel(Shading& s, PointSurface& out, const SurfaceHit& hit, const glm::vec2& xi) const;
    void put_axes(const Shading& s, PointSurface& out, const SurfaceHit& hit) const;
    glm::vec2 own_coordinates(const SurfaceHit& hit) const;

    Material m_;
    MaterialValues<f32::SurfaceMaterial> values_;
    std::array<std::shared_ptr<const TexturePyramid>, kMaterialTextures> pyramids_;
    std::shared_ptr<const AlbedoTable> albedos_;  // none: no light is added
    std::vector<TableLobe> tables_;               // by exemplar
    const TextureUse* own_use_ = nullptr;  // whose coordinates cloth and tables are read with
    f32::vec2 turn_{};                     // of the anisotropy texture's directions
    int method_ = 0;
    bool has_diffuse_ = true;
    bool lobe_from_texture_ = false;
    bool one_color_ = false;  // but for colors of vertices
    bool perturbed_ = false;  // by a map, a weave or a measurement
    bool turned_ = false;     // the lobe's x axis is not the tangent
    bool slopes_ = false, coat_slopes_ = false;
    bool reads_textures_ = false;
};

}  // namespace burnish
