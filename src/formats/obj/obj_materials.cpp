#include "formats/obj/obj_materials.hpp"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/constants.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "formats/model_limits.hpp"
#include "formats/obj/obj_text.hpp"

namespace burnish {
namespace {

// The path of a file named inside another one; nothing when it lies outside the folder.
std::optional<std::filesystem::path> inside(const std::filesystem::path& folder, std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    const auto relative = std::filesystem::path(name).lexically_normal();
    if (relative.empty() || relative.is_absolute() || *relative.begin() == ".." ||
        name.find('\0') != std::string::npos)
        return std::nullopt;
    return folder / relative;
}

// The keywords of each material of a library, because the parser does not distinguish 0 from
// missing.
std::map<std::string, std::set<std::string>> keywords_of(std::string_view text) {
    std::map<std::string, std::set<std::string>> keywords;
    std::string material;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t blank = line.find_first_of(" \t");
        if (blank == std::string_view::npos) continue;
        const std::string_view word = line.substr(0, blank);
        if (word == "newmtl")
            material = trimmed(line.substr(blank));
        else
            keywords[material].emplace(word);
    }
    return keywords;
}

float unit(float value, float otherwise) {
    return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : otherwise;
}

class LibraryReader {
  public:
    LibraryReader(const std::filesystem::path& folder, ObjMaterials& out)
        : folder_(folder), out_(out) {}

    void read(const std::string& library);
    void decode_textures();

  private:
    using Keywords = std::set<std::string>;
    Material convert(const tinyobj::material_t& from, const Keywords& keywords);
    void convert_surface(const tinyobj::material_t& from, const Keywords& keywords, Material& to,
                         GltfLobe& lobe);
    TextureUse use(const std::string& name, const tinyobj::texture_option_t& options,
                   ColorSpace color_space);
    void warn(std::string line) {
        if (std::find(out_.warnings.begin(), out_.warnings.end(), line) == out_.warnings.end())
            out_.warnings.push_back(std::move(line));
    }

