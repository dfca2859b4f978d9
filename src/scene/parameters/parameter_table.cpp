#include <array>

#include "burnish/parameters.hpp"
#include "burnish/shading_names.hpp"
#include "image/display.hpp"

namespace burnish {

namespace {

using Kind = ParameterKind;
using Group = ParameterGroup;

// "none" and then conductor_names(), in that order (a test holds them together).
constexpr std::array<std::string_view, 8> kMetals = {"none",      "gold",  "silver", "copper",
                                                     "aluminium", "steel", "brass",  "titanium"};
constexpr std::array<std::string_view, 4> kImageLights = {"off", "importance", "bent-normal",
                                                          "prefiltered"};
constexpr std::array<std::string_view, 2> kNormalFilters = {"mips", "moments"};
constexpr std::array<std::string_view, 2> kScratchDirections = {"keep", "follow"};
constexpr std::array<std::string_view, 3> kBackgrounds = {"environment", "color", "transparent"};

// Positions and distances: a thousand kilometres leave float coordinates 6 cm apart, enough for
// any scene that can still be drawn.
constexpr double kFar = 1e6;
constexpr double kMaxSeed = 2147483647.0;

// The table while it is written: one call a parameter, in the order of help texts.
struct Table {
    Group group = Group::material;
    std::vector<Parameter> rows;

