// The rows of THE parameter table. Names of choices stand beside their enumerations, and defaults
// in the structs that the values go into.
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <glm/trigonometric.hpp>

#include "burnish/conductors.hpp"
#include "burnish/display.hpp"
#include "burnish/parameters.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/scene.hpp"
#include "burnish/shading_names.hpp"

namespace burnish {

std::span<const std::string_view> scratch_direction_names() {
    static constexpr std::array<std::string_view, 2> kNames = {"keep", "follow"};
    return kNames;
}

namespace {

constexpr std::array<std::string_view, 2> kBitDepths = {"8", "16"};

using Kind = ParameterKind;
using Group = ParameterGroup;

// Largest position or distance, in meters. At a thousand kilometers float coordinates are 6 cm
// apart, which is enough for any scene that can be drawn.
constexpr double kFar = 1e6;
// Degrees. Angles wrap; beyond a hundred turns single precision would show its steps.
constexpr double kTurned = 36000;
constexpr double kMaxSeed = 2147483647.0;

// The decimal number that a float default of a struct stands for: 0.7, not 0.699999988. Every float
// keeps six digits.
double decimal(float value) {
    const std::string digits = fmt::format("{:.6g}", value);
    double number = 0.0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number;
}

template <typename Enumeration>
ParameterChoice choice_of(Enumeration value) {
    return {static_cast<int>(value)};
}

// The names "none" and those of the conductors.
std::span<const std::string_view> metals() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all{"none"};
        all.insert(all.end(), conductor_names().begin(), conductor_names().end());
        return all;
    }();
    return names;
}

// Builds the table: one call per parameter, in the order of help texts.
struct Table {
    using Text = std::string_view;
    using Default = std::optional<ParameterValue>;

    Group group = Group::material;
    Text belongs_to;  // of the rows that follow
    std::vector<Parameter> rows;

    void add(Text name, Kind kind, double low, double high, Default standard, Text unit, Text help,
             std::span<const Text> choices = {}) {
        rows.push_back({name, group, kind, low, high, std::move(standard), "", unit, help, choices,
                        belongs_to, ""});
        Parameter& row = rows.back();
        if (row.default_value) row.default_text = text_of(row, *row.default_value);
    }
    void real(Text name, double low, double high, Default standard, Text unit, Text help) {
        add(name, Kind::real, low, high, std::move(standard), unit, help);
    }
    void integer(Text name, double low, double high, Default standard, Text unit, Text help) {
        add(name, Kind::integer, low, high, std::move(standard), unit, help);
    }
    void boolean(Text name, Default standard, Text help) {
        add(name, Kind::boolean, 0, 1, std::move(standard), "", help);
    }
    void choice(Text name, std::span<const Text> choices, Default standard, Text help) {
        add(name, Kind::choice, 0, 0, std::move(standard), "", help, choices);
    }
    void color(Text name, double high, Default standard, Text help) {
        add(name, Kind::color, 0, high, std::move(standard), "", help);
    }
    void vector(Text name, double reach, Default standard, Text help) {
        add(name, Kind::vector, -reach, reach, std::move(standard), "", help);
    }
    void position(Text name, Text help) { add(name, Kind::vector, -kFar, kFar, {}, "m", help); }
    void text(Text name, Text help, Text names = "FILE") {
        add(name, Kind::text, 0, 0, {}, "", help);
        rows.back().names = names;
    }
};

void add_layers(Table& t) {
    t.real("coat", 0, 1, {}, "",
           "clear coat over the surface: the share of it that is coated (KHR_materials_clearcoat)");
    t.real("coat_roughness", 0, 1, {}, "", "perceptual roughness of the coat's face");
    t.color(
        "coat_tint", 1, {},
        "what the coat lets through along its normal and back, darker towards the edges: lacquer "
        "that is dyed, anodized aluminum");
    t.text("coat_normal_map", "normal map of the coat alone: a picture, builtin:bumps, or none");
    t.color("sheen_color", 1, {},
            "sheen of fibers that stand out, as of velvet (KHR_materials_sheen); 0 is none");
    t.real("sheen_roughness", 0, 1, {}, "",
           "perceptual roughness of the sheen; small ones show at the edges alone");
}

