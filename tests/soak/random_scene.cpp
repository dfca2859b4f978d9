#include "random_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>

#include "burnish/builtin_meshes.hpp"
#include "burnish/conductors.hpp"
#include "burnish/draft.hpp"
#include "burnish/environments.hpp"
#include "burnish/parameters.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/stage.hpp"

namespace burnish::soak {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Ends of ranges are where things go wrong; small numbers want their share of wide ranges.
double value_within(Random& random, double low, double high) {
    if (one_in(random, 8)) return one_in(random, 2) ? low : high;
    if (one_in(random, 2)) return between(random, low, high);
    const double near = std::clamp(0.0, low, high);
    const double end = one_in(random, 2) ? low : high;
    return near + (end - near) * std::pow(10.0, between(random, -6.0, 0.0));
}

std::string text_of(const Parameter& parameter, Random& random) {
    const auto value = [&] { return value_within(random, parameter.low, parameter.high); };
    switch (parameter.kind) {
        case ParameterKind::real:
            return fmt::format("{}", value());
        case ParameterKind::integer:
            return fmt::format("{:.0f}", value());
        case ParameterKind::boolean:
            return one_in(random, 2) ? "true" : "false";
        case ParameterKind::choice:
            return std::string(parameter.choices[below(random, parameter.choices.size())]);
        case ParameterKind::color:
        case ParameterKind::vector: {
            const double x = value(), y = value(), z = value();
            return fmt::format("{},{},{}", x, y, z);
        }
        case ParameterKind::text:
            break;
    }
    return {};
}

// Left to chance alone these would ask for hours, for files, or for two things at once.
bool is_set_elsewhere(std::string_view name) {
    static constexpr std::string_view kNames[] = {
        "width",      "height",       "samples", "image_light_samples", "triangles",
        "normal_map", "camera_index", "scratch", "scratch_direction",   "cosine_exponent",
        "weave",      "tabulated"};
    return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

ParameterValues random_values(Random& random) {
    ParameterValues values;
    const bool woven = one_in(random, 6);
    const bool exponents = one_in(random, 2);
    for (const Parameter& parameter : parameter_table()) {
        const bool other_way = parameter.name.starts_with(exponents ? "alpha_" : "e_");
        if (is_set_elsewhere(parameter.name) || other_way || !one_in(random, 3)) continue;
        if (parameter.kind == ParameterKind::text) continue;  // files
        if (parameter.belongs_to == "weave" && !woven) continue;
        // A camera at a chance place of a thousand kilometres sees nothing.
        const bool placed = parameter.name.starts_with("camera_") && !one_in(random, 8);
        if (placed && parameter.kind == ParameterKind::vector) continue;
        if (placed && parameter.name == "camera_distance") continue;
        values.set(parameter.name, text_of(parameter, random), "");
    }
    const auto set = [&](std::string_view name, std::size_t low, std::size_t high) {
        values.set(name, std::to_string(low + below(random, high - low + 1)), "");
    };
    set("width", 32, 96);
    set("height", 32, 96);
    set("samples", 1, 4);
    set("image_light_samples", 1, 16);
    set("triangles", 20, 4000);
    if (woven)
        values.set("weave", std::string(draft_names()[below(random, draft_names().size())]), "");
    else if (one_in(random, 16))
        values.set("normal_map", "builtin:bumps", "");
    // Refused with a line, which is not what is tried here.
    if (values.is_set("brdf") && !has_half_vectors(static_cast<Brdf>(values.choice("brdf"))))
        values.set("method", "follow-grain", "");
    return values;
}

// --- what the table has no word for -----------------------------------------------------------

int add_texture(Scene& scene, Random& random, ColorSpace color_space) {
    constexpr std::size_t kBytes[] = {1, 2, 4};
    Texture texture;
    texture.name = "random";
    texture.width = static_cast<int>(1 + below(random, 64));
    texture.height = static_cast<int>(1 + below(random, 64));
    texture.channels = static_cast<int>(3 + below(random, 2));
    texture.type = static_cast<TexelType>(below(random, 3));
    texture.color_space = texture.type == TexelType::f32 ? ColorSpace::linear : color_space;
    texture.texels.resize(static_cast<std::size_t>(texture.width) *
                          static_cast<std::size_t>(texture.height) *
                          static_cast<std::size_t>(texture.channels) *
                          kBytes[static_cast<std::size_t>(texture.type)]);
    // Any bit pattern: as floats, NaN and infinities and 1e38 among them.
    for (std::byte& byte : texture.texels) byte = static_cast<std::byte>(random() & 0xFF);
    scene.textures.push_back(std::move(texture));
    return static_cast<int>(scene.textures.size()) - 1;
}

TextureUse random_use(Scene& scene, Random& random, ColorSpace color_space) {
    TextureUse use;
    use.texture = add_texture(scene, random, color_space);
    use.texcoord = static_cast<int>(below(random, 2));
    use.wrap_s = static_cast<Wrap>(below(random, 3));
    use.wrap_t = static_cast<Wrap>(below(random, 3));
    use.nearest = one_in(random, 4);
    if (one_in(random, 2))
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 2; ++r)
                use.transform[c][r] = static_cast<float>(between(random, -4, 4));
    return use;
}

void add_textures(Stage& stage, Random& random) {
    Material& m = stage.scene.materials.front();
    const auto maybe = [&](TextureUse& use, std::size_t count, ColorSpace color_space) {
        if (one_in(random, count)) use = random_use(stage.scene, random, color_space);
    };
    maybe(m.normal_texture, 2, ColorSpace::linear);
    maybe(m.anisotropy_texture, 4, ColorSpace::linear);
    maybe(m.base_color_texture, 4, ColorSpace::srgb);
    maybe(m.metallic_roughness_texture, 4, ColorSpace::linear);
    maybe(m.occlusion_texture, 6, ColorSpace::linear);
    maybe(m.emissive_texture, 6, ColorSpace::srgb);
    maybe(m.coat.texture, 8, ColorSpace::linear);
    maybe(m.coat.roughness_texture, 8, ColorSpace::linear);
    maybe(m.coat.normal_texture, 8, ColorSpace::linear);
    maybe(m.sheen.color_texture, 8, ColorSpace::srgb);
    maybe(m.sheen.roughness_texture, 8, ColorSpace::linear);
}

Light random_light(Random& random) {
    Light light;
    light.type = static_cast<LightType>(below(random, 3));
    for (int i = 0; i < 3; ++i) {
        light.color[i] = static_cast<float>(between(random, 0, 1));
        light.position[i] = static_cast<float>(between(random, -2, 2));
        light.direction[i] = static_cast<float>(between(random, -1, 1));
    }
    light.direction = glm::normalize(light.direction + glm::vec3(0.0f, 1e-3f, 0.0f));
    light.intensity = static_cast<float>(std::pow(10.0, between(random, -3, 6)));
    light.range = one_in(random, 2) ? 0.0f : static_cast<float>(between(random, 0.01, 10));
    light.outer_cone = static_cast<float>(between(random, 0.002, 1.57));
    light.inner_cone = static_cast<float>(between(random, 0, light.outer_cone));
    return light;
}

// What shaders are compiled for.
void vary_models(Material& m, Random& random) {
    m.mdf = static_cast<Mdf>(below(random, mdf_names().size()));
    m.brdf = static_cast<Brdf>(below(random, brdf_names().size()));
    m.method = static_cast<Method>(below(random, method_names().size()));
    m.conserve = one_in(random, 2);
    m.alpha_mode = static_cast<AlphaMode>(below(random, 3));
    m.conductor.reset();
    if (!one_in(random, 4)) return;
    const std::string_view metal = conductor_names()[below(random, conductor_names().size())];
    m.conductor = conductor_preset(metal);
    if (one_in(random, 2) && !oxide_of(metal).empty())
        m.conductor->oxide =
            oxide_film(metal, static_cast<float>(value_within(random, 0.0, 1000.0)));
}

void vary_factors(Material& m, Random& random) {
    const auto unit = [&] { return static_cast<float>(between(random, 0, 1)); };
    m.alpha_cutoff = unit();
    m.base_color = {unit(), unit(), unit(), unit()};
    m.metallic = unit();
    m.occlusion_strength = unit();
    m.coat.strength = one_in(random, 3) ? unit() : 0.0f;
    m.coat.roughness = unit();
    m.coat.tint = {unit(), unit(), unit()};
    m.sheen.color = one_in(random, 3) ? glm::vec3(unit()) : glm::vec3(0.0f);
    m.sheen.roughness = unit();
    m.specular = one_in(random, 3) ? unit() : 1.0f;
    const glm::vec2 gltf(unit(), unit());
    m.anisotropy_rotation = static_cast<float>(between(random, -7, 7));
    const auto alpha = [&] { return static_cast<float>(value_within(random, 0.001, 1.5)); };
    if (Cloth* cloth = std::get_if<Cloth>(&m.lobe)) {
        cloth->alpha = {alpha(), alpha()};
    } else if (stated_alpha(m)) {
        m.lobe = AlphaLobe{{alpha(), alpha()}};
    } else {
        m.lobe = GltfLobe{gltf.x, gltf.y};
    }
    // Beyond the table's 16: files may say so, with either sign.
    if (one_in(random, 4)) m.normal_scale = static_cast<float>(between(random, -100, 100));
    if (one_in(random, 4)) m.emissive = glm::vec3(static_cast<float>(between(random, 0, 1e4)));
}

void vary(Camera& camera, Random& random) {
    const glm::vec3 away = camera.position - camera.target;
    // Nearer, and the target's rounding would swallow the step; farther, and nothing is seen.
    const double least = 1e-5 * glm::length(glm::dvec3(camera.target));
    const auto distance =
        static_cast<float>(std::max(std::pow(10.0, between(random, -1.5, 1.5)), least));
    camera.position = camera.target + distance * glm::normalize(away);
    camera.orthographic = one_in(random, 4);
    camera.ymag = static_cast<float>(between(random, 0.01, 3));
}

const Environment& studio() {
    static const Environment environment = load_environment("builtin:studio");
    return environment;
}

}  // namespace