    using Text = std::string_view;
    void real(Text name, double low, double high, Text standard, Text unit, Text help) {
        rows.push_back({name, group, Kind::real, low, high, standard, unit, help, {}});
    }
    void integer(Text name, double low, double high, Text standard, Text unit, Text help) {
        rows.push_back({name, group, Kind::integer, low, high, standard, unit, help, {}});
    }
    void boolean(Text name, Text standard, Text help) {
        rows.push_back({name, group, Kind::boolean, 0, 1, standard, "", help, {}});
    }
    void choice(Text name, std::span<const Text> choices, Text standard, Text help) {
        rows.push_back({name, group, Kind::choice, 0, 0, standard, "", help, choices});
    }
    void color(Text name, double high, Text standard, Text help) {
        rows.push_back({name, group, Kind::color, 0, high, standard, "", help, {}});
    }
    void vector(Text name, double reach, Text standard, Text help) {
        rows.push_back({name, group, Kind::vector, -reach, reach, standard, "", help, {}});
    }
    void position(Text name, Text help) {
        rows.push_back({name, group, Kind::vector, -kFar, kFar, "", "m", help, {}});
    }
    void text(Text name, Text help) {
        rows.push_back({name, group, Kind::text, 0, 0, "", "", help, {}});
    }
};

void add_material(Table& t) {
    t.group = Group::material;
    t.choice("mdf", mdf_names(), "ggx", "microfacet distribution of the specular lobe");
    t.choice("brdf", brdf_names(), "microfacet", "reflection model");
    t.choice("method", method_names(), "follow-grain",
             "what a normal map does to the anisotropic lobe");
    t.boolean("conserve", "false", "energy-conserving form of the deform methods");
    t.real("alpha_x", 0.001, 1.5, "", "", "roughness along the tangent; alone it sets both");
    t.real("alpha_y", 0.001, 1.5, "", "", "roughness across the tangent; alone it sets both");
    t.real("e_x", 0, 1000000, "", "",
           "Ashikhmin-Shirley exponent along the tangent, alpha = sqrt(2 / (e + 2))");
    t.real("e_y", 0, 1000000, "", "", "Ashikhmin-Shirley exponent across the tangent");
    t.real("cosine_exponent", 0, 100000, "", "",
           "Phong's and Lafortune's exponent n, alpha = 1 / sqrt(2 n + 1)");
    t.real("roughness", 0, 1, "", "", "perceptual roughness of glTF, alpha = roughness^2");
    t.real("anisotropy", 0, 1, "", "",
           "strength of KHR_materials_anisotropy: stretch along the tangent");
    t.real("anisotropy_rotation", -360, 360, "", "deg",
           "turn of the lobe, counter-clockwise from the tangent");
    t.real("ks", 0, 1e6, "", "",
           "scale of the phong and lafortune lobes (left out: as much as keeps their energy)");
    t.vector(
        "lafortune_c", 10, "-1,-1,1",
        "Cx,Cy,Cz of lafortune: -1,-1,1 leans to the mirror direction, 1,1,1 back to the light");
    t.real("metallic", 0, 1, "", "", "0 dielectric, 1 metal");
    t.color("base_color", 1, "",
            "diffuse colour, or reflectance of a metal: r,g,b linear or #rrggbb");
    t.choice("metal", kMetals, "", "measured metal with exact Fresnel instead of base_color");
    t.real("f0", 0, 1, "", "",
           "normal reflectance of a dielectric (0.04 is a refractive index of 1.5)");
    t.text("normal_map", "normal map: a picture, builtin:bumps, or none");
    t.real("normal_scale", 0, 16, "", "", "strength of the normal map (1 as stored)");
    t.boolean("flip_green", "", "the normal map has +y down (DirectX)");
    t.choice("normal_filter", kNormalFilters, "moments",
             "normal maps from afar: moments widens the lobe by the bumps too small to see, mips "
             "averages normals");
    t.text("scratch",
           "scratch map in place of a normal map: a folder made by burnish scratch, or brushed, "
           "fine-random, deep-gouges, circular-brushed, swirl-marks, tool-marks");
    t.choice("scratch_direction", kScratchDirections, "keep",
             "grooves of the lobe: keep the material's, or follow the scratches");
    t.text(
        "tabulated",
        "measured material in place of the lobe and its colours: a file of burnish capture fit, an "
        "RGL .bsdf (its distribution of normals), or none");
    t.real("uv_scale", 0.01, 1000, "", "",
           "repeats of the normal or scratch map, or the tabulated material, across the texture "
           "square");
    t.boolean("double_sided", "", "show back faces too");
}

// Defaults are those of Cloth (a test holds them together).
void add_cloth(Table& t) {
    t.text("weave",
           "woven cloth in place of a normal map: plain, twill-2-1, twill-2-2, twill-3-1, "
           "herringbone, satin-5, satin-8, basket, a .wif file, or none");
    t.real(
        "weave_yarns", 1, 100000, "100", "",
        "yarns of each family across the texture square; a multiple of the draft's repeat has no "
        "seam");
    t.real("weave_crimp", 0, 0.5, "0.15", "",
           "rise and fall of a yarn's middle line, in yarn spacings");
    t.real("weave_bulge", 0, 0.95, "0.7", "", "sine of the tilt of a yarn's surface at its edges");
    t.real("weave_gap", 0, 0.9, "0.08", "", "gap between neighbouring yarns, in yarn spacings");
    t.real("weave_twist", -85, 85, "20", "deg",
           "turn of the fibres, counter-clockwise from their yarn");
    t.real("weave_fuzz", 0, 1, "0.1", "",
           "disorder of the fibres: standard deviation of their slopes");
    t.color("warp_color", 1, "", "colour of the warp yarns, along the bitangent: r,g,b or #rrggbb");
    t.color("weft_color", 1, "", "colour of the weft yarns, along the tangent");
}

void add_render(Table& t) {
    t.group = Group::render;
    t.integer("width", 1, 16384, "1280", "px", "picture width");
    t.integer("height", 1, 16384, "720", "px", "picture height");
    t.integer("samples", 1, 65536, "64", "", "jittered samples a pixel");
    t.choice(
        "image_light", kImageLights, "importance",
        "how the environment lights the surface: prefiltered is for turning a model, importance "
        "exact");
    t.integer("image_light_samples", 1, 1024, "16", "",
              "environment samples for each sample of a pixel");
    t.boolean("shadows", "true", "lights cast shadows");
    t.boolean("ground", "false", "the model's shadow on the plane under it");
    t.real("exposure", -20, 20, "0", "EV", "brightness, in powers of two");
    t.choice("tone_map", tone_map_names(), "khronos-neutral",
             "how radiance becomes display colour");
    t.choice("background", kBackgrounds, "environment", "what is behind the model");
    t.color("background_color", 1e6, "0.05,0.05,0.05",
            "for background color: r,g,b linear or #rrggbb");
    t.real("background_blur", 0, 1, "0", "", "blur of the environment as background");
    t.integer("seed", 0, kMaxSeed, "0", "", "seed of all random choices");
}

void add_camera(Table& t) {
    t.group = Group::camera;
    t.real("camera_azimuth", -360, 360, "30", "deg",
           "around the model: 0 looks along -z, 90 from +x");
    t.real("camera_elevation", -90, 90, "20", "deg", "above the horizon");
    t.real("camera_distance", 1e-4, kFar, "", "m",
           "from the target (default: the scene fills the view)");
    t.real("camera_fov", 1, 170, "30", "deg", "vertical field of view");
    t.position("camera_position", "x,y,z of the eye instead of azimuth, elevation and distance");
    t.position("camera_target", "x,y,z looked at (default: the middle of the scene)");
    t.integer("camera_index", 0, 65535, "", "", "use this camera of the file");
}

void add_environment_and_mesh(Table& t) {
    t.group = Group::environment;
    t.real("environment_rotation", -360, 360, "0", "deg", "turn of the environment about +y");
    t.real("environment_intensity", 0, 1e6, "1", "", "factor on the environment's radiance");
    t.group = Group::mesh;
    t.integer("triangles", 0, 4000000, "0", "", "wished size of a built-in mesh (0: its default)");
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

const Parameter* find_parameter(std::string_view name) {
    for (const Parameter& parameter : parameter_table())
        if (parameter.name == name) return &parameter;
    return nullptr;
}

}  // namespace burnish
