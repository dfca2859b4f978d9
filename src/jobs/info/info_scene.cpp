#include "jobs/info/info_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "burnish/conductors.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/scene_file.hpp"
#include "burnish/stage.hpp"
#include "core/text.hpp"
#include "scene/material/texture_uses.hpp"
#include "stage/normal_map_check.hpp"

namespace burnish {

namespace {

// The description of one item: words and numbers alternate. "roughness ", 0.5, ", ..." is stored as
// {"roughness ", ", ..."} and {0.5}. Items with the same words can share a line.
struct Description {
    std::string name;
    std::vector<std::string> words{""};
    std::vector<double> numbers{};

    Description& say(std::string_view text) {
        words.back() += text;
        return *this;
    }
    Description& say(double number) {
        numbers.push_back(number);
        words.emplace_back();
        return *this;
    }
};

// Up to this many items of one kind are listed one by one.
constexpr std::size_t kFew = 8;

std::string shown_number(double low, double high) {
    const auto plain = [](double number) {  // integers keep their digits
        return number == std::floor(number) ? fmt::format("{:.0f}", number)
                                            : fmt::format("{:.3g}", number);
    };
    const std::string from = plain(low), to = plain(high);
    return from == to ? from : fmt::format("{}..{}", from, to);
}

// The line for the items of `all` at `members`: a number that differs becomes a range.
std::string line_of(const std::vector<Description>& all, const std::vector<std::size_t>& members,
                    std::string_view kind) {
    const Description& first = all[members.front()];
    std::string text = members.size() == 1
                           ? fmt::format("  {} {}: ", kind, first.name)
                           : fmt::format("  {} {} .. {} ({}): ", kind, first.name,
                                         all[members.back()].name, plural(members.size(), kind));
    for (std::size_t i = 0; i < first.numbers.size(); ++i) {
        double low = first.numbers[i], high = low;
        for (const std::size_t member : members) {
            low = std::min(low, all[member].numbers[i]);
            high = std::max(high, all[member].numbers[i]);
        }
        text += first.words[i] + shown_number(low, high);
    }
    return text + first.words.back() + '\n';
}

// One line for each item, or one shared line for many items that differ only in numbers.
std::string lines_of(const std::vector<Description>& all, std::string_view kind) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto alike = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
            return all[group.front()].words == all[i].words;
        });
        if (alike == groups.end()) {
            groups.push_back({i});
        } else {
            alike->push_back(i);
        }
    }
    std::string text;
    for (const std::vector<std::size_t>& group : groups) {
        if (group.size() > kFew) {
            text += line_of(all, group, kind);
            continue;
        }
        for (const std::size_t member : group) text += line_of(all, {member}, kind);
    }
    return text;
}

std::string name_or_none(const std::string& name) {
    return name.empty() ? "(unnamed)" : name;
}

Description describe_mesh(const Mesh& mesh) {
    Description d{name_or_none(mesh.name)};
    d.say(static_cast<double>(mesh.indices.size() / 3)).say(" triangles, ");
    d.say(static_cast<double>(mesh.positions.size())).say(" vertices");
    if (mesh.texcoord0.empty()) d.say(", no texture coordinates");
    if (!mesh.colors.empty()) d.say(", vertex colors");
    return d;
}

std::string describe_texture_use(const Scene& scene, std::string_view what, const TextureUse& use) {
    if (!use) return "";
    const Texture& texture = scene.textures[static_cast<std::size_t>(use.texture)];
    // Textures inside a model are named "model.glb: images[2]"; the headline already names the
    // model.
    const std::size_t inside = texture.name.find(": ");
    const std::string name =
        inside == std::string::npos ? texture.name : texture.name.substr(inside + 2);
    return fmt::format("\n    {}: {} {}x{}", what, name, texture.width, texture.height);
}

void describe_lobe(const Material& m, Description& d) {
    const std::optional<glm::vec2> alpha = stated_alpha(m);
    const GltfLobe* gltf = gltf_lobe_of(m);
    const GltfLobe lobe = gltf ? *gltf : GltfLobe{};
    if (alpha) {
        d.say(", alpha (").say(alpha->x).say(", ").say(alpha->y).say(")");
    } else {
        d.say(", roughness ").say(lobe.roughness);
        if (lobe.anisotropy_strength > 0) d.say(", anisotropy ").say(lobe.anisotropy_strength);
    }
    if ((alpha || lobe.anisotropy_strength > 0) && m.anisotropy_rotation != 0)
        d.say(" turned ").say(glm::degrees(m.anisotropy_rotation)).say(" deg");
    if (m.mdf != Mdf::ggx) d.say(", ").say(name_of(m.mdf));
    if (m.brdf != Brdf::microfacet) d.say(", ").say(name_of(m.brdf));
}

