#include "stage/map_textures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "burnish/image_io.hpp"
#include "burnish/material_assets.hpp"
#include "core/parallel.hpp"
#include "core/text.hpp"
#include "formats/model_textures.hpp"
#include "image/texel_value.hpp"
#include "stage/folder_hint.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

struct Row {
    MapRole role;
    std::string_view parameter;
};
constexpr std::array<Row, 9> kRows = {{{MapRole::base_color, "base_color_map"},
                                       {MapRole::roughness, "roughness_map"},
                                       {MapRole::glossiness, "glossiness_map"},
                                       {MapRole::metallic, "metallic_map"},
                                       {MapRole::occlusion, "ao_map"},
                                       {MapRole::orm, "orm_map"},
                                       {MapRole::anisotropy, "anisotropy_map"},
                                       {MapRole::height, "height_map"},
                                       {MapRole::emissive, "emissive_map"}}};

// What a map takes the place of when a parameter names it.
std::vector<MapRole> replaced_by(MapRole role) {
    switch (role) {
        case MapRole::roughness:
            return {MapRole::glossiness};
        case MapRole::glossiness:
            return {MapRole::roughness};
        case MapRole::height:
            return {MapRole::normal, MapRole::normal_directx};
        case MapRole::orm: {
            std::vector<MapRole> replaced = {MapRole::roughness, MapRole::glossiness,
                                             MapRole::metallic, MapRole::occlusion};
            for (const MapRole packed : kPackedRoles)
                if (packed != role) replaced.push_back(packed);
            return replaced;
        }
        default:
            return {};
    }
}

// The maps that the parameters of single maps take the place of.
MapsBeside maps_beside(const ParameterValues& values) {
    MapsBeside beside;
    for (const auto& [role, parameter] : kRows) {
        if (!values.is_set(parameter)) continue;
        beside[role] = parameter;
        if (!names_one(values, parameter)) continue;
        for (const MapRole other : replaced_by(role)) beside.emplace(other, parameter);
    }
    return beside;
}

void add_single_maps(const ParameterValues& values, MapSet& set) {
    for (const auto& [role, parameter] : kRows) {
        if (!names_one(values, parameter)) continue;
        refuse_folder(parameter, "a picture", values.text(parameter));
        for (const MapRole other : replaced_by(role)) set.files.erase(other);
        set.files[role] = values.text(parameter);
    }
}

// One number a texel in [0, 1], between texels by bilinear interpolation; the map repeats.
class NumberMap {
  public:
    explicit NumberMap(const fs::path& file)
        : texture_(read_texture(file, ColorSpace::linear)), channel_(0) {}
    // `channel` as channel_in has it.
    NumberMap(Texture texture, int channel) : texture_(std::move(texture)), channel_(channel) {}

    int width() const { return texture_.width; }
    int height() const { return texture_.height; }

    float texel(int x, int y) const {
        const auto wrapped = [](int i, int n) { return ((i % n) + n) % n; };
        const std::size_t at = static_cast<std::size_t>(wrapped(y, texture_.height)) *
                                   static_cast<std::size_t>(texture_.width) +
                               static_cast<std::size_t>(wrapped(x, texture_.width));
        return texel_value(texture_, at * static_cast<std::size_t>(texture_.channels) +
                                         static_cast<std::size_t>(channel_));
    }

    // At the middle of a texel of a map of another size.
    float at(int x, int y, int width, int height) const {
        if (width == texture_.width && height == texture_.height) return texel(x, y);
        const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(width) *
                            static_cast<float>(texture_.width) -
                        0.5f;
        const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(height) *
                            static_cast<float>(texture_.height) -
                        0.5f;
        const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
        const float fx = u - std::floor(u), fy = v - std::floor(v);
        return std::lerp(std::lerp(texel(left, top), texel(left + 1, top), fx),
                         std::lerp(texel(left, top + 1), texel(left + 1, top + 1), fx), fy);
    }

  private:
    Texture texture_;
    int channel_;
};

// 16 bits: with 8, the highlight of a smooth metal would show steps.
Texture codes(std::string name, int width, int height, int channels, ColorSpace space) {
    Texture t{std::move(name), width, height, channels, TexelType::u16, space, {}};
    t.texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                    static_cast<std::size_t>(channels) * sizeof(std::uint16_t));
    return t;
}

template <typename Put>
void for_texels(int width, int height, const Put& put) {
    parallel_for(static_cast<std::size_t>(height), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y)
            for (int x = 0; x < width; ++x)
                put(x, static_cast<int>(y),
                    y * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    });
}

// Green roughness, blue metallic, as large as the larger of the two.
Texture metallic_roughness(const std::optional<NumberMap>& rough, bool glossy,
                           const std::optional<NumberMap>& metal) {
    const int width = std::max(rough ? rough->width() : 1, metal ? metal->width() : 1);
    const int height = std::max(rough ? rough->height() : 1, metal ? metal->height() : 1);
    Texture t = codes("roughness and metallic maps", width, height, 3, ColorSpace::linear);
    for_texels(width, height, [&](int x, int y, std::size_t i) {
        const float r = rough ? rough->at(x, y, width, height) : 1.0f;
        set_texel_value(t, 3 * i, 1.0f);
        set_texel_value(t, 3 * i + 1, glossy ? 1.0f - r : r);
        set_texel_value(t, 3 * i + 2, metal ? metal->at(x, y, width, height) : 1.0f);
    });
    return t;
}