    std::filesystem::path folder_;
    ObjMaterials& out_;
    std::map<std::pair<std::string, ColorSpace>, int> slots_;
    std::vector<std::pair<std::filesystem::path, ColorSpace>> wanted_;  // one per texture
};

TextureUse LibraryReader::use(const std::string& name, const tinyobj::texture_option_t& options,
                              ColorSpace color_space) {
    TextureUse use;
    if (name.empty()) return use;
    const auto path = inside(folder_, name);
    std::error_code ignored;
    if (!path || !std::filesystem::is_regular_file(*path, ignored)) {
        warn(fmt::format("texture {}: not found in the model's folder: not used", shown(name)));
        return use;
    }
    const auto [slot, fresh] =
        slots_.try_emplace({path->string(), color_space}, static_cast<int>(wanted_.size()));
    if (fresh) wanted_.emplace_back(*path, color_space);
    use.texture = slot->second;
    if (options.clamp) use.wrap_s = use.wrap_t = Wrap::clamp;
    // uv' = scale uv + origin with v upwards; here v runs downwards, v_down = 1 - v.
    const auto number = [](float value, float otherwise) {
        return std::abs(value) <= kLargestTexcoord ? value : otherwise;
    };
    const float scale_u = number(options.scale[0], 1.0f);
    const float scale_v = number(options.scale[1], 1.0f);
    use.transform[0][0] = scale_u;
    use.transform[1][1] = scale_v;
    use.transform[2][0] = number(options.origin_offset[0], 0.0f);
    use.transform[2][1] = 1.0f - scale_v - number(options.origin_offset[1], 0.0f);
    return use;
}

// Converts roughness and reflection: from the PBR keys where present, else from Phong's.
void LibraryReader::convert_surface(const tinyobj::material_t& from, const Keywords& keywords,
                                    Material& to, GltfLobe& lobe) {
    to.metallic = keywords.contains("Pm") ? unit(from.metallic, 0.0f) : 0.0f;
    if (keywords.contains("Pr")) {
        lobe.roughness = unit(from.roughness, 1.0f);
        return;
    }
    const float strongest = std::max({from.specular[0], from.specular[1], from.specular[2]});
    if (keywords.contains("Ks") && !(strongest > 0.0f)) to.dielectric_f0 = 0.0f;
    // A Blinn-Phong lobe of exponent Ns has about the width of a Beckmann lobe with alpha^2 =
    // 2/(Ns+2).
    if (keywords.contains("Ns") && from.shininess >= 0.0f && std::isfinite(from.shininess))
        lobe.roughness = std::pow(2.0f / (from.shininess + 2.0f), 0.25f);
}

Material LibraryReader::convert(const tinyobj::material_t& from, const Keywords& keywords) {
    Material to = default_obj_material();
    to.name = from.name;
    for (int i = 0; i < 3; ++i) {
        to.base_color[i] = unit(from.diffuse[i], 0.0f);
        to.emissive[i] =
            std::isfinite(from.emission[i]) ? std::clamp(from.emission[i], 0.0f, 65504.0f) : 0.0f;
    }
    if (!keywords.contains("Kd"))
        to.base_color = glm::vec4(keywords.contains("map_Kd") ? 1.0f : 0.8f);
    to.base_color.a = unit(from.dissolve, 1.0f);
    if (to.base_color.a < 1.0f) to.alpha_mode = AlphaMode::blend;
    GltfLobe lobe = *gltf_lobe_of(to);
    convert_surface(from, keywords, to, lobe);
    lobe.anisotropy_strength = unit(from.anisotropy, 0.0f);
    to.lobe = lobe;
    to.anisotropy_rotation = static_cast<float>(kTwoPi) * unit(from.anisotropy_rotation, 0.0f);
    to.base_color_texture = use(from.diffuse_texname, from.diffuse_texopt, ColorSpace::srgb);
    to.emissive_texture = use(from.emissive_texname, from.emissive_texopt, ColorSpace::srgb);
    if (to.emissive_texture && !keywords.contains("Ke")) to.emissive = glm::vec3(1.0f);
    to.normal_texture = use(from.normal_texname, from.normal_texopt, ColorSpace::linear);
    if (to.normal_texture && std::isfinite(from.normal_texopt.bump_multiplier))
        to.normal_scale = std::clamp(from.normal_texopt.bump_multiplier, -100.0f, 100.0f);
    for (const char* key : {"map_Bump", "map_bump", "bump", "map_Pr", "map_Pm", "map_Ks", "map_Ns",
                            "map_d", "disp", "refl"}) {
        if (keywords.contains(key)) warn(fmt::format("{} of {}: not read", key, shown(to.name)));
    }
    return to;
}

void LibraryReader::read(const std::string& library) {
    const auto path = inside(folder_, library);
    std::string text;
    try {
        if (!path) throw Error("it does not lie in the model's folder");
        constexpr std::uintmax_t kLargestLibrary = std::uintmax_t{64} << 20;
        text = read_text_file(*path, kLargestLibrary);
    } catch (const Error& error) {
        warn(fmt::format("mtllib {}: {}: default material", shown(library), error.what()));
        return;
    }
    std::map<std::string, int> names;
    std::vector<tinyobj::material_t> parsed;
    std::string warnings;
    std::string errors;
    std::istringstream stream(text);
    tinyobj::LoadMtl(&names, &parsed, &stream, &warnings, &errors);
    const auto keywords = keywords_of(text);
    for (const tinyobj::material_t& material : parsed) {
        const std::string name(trimmed(material.name));
        if (name.empty() || out_.by_name.contains(name)) continue;
        out_.by_name.emplace(name, static_cast<int>(out_.materials.size()));
        const auto found = keywords.find(name);
        out_.materials.push_back(
            convert(material, found == keywords.end() ? Keywords() : found->second));
    }
}

void LibraryReader::decode_textures() {
    out_.textures.resize(wanted_.size());
    std::vector<std::string> failures(wanted_.size());
    std::vector<std::vector<std::string>> warnings(wanted_.size());
    parallel_for(wanted_.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            try {
                out_.textures[i] = read_texture(wanted_[i].first, wanted_[i].second, &warnings[i]);
            } catch (const Error& error) {
                failures[i] = error.what();
            }
        }
    });
    for (std::size_t i = 0; i < failures.size(); ++i) {
        for (std::string& line : warnings[i]) warn(std::move(line));
        if (failures[i].empty()) continue;
        throw Error(failures[i]);
    }
}

}  // namespace

Material default_obj_material() {
    Material material;
    material.name = "default";
    material.base_color = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f);
    material.metallic = 0.0f;
    material.lobe = GltfLobe{0.5f};
    return material;
}

ObjMaterials read_obj_materials(const std::filesystem::path& folder,
                                const std::vector<std::string>& libraries) {
    ObjMaterials out;
    LibraryReader reader(folder, out);
    for (const std::string& library : libraries) reader.read(library);
    reader.decode_textures();
    return out;
}

}  // namespace burnish
