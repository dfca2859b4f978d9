#include "formats/obj/obj_materials.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "burnish/error.hpp"
#include "core/constants.hpp"
#include "core/files.hpp"
#include "core/utf8.hpp"
#include "formats/model_files.hpp"
#include "formats/model_limits.hpp"
#include "formats/obj/mtl_text.hpp"
#include "formats/obj/mtl_textures.hpp"
#include "formats/obj/obj_text.hpp"
#include "maps/normal/normal_map_look.hpp"
#include "maps/normal/normal_without_z.hpp"

namespace burnish {
namespace {

// Lines that hold for several materials of a library, said once.
class MaterialNotes {
  public:
    void add(const std::string& library, const std::string& material, const std::string& text) {
        const auto [at, fresh] = places_.try_emplace({library, text}, notes_.size());
        if (fresh) notes_.push_back({library, text, {}, 0});
        Note& note = notes_[at->second];
        constexpr std::size_t kNamed = 3;
        if (note.count++ < kNamed) note.names.push_back(shown(material));
    }

    void append_to(std::vector<std::string>& lines) const {
        for (const Note& note : notes_) {
            const std::size_t more = note.count - note.names.size();
            lines.push_back(fmt::format("{}: {}{}: {}", note.library, fmt::join(note.names, ", "),
                                        more > 0 ? fmt::format(" and {} more", more) : "",
                                        note.text));
        }
    }

  private:
    struct Note {
        std::string library, text;
        std::vector<std::string> names;  // the first ones
        std::size_t count;
    };
    std::map<std::pair<std::string, std::string>, std::size_t> places_;
    std::vector<Note> notes_;
};

// A material before its pictures are read.
struct UnreadMaterial {
    Material material;
    std::string library;              // the file, for messages
    std::string bump_key, bump_name;  // the normal texture comes from this key: may be a height map
    bool has_black_kd = false;        // Kd 0 0 0 beside map_Kd
    bool has_alpha_map = false;
};

class LibraryReader {
  public:
    LibraryReader(const std::filesystem::path& folder, ObjMaterials& out)
        : folder_(folder), files_(folder), out_(out) {}

    // One line of mtllib: a name, which may have blanks in it, or several names.
    void read_all(const std::string& line, const std::string& model);
    void finish();

  private:
    void read(const std::string& library, const std::string& model);
    UnreadMaterial convert(const tinyobj::material_t& from, const MtlKeys& keys);
    void convert_surface(const tinyobj::material_t& from, const MtlKeys& keys, Material& to,
                         GltfLobe& lobe);
    void use_color(const tinyobj::material_t& from, UnreadMaterial& to);
    void use_normals(const tinyobj::material_t& from, const MtlKeys& keys, UnreadMaterial& to);
    void use_metallic_roughness(const tinyobj::material_t& from, Material& to, GltfLobe& lobe);
    void settle(UnreadMaterial& unread);
    std::filesystem::path find_library(const std::string& library, const std::string& model);

    // The picture of that name, which `material` has under `key`. Nothing, with a warning, where none
    // is found; a warning names what was found in its place.
    std::optional<std::filesystem::path> find(const std::string& key, const std::string& name,
                                              const std::string& material);