void add_material(Table& t) {
    t.group = Group::material;
    const Material standard;
    t.choice("mdf", mdf_names(), choice_of(standard.mdf),
             "microfacet distribution of the specular lobe");
    t.choice("brdf", brdf_names(), choice_of(standard.brdf), "reflection model");
    t.choice("method", method_names(), choice_of(standard.method),
             "what a normal map does to the anisotropic lobe");
    t.choice("process", process_names(), {},
             "how bumps and grain came together, which picks the method: follow-grain, rotate-arc, "
             "stretch or slope-shift");
    t.boolean("conserve", standard.conserve, "energy-conserving form of the deform methods");
    t.boolean(
        "single_scattering", standard.single_scattering,
        "microfacet models as published, without the light that facets reflect more than once");
    t.real("alpha_x", 0.001, 1.5, {}, "", "roughness along the tangent; alone it sets both");
    t.real("alpha_y", 0.001, 1.5, {}, "", "roughness across the tangent; alone it sets both");
    t.real("e_x", 0, 1000000, {}, "",
           "Ashikhmin-Shirley exponent along the tangent, alpha = sqrt(2 / (e + 2))");
    t.real("e_y", 0, 1000000, {}, "", "Ashikhmin-Shirley exponent across the tangent");
    t.real("cosine_exponent", 0, 100000, {}, "",
           "Phong's and Lafortune's exponent n, alpha = 1 / sqrt(2 n + 1)");
    t.real("roughness", 0, 1, {}, "", "perceptual roughness of glTF, alpha = roughness^2");
    t.real("anisotropy", 0, 1, {}, "",
           "strength of KHR_materials_anisotropy: stretch along the tangent");
    t.real("anisotropy_rotation", -kTurned, kTurned, {}, "deg",
           "turn of the lobe, counter-clockwise from the tangent");
    t.real("ks", 0, 1e6, {}, "",
           "scale of the phong and lafortune lobes (left out: as much as keeps their energy)");
    t.vector(
        "lafortune_c", 10, standard.lafortune_c,
        "Cx,Cy,Cz of lafortune: -1,-1,1 leans to the mirror direction, 1,1,1 back to the light");
    t.real("metallic", 0, 1, {}, "", "0 dielectric, 1 metal");
    t.color("base_color", 1, {},
            "diffuse color, or reflectance of a metal: r,g,b linear or #rrggbb");
    t.choice("metal", metals(), {}, "measured metal with exact Fresnel instead of base_color");
    t.belongs_to = "metal";
    t.real("oxide", 0, 1000, 0.0, "nm",
           "thickness of a film of oxide on the metal, which colors it by interference: anodized "
           "titanium, tempered steel");
    t.belongs_to = "";
    t.real("f0", 0, 1, {}, "",
           "normal reflectance of a dielectric (0.04 is a refractive index of 1.5)");
    t.real("ior", 1, 100, {}, "",
           "refractive index of a dielectric, in place of f0 (KHR_materials_ior): 1.5 is 0.04");
    t.real("specular", 0, 1, {}, "",
           "weight of a dielectric's specular term (KHR_materials_specular)");
    t.color(
        "specular_color", 1000, {},
        "color of a dielectric's normal reflectance, which it multiplies: r,g,b linear or #rrggbb");
    add_layers(t);
    t.text("normal_map", "normal map: a picture, builtin:bumps, or none");
    t.real("normal_scale", 0, 16, {}, "", "strength of the normal map (1 as stored)");
    t.boolean("flip_green", {}, "the normal map has +y down (DirectX)");
    t.choice("normal_filter", normal_filter_names(), choice_of(standard.normal_filter),
             "normal maps from afar: moments widens the lobe by the bumps too small to see, mips "
             "averages normals");
    t.text("maps",
           "folder of maps of one surface, told by their names (ambientCG, Poly Haven, cgbookcase, "
           "Substance, burnish export), or none",
           "FOLDER");
    t.belongs_to = "maps";
    t.real("maps_tile_mm", 0.001, 1000000, {}, "mm",
           "width of the maps on a model in meters, in place of uv_scale");
    t.belongs_to = "";
    t.text("base_color_map", "color, sRGB; its alpha is the coverage");
    t.text("roughness_map", "perceptual roughness of glTF, linear");
    t.text("glossiness_map", "1 - roughness, linear, in place of roughness_map");
    t.text("metallic_map", "0 dielectric, 1 metal, linear");
    t.text("orm_map", "red occlusion, green roughness, blue metallic: three maps in one");
    t.text("ao_map", "ambient occlusion, linear");
    t.text("anisotropy_map", "red and green direction, blue strength of KHR_materials_anisotropy");
    t.text("emissive_map", "emitted radiance, sRGB");
    t.text("height_map", "height in place of a normal map, linear: white is up");
    t.belongs_to = "height_map";
    t.real("height_scale", 0, 10, 0.02, "",
           "height of white over black in height_map, in sides of the texture square");
    t.belongs_to = "";
    t.text("scratch",
           "scratch map in place of a normal map: a folder made by burnish scratch, or brushed, "
           "fine-random, deep-gouges, circular-brushed, swirl-marks, tool-marks",
           "NAME|FOLDER");
    t.belongs_to = "scratch";
    t.choice("scratch_direction", scratch_direction_names(), choice_of(ScratchDirection::keep),
             "grooves of the lobe: keep the material's, or follow the scratches");
    t.belongs_to = "";
    t.boolean("physical_size", false,
              "scratches, maps and measured materials as large as their folder or file says, on a "
              "model in meters: sets uv_scale");
    t.text(
        "tabulated",
        "measured material in place of the lobe and its colors: a file of burnish capture fit, an "
        "RGL .bsdf (its distribution of normals), or none");
    t.real("uv_scale", 0.01, 1000, {}, "",
           "repeats of the normal or scratch map, or the tabulated material, across the texture "
           "square");
    t.boolean("double_sided", {}, "show back faces too");
}

