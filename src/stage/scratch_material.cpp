#include "stage/scratch_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "burnish/error.hpp"
#include "core/memory.hpp"
#include "image/image_io.hpp"
#include "maps/scratch/scratch.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "scratch ";

using Rows = std::function<void(int begin, int end, float* to)>;

// 16 bits: 8 would show as steps in the highlight of a smooth metal.
Texture texture_of(const std::string& name, int size, const Rows& rows) {
    Texture texture{name, size, size, 3, TexelType::u16, ColorSpace::linear, {}};
    const std::size_t row = 3 * static_cast<std::size_t>(size);
    texture.texels.resize(row * static_cast<std::size_t>(size) * sizeof(std::uint16_t));
    constexpr int kStrip = 64;
    std::vector<float> values(row * kStrip);
    std::byte* to = texture.texels.data();
    for (int y = 0; y < size; y += kStrip) {
        const int end = std::min(y + kStrip, size);
        rows(y, end, values.data());
        for (std::size_t i = 0; i < row * static_cast<std::size_t>(end - y); ++i) {
            const auto code = static_cast<std::uint16_t>(values[i] * 65535.0f + 0.5f);
            std::memcpy(to, &code, sizeof code);
            to += sizeof code;
        }
    }
    return texture;
}

struct ScratchTextures {
    Texture normal, anisotropy;
};

ScratchTextures engraved(const std::string& preset) {
    ScratchSettings settings = scratch_preset(preset, "scratch");
    settings.size = kScratchPresetSize;
    const ScratchMaps maps = engrave(settings, {}, available_memory());
    const ScratchLayer& ground = settings.layers.front();
    return {texture_of({}, maps.size,
                       [&](int begin, int end, float* to) { normal_rows(maps, begin, end, to); }),
            texture_of({}, maps.size, [&](int begin, int end, float* to) {
                stretch_rows(maps, ground, begin, end, to);
            })};
}

Texture read_map(const fs::path& file) {
    Texture texture = read_texture(file, ColorSpace::linear);
    if (texture.channels < 3)
        throw Error(file.string(), "channels", "3", std::to_string(texture.channels));
    return texture;
}

ScratchTextures textures_named(const std::string& name, bool follow) {
    if (is_scratch_preset(name)) return engraved(name);
    std::error_code error;
    if (!fs::is_directory(name, error))
        throw UsageError("scratch", "",
                         fmt::format("a folder made by burnish scratch, or {}",
                                     fmt::join(scratch_preset_names(), ", ")),
                         shown(name));
    const fs::path folder = name;
    return {read_map(folder / "normal.png"),
            follow ? read_map(folder / "anisotropy.png") : Texture{}};
}

int texture_index(const Scene& scene, const std::string& name) {
    for (std::size_t i = 0; i < scene.textures.size(); ++i)
        if (scene.textures[i].name == name) return static_cast<int>(i);
    return -1;
}

int add_texture(Scene& scene, Texture texture, const std::string& name) {
    const int known = texture_index(scene, name);
    if (known >= 0 || texture.empty()) return known;
    texture.name = name;
    scene.textures.push_back(std::move(texture));
    return static_cast<int>(scene.textures.size() - 1);
}

TextureUse use_of(int texture) {
    TextureUse use;
    use.texture = texture;
    return use;
}

// The map stores the direction of stretch, across the groove; the material's grooves run along the
// smaller alpha, so a pair whose smaller one is x has to be turned.
void follow_grooves(Material& material, const ParameterValues& values, int texture) {
    material.anisotropy_texture = use_of(texture);
    const float turn = values.is_set("anisotropy_rotation")
                           ? glm::radians(static_cast<float>(values.real("anisotropy_rotation")))
                           : 0.0f;
    const bool along_x = material.alpha && material.alpha->x < material.alpha->y;
    material.anisotropy_rotation = turn + (along_x ? 0.5f * std::numbers::pi_v<float> : 0.0f);
}

}  // namespace

bool is_scratch_preset(std::string_view name) {
    const auto names = scratch_preset_names();
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_scratch_texture(const Texture& texture) {
    return texture.name.starts_with(kPrefix);
}

void apply_scratch(Scene& scene, std::size_t first, std::size_t count,
                   const ParameterValues& values) {
    if (!values.is_set("scratch") || count == 0) return;
    if (values.is_set("normal_map"))
        throw UsageError("scratch", "", "a scratch map or a normal_map, not both", "both");
    const std::string name = values.text("scratch");
    const bool follow = values.text("scratch_direction") == "follow";
    const std::string normal_name = std::string(kPrefix) + name + ": normal";
    const std::string anisotropy_name = std::string(kPrefix) + name + ": anisotropy";
    int normal = texture_index(scene, normal_name);
    int anisotropy = texture_index(scene, anisotropy_name);
    if (normal < 0 || (follow && anisotropy < 0)) {
        ScratchTextures made = textures_named(name, follow);
        normal = add_texture(scene, std::move(made.normal), normal_name);
        if (follow) anisotropy = add_texture(scene, std::move(made.anisotropy), anisotropy_name);
    }
    for (std::size_t i = first; i < first + count; ++i) {
        Material& material = scene.materials[i];
        material.normal_texture = use_of(normal);
        if (!values.is_set("normal_scale")) material.normal_scale = 1.0f;
        material.flip_green = false;
        if (follow) follow_grooves(material, values, anisotropy);
    }
}

}  // namespace burnish
