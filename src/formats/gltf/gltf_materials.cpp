#include "formats/gltf/gltf_materials.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "burnish/error.hpp"
#include "core/constants.hpp"
#include "formats/model_limits.hpp"
#include "formats/model_textures.hpp"
#include "scene/material/texture_uses.hpp"

namespace burnish {
namespace {

// Reads the materials of one file; `where` is the key of the current material.
class MaterialReader {
  public:
    MaterialReader(const tinygltf::Model& model, GltfImages& images, GltfReport& report)
        : model_(model), images_(images), report_(report) {}

    Material read(const tinygltf::Material& from, std::size_t index);

    // Makes 0 and 1 of the sets of coordinates that the material reads; returns the sets that they
    // stand for.
    std::array<int, 2> take_two_sets(Material& material);

  private:
    void read_base(const tinygltf::PbrMetallicRoughness& from, Material& to, GltfLobe& lobe);
    void read_extensions(const tinygltf::ExtensionMap& from, Material& to, GltfLobe& lobe);
    void read_anisotropy(const tinygltf::Value& from, Material& to, GltfLobe& lobe);
    void read_draft_anisotropy(const tinygltf::Value& from, Material& to, GltfLobe& lobe);
    void read_specular(const tinygltf::Value& from, Material& to);
    void read_clearcoat(const tinygltf::Value& from, Coat& to);
    void read_sheen(const tinygltf::Value& from, Sheen& to);
    // The texture of the extension's key `name`, where it has one.
    TextureUse use_in(const tinygltf::Value& extension, const char* extension_name,
                      const char* name, GltfReading reading);
    glm::vec3 color_in(const tinygltf::Value& extension, const char* key, glm::vec3 otherwise,
                       double high, const std::string& where);
    TextureUse use(const tinygltf::Value& info, GltfReading reading, const std::string& key);
    AlphaMode alpha_mode(const std::string& name) const;

    template <class Info>
    TextureUse use(const Info& info, GltfReading reading, const char* key);
    TextureUse use(int texture, int texcoord, const tinygltf::Value* transform, GltfReading reading,
                   const std::string& key);
    void read_sampler(int sampler, TextureUse& use, const std::string& key) const;
    Wrap wrap(int code, const std::string& key) const;

    // `value` as a float in [low, high].
    float clamped(double value, double low, double high, const char* key);