double between(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

Environment random_environment(Random& random) {
    if (one_in(random, 8)) return {};
    if (one_in(random, 8)) return studio();
    Environment environment;
    environment.name = "random";
    const auto height = static_cast<int>(1 + below(random, 32));
    environment.radiance = Image(2 * height, height, 3);
    const double brightest = between(random, -3, 4);
    for (float& value : environment.radiance.pixels)
        value = one_in(random, 4)
                    ? 0.0f
                    : static_cast<float>(std::pow(10.0, between(random, -6, brightest)));
    return environment;
}

Stage random_stage(Random& random) {
    StageRequest request;
    const auto names = builtin_names();
    request.input = "builtin:" + std::string(names[below(random, names.size())]);
    request.environment = "none";
    request.values = random_values(random);
    Stage stage = set_stage(request);
    stage.environment = random_environment(random);
    const std::size_t lights = below(random, 5);
    for (std::size_t i = 0; i < lights; ++i) stage.scene.lights.push_back(random_light(random));
    add_textures(stage, random);
    return stage;
}

void change_models(Stage& stage, Random& random) {
    for (Material& material : stage.scene.materials) vary_models(material, random);
    RenderSettings& options = stage.settings;
    options.image_light = static_cast<ImageLight>(below(random, 4));
    options.background = static_cast<BackgroundKind>(below(random, 3));
    options.surface_pass = static_cast<SurfacePass>(below(random, 3));
}

void change_numbers(Stage& stage, Random& random) {
    for (Material& material : stage.scene.materials) vary_factors(material, random);
    vary(stage.camera, random);
    RenderSettings& options = stage.settings;
    options.environment_intensity = static_cast<float>(value_within(random, 0, 1e6));
    options.environment_rotation = static_cast<float>(between(random, -7, 7));
    options.background_blur = static_cast<float>(between(random, 0, 1));
    options.tile_size = one_in(random, 4) ? static_cast<int>(16 + below(random, 64)) : 0;
    options.seed = static_cast<unsigned>(random());
}

std::string break_stage(Stage& stage, Random& random) {
    Mesh& mesh = stage.scene.meshes.front();
    switch (below(random, 10)) {
        case 0:
            mesh.indices[below(random, mesh.indices.size())] = 1U << 30;
            return "an index out of range";
        case 1:
            mesh.normals.pop_back();
            return "a normal short";
        case 2:
            mesh.indices.pop_back();
            return "a corner short";
        case 3:
            stage.scene.instances.front().mesh = 7;
            return "an instance of no mesh";
        case 4:
            stage.scene.instances.front().transform[3][1] = kNan;
            return "a transform of NaN";
        case 5:
            stage.scene.materials.front().occlusion_texture.texture = 99;
            return "a texture out of range";
        case 6:  // of a texture in use: others are not looked at
            stage.scene.materials.front().base_color_texture.texture =
                add_texture(stage.scene, random, ColorSpace::srgb);
            stage.scene.textures.back().texels.pop_back();
            return "a texel short";
        case 7:
            stage.settings.width = 0;
            return "no width";
        case 8:
            stage.camera.target = stage.camera.position;
            return "a camera that looks at itself";
        default:
            stage.settings.samples = 0;
            return "no samples";
    }
}

BadValue bad_value(Random& random) {
    const auto table = parameter_table();
    for (;;) {
        const Parameter& parameter = table[below(random, table.size())];
        const bool number =
            parameter.kind == ParameterKind::real || parameter.kind == ParameterKind::integer;
        if (!number) continue;
        const char* kWords[] = {"nan", "inf", "", "1e999", "0x10", "1,2", "--1"};
        const std::string text = one_in(random, 2) ? fmt::format("{:.0f}", parameter.high + 1.0)
                                                   : kWords[below(random, std::size(kWords))];
        return {std::string(parameter.name), text};
    }
}

}  // namespace burnish::soak
