#include "stage/scratch_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/scratch_maps.hpp"
#include "core/memory.hpp"
#include "formats/own_folder.hpp"
#include "stage/folder_hint.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

using Rows = std::function<void(int begin, int end, float* to)>;

// 16 bits: with 8, the highlight of a smooth metal would show steps.
Texture texture_of(int size, const Rows& rows) {
    Texture texture{{}, size, size, 3, TexelType::u16, ColorSpace::linear, {}};
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

ScratchTextures engraved(const std::string& preset) {
    ScratchSettings settings = scratch_preset(preset, "scratch");
    settings.size = kScratchPresetSize;
    return scratch_textures(engrave(settings, {}, available_memory()), settings.layers.front());
}

// What `burnish scratch` writes into its pictures; 0 where it is not there, or no number.
double tile_mm_of(const fs::path& picture) {
    const auto metadata = read_image_info(picture).metadata;
    const auto found = metadata.find("burnish:tile_mm");
    if (found == metadata.end()) return 0.0;
    double value = 0.0;
    const char* end = found->second.data() + found->second.size();
    const auto [stop, error] = std::from_chars(found->second.data(), end, value);
    return error == std::errc() && stop == end && value > 0.0 && value < 1e9 ? value : 0.0;
}

Texture read_map(const fs::path& file) {
    Texture texture = read_texture(file, ColorSpace::linear);
    if (texture.channels < 3)
        throw Error(file.string(), "channels", "3", std::to_string(texture.channels));
    return texture;
}

// A folder that states its kind must be one of scratches; another one needs the normal map.
void require_scratch_folder(const std::string& name) {
    const std::string expected = fmt::format("a folder made by burnish scratch, or {}",
                                             fmt::join(scratch_preset_names(), ", "));
    std::error_code error;
    if (!fs::is_directory(name, error))
        throw UsageError(
            "scratch", "", expected,
            shown(name) +
                (fs::exists(name, error) ? ", a file (--normal-map takes a normal map)" : ""));
    const auto kind = own_folder_kind(name);
    if (kind ? *kind != OwnFolderKind::scratch : !fs::exists(fs::path(name) / "normal.png", error))
        refuse_folder("scratch", expected, name);
}

bool is_preset(std::string_view name) {
    const auto names = scratch_preset_names();
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

ScratchTextures scratch_textures(const ScratchMaps& maps, const ScratchLayer& ground) {
    return {texture_of(maps.size,
                       [&](int begin, int end, float* to) { normal_rows(maps, begin, end, to); }),
            texture_of(maps.size, [&](int begin, int end,
                                      float* to) { stretch_rows(maps, ground, begin, end, to); }),
            maps.tile_mm};
}

ScratchTextures load_scratch(const std::string& name, bool with_anisotropy) {
    ScratchTextures textures;
    if (is_preset(name)) {
        textures = engraved(name);
    } else {
        require_scratch_folder(name);
        const fs::path folder = name;
        textures.normal = read_map(folder / "normal.png");
        textures.tile_mm = tile_mm_of(folder / "normal.png");
        if (with_anisotropy) textures.anisotropy = read_map(folder / "anisotropy.png");
    }
    textures.normal.name = "scratch " + name + ": normal";
    textures.anisotropy.name = "scratch " + name + ": anisotropy";
    return textures;
}

double scratch_tile_mm(const std::string& name) {
    if (is_preset(name)) return scratch_preset(name, "scratch").tile_mm;
    const fs::path normal = fs::path(name) / "normal.png";
    std::error_code error;
    return fs::exists(normal, error) ? tile_mm_of(normal) : 0.0;
}

}  // namespace burnish