    const tinygltf::Model& model_;
    GltfImages& images_;
    GltfReport& report_;
    std::string where_;
};

double number(const tinygltf::Value& object, const char* key, double otherwise) {
    return object.Has(key) ? object.Get(key).GetNumberAsDouble() : otherwise;
}

const tinygltf::Value* find(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto it = extensions.find(name);
    return it == extensions.end() ? nullptr : &it->second;
}

constexpr const char* kAnisotropy = "KHR_materials_anisotropy";

// The keys that only the draft of KHR_materials_anisotropy has.
std::vector<const char*> draft_keys(const tinygltf::Value& from) {
    std::vector<const char*> keys;
    for (const char* key :
         {"anisotropy", "anisotropyFactor", "anisotropyDirection", "anisotropyDirectionTexture"})
        if (from.Has(key)) keys.push_back(key);
    return keys;
}

// The part in the tangent plane of a vector of two or three numbers; nothing for other values and
// for vectors without such a part.
std::optional<glm::dvec2> plane_direction(const tinygltf::Value& value) {
    if (!value.IsArray() || value.ArrayLen() < 2 || value.ArrayLen() > 3) return std::nullopt;
    glm::dvec2 direction(0.0);
    for (int i = 0; i < 2; ++i) {
        const tinygltf::Value& item = value.Get(i);
        if (!item.IsNumber()) return std::nullopt;
        direction[i] = item.GetNumberAsDouble();
    }
    // Exporters round to some six digits; a smaller length is a rounded zero.
    if (!(std::hypot(direction.x, direction.y) > 1e-6)) return std::nullopt;
    return direction;
}

glm::vec2 pair(const tinygltf::Value& object, const char* key, glm::vec2 otherwise) {
    if (!object.Has(key)) return otherwise;
    const tinygltf::Value& array = object.Get(key);
    return {static_cast<float>(array.Get(0).GetNumberAsDouble()),
            static_cast<float>(array.Get(1).GetNumberAsDouble())};
}

// KHR_texture_transform: scale, then rotation, then translation. v runs downwards, so a rotation
// that is counter-clockwise in the picture has this sign. The extension's test model and all
// engines agree on it, but the matrix printed in its text is the transpose.
glm::mat3 texture_transform(const tinygltf::Value& from) {
    const glm::vec2 offset = pair(from, "offset", glm::vec2(0.0f));
    const glm::vec2 scale = pair(from, "scale", glm::vec2(1.0f));
    const double rotation = number(from, "rotation", 0.0);
    const auto c = static_cast<float>(std::cos(rotation));
    const auto s = static_cast<float>(std::sin(rotation));
    return {glm::vec3(c * scale.x, -s * scale.x, 0.0f), glm::vec3(s * scale.y, c * scale.y, 0.0f),
            glm::vec3(offset, 1.0f)};
}

float MaterialReader::clamped(double value, double low, double high, const char* key) {
    const double inside = std::clamp(value, low, high);
    if (inside != value)
        report_.warn(fmt::format("{}.{}: {} is not from {} to {}: {} is used", where_, key, value,
                                 low, high, inside));
    return static_cast<float>(inside);
}

Wrap MaterialReader::wrap(int code, const std::string& key) const {
    switch (code) {
        case TINYGLTF_TEXTURE_WRAP_REPEAT:
            return Wrap::repeat;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return Wrap::mirror;
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return Wrap::clamp;
        default:
            report_.fail(key, "10497, 33071 or 33648", fmt::format("{}", code));
    }
}

void MaterialReader::read_sampler(int index, TextureUse& use, const std::string& key) const {
    const auto& sampler = item_at(model_.samplers, index, report_, key);
    use.wrap_s = wrap(sampler.wrapS, fmt::format("samplers[{}].wrapS", index));
    use.wrap_t = wrap(sampler.wrapT, fmt::format("samplers[{}].wrapT", index));
    use.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
}

TextureUse MaterialReader::use(int index, int texcoord, const tinygltf::Value* transform,
                               GltfReading reading, const std::string& key) {
    TextureUse use;
    const auto& texture = item_at(model_.textures, index, report_, key + ".index");
    const std::string texture_key = fmt::format("textures[{}]", index);
    use.texcoord = texcoord;
    if (transform) {
        use.transform = texture_transform(*transform);
        for (int i = 0; i < 9; ++i) {
            const float entry = use.transform[i / 3][i % 3];
            if (std::abs(entry) > kLargestTexcoord)
                report_.fail(key + ".extensions.KHR_texture_transform", "numbers up to 2^24",
                             fmt::format("{}", entry));
        }
        if (transform->Has("texCoord")) use.texcoord = transform->Get("texCoord").GetNumberAsInt();
    }
    if (texture.sampler >= 0) read_sampler(texture.sampler, use, texture_key + ".sampler");
    use.texture = images_.use(index, reading, key);
    return use ? use : TextureUse();
}

template <class Info>
TextureUse MaterialReader::use(const Info& info, GltfReading reading, const char* key) {
    if (info.index < 0) return {};
    return use(info.index, info.texCoord, find(info.extensions, "KHR_texture_transform"), reading,
               fmt::format("{}.{}", where_, key));
}

void MaterialReader::read_base(const tinygltf::PbrMetallicRoughness& from, Material& to,
                               GltfLobe& lobe) {
    for (int i = 0; i < 4; ++i)
        to.base_color[i] = clamped(from.baseColorFactor[static_cast<std::size_t>(i)], 0.0, 1.0,
                                   "pbrMetallicRoughness.baseColorFactor");
    to.metallic = clamped(from.metallicFactor, 0.0, 1.0, "pbrMetallicRoughness.metallicFactor");
    lobe.roughness =
        clamped(from.roughnessFactor, 0.0, 1.0, "pbrMetallicRoughness.roughnessFactor");
    to.base_color_texture =
        use(from.baseColorTexture, GltfReading::color, "pbrMetallicRoughness.baseColorTexture");
    to.metallic_roughness_texture = use(from.metallicRoughnessTexture, GltfReading::data,
                                        "pbrMetallicRoughness.metallicRoughnessTexture");
}

TextureUse MaterialReader::use(const tinygltf::Value& info, GltfReading reading,
                               const std::string& key) {
    const tinygltf::Value* transform = nullptr;
    if (info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform"))
        transform = &info.Get("extensions").Get("KHR_texture_transform");
    const int texcoord = info.Has("texCoord") ? info.Get("texCoord").GetNumberAsInt() : 0;
    return use(info.Get("index").GetNumberAsInt(), texcoord, transform, reading, key);
}

// The draft's amount goes from -1 (stretched across the direction) to 1 (along it); its direction
// is a vector (tangent, bitangent, normal), its direction texture one a texel. What the channels of
// its anisotropyTexture mean changed between versions.
void MaterialReader::read_draft_anisotropy(const tinygltf::Value& from, Material& to,
                                           GltfLobe& lobe) {
    const std::string key = where_ + ".extensions." + kAnisotropy;
    const double amount = clamped(number(from, "anisotropy", number(from, "anisotropyFactor", 0.0)),
                                  -1.0, 1.0, "extensions.KHR_materials_anisotropy.anisotropy");
    lobe.anisotropy_strength = static_cast<float>(std::abs(amount));
    double angle = 0.0;
    std::vector<std::string> passed_over;
    if (from.Has("anisotropyDirectionTexture")) {
        to.anisotropy_texture = use(from.Get("anisotropyDirectionTexture"), GltfReading::direction,
                                    key + ".anisotropyDirectionTexture");
        if (from.Has("anisotropyDirection")) passed_over.emplace_back("anisotropyDirection");
    } else if (from.Has("anisotropyDirection")) {
        const auto direction = plane_direction(from.Get("anisotropyDirection"));
        if (direction) angle = std::atan2(direction->y, direction->x);
        if (!direction) passed_over.emplace_back("anisotropyDirection");
    }
    if (from.Has("anisotropyTexture")) passed_over.emplace_back("anisotropyTexture");
    if (amount < 0.0) angle += kHalfPi;
    to.anisotropy_rotation = static_cast<float>(std::remainder(angle, kTwoPi));
    report_.warn(fmt::format(
        "{}: {} of the extension's draft: drawn as anisotropyStrength {:.4g}, anisotropyRotation "
        "{:.4g}{}{}",
        key, fmt::join(draft_keys(from), ", "), lobe.anisotropy_strength, to.anisotropy_rotation,
        to.anisotropy_texture ? " and the directions of the texture" : "",
        passed_over.empty() ? "" : fmt::format("; not read: {}", fmt::join(passed_over, ", "))));
}

void MaterialReader::read_anisotropy(const tinygltf::Value& from, Material& to, GltfLobe& lobe) {
    const std::string key = where_ + ".extensions." + kAnisotropy;
    const std::vector<const char*> draft = draft_keys(from);
    const bool current = from.Has("anisotropyStrength") || from.Has("anisotropyRotation");
    if (!draft.empty() && !current) return read_draft_anisotropy(from, to, lobe);
    if (!draft.empty())
        report_.warn(
            fmt::format("{}: {} of the extension's draft: not read, today's keys beside "
                        "them are drawn",
                        key, fmt::join(draft, ", ")));
    lobe.anisotropy_strength = clamped(number(from, "anisotropyStrength", 0.0), 0.0, 1.0,
                                       "extensions.KHR_materials_anisotropy.anisotropyStrength");
    to.anisotropy_rotation =
        static_cast<float>(std::remainder(number(from, "anisotropyRotation", 0.0), kTwoPi));
    if (from.Has("anisotropyTexture"))
        to.anisotropy_texture =
            use(from.Get("anisotropyTexture"), GltfReading::data, key + ".anisotropyTexture");
}

TextureUse MaterialReader::use_in(const tinygltf::Value& extension, const char* extension_name,
                                  const char* name, GltfReading reading) {
    if (!extension.Has(name)) return {};
    return use(extension.Get(name), reading,
               fmt::format("{}.extensions.{}.{}", where_, extension_name, name));
}

glm::vec3 MaterialReader::color_in(const tinygltf::Value& extension, const char* key,
                                   glm::vec3 otherwise, double high, const std::string& where) {
    if (!extension.Has(key)) return otherwise;
    glm::vec3 color;
    for (int i = 0; i < 3; ++i)
        color[i] = clamped(extension.Get(key).Get(i).GetNumberAsDouble(), 0.0, high, where.c_str());
    return color;
}

void MaterialReader::read_specular(const tinygltf::Value& from, Material& to) {
    constexpr const char* kName = "KHR_materials_specular";
    const std::string at = fmt::format("extensions.{}.", kName);
    to.specular =
        clamped(number(from, "specularFactor", 1.0), 0.0, 1.0, (at + "specularFactor").c_str());
    // 1000: any interface then reflects all light, which is the most that is drawn.
    to.specular_color =
        color_in(from, "specularColorFactor", glm::vec3(1.0f), 1000.0, at + "specularColorFactor");
    to.specular_texture = use_in(from, kName, "specularTexture", GltfReading::data);
    to.specular_color_texture = use_in(from, kName, "specularColorTexture", GltfReading::color);
}

void MaterialReader::read_clearcoat(const tinygltf::Value& from, Coat& to) {
    constexpr const char* kName = "KHR_materials_clearcoat";
    const std::string at = fmt::format("extensions.{}.", kName);
    to.strength =
        clamped(number(from, "clearcoatFactor", 0.0), 0.0, 1.0, (at + "clearcoatFactor").c_str());
    to.roughness = clamped(number(from, "clearcoatRoughnessFactor", 0.0), 0.0, 1.0,
                           (at + "clearcoatRoughnessFactor").c_str());
    to.texture = use_in(from, kName, "clearcoatTexture", GltfReading::data);
    to.roughness_texture = use_in(from, kName, "clearcoatRoughnessTexture", GltfReading::data);
    to.normal_texture = use_in(from, kName, "clearcoatNormalTexture", GltfReading::data);
    if (from.Has("clearcoatNormalTexture"))
        to.normal_scale = clamped(number(from.Get("clearcoatNormalTexture"), "scale", 1.0), -100.0,
                                  100.0, (at + "clearcoatNormalTexture.scale").c_str());
}

void MaterialReader::read_sheen(const tinygltf::Value& from, Sheen& to) {
    constexpr const char* kName = "KHR_materials_sheen";
    const std::string at = fmt::format("extensions.{}.", kName);
    to.color = color_in(from, "sheenColorFactor", glm::vec3(0.0f), 1.0, at + "sheenColorFactor");
    to.roughness = clamped(number(from, "sheenRoughnessFactor", 0.0), 0.0, 1.0,
                           (at + "sheenRoughnessFactor").c_str());
    to.color_texture = use_in(from, kName, "sheenColorTexture", GltfReading::color);
    to.roughness_texture = use_in(from, kName, "sheenRoughnessTexture", GltfReading::data);
}

void MaterialReader::read_extensions(const tinygltf::ExtensionMap& from, Material& to,
                                     GltfLobe& lobe) {
    if (const auto* anisotropy = find(from, kAnisotropy)) read_anisotropy(*anisotropy, to, lobe);
    if (const auto* ior = find(from, "KHR_materials_ior")) {
        const double n = number(*ior, "ior", 1.5);
        if (n != 0.0 && n < 1.0)
            report_.fail(where_ + ".extensions.KHR_materials_ior.ior", "0, or 1 or more",
                         fmt::format("{}", n));
        // 0 represents infinity: everything is reflected.
        const double root = n == 0.0 ? 1.0 : (n - 1.0) / (n + 1.0);
        to.dielectric_f0 = static_cast<float>(root * root);
    }
    if (const auto* specular = find(from, "KHR_materials_specular")) read_specular(*specular, to);
    if (const auto* coat = find(from, "KHR_materials_clearcoat")) read_clearcoat(*coat, to.coat);
    if (const auto* sheen = find(from, "KHR_materials_sheen")) read_sheen(*sheen, to.sheen);
    if (const auto* strength = find(from, "KHR_materials_emissive_strength")) {
        // Renderers sum light in half floats, which end at 65504; no lamp needs more.
        to.emissive *= clamped(number(*strength, "emissiveStrength", 1.0), 0.0, 65504.0,
                               "extensions.KHR_materials_emissive_strength.emissiveStrength");
    }
}

// The surface emits its base color; what it reflects has the factor 0.
void make_unlit(Material& to) {
    to.emissive = glm::vec3(to.base_color);
    to.emissive_texture = to.base_color_texture;
    to.base_color = glm::vec4(0.0f, 0.0f, 0.0f, to.base_color.a);
    // Its alpha alone is drawn.
    if (to.alpha_mode == AlphaMode::opaque) to.base_color_texture = TextureUse();
    to.metallic = 0.0f;
    to.brdf = Brdf::phong;
    to.ks = 0.0f;
    to.lobe = GltfLobe();
    to.anisotropy_rotation = 0.0f;
    for (const auto use : {&Material::metallic_roughness_texture, &Material::normal_texture,
                           &Material::occlusion_texture, &Material::anisotropy_texture,
                           &Material::specular_texture, &Material::specular_color_texture})
        to.*use = TextureUse();
    to.specular = 1.0f;
    to.specular_color = glm::vec3(1.0f);
    to.coat = Coat();
    to.sheen = Sheen();
}

AlphaMode MaterialReader::alpha_mode(const std::string& name) const {
    if (name == "OPAQUE") return AlphaMode::opaque;
    if (name == "MASK") return AlphaMode::mask;
    if (name == "BLEND") return AlphaMode::blend;
    report_.fail(where_ + ".alphaMode", "OPAQUE, MASK or BLEND", shown(name));
}

Material MaterialReader::read(const tinygltf::Material& from, std::size_t index) {
    where_ = fmt::format("materials[{}]", index);
    Material to;
    to.name = from.name.empty() ? where_ : from.name;
    GltfLobe lobe;
    read_base(from.pbrMetallicRoughness, to, lobe);
    to.normal_texture = use(from.normalTexture, GltfReading::data, "normalTexture");
    // 100 times the least slope of an 8-bit map, 1/127, is 38 degrees: steep enough.
    to.normal_scale = clamped(from.normalTexture.scale, -100.0, 100.0, "normalTexture.scale");
    to.occlusion_texture = use(from.occlusionTexture, GltfReading::data, "occlusionTexture");
    to.occlusion_strength =
        clamped(from.occlusionTexture.strength, 0.0, 1.0, "occlusionTexture.strength");
    for (int i = 0; i < 3; ++i)
        to.emissive[i] =
            clamped(from.emissiveFactor[static_cast<std::size_t>(i)], 0.0, 1.0, "emissiveFactor");
    to.emissive_texture = use(from.emissiveTexture, GltfReading::color, "emissiveTexture");
    to.alpha_mode = alpha_mode(from.alphaMode);
    to.alpha_cutoff = clamped(from.alphaCutoff, 0.0, 1e6, "alphaCutoff");
    to.double_sided = from.doubleSided;
    read_extensions(from.extensions, to, lobe);
    to.lobe = lobe;
    if (find(from.extensions, "KHR_materials_unlit") != nullptr) make_unlit(to);
    return to;
}

std::array<int, 2> MaterialReader::take_two_sets(Material& material) {
    // The textures in the order in which they get a set.
    using enum MaterialTexture;
    constexpr MaterialTexture kOrder[] = {
        normal,          base_color,     anisotropy, metallic_roughness, emissive,
        occlusion,       coat_normal,    coat,       coat_roughness,     sheen_color,
        sheen_roughness, specular_color, specular};
    std::vector<int> found;
    for (const MaterialTexture which : kOrder) {
        TextureUse& use = texture_use(material, which);
        if (!use || std::find(found.begin(), found.end(), use.texcoord) != found.end()) continue;
        if (found.size() < 2) {
            found.push_back(use.texcoord);
            continue;
        }
        report_.warn(
            fmt::format("{}: its {} is not drawn: TEXCOORD_{} is a third set of "
                        "coordinates, and a material has two: TEXCOORD_{} and TEXCOORD_{}",
                        where_, kTextureNames[static_cast<std::size_t>(which)], use.texcoord,
                        found[0], found[1]));
        use = TextureUse();
    }
    std::array<int, 2> sets = {0, 1};
    std::sort(found.begin(), found.end());
    if (found.size() == 2) sets = {found[0], found[1]};
    if (found.size() == 1 && found[0] > 1) sets[1] = found[0];
    for (const MaterialTexture which : kOrder) {
        TextureUse& use = texture_use(material, which);
        use.texcoord = use && use.texcoord == sets[1] ? 1 : 0;
    }
    return sets;
}

}  // namespace

GltfMaterials read_gltf_materials(const tinygltf::Model& model, GltfImages& images,
                                  GltfReport& report) {
    MaterialReader reader(model, images, report);
    GltfMaterials read;
    read.materials.reserve(model.materials.size() + 1);
    for (const tinygltf::Material& material : model.materials) {
        Material& to = read.materials.emplace_back(reader.read(material, read.materials.size()));
        read.sets.push_back(reader.take_two_sets(to));
    }
    return read;
}

}  // namespace burnish
