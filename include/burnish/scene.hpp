// A scene: what the renderers consume. Files are read into it by scene/, nothing here knows a path.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/conductor.hpp"
#include "burnish/image.hpp"
#include "burnish/mesh.hpp"
#include "burnish/shading_names.hpp"

namespace BURNISH_API burnish {

enum class Wrap { repeat, mirror, clamp };
enum class AlphaMode { opaque, mask, blend };

// How a normal map is read where its texels are smaller than a pixel (docs/theory/normal-filtering.md).
enum class NormalFilter {
    mips,    // the mean of the normals, as engines do: the lobe stays as narrow as it is up close
    moments  // the mean slope, and the lobe widened by the variance of slopes
};

// A use of a texture by a material.
struct TextureUse {
    int texture = -1;           // index into Scene::textures, -1: none
    int texcoord = 0;           // 0 or 1
    glm::mat3 transform{1.0f};  // KHR_texture_transform: (u', v', 1) = transform (u, v, 1)
    Wrap wrap_s = Wrap::repeat;
    Wrap wrap_t = Wrap::repeat;
    bool nearest = false;  // no filtering asked for
    explicit operator bool() const { return texture >= 0; }
};

struct Draft;              // maps/weave/draft.hpp
struct TabulatedMaterial;  // scene/material/tabulated_material.hpp

// Woven cloth in place of a normal map (docs/theory/cloth.md). The lobe's x axis runs along the fibres:
// along the tangent on weft yarns, the bitangent on warp yarns, turned by twist and
// anisotropy_rotation.
struct Cloth {
    std::shared_ptr<const Draft> draft;
    float yarns = 100.0f;  // of each family across the texture square
    float crimp = 0.15f;   // WeaveShape of shading/surface/weave.glsl
    float bulge = 0.7f;
    float gap = 0.08f;
    float twist = 0.34906585f;  // radians
    float fuzz = 0.1f;          // standard deviation of slopes by which fibres are in disorder
    // In place of base_color; none: the draft's, or base_color.
    std::optional<glm::vec3> warp_color, weft_color;
};

// Names follow glTF 2.0 where glTF has the thing.
struct Material {
    std::string name;
    glm::vec4 base_color{1.0f};
    TextureUse base_color_texture;
    float metallic = 1.0f;
    float roughness = 1.0f;                 // perceptual: alpha = roughness^2
    TextureUse metallic_roughness_texture;  // G roughness, B metallic
    TextureUse normal_texture;
    float normal_scale = 1.0f;
    bool flip_green = false;  // the normal map is of the +y-down (DirectX) kind
    NormalFilter normal_filter = NormalFilter::moments;
    TextureUse occlusion_texture;
    float occlusion_strength = 1.0f;
    glm::vec3 emissive{0.0f};
    TextureUse emissive_texture;
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;

    // KHR_materials_anisotropy: the lobe is stretched along the tangent turned by the rotation.
    float anisotropy_strength = 0.0f;  // 0..1
    float anisotropy_rotation = 0.0f;  // radians, counter-clockwise from the tangent
    TextureUse anisotropy_texture;     // RG direction, B strength

    // What glTF has no word for. `alpha` (x along the turned tangent) overrides roughness and
    // anisotropy strength; textures then no longer scale them.
    std::optional<glm::vec2> alpha;
    std::optional<Conductor> conductor;  // exact Fresnel instead of Schlick with F0 = base colour
    float dielectric_f0 = 0.04f;
    Mdf mdf = Mdf::ggx;
    Brdf brdf = Brdf::microfacet;
    std::optional<float> ks;  // phong, lafortune: scale; none: as much as keeps its energy
    glm::vec3 lafortune_c{-1.0f, -1.0f, 1.0f};  // Cx, Cy, Cz: the mirror direction
    Method method = Method::follow_grain;
    bool conserve = false;       // deform-*: the energy-conserving form
    std::optional<Cloth> cloth;  // with `alpha` set, and no normal, anisotropy or roughness texture
    // A measured lobe, colours and normals at every texel in place of lobe and base colour
    // (docs/reference/tabulated-file.md), read where normal_texture is, which may perturb it further;
    // anisotropy_rotation turns it. No cloth beside it, no other texture of lobe or colour.
    std::shared_ptr<const TabulatedMaterial> tabulated;
    std::string tabulated_file;  // where it is from, for messages
};

// The method that a renderer draws the material with. `normal-map` stands for what engines ship,
// and where nothing is anisotropic (one alpha, no strength, no anisotropy texture) they evaluate
// the isotropic D(n~.h), which is the rotated lobe: `gram-schmidt` there, as every rotation is the
// same.
Method drawn_method(const Material& material);

struct Instance {
    int mesh = 0;      // index into Scene::meshes
    int material = 0;  // index into Scene::materials
    glm::mat4 transform{1.0f};
};

enum class LightType { directional, point, spot };

struct Light {
    LightType type = LightType::directional;
    glm::vec3 color{1.0f};   // linear, times intensity: radiance scale of the light
    float intensity = 1.0f;  // lux (directional) or candela (point, spot)
    glm::vec3 position{0.0f};
    glm::vec3 direction{0.0f, 0.0f, -1.0f};  // unit, the way the light travels
    float range = 0.0f;                      // 0: unbounded
    float inner_cone = 0.0f;                 // radians, spot only
    float outer_cone = 0.7853982f;
};

struct Camera {
    glm::vec3 position{0.0f, 0.0f, 3.0f};
    glm::vec3 target{0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    bool orthographic = false;
    float yfov = 0.6f;        // radians
    float ymag = 1.0f;        // half height of an orthographic view, metres
    float near_plane = 0.0f;  // 0: chosen from the scene's bounds
    float far_plane = 0.0f;
};

// Light from everywhere: a lat-long radiance map, +y up, row 0 at the zenith. The middle of the
// picture looks along -z (what a camera at +z sees behind the model) and columns run towards +x: u
// = 1/2 + atan2(x, -z) / (2 pi), v = acos(y) / pi.
struct Environment {
    std::string name;
    Image radiance;  // RGB
};

struct Scene {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Material> materials;  // never empty when there is an instance
    std::vector<Texture> textures;
    std::vector<Instance> instances;
    std::vector<Light> lights;
    std::vector<Camera> cameras;        // those stored in the file, in order
    std::vector<std::string> warnings;  // what will look different, one line each
};

// Bounds of all instances in world space.
Bounds bounds_of(const Scene& scene);

}  // namespace burnish