void describe_layers(const Material& m, Description& d) {
    const auto color = [&](const glm::vec3& c) {
        d.say("(").say(c.r).say(", ").say(c.g).say(", ").say(c.b).say(")");
    };
    if (has_specular_factors(m)) {
        d.say(", specular ").say(m.specular);
        if (m.specular_color != glm::vec3(1.0f)) d.say(" "), color(m.specular_color);
    }
    if (has_sheen(m)) {
        d.say(", sheen "), color(m.sheen.color);
        d.say(" roughness ").say(m.sheen.roughness);
    }
    if (!has_coat(m)) return;
    d.say(", coat ").say(m.coat.strength).say(" roughness ").say(m.coat.roughness);
    if (m.coat.tint != glm::vec3(1.0f)) d.say(" tint "), color(m.coat.tint);
}

Description describe_material(const Scene& scene, const Material& material) {
    const Material m = drawn_material(material);
    Description d{name_or_none(m.name)};
    if (m.conductor) {
        const std::string_view metal = conductor_name(*m.conductor);
        d.say("metal ").say(metal.empty() ? "of its own" : metal);
        if (m.conductor->oxide)
            d.say(" under ").say(m.conductor->oxide->thickness_nm).say(" nm of oxide");
    } else {
        d.say("base color (").say(m.base_color.r).say(", ").say(m.base_color.g).say(", ");
        d.say(m.base_color.b).say(")");
    }
    if (!m.conductor || m.metallic != 1.0f) d.say(", metallic ").say(m.metallic);
    describe_lobe(m, d);
    if (m.alpha_mode != AlphaMode::opaque)
        d.say(m.alpha_mode == AlphaMode::mask ? ", alpha mask" : ", alpha blend");
    if (m.double_sided) d.say(", double sided");
    describe_layers(m, d);
    static constexpr std::array<const char*, kMaterialTextures> kWords = {
        "base color",  "metallic-roughness", "normal",         "occlusion", "emissive",
        "anisotropy",  "specular",           "specular color", "coat",      "coat roughness",
        "coat normal", "sheen color",        "sheen roughness"};
    const auto uses = texture_uses(m);
    for (std::size_t i = 0; i < uses.size(); ++i)
        d.say(describe_texture_use(scene, kWords[i], *uses[i]));
    return d;
}

std::string describe_camera(const Camera& camera) {
    const auto triple = [](const glm::vec3& v) {
        return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z);
    };
    return fmt::format("at {} towards {}, ", triple(camera.position), triple(camera.target)) +
           (camera.orthographic
                ? fmt::format("orthographic, {:.4g} m high", 2 * camera.ymag)
                : fmt::format("field of view {:.4g} deg", glm::degrees(camera.yfov)));
}

}  // namespace

std::string describe_scene(const std::string& path, const Scene& scene) {
    const Bounds bounds = bounds_of(scene);
    std::string text = fmt::format(
        "{}: {}, {}, {}, {}, {}, {}\n", path, plural(scene.instances.size(), "instance"),
        plural(scene.meshes.size(), "mesh"), plural(scene.materials.size(), "material"),
        plural(scene.textures.size(), "texture"), plural(scene.lights.size(), "light"),
        plural(scene.cameras.size(), "camera"));
    text += fmt::format("  bounds ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g}) m\n",
                        bounds.low.x, bounds.low.y, bounds.low.z, bounds.high.x, bounds.high.y,
                        bounds.high.z);
    std::vector<Description> meshes, materials;
    for (const Mesh& mesh : scene.meshes) meshes.push_back(describe_mesh(mesh));
    for (const Material& m : scene.materials) materials.push_back(describe_material(scene, m));
    text += lines_of(meshes, "mesh") + lines_of(materials, "material");
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        text += fmt::format("  camera {}: {}\n", i, describe_camera(scene.cameras[i]));
    for (const std::string& warning : scene.warnings) text += "  warning: " + warning + '\n';
    for (const std::string& note : scene.notes) text += "  note: " + note + '\n';
    return text;
}

std::string describe_scene_file(const std::string& path) {
    SceneFile file = load_scene_file(path);
    LayeredMaterials materials(file.scene.materials, file.layers);
    append_remarks(materials.apply(file.scene, {}), file.scene);
    warn_of_odd_normal_maps(file.scene);
    std::string text = describe_scene(path, file.scene);
    text += "  environment: " +
            (file.environment.empty() ? fmt::format("{} (default)", kDefaultEnvironment)
                                      : file.environment) +
            '\n';
    const double aspect = static_cast<double>(file.values.integer("width")) /
                          static_cast<double>(file.values.integer("height"));
    if (!file.scene.instances.empty())
        text += "  camera of the picture: " +
                describe_camera(place_camera(file.scene, file.values, aspect)) + '\n';
    return text;
}

}  // namespace burnish
