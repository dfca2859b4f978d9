#include "stage/material_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/trigonometric.hpp>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "burnish/f64.hpp"
#include "image/image_io.hpp"
#include "maps/normal/bumps.hpp"
#include "models/conductors.hpp"
#include "scene/geometry/builtin_meshes.hpp"
#include "stage/cloth_material.hpp"
#include "stage/scratch_material.hpp"
#include "stage/tabulated_apply.hpp"

namespace burnish {

namespace {

constexpr std::string_view kBumps = "builtin:bumps";
constexpr int kBumpsSize = 1024;

float real_of(const ParameterValues& values, std::string_view name) {
    return static_cast<float>(values.real(name));
}

// 16 bits: 8 would show as steps in the highlight of a smooth metal.
Texture bumps_texture() {
    const Image map = bump_normal_map(kBumpsSize);
    Texture texture{std::string(kBumps), map.width,          map.height, 3,
                    TexelType::u16,      ColorSpace::linear, {}};
    texture.texels.resize(map.pixels.size() * sizeof(std::uint16_t));
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        const auto code = static_cast<std::uint16_t>(std::lround(map.pixels[i] * 65535.0f));
        std::memcpy(texture.texels.data() + i * sizeof code, &code, sizeof code);
    }
    return texture;
}

// Index of the normal map in the scene's textures, read when it is not there yet.
int normal_map_index(Scene& scene, const std::string& name) {
    for (std::size_t i = 0; i < scene.textures.size(); ++i)
        if (scene.textures[i].name == name && scene.textures[i].color_space == ColorSpace::linear)
            return static_cast<int>(i);
    if (is_builtin(name) && name != kBumps)
        throw UsageError("normal_map", "", "a picture, builtin:bumps or none", shown(name));
    Texture texture = name == kBumps ? bumps_texture() : read_texture(name, ColorSpace::linear);
    if (texture.channels < 3)
        throw Error(name, "channels", "a normal map with red, green and blue",
                    std::to_string(texture.channels));
    texture.name = name;
    scene.textures.push_back(std::move(texture));
    return static_cast<int>(scene.textures.size() - 1);
}

float alpha_from_exponent(double e) {
    return static_cast<float>(std::sqrt(2.0 / (e + 2.0)));
}

float alpha_from_cosine_exponent(double n) {
    return static_cast<float>(f64::alpha_from_cosine_exponent(n));
}

// The pair that the values name, as alpha or as exponents. One alone sets both, unless the
// material has a pair already.
std::optional<glm::vec2> roughness_pair(const Material& material, const ParameterValues& values) {
    const auto pair_of = [&](std::string_view x, std::string_view y, auto convert) {
        glm::vec2 pair = material.alpha.value_or(glm::vec2(0.0f));
        const bool has_x = values.is_set(x), has_y = values.is_set(y);
        if (has_x) pair.x = convert(values.real(x));
        if (has_y) pair.y = convert(values.real(y));
        if (!material.alpha && !has_y) pair.y = pair.x;
        if (!material.alpha && !has_x) pair.x = pair.y;
        return pair;
    };
    const bool has_alpha = values.is_set("alpha_x") || values.is_set("alpha_y");
    const bool has_e = values.is_set("e_x") || values.is_set("e_y");
    require_one_roughness(values, false);
    if (values.is_set("cosine_exponent"))
        return glm::vec2(alpha_from_cosine_exponent(values.real("cosine_exponent")));
    if (has_alpha)
        return pair_of("alpha_x", "alpha_y", [](double a) { return static_cast<float>(a); });
    if (has_e) return pair_of("e_x", "e_y", alpha_from_exponent);
    return std::nullopt;
}

void apply_lobe(Material& material, const ParameterValues& values) {
    if (values.is_set("mdf")) material.mdf = static_cast<Mdf>(values.choice("mdf"));
    if (values.is_set("brdf")) material.brdf = static_cast<Brdf>(values.choice("brdf"));
    if (values.is_set("method")) material.method = static_cast<Method>(values.choice("method"));
    require_drawable(material.brdf, material.method);
    if (values.is_set("ks")) material.ks = real_of(values, "ks");
    if (values.is_set("lafortune_c")) material.lafortune_c = values.vec3("lafortune_c");
    if (values.is_set("conserve")) material.conserve = values.boolean("conserve");
    if (values.is_set("roughness")) material.roughness = real_of(values, "roughness");
    if (values.is_set("anisotropy")) material.anisotropy_strength = real_of(values, "anisotropy");
    if (values.is_set("anisotropy_rotation"))
        material.anisotropy_rotation = glm::radians(real_of(values, "anisotropy_rotation"));
    const std::optional<glm::vec2> pair = roughness_pair(material, values);
    if (pair) {
        material.alpha = pair;
    } else if (values.is_set("roughness") || values.is_set("anisotropy")) {
        material.alpha.reset();  // an earlier pair would hide them
    }
}

void apply_color(Material& material, const ParameterValues& values) {
    if (values.is_set("base_color"))
        material.base_color = glm::vec4(values.vec3("base_color"), material.base_color.a);
    if (values.is_set("metallic")) material.metallic = real_of(values, "metallic");
    if (values.is_set("f0")) material.dielectric_f0 = real_of(values, "f0");
    if (values.is_set("double_sided")) material.double_sided = values.boolean("double_sided");
    if (!values.is_set("metal")) return;
    const std::string metal = values.text("metal");
    if (metal == "none") {
        material.conductor.reset();
        return;
    }
    material.conductor = conductor_preset(metal);
    if (!values.is_set("metallic")) material.metallic = 1.0f;
}

void apply_normal_map(const Scene& scene, Material& material, const ParameterValues& values,
                      int texture) {
    if (values.is_set("normal_map")) {
        material.normal_texture = TextureUse{};
        material.normal_texture.texture = texture;
        if (!values.is_set("normal_scale")) material.normal_scale = 1.0f;
        if (!values.is_set("flip_green")) material.flip_green = false;
    }
    if (values.is_set("normal_scale")) material.normal_scale = real_of(values, "normal_scale");
    if (values.is_set("flip_green")) material.flip_green = values.boolean("flip_green");
    if (values.is_set("normal_filter"))
        material.normal_filter = static_cast<NormalFilter>(values.choice("normal_filter"));
    if (values.is_set("uv_scale")) {
        const float s = real_of(values, "uv_scale");
        const glm::mat3 scale(s, 0.0f, 0.0f, 0.0f, s, 0.0f, 0.0f, 0.0f, 1.0f);
        material.normal_texture.transform = scale * material.normal_texture.transform;
        const int turned = material.anisotropy_texture.texture;
        if (turned >= 0 && is_scratch_texture(scene.textures[static_cast<std::size_t>(turned)]))
            material.anisotropy_texture.transform = material.normal_texture.transform;
    }
}

// Values that the reflection models of the materials do not ask for.
void warn_of_idle_values(Scene& scene, std::size_t first, std::size_t end,
                         const ParameterValues& values) {
    const auto warn_unless = [&](std::string_view name, std::string_view users, auto uses) {
        if (!values.is_set(name) || first == end) return;
        for (std::size_t i = first; i < end; ++i)
            if (uses(scene.materials[i].brdf)) return;
        scene.warnings.push_back(fmt::format("{}: only {} asks for it: nothing changes",
                                             std::string(name), std::string(users)));
    };
    warn_unless("ks", "phong or lafortune", [](Brdf brdf) { return !has_half_vectors(brdf); });
    warn_unless("lafortune_c", "lafortune", [](Brdf brdf) { return brdf == Brdf::lafortune; });
    if (values.is_set("roughness") && roughness_pair({}, values))
        scene.warnings.push_back("roughness: the pair set beside it holds: nothing changes");
}

void warn_of_missing_coordinates(Scene& scene, std::size_t first, std::size_t end) {
    for (const Instance& instance : scene.instances) {
        const auto material = static_cast<std::size_t>(instance.material);
        if (material < first || material >= end) continue;
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        if (!mesh.texcoord0.empty()) continue;
        const Material& m = scene.materials[material];
        const char* detail = m.cloth ? "weave" : m.tabulated ? "tabulated material" : "normal map";
        const std::string warning = "mesh " + shown(mesh.name) +
                                    " has no texture coordinates: the " + detail + " does not show";
        if (std::find(scene.warnings.begin(), scene.warnings.end(), warning) ==
            scene.warnings.end())
            scene.warnings.push_back(warning);
    }
}

}  // namespace

