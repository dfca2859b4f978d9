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
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/conductor.hpp"
#include "burnish/image.hpp"
#include "burnish/mesh.hpp"
#include "burnish/shading_names.hpp"

namespace BURNISH_API burnish {

enum class Wrap { repeat, mirror, clamp };
enum class AlphaMode { opaque, mask, blend };

// How a renderer reads a normal map whose texels are smaller than a pixel
// (docs/theory/normal-filtering.md).
enum class NormalFilter {
    mips,    // the mean of the normals, as engines do: the lobe stays as narrow as it is up close
    moments  // the mean slope, and the lobe widened by the variance of slopes
};
std::span<const std::string_view> normal_filter_names();  // in the order of the enumeration

// A use of a texture by a material.
struct TextureUse {
    int texture = -1;           // index into Scene::textures, -1: none
    int texcoord = 0;           // 0 or 1
    glm::mat3 transform{1.0f};  // KHR_texture_transform: (u', v', 1) = transform (u, v, 1)
    Wrap wrap_s = Wrap::repeat;
    Wrap wrap_t = Wrap::repeat;
    bool nearest = false;  // no filtering asked for
    explicit operator bool() const { return texture >= 0; }
    bool operator==(const TextureUse&) const = default;
};

struct Draft;              // burnish/draft.hpp
struct TabulatedMaterial;  // burnish/tabulated_material.hpp

// --- the four kinds of lobe: a material has exactly one ------------------------------------------

// Roughness as glTF says it; G of metallic_roughness_texture scales the roughness, B of
// anisotropy_texture the strength.
struct GltfLobe {
    float roughness = 1.0f;            // perceptual: alpha = roughness^2
    float anisotropy_strength = 0.0f;  // 0..1, KHR_materials_anisotropy: stretch along the tangent
    bool operator==(const GltfLobe&) const = default;
};

// Roughness along the lobe's axes; textures do not scale it.
struct AlphaLobe {
    glm::vec2 alpha{1.0f};  // x along the rotated tangent; a renderer draws at least 0.001
    bool operator==(const AlphaLobe&) const = default;
};

// Woven cloth in place of a normal map (docs/theory/cloth.md). The lobe's x axis runs along the fibres:
// along the tangent on weft yarns, the bitangent on warp yarns, rotated by twist and
// anisotropy_rotation.
struct Cloth {
    std::shared_ptr<const Draft> draft;  // never null where a renderer draws it
    float yarns = 100.0f;                // of each family across the texture square
    float crimp = 0.15f;                 // WeaveShape of shading/surface/weave.glsl
    float bulge = 0.7f;
    float gap = 0.08f;
    float twist = 0.34906585f;  // radians: 20 degrees
    float fuzz = 0.1f;          // standard deviation of slopes by which fibres are in disorder
    // In place of base_color; none: the draft's, or base_color.
    std::optional<glm::vec3> warp_color, weft_color;
    glm::vec2 alpha{0.2f, 0.45f};  // roughness along and across the fibres
    bool operator==(const Cloth&) const = default;
};

// A measured lobe, colors and normals at every texel (docs/reference/tabulated-file.md). The table is
// read with the coordinates of normal_texture, which may perturb it further; anisotropy_rotation
// rotates it.
struct Tabulated {
    std::shared_ptr<const TabulatedMaterial> material;  // never null where a renderer draws it
    std::string file;                                   // where it is from, for messages
    bool operator==(const Tabulated&) const = default;
};

using MaterialLobe = std::variant<GltfLobe, AlphaLobe, Cloth, Tabulated>;

// --- layers over every kind of lobe --------------------------------------------------------------

// A clear layer of refractive index 1.5 over the surface: lacquer, or the oxide of anodized aluminum
// (KHR_materials_clearcoat, docs/theory/coats.md). Its normal is that of its own map, else the geometric
// one.
struct Coat {
    float strength = 0.0f;   // share of the surface that is coated; 0: no coat
    float roughness = 0.0f;  // perceptual, of its face; what lies below stays as sharp as it is
    glm::vec3 tint{1.0f};    // what it lets through along its normal and back, linear; 1: clear
    TextureUse texture;      // R scales the strength
    TextureUse roughness_texture;  // G scales the roughness
    TextureUse normal_texture;     // tangent space, as Material::normal_texture
    float normal_scale = 1.0f;
    bool flip_green = false;  // its normal map is of the +y-down (DirectX) kind
    bool operator==(const Coat&) const = default;
};

// Fibers that stand out of the surface, such as velvet (KHR_materials_sheen), under the coat.
struct Sheen {
    glm::vec3 color{0.0f};         // linear; 0: no sheen
    float roughness = 0.0f;        // perceptual; drawn from 0.07
    TextureUse color_texture;      // RGB scales the color
    TextureUse roughness_texture;  // A scales the roughness
    bool operator==(const Sheen&) const = default;
};

// Names follow glTF 2.0 where glTF has the thing. A plain value: copy, change and compare it.
// Every kind of lobe reads a part of the other members, and a renderer ignores the rest
// (drawn_material):
// - GltfLobe and AlphaLobe read them all;
// - Cloth reads neither normal_texture, anisotropy_texture nor metallic_roughness_texture;
// - Tabulated reads no texture of color or lobe (base_color, metallic_roughness, anisotropy) and
//   neither the RGB of base_color, metallic, conductor, mdf, brdf nor specular.
struct Material {
    std::string name;
    glm::vec4 base_color{1.0f};
    TextureUse base_color_texture;
    float metallic = 1.0f;
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

