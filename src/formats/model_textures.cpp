#include "formats/model_textures.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "burnish/error.hpp"
#include "core/text.hpp"
#include "maps/normal/normal_without_z.hpp"
#include "scene/material/texture_uses.hpp"

namespace burnish {
namespace {

void make_stand_in(Texture& texture) {
    const ColorSpace space = texture.color_space;
    texture = Texture{"white", 1, 1, 3, TexelType::u8, space, {}};
    texture.texels.assign(3, std::byte{0xFF});
}

// Takes texture `index` out of the material; returns the names of its uses.
std::string take_out(Material& material, int index) {
    std::string names;
    const auto uses = texture_uses(material);
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (uses[i]->texture != index) continue;
        *uses[i] = TextureUse();
        names += fmt::format("{}{}", names.empty() ? "" : ", ", kTextureNames[i]);
        if (uses[i] == &material.emissive_texture && !emits_only(material))
            material.emissive = glm::vec3(0.0f);
    }
    return names;
}

bool has_other_use(const Scene& scene, int index) {
    for (const Material& material : scene.materials)
        for (const TextureUse* use : texture_uses(material))
            if (use != &material.normal_texture && use != &material.coat.normal_texture &&
                use->texture == index)
                return true;
    return false;
}

}  // namespace

bool emits_only(const Material& material) {
    return material.brdf == Brdf::phong && material.ks == 0.0f;
}

std::vector<std::string> leave_out_textures(Scene& scene,
                                            const std::vector<std::string>& failures) {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < failures.size(); ++i) {
        if (failures[i].empty()) continue;
        make_stand_in(scene.textures[i]);
        std::string users;
        std::size_t count = 0;
        for (Material& material : scene.materials) {
            const std::string names = take_out(material, static_cast<int>(i));
            if (names.empty()) continue;
            if (++count == 1) users = fmt::format("{} of {}", names, one_line(material.name));
        }
        if (count > 1) users += fmt::format(" and {} more materials", count - 1);
        if (count > 0)
            warnings.push_back(fmt::format("{}: drawn without it: {}", failures[i], users));
    }
    return warnings;
}

std::string gray_packed_warning(const Texture& texture, std::string_view role) {
    if (texture.channels >= 3 || texture.empty()) return "";
    return fmt::format(
        "{}: expected a {} map with red, green and blue, found a gray picture: every property is "
        "drawn from its gray (a map of one property has a flag of its own, such as "
        "--roughness-map)",
        one_line(texture.name), role);
}

std::vector<std::string> gray_packed_warnings(const Scene& scene) {
    std::vector<std::string> warnings;
    const auto check = [&](const TextureUse& use, std::string_view role) {
        if (!use) return;
        std::string line =
            gray_packed_warning(scene.textures[static_cast<std::size_t>(use.texture)], role);
        if (!line.empty()) append_once(warnings, std::move(line));
    };
    for (const Material& material : scene.materials) {
        check(material.metallic_roughness_texture, "metallic-roughness");
        check(material.anisotropy_texture, "anisotropy");
    }
    return warnings;
}

std::vector<std::string> complete_normal_maps(Scene& scene) {
    std::vector<std::string> warnings;
    std::map<int, int> completed;  // texture -> the map to use in its place
    std::vector<TextureUse*> uses;
    for (Material& material : scene.materials)
        for (TextureUse* use : {&material.normal_texture, &material.coat.normal_texture})
            if (*use) uses.push_back(use);
    for (TextureUse* const in_use : uses) {
        TextureUse& use = *in_use;
        auto found = completed.find(use.texture);
        if (found == completed.end()) {
            const int index = use.texture;
            found = completed.emplace(index, index).first;
            std::optional<Texture> map =
                normal_map_without_z(scene.textures[static_cast<std::size_t>(index)]);
            if (map) {
                warnings.push_back(normal_without_z_warning(map->name));
                if (has_other_use(scene, index)) {
                    found->second = static_cast<int>(scene.textures.size());
                    scene.textures.push_back(std::move(*map));
                } else {
                    scene.textures[static_cast<std::size_t>(index)] = std::move(*map);
                }
            }
        }
        use.texture = found->second;
    }
    return warnings;
}

}  // namespace burnish