// The normals of the slopes of a height, by central differences over two texels. The height's unit is
// a side of the texture square, along which both axes run from 0 to 1.
Texture normals_of_height(const NumberMap& height, float scale, const std::string& name) {
    Texture t = codes(name + ": normals", height.width(), height.height(), 3, ColorSpace::linear);
    const float per_u = 0.5f * scale * static_cast<float>(height.width());
    const float per_v = 0.5f * scale * static_cast<float>(height.height());
    for_texels(height.width(), height.height(), [&](int x, int y, std::size_t i) {
        const float sx = (height.texel(x - 1, y) - height.texel(x + 1, y)) * per_u;
        const float sy = (height.texel(x, y + 1) - height.texel(x, y - 1)) * per_v;
        const f32::vec3 n = f32::normal_of_slopes(sx, sy);
        set_texel_value(t, 3 * i, 0.5f + 0.5f * n.x);
        set_texel_value(t, 3 * i + 1, 0.5f + 0.5f * n.y);
        set_texel_value(t, 3 * i + 2, 0.5f + 0.5f * n.z);
    });
    return t;
}

// The base color with an alpha.
Texture with_opacity(const Texture& base, const NumberMap& opacity) {
    Texture t = codes(base.name, base.width, base.height, 4, base.color_space);
    const auto channels = static_cast<std::size_t>(base.channels);
    for_texels(base.width, base.height, [&](int x, int y, std::size_t i) {
        for (std::size_t c = 0; c < 3; ++c)
            set_texel_value(t, 4 * i + c,
                            texel_value(base, channels * i + (base.channels >= 3 ? c : 0)));
        set_texel_value(t, 4 * i + 3, opacity.at(x, y, base.width, base.height));
    });
    return t;
}

// One number as a texture of its own.
Texture one_channel(const NumberMap& map, std::string name) {
    Texture t = codes(std::move(name), map.width(), map.height(), 1, ColorSpace::linear);
    for_texels(map.width(), map.height(),
               [&](int x, int y, std::size_t i) { set_texel_value(t, i, map.texel(x, y)); });
    return t;
}

// A picture of several properties, read once.
struct Packed {
    fs::path path;
    Texture texture;
};

// Where a channel of a packed map, 0 red to 3 alpha, lies in a picture: gray is its red, green and
// blue. None: it has no alpha.
std::optional<int> channel_in(const Texture& texture, int channel) {
    const bool gray = texture.channels < 3, alpha = texture.channels % 2 == 0;
    if (channel == 3) return alpha ? std::optional(texture.channels - 1) : std::nullopt;
    return gray ? 0 : channel;
}

class Loader {
  public:
    Loader(const ParameterValues& values, const std::function<int(Texture)>& append)
        : values_(values), append_(append) {}

    MapTextures load() {
        read_folder();
        add_single_maps(values_, set_);
        load_base_color();
        load_surface();
        load_normal();
        out_.occlusion = load(MapRole::occlusion, ColorSpace::linear, out_.occlusion);
        load_anisotropy();
        out_.emissive = load(MapRole::emissive, ColorSpace::srgb, -1);
        return std::move(out_);
    }

  private:
    void read_folder() {
        if (!names_one(values_, "maps")) return;
        out_.whole = true;
        set_ = find_map_set(values_.text("maps"), maps_beside(values_));
        out_.notes = set_.notes;
        out_.warnings = set_.warnings;
        out_.tile_mm = set_.tile_mm;
        for (const auto& [role, path] : set_.files)
            out_.files.emplace_back(map_role_name(role), path.filename().string());
    }

    const fs::path* file(MapRole role) const {
        const auto found = set_.files.find(role);
        return found == set_.files.end() ? nullptr : &found->second;
    }

    int load(MapRole role, ColorSpace space, int otherwise) const {
        const fs::path* path = file(role);
        return path ? append_(read_texture(*path, space)) : otherwise;
    }

    void load_base_color() {
        const fs::path* path = file(MapRole::base_color);
        if (!path) {
            if (const fs::path* alone = file(MapRole::opacity))
                out_.warnings.push_back(fmt::format(
                    "{}: opacity without a map of the base color is not drawn: give one "
                    "(--base-color-map)",
                    one_line(alone->string())));
            return;
        }
        Texture base = read_texture(*path, ColorSpace::srgb);
        const fs::path* opacity = file(MapRole::opacity);
        out_.has_opacity = opacity || base.channels == 4 || base.channels == 2;
        if (opacity) base = with_opacity(base, NumberMap(*opacity));
        out_.base_color = append_(std::move(base));
    }