    MaterialLobe lobe;                 // a fully rough GltfLobe, as glTF's default
    float anisotropy_rotation = 0.0f;  // radians, counter-clockwise from the tangent
    TextureUse anisotropy_texture;     // RG direction, B strength
    // Radians from the frame in which anisotropy_texture stores directions to that of the tangents:
    // not 0 where its transform and that of normal_texture turn differently. fit_tangents sets it.
    float anisotropy_texture_turn = 0.0f;

    // What glTF has no word for.
    // Its own Fresnel factor, or that of the film on it, instead of Schlick's with F0 = base color.
    std::optional<Conductor> conductor;
    float dielectric_f0 = 0.04f;
    // KHR_materials_specular: weight of a dielectric's specular term, and color of its reflectance at
    // normal incidence, which multiplies dielectric_f0 (at most 1 is drawn).
    float specular = 1.0f;
    glm::vec3 specular_color{1.0f};
    TextureUse specular_texture;        // A
    TextureUse specular_color_texture;  // RGB
    Coat coat;
    Sheen sheen;
    Mdf mdf = Mdf::ggx;
    Brdf brdf = Brdf::microfacet;
    std::optional<float> ks;  // phong, lafortune: scale; none: as much as keeps its energy
    glm::vec3 lafortune_c{-1.0f, -1.0f, 1.0f};  // Cx, Cy, Cz: the mirror direction
    Method method = Method::follow_grain;
    std::optional<Process> process;  // that the file or a person names; renderers draw `method`
    bool conserve = false;           // deform-*: the energy-conserving form
    // microfacet, microfacet-separable: without the light that facets reflect more than once, as the
    // models were published (docs/theory/energy.md). The other models have none.
    bool single_scattering = false;