void add_cloth(Table& t) {
    const Cloth standard;
    t.text("weave",
           "woven cloth in place of a normal map: plain, twill-2-1, twill-2-2, twill-3-1, "
           "herringbone, satin-5, satin-8, basket, a .wif file, or none",
           "NAME|FILE");
    t.belongs_to = "weave";
    t.real(
        "weave_yarns", 1, 100000, decimal(standard.yarns), "",
        "yarns of each family across the texture square; a multiple of the draft's repeat has no "
        "seam");
    t.real("weave_yarns_per_cm", 0.01, 1000, {}, "1/cm",
           "yarns a centimeter on a model in meters, in place of weave_yarns");
    t.real("weave_crimp", 0, 0.5, decimal(standard.crimp), "",
           "rise and fall of a yarn's middle line, in yarn spacings");
    t.real("weave_bulge", 0, 0.95, decimal(standard.bulge), "",
           "sine of the tilt of a yarn's surface at its edges");
    t.real("weave_gap", 0, 0.9, decimal(standard.gap), "",
           "gap between neighbouring yarns, in yarn spacings");
    t.real("weave_twist", -85, 85, decimal(glm::degrees(standard.twist)), "deg",
           "turn of the fibres, counter-clockwise from their yarn");
    t.real("weave_fuzz", 0, 1, decimal(standard.fuzz), "",
           "disorder of the fibres: standard deviation of their slopes");
    t.color("warp_color", 1, {}, "color of the warp yarns, along the bitangent: r,g,b or #rrggbb");
    t.color("weft_color", 1, {}, "color of the weft yarns, along the tangent");
    t.belongs_to = "";
}