void require_one_roughness(const ParameterValues& values, bool as_flags) {
    const auto set_among = [&](std::initializer_list<std::string_view> names) {
        std::string list;
        for (const std::string_view name : names) {
            if (!values.is_set(name)) continue;
            list += (list.empty() ? "" : " ") + (as_flags ? flag_of(name) : std::string(name));
        }
        return list;
    };
    const std::string alphas = set_among({"alpha_x", "alpha_y"});
    const std::string exponents = set_among({"e_x", "e_y"});
    const std::string cosine = set_among({"cosine_exponent"});
    std::string all;
    int ways = 0;
    for (const std::string& way : {alphas, exponents, cosine}) {
        if (way.empty()) continue;
        all += (all.empty() ? "" : " and ") + way;
        ++ways;
    }
    if (ways < 2) return;
    throw UsageError(all + " say the same thing: give one pair only");
}

void require_drawable(Brdf brdf, Method method) {
    if (f32::brdf_takes_method(static_cast<int>(brdf), static_cast<int>(method))) return;
    throw UsageError("method", "",
                     "a rotation such as follow-grain for brdf " + std::string(name_of(brdf)) +
                         ", which has no half vectors to deform",
                     std::string(name_of(method)));
}

void apply_material_parameters(Scene& scene, std::size_t first, std::size_t count,
                               const ParameterValues& values) {
    int texture = -1;
    if (values.is_set("normal_map") && values.text("normal_map") != "none" && count > 0) {
        texture = normal_map_index(scene, values.text("normal_map"));
        warn_of_missing_coordinates(scene, first, first + count);
    }
    for (std::size_t i = first; i < first + count; ++i) {
        apply_lobe(scene.materials[i], values);
        apply_color(scene.materials[i], values);
    }
    warn_of_idle_values(scene, first, first + count, values);
    apply_scratch(scene, first, count, values);
    if (values.is_set("scratch")) warn_of_missing_coordinates(scene, first, first + count);
    for (std::size_t i = first; i < first + count; ++i)
        apply_normal_map(scene, scene.materials[i], values, texture);
    apply_cloth(scene, first, count, values);
    if (values.is_set("weave")) warn_of_missing_coordinates(scene, first, first + count);
    apply_tabulated(scene, first, count, values);
    if (values.is_set("tabulated") && values.text("tabulated") != "none")
        warn_of_missing_coordinates(scene, first, first + count);
}

void apply_material_parameters(Scene& scene, const ParameterValues& values) {
    apply_material_parameters(scene, 0, scene.materials.size(), values);
}

}  // namespace burnish
