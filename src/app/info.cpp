#include "app/info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "burnish/scene.hpp"
#include "core/image_io.hpp"
#include "gpu/context.hpp"
#include "scene/load.hpp"

namespace burnish {

namespace {

std::string plural(std::size_t count, std::string_view word) {
    const bool es = word.ends_with("sh");
    return fmt::format("{} {}{}", count, word, count == 1 ? "" : es ? "es" : "s");
}

std::string describe_mesh(const Mesh& mesh) {
    return fmt::format("  mesh {}: {}, {}{}{}\n", mesh.name.empty() ? "(unnamed)" : mesh.name,
                       plural(mesh.indices.size() / 3, "triangle"),
                       plural(mesh.positions.size(), "vertice"),
                       mesh.texcoord0.empty() ? ", no texture coordinates" : "",
                       mesh.colors.empty() ? "" : ", vertex colours");
}

std::string describe_texture_use(const Scene& scene, std::string_view what, const TextureUse& use) {
    if (!use) return "";
    const Texture& texture = scene.textures[static_cast<std::size_t>(use.texture)];
    return fmt::format("    {}: {} {}x{}\n", what, texture.name, texture.width, texture.height);
}

std::string describe_material(const Scene& scene, const Material& m) {
    std::string text = fmt::format(
        "  material {}: base colour ({:.3g}, {:.3g}, {:.3g}), metallic {:.3g}, roughness {:.3g}",
        m.name.empty() ? "(unnamed)" : m.name, m.base_color.r, m.base_color.g, m.base_color.b,
        m.metallic, m.roughness);
    if (m.alpha) text += fmt::format(", alpha ({:.3g}, {:.3g})", m.alpha->x, m.alpha->y);
    if (m.anisotropy_strength > 0)
        text += fmt::format(", anisotropy {:.3g} turned {:.4g} deg", m.anisotropy_strength,
                            glm::degrees(m.anisotropy_rotation));
    if (m.alpha_mode != AlphaMode::opaque)
        text += m.alpha_mode == AlphaMode::mask ? ", alpha mask" : ", alpha blend";
    if (m.double_sided) text += ", double sided";
    text += '\n';
    text += describe_texture_use(scene, "base colour", m.base_color_texture);
    text += describe_texture_use(scene, "metallic-roughness", m.metallic_roughness_texture);
    text += describe_texture_use(scene, "normal", m.normal_texture);
    text += describe_texture_use(scene, "occlusion", m.occlusion_texture);
    text += describe_texture_use(scene, "emissive", m.emissive_texture);
    text += describe_texture_use(scene, "anisotropy", m.anisotropy_texture);
    return text;
}

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
    for (const Mesh& mesh : scene.meshes) text += describe_mesh(mesh);
    for (const Material& material : scene.materials) text += describe_material(scene, material);
    for (const std::string& warning : scene.warnings) text += "  warning: " + warning + '\n';
    return text;
}

// Radiance figures weighted by solid angle, for pictures that could be environments.
std::string describe_radiance(const Image& image) {
    double sum = 0, weights = 0, peak = 0;
    for (int y = 0; y < image.height; ++y) {
        const double weight = std::sin((y + 0.5) / image.height * 3.14159265358979);
        for (int x = 0; x < image.width; ++x) {
            const float* p = image.at(x, y);
            const double luminance = image.channels < 3
                                         ? static_cast<double>(p[0])
                                         : 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
            sum += weight * luminance;
            weights += weight;
            peak = std::max(peak, luminance);
        }
    }
    return fmt::format("  as an environment: mean radiance {:.4g}, brightest {:.4g}\n",
                       sum / weights, peak);
}

std::string describe_image(const std::string& path) {
    const ImageInfo info = read_image_info(path);
    std::string text =
        fmt::format("{}: {} image, {}x{}, {}, {}\n", path, info.format, info.width, info.height,
                    plural(static_cast<std::size_t>(info.channels), "channel"), info.pixel_type);
    for (const auto& [key, value] : info.metadata) text += fmt::format("  {}: {}\n", key, value);
    if (info.width == 2 * info.height) text += describe_radiance(read_image(path));
    return text;
}

}  // namespace

std::string describe_file(const std::string& path) {
    constexpr std::string_view kBuiltin = "builtin:";
    const auto shapes = builtin_names();
    const bool mesh = path.starts_with(kBuiltin) &&
                      std::find(shapes.begin(), shapes.end(), path.substr(kBuiltin.size())) !=
                          shapes.end();
    if (!mesh && path.starts_with(kBuiltin)) {
        const Environment environment = load_environment(path);
        return fmt::format("{}: environment, {}x{}\n{}", path, environment.radiance.width,
                           environment.radiance.height, describe_radiance(environment.radiance));
    }
    if (!mesh && is_image_file(path)) return describe_image(path);
    if (!mesh && is_scene_file(path)) return describe_scene(path, load_scene_file(path).scene);
    return describe_scene(path, load_model(path));
}

std::string describe_devices() {
    std::string text;
    for (const gpu::DeviceInfo& device : gpu::list_devices())
        text += fmt::format("device {}: {}{}\n", device.index, device.description,
                            device.software ? " (software)" : "");
    return text.empty() ? "no EGL device; Mesa's surfaceless software renderer is used\n" : text;
}

}  // namespace burnish