void add_render(Table& t) {
    t.group = Group::render;
    const RenderSettings standard;
    t.integer("width", 1, 16384, standard.width, "px", "picture width");
    t.integer("height", 1, 16384, standard.height, "px", "picture height");
    t.integer("samples", 1, 65536, standard.samples, "", "jittered samples a pixel");
    t.choice(
        "image_light", image_light_names(), choice_of(standard.image_light),
        "how the environment lights the surface: prefiltered is for turning a model, importance "
        "exact");
    t.integer("image_light_samples", 1, 1024, standard.image_light_samples, "",
              "environment samples for each sample of a pixel");
    t.boolean(
        "robust_mean", true,
        "samples brighter than twice white count less, so that bright edges are smooth; never in "
        ".exr, which keeps energy");
    t.boolean("shadows", standard.shadows, "lights cast shadows");
    t.boolean("visibility", standard.visibility,
              "surfaces shade one another from the environment, found by rays");
    t.belongs_to = "visibility";
    t.integer(
        "bounces", 0, 8, standard.bounces, "",
        "reflections by which light reaches a place that other surfaces shade; 0: it stays black");
    t.integer("visibility_rays", 16, 4096, standard.visibility_rays, "",
              "rays of each vertex: more is smoother");
    t.belongs_to = "";
    t.boolean("ground", standard.ground, "the model's shadow on the plane under it");
    t.real("exposure", -20, 20, 0.0, "EV", "brightness, in powers of two");
    t.choice("tone_map", tone_map_names(), choice_of(ToneMap::khronos_neutral),
             "how radiance becomes display color");
    t.choice("background", background_names(), choice_of(standard.background),
             "what is behind the model");
    t.color("background_color", 1e6, standard.background_color,
            "for background color: r,g,b linear or #rrggbb");
    t.real("background_blur", 0, 1, decimal(standard.background_blur), "",
           "blur of the environment as background");
    t.choice("bit_depth", kBitDepths, ParameterChoice{0}, "bits a channel of .png and .tif");
    t.boolean("dither", true, "noise below one step of 8 bits, in place of bands");
    t.integer("seed", 0, kMaxSeed, static_cast<int>(standard.seed), "",
              "seed of all random choices");
}

void add_camera(Table& t) {
    t.group = Group::camera;
    t.real("camera_azimuth", -kTurned, kTurned, 30.0, "deg",
           "around the model: 0 looks along -z, 90 from +x");
    t.real("camera_elevation", -90, 90, 20.0, "deg", "above the horizon");
    t.real("camera_distance", 1e-4, kFar, {}, "m",
           "from the target (default: the scene fills the view)");
    t.real("camera_zoom", 0.01, 100, 1.0, "",
           "nearer by this factor than where the scene fills the view");
    t.real("camera_fov", 1, 170, 30.0, "deg", "vertical field of view");
    t.position("camera_position", "x,y,z of the eye instead of azimuth, elevation and distance");
    t.position("camera_target", "x,y,z looked at (default: the middle of the scene)");
    t.integer("camera_index", 0, 65535, {}, "", "use this camera of the file");
}

void add_environment_and_mesh(Table& t) {
    t.group = Group::environment;
    const RenderSettings standard;
    t.real("environment_rotation", -kTurned, kTurned,
           decimal(glm::degrees(standard.environment_rotation)), "deg",
           "turn of the environment about +y");
    t.real("environment_intensity", 0, 1e6, decimal(standard.environment_intensity), "",
           "factor on the environment's radiance");
    t.group = Group::mesh;
    t.integer("triangles", 0, 4000000, 0, "", "wished size of a built-in mesh (0: its default)");
}

std::vector<Parameter> make_table() {
    Table table;
    add_material(table);
    add_cloth(table);
    add_render(table);
    add_camera(table);
    add_environment_and_mesh(table);
    return table.rows;
}

}  // namespace

std::span<const Parameter> parameter_table() {
    static const std::vector<Parameter> table = make_table();
    return table;
}

}  // namespace burnish