    void warn(std::string line) {
        if (!line.empty()) append_once(out_.warnings, std::move(line));
    }

    // The packed map of the set; at most one is left of several.
    std::optional<MapRole> packed_role() const {
        for (const MapRole role : kPackedRoles)
            if (file(role)) return role;
        return std::nullopt;
    }

    // A property of the packed map; none where the picture lacks the channel, with a warning.
    std::optional<NumberMap> packed_number(const Packed& packed, int channel,
                                           std::string_view property) {
        if (channel < 0) return std::nullopt;
        const auto in = channel_in(packed.texture, channel);
        if (in) return NumberMap(packed.texture, *in);
        out_.warnings.push_back(fmt::format(
            "{}: expected {} in the alpha channel, found {} without alpha: the roughness is 1",
            one_line(packed.path.string()), property,
            plural(static_cast<std::size_t>(packed.texture.channels), "channel")));
        return std::nullopt;
    }

    void load_surface() {
        const fs::path* gloss = file(MapRole::glossiness);
        const fs::path* rough = gloss ? gloss : file(MapRole::roughness);
        const fs::path* metal = file(MapRole::metallic);
        const std::optional<MapRole> role = packed_role();
        Packed packed;
        MapPacking packing;
        if (role) {
            packed = {*file(*role), read_texture(*file(*role), ColorSpace::linear)};
            packing = *packing_of(*role);
            // Unity's metallic alone is a color, and may be gray.
            if (*role != MapRole::metallic_smoothness)
                warn(gray_packed_warning(packed.texture, map_role_name(*role)));
            load_packed_occlusion(packed, packing);
        }
        // As glTF has them: the texture is drawn as it is.
        const bool whole = packing.roughness == 1 && packing.metallic == 2;
        if (whole && !rough && !metal) {
            out_.metallic_roughness =
                packing.occlusion == 0 ? out_.occlusion : append_(std::move(packed.texture));
            out_.has_roughness = out_.has_metallic = true;
            return;
        }
        // What a map of its own does not say, the channel of the packed map says.
        std::optional<NumberMap> rough_map, metal_map;
        bool glossy = gloss != nullptr;
        if (rough) {
            rough_map.emplace(*rough);
        } else if (packing.smoothness >= 0) {
            rough_map = packed_number(packed, packing.smoothness, "smoothness");
            glossy = true;
        } else {
            rough_map = packed_number(packed, packing.roughness, "roughness");
        }
        if (metal)
            metal_map.emplace(*metal);
        else
            metal_map = packed_number(packed, packing.metallic, "metallic");
        if (!rough_map && !metal_map) return;
        out_.metallic_roughness = append_(metallic_roughness(rough_map, glossy, metal_map));
        out_.has_roughness = rough_map.has_value();
        out_.has_metallic = metal_map.has_value();
    }

    // Occlusion is read from red.
    void load_packed_occlusion(const Packed& packed, const MapPacking& packing) {
        if (packing.occlusion < 0) return;
        if (packing.occlusion == 0)
            out_.occlusion = append_(Texture(packed.texture));
        else if (const auto number = packed_number(packed, packing.occlusion, "occlusion"))
            out_.occlusion = append_(one_channel(*number, packed.texture.name + ": occlusion"));
    }

    void load_anisotropy() {
        const fs::path* path = file(MapRole::anisotropy);
        if (!path) return;
        Texture texture = read_texture(*path, ColorSpace::linear);
        warn(gray_packed_warning(texture, map_role_name(MapRole::anisotropy)));
        out_.anisotropy = append_(std::move(texture));
    }

    void load_normal() {
        if (const fs::path* height = file(MapRole::height)) {
            out_.normal = append_(normals_of_height(
                NumberMap(*height), static_cast<float>(values_.real("height_scale")),
                height->string()));
            return;
        }
        out_.normal = load(MapRole::normal, ColorSpace::linear, -1);
        if (out_.normal >= 0) return;
        out_.normal = load(MapRole::normal_directx, ColorSpace::linear, -1);
        out_.directx = out_.normal >= 0;
    }

    const ParameterValues& values_;
    const std::function<int(Texture)>& append_;
    MapSet set_;
    MapTextures out_;
};

}  // namespace

std::string_view map_parameter(MapRole role) {
    for (const Row& row : kRows)
        if (row.role == role) return row.parameter;
    return "";
}

bool names_maps(const ParameterValues& values) {
    if (names_one(values, "maps")) return true;
    return std::any_of(kRows.begin(), kRows.end(),
                       [&](const Row& row) { return names_one(values, row.parameter); });
}

std::string map_names(const ParameterValues& values) {
    std::string names;
    const auto add = [&](std::string_view parameter) {
        if (values.is_set(parameter))
            names += fmt::format("{}={}\n", parameter, values.text(parameter));
    };
    add("maps");
    for (const Row& row : kRows) add(row.parameter);
    add("height_scale");
    return names;
}

MapTextures load_map_textures(const ParameterValues& values,
                              const std::function<int(Texture)>& append) {
    return Loader(values, append).load();
}

}  // namespace burnish