    bool operator==(const Material&) const = default;
};

// The material's lobe when it is of this kind, else nullptr.
inline const GltfLobe* gltf_lobe_of(const Material& material) {
    return std::get_if<GltfLobe>(&material.lobe);
}
inline const Cloth* cloth_of(const Material& material) {
    return std::get_if<Cloth>(&material.lobe);
}
inline const Tabulated* tabulated_of(const Material& material) {
    return std::get_if<Tabulated>(&material.lobe);
}
// The pair (alpha_x, alpha_y) that an AlphaLobe or a Cloth states.
std::optional<glm::vec2> stated_alpha(const Material& material);

// The material with a neutral value for every member that its kind of lobe does not read: what
// renderers draw. drawn_material(drawn_material(m)) == drawn_material(m).
Material drawn_material(Material material);
std::vector<Material> drawn_materials(std::vector<Material> materials);

// The method that a renderer draws the material with. `normal-map` stands for what engines ship,
// and where nothing is anisotropic (one alpha, no strength, no anisotropy texture) they evaluate
// the isotropic D(n~.h), which is the rotated lobe: `gram-schmidt` there, as every rotation is the
// same.
Method drawn_method(const Material& material);
// drawn_method of the material without its anisotropy texture.
Method untextured_method(const Material& material);

// Whether a layer lies over the surface, whatever its textures say.
inline bool has_coat(const Material& material) {
    return material.coat.strength > 0.0f;
}
inline bool has_sheen(const Material& material) {
    return material.sheen.color != glm::vec3(0.0f);
}
// Whether KHR_materials_specular changes the interface.
inline bool has_specular_factors(const Material& m) {
    return m.specular != 1.0f || m.specular_color != glm::vec3(1.0f) || m.specular_texture ||
           m.specular_color_texture;
}

// Whether a renderer adds the light that facets reflect more than once: cloth and tabulated materials
// have none to add.
bool is_compensated(const Material& material);

// An instance whose mesh is negative is an erased one: nothing is drawn.
struct Instance {
    int mesh = 0;      // index into Scene::meshes
    int material = 0;  // index into Scene::materials
    glm::mat4 transform{1.0f};
    bool operator==(const Instance&) const = default;
};

// The picture on a light: linear, RGB, times the radiance. Two with the same file are the same picture.
struct LightTexture {
    std::shared_ptr<const Image> image;  // null: white
    std::string file;  // where it is from, for scene files and messages; "": made in memory
    bool operator==(const LightTexture& other) const {
        return file == other.file && (!file.empty() || image == other.image);
    }
};

enum class LightType { directional, point, spot, rectangle, disc, tube };

struct Light {
    LightType type = LightType::directional;
    glm::vec3 color{1.0f};  // linear, times intensity: radiance scale of the light
    // Lux (directional), candela (point, spot), or candela per square meter: the radiance that a light
    // with an area emits, the same in all directions.
    float intensity = 1.0f;
    glm::vec3 position{0.0f};  // of a light with an area: its middle
    // Unit, the way the light travels: of a rectangle or disc the normal of its emitting side; of a tube
    // its axis.
    glm::vec3 direction{0.0f, 0.0f, -1.0f};
    float range = 0.0f;       // 0: unbounded
    float inner_cone = 0.0f;  // radians, spot only
    float outer_cone = 0.7853982f;
    // Lights with an area only (docs/theory/area-lights.md). They neither block light nor reflect it.
    glm::vec2 size{1.0f};  // meters, above 0: width and height, of a tube length and diameter
    glm::vec3 up{0.0f, 1.0f,
                 0.0f};      // towards the upper edge; not along `direction`, need not be unit
    bool two_sided = false;  // rectangle, disc: the back emits as well
    bool visible = true;     // shown in the picture, from sides that emit
    // Rectangle: its upper edge lies at the upper edge of the light, seen from the side that emits.
    LightTexture texture{};
    bool operator==(const Light&) const = default;
};

// rectangle, disc, tube
inline bool has_area(const Light& light) {
    return light.type >= LightType::rectangle;
}

struct Camera {
    glm::vec3 position{0.0f, 0.0f, 3.0f};
    glm::vec3 target{0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    bool orthographic = false;
    float yfov = 0.6f;        // radians
    float ymag = 1.0f;        // half height of an orthographic view, metres
    float near_plane = 0.0f;  // 0: chosen from the scene's bounds
    float far_plane = 0.0f;
    bool operator==(const Camera&) const = default;
};

// Light from everywhere: a lat-long radiance map, +y up, row 0 at the zenith. The middle of the
// picture looks along -z (what a camera at +z sees behind the model) and columns run towards +x: u
// = 1/2 + atan2(x, -z) / (2 pi), v = acos(y) / pi.
struct Environment {
    std::string name;
    Image radiance;  // RGB
    // What is seen behind the scene in its place, a lat-long map too; empty: the radiance.
    Image backdrop;
};

// A scene owns its data; distinct scenes may be used by distinct threads at once, and one scene by
// any number of readers.
//
// The index of a mesh, material, texture, instance or light is its id: it holds as long as nothing
// is erased from the middle of a vector. To change a scene that a renderer draws, assign to an
// element or append one. To erase an instance, set its mesh to -1: its place stays, so that no
// other id moves. A material, mesh or texture that no instance uses costs memory alone, and its
// place may be assigned anew.
struct Scene {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Material> materials;  // never empty when there is an instance
    std::vector<Texture> textures;
    std::vector<Instance> instances;
    std::vector<Light> lights;
    std::vector<Camera> cameras;        // those stored in the file, in order
    std::vector<std::string> warnings;  // what will look different, one line each
    std::vector<std::string> notes;     // what was chosen, one line each
};

// Bounds of all instances in world space.
Bounds bounds_of(const Scene& scene);

}  // namespace burnish