    std::filesystem::path folder_, library_folder_;
    std::string library_;  // the file that is read, for messages
    ModelFiles files_;
    MtlTextures textures_;
    ObjMaterials& out_;
    std::vector<UnreadMaterial> unread_;
    MaterialNotes notes_;
};

TextureUse use_of(int texture, const tinyobj::texture_option_t& options) {
    TextureUse use;
    use.texture = texture;
    if (options.clamp) use.wrap_s = use.wrap_t = Wrap::clamp;
    // uv' = scale uv + origin with v upwards; here v runs downwards, v_down = 1 - v.
    const auto number = [](double value, float otherwise) {
        return std::abs(value) <= static_cast<double>(kLargestTexcoord) ? static_cast<float>(value)
                                                                        : otherwise;
    };
    const float scale_u = number(options.scale[0], 1.0f);
    const float scale_v = number(options.scale[1], 1.0f);
    use.transform[0][0] = scale_u;
    use.transform[1][1] = scale_v;
    use.transform[2][0] = number(options.origin_offset[0], 0.0f);
    use.transform[2][1] = 1.0f - scale_v - number(options.origin_offset[1], 0.0f);
    return use;
}

std::optional<std::filesystem::path> LibraryReader::find(const std::string& key,
                                                         const std::string& written,
                                                         const std::string& material) {
    const std::string name(trimmed(written));
    if (name.empty()) return std::nullopt;
    const FoundFile found = files_.find_picture(name, library_folder_);
    if (!found) {
        notes_.add(library_, material,
                   fmt::format("{} {}: no such picture in the model's folder: drawn without it",
                               key, shown(name)));
        return std::nullopt;
    }
    if (!found.is_exact())
        notes_.add(library_, material, fmt::format("{} {}", key, used_in_place(name, found)));
    return found.path;
}

// The channel that -imfchan names; the first one for its other values, which are for color pictures.
int channel_of(const tinyobj::texture_option_t& options) {
    return options.imfchan == 'g' ? 1 : options.imfchan == 'b' ? 2 : 0;
}

// Converts roughness and reflection: from the PBR keys where present, else from Phong's.
void LibraryReader::convert_surface(const tinyobj::material_t& from, const MtlKeys& keys,
                                    Material& to, GltfLobe& lobe) {
    to.metallic = keys.contains("Pm") ? static_cast<float>(from.metallic) : 0.0f;
    if (keys.contains("Pr")) {
        lobe.roughness = static_cast<float>(from.roughness);
        return;
    }
    const double strongest = std::max({from.specular[0], from.specular[1], from.specular[2]});
    if (keys.contains("Ks") && !(strongest > 0.0)) to.dielectric_f0 = 0.0f;
    // A Blinn-Phong lobe of exponent Ns has about the width of a Beckmann lobe with alpha^2 =
    // 2/(Ns+2).
    if (keys.contains("Ns"))
        lobe.roughness = static_cast<float>(std::pow(2.0 / (from.shininess + 2.0), 0.25));
}

void LibraryReader::use_color(const tinyobj::material_t& from, UnreadMaterial& to) {
    const auto color = find("map_Kd", from.diffuse_texname, from.name);
    const auto alpha = find("map_d", from.alpha_texname, from.name);
    Material& material = to.material;
    const auto& options = color ? from.diffuse_texopt : from.alpha_texopt;
    if (alpha) {
        to.has_alpha_map = true;
        const int texture =
            textures_.color_with_alpha(color.value_or(std::filesystem::path()), *alpha);
        material.base_color_texture = use_of(texture, options);
    } else if (color) {
        material.base_color_texture = use_of(textures_.plain(*color, ColorSpace::srgb), options);
    }
    const glm::vec3 kd(material.base_color);
    to.has_black_kd = color && kd == glm::vec3(0.0f);
}

// A map replaces the number of its key: exporters write both, and the number is a default.
void LibraryReader::use_metallic_roughness(const tinyobj::material_t& from, Material& to,
                                           GltfLobe& lobe) {
    const auto roughness = find("map_Pr", from.roughness_texname, to.name);
    const auto metallic = find("map_Pm", from.metallic_texname, to.name);
    if (!roughness && !metallic) return;
    const auto picture = [](const auto& path, const tinyobj::texture_option_t& options) {
        return path ? MtlPicture{*path, channel_of(options)} : MtlPicture{};
    };
    to.metallic_roughness_texture =
        use_of(textures_.metallic_roughness(picture(roughness, from.roughness_texopt),
                                            picture(metallic, from.metallic_texopt)),
               roughness ? from.roughness_texopt : from.metallic_texopt);
    if (roughness) lobe.roughness = 1.0f;
    if (metallic) to.metallic = 1.0f;
}

void LibraryReader::use_normals(const tinyobj::material_t& from, const MtlKeys& keys,
                                UnreadMaterial& to) {
    const auto use = [&](const std::filesystem::path& path,
                         const tinyobj::texture_option_t& options) {
        to.material.normal_texture = use_of(textures_.plain(path, ColorSpace::linear), options);
        if (std::isfinite(options.bump_multiplier))
            to.material.normal_scale =
                static_cast<float>(std::clamp(options.bump_multiplier, -100.0, 100.0));
    };
    for (const char* key : {"map_Bump", "map_bump", "bump"})
        if (keys.contains(key)) to.bump_key = key;
    if (const auto normals = find("norm", from.normal_texname, from.name)) {
        use(*normals, from.normal_texopt);
        if (!to.bump_key.empty())
            notes_.add(library_, from.name, to.bump_key + " is not read beside norm");
        to.bump_key.clear();
    } else if (const auto bumps = find(to.bump_key, from.bump_texname, from.name)) {
        use(*bumps, from.bump_texopt);
        to.bump_name = one_line(bumps->filename().string());
    } else {
        to.bump_key.clear();
    }
}

// Numbers have been held against their ranges (MtlText::remarks).
UnreadMaterial LibraryReader::convert(const tinyobj::material_t& from, const MtlKeys& keys) {
    UnreadMaterial unread;
    Material& to = unread.material = default_obj_material();
    to.name = from.name;
    unread.library = library_;
    for (int i = 0; i < 3; ++i) {
        to.base_color[i] = static_cast<float>(from.diffuse[i]);
        to.emissive[i] = static_cast<float>(from.emission[i]);
    }
    if (!keys.contains("Kd")) to.base_color = glm::vec4(keys.contains("map_Kd") ? 1.0f : 0.8f);
    to.base_color.a = static_cast<float>(from.dissolve);
    if (to.base_color.a < 1.0f) to.alpha_mode = AlphaMode::blend;
    GltfLobe lobe = *gltf_lobe_of(to);
    convert_surface(from, keys, to, lobe);
    lobe.anisotropy_strength = static_cast<float>(from.anisotropy);
    to.anisotropy_rotation = static_cast<float>(kTwoPi * from.anisotropy_rotation);
    to.coat.strength = static_cast<float>(from.clearcoat_thickness);
    to.coat.roughness = static_cast<float>(from.clearcoat_roughness);
    use_color(from, unread);
    if (const auto emissive = find("map_Ke", from.emissive_texname, from.name)) {
        to.emissive_texture =
            use_of(textures_.plain(*emissive, ColorSpace::srgb), from.emissive_texopt);
        if (!keys.contains("Ke")) to.emissive = glm::vec3(1.0f);
    }
    use_normals(from, keys, unread);
    use_metallic_roughness(from, to, lobe);
    to.lobe = lobe;
    for (const auto& [key, value] : keys)
        if (is_lost_mtl_key(key, value))
            notes_.add(library_, to.name, one_line(key.substr(0, 40)) + " is not read");
    return unread;
}

// Looks for the model's own name where the library's is not found.
std::filesystem::path LibraryReader::find_library(const std::string& library,
                                                  const std::string& model) {
    FoundFile found = files_.find(library);
    if (!found) found = files_.find(model + ".mtl");
    if (!found) throw Error("no such file in the model's folder");
    if (found.path.filename() != std::filesystem::path(library).filename() || !found.is_exact())
        out_.warnings.push_back(fmt::format("mtllib {}: {} is read in its place", shown(library),
                                            one_line(found.path.string())));
    return found.path;
}

void LibraryReader::read_all(const std::string& line, const std::string& model) {
    if (line.find_first_of(" \t") == line.npos || files_.find(line)) return read(line, model);
    std::istringstream names(line);
    for (std::string name; names >> name;) read(name, model);
}

void LibraryReader::read(const std::string& library, const std::string& model) {
    std::string text;
    try {
        const std::filesystem::path path = find_library(library, model);
        constexpr std::uintmax_t kLargestLibrary = std::uintmax_t{64} << 20;
        text = as_utf8(read_text_file(path, kLargestLibrary));
        library_ = one_line(path.string());
        library_folder_ = path.parent_path().lexically_relative(folder_);
        if (library_folder_ == ".") library_folder_.clear();
    } catch (const Error& error) {
        out_.warnings.push_back(
            fmt::format("mtllib {}: {}: default material", shown(library), error.what()));
        return;
    }
    std::map<std::string, int> names;
    std::vector<tinyobj::material_t> parsed;
    std::string warnings;
    std::string errors;
    const MtlText sorted = read_mtl_text(text);
    for (const auto& [name, remark] : sorted.remarks) notes_.add(library_, name, remark);
    std::istringstream stream(sorted.text);
    tinyobj::LoadMtl(&names, &parsed, &stream, &warnings, &errors);
    for (const tinyobj::material_t& material : parsed) {
        const std::string name(trimmed(material.name));
        if (name.empty() || out_.by_name.contains(name)) continue;
        out_.by_name.emplace(name, static_cast<int>(unread_.size()));
        const auto found = sorted.materials.find(name);
        unread_.push_back(
            convert(material, found == sorted.materials.end() ? MtlKeys() : found->second));
    }
}

// Decides what the pictures say: which could be read, and what a bump map is.
void LibraryReader::settle(UnreadMaterial& unread) {
    Material& material = unread.material;
    const auto texture = [&](const TextureUse& use) -> const Texture& {
        return out_.textures[static_cast<std::size_t>(use.texture)];
    };
    for (TextureUse* use : {&material.base_color_texture, &material.emissive_texture,
                            &material.normal_texture, &material.metallic_roughness_texture})
        if (*use && texture(*use).empty()) *use = TextureUse();
    if (!unread.bump_key.empty() && material.normal_texture) {
        const Texture& bump = texture(material.normal_texture);
        const bool normals = looks_like_normal_map(bump) || normal_map_without_z(bump).has_value();
        const std::string what = fmt::format("{} {}", unread.bump_key, unread.bump_name);
        if (normals) {
            notes_.add(unread.library, material.name,
                       what + " looks like a tangent-space normal map: it is drawn as one");
        } else {
            material.normal_texture = TextureUse();
            notes_.add(unread.library, material.name,
                       what +
                           " does not look like a tangent-space normal map: height maps are not "
                           "drawn; name a normal map by norm in the .mtl, or give --normal-map");
        }
    }
    if (!material.normal_texture) material.normal_scale = 1.0f;
    if (unread.has_black_kd && material.base_color_texture) {
        material.base_color = glm::vec4(1.0f, 1.0f, 1.0f, material.base_color.a);
        notes_.add(unread.library, material.name,
                   "Kd 0 0 0 would make map_Kd black: the picture is drawn as it is");
    }
    if (!unread.has_alpha_map || !material.base_color_texture) return;
    const Texture& color = texture(material.base_color_texture);
    if (color.channels == 2 || color.channels == 4) {
        const bool whole = material.base_color.a == 1.0f;
        material.alpha_mode = whole && is_cut_out(color) ? AlphaMode::mask : AlphaMode::blend;
    } else {
        notes_.add(unread.library, material.name, "map_d has no alpha: it is drawn opaque");
    }
}

void LibraryReader::finish() {
    out_.textures = textures_.decode();
    for (UnreadMaterial& unread : unread_) settle(unread);
    // Pictures that no material uses are dropped.
    std::vector<int> number(out_.textures.size(), -1);
    std::vector<Texture> used;
    for (UnreadMaterial& unread : unread_) {
        Material& material = unread.material;
        for (TextureUse* use : {&material.base_color_texture, &material.emissive_texture,
                                &material.normal_texture, &material.metallic_roughness_texture}) {
            if (!*use) continue;
            const auto place = static_cast<std::size_t>(use->texture);
            if (number[place] < 0) {
                number[place] = static_cast<int>(used.size());
                used.push_back(std::move(out_.textures[place]));
            }
            use->texture = number[place];
        }
        out_.materials.push_back(std::move(material));
    }
    out_.textures = std::move(used);
    out_.warnings.insert(out_.warnings.end(), textures_.warnings().begin(),
                         textures_.warnings().end());
    notes_.append_to(out_.warnings);
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

ObjMaterials read_obj_materials(const std::filesystem::path& model,
                                const std::vector<std::string>& libraries) {
    ObjMaterials out;
    LibraryReader reader(model.parent_path(), out);
    for (const std::string& library : libraries) reader.read_all(library, model.stem().string());
    reader.finish();
    return out;
}

}  // namespace burnish
