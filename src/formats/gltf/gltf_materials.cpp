#include "formats/gltf/gltf_materials.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>

#include "burnish/error.hpp"
#include "core/constants.hpp"
#include "formats/model_limits.hpp"

namespace burnish {
namespace {

// Reads the materials of one file; `where` is the key of the current material.
class MaterialReader {
  public:
    MaterialReader(const tinygltf::Model& model, GltfImages& images, GltfReport& report)
        : model_(model), images_(images), report_(report) {}

    Material read(const tinygltf::Material& from, std::size_t index);

  private:
    void read_base(const tinygltf::PbrMetallicRoughness& from, Material& to, GltfLobe& lobe);
    void read_extensions(const tinygltf::ExtensionMap& from, Material& to, GltfLobe& lobe);
    void read_anisotropy(const tinygltf::Value& from, Material& to, GltfLobe& lobe);
    AlphaMode alpha_mode(const std::string& name) const;

    template <class Info>
    TextureUse use(const Info& info, ColorSpace color_space, const char* key);
    TextureUse use(int texture, int texcoord, const tinygltf::Value* transform,
                   ColorSpace color_space, const std::string& key);
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
                               ColorSpace color_space, const std::string& key) {
    TextureUse use;
    const auto& texture = item_at(model_.textures, index, report_, key + ".index");
    const std::string texture_key = fmt::format("textures[{}]", index);
    if (texture.source < 0) {
        report_.warn(fmt::format("{}: no PNG or JPEG: {} is not used", texture_key, key));
        return use;
    }
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
    if (use.texcoord > 1) {
        report_.warn(
            fmt::format("{}: only TEXCOORD_0 and TEXCOORD_1 are read: it is not used", key));
        return TextureUse();
    }
    if (texture.sampler >= 0) read_sampler(texture.sampler, use, texture_key + ".sampler");
    use.texture = images_.use(texture.source, color_space, texture_key + ".source");
    return use;
}

template <class Info>
TextureUse MaterialReader::use(const Info& info, ColorSpace color_space, const char* key) {
    if (info.index < 0) return {};
    return use(info.index, info.texCoord, find(info.extensions, "KHR_texture_transform"),
               color_space, fmt::format("{}.{}", where_, key));
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
        use(from.baseColorTexture, ColorSpace::srgb, "pbrMetallicRoughness.baseColorTexture");
    to.metallic_roughness_texture = use(from.metallicRoughnessTexture, ColorSpace::linear,
                                        "pbrMetallicRoughness.metallicRoughnessTexture");
}

void MaterialReader::read_anisotropy(const tinygltf::Value& from, Material& to, GltfLobe& lobe) {
    lobe.anisotropy_strength = clamped(number(from, "anisotropyStrength", 0.0), 0.0, 1.0,
                                       "extensions.KHR_materials_anisotropy.anisotropyStrength");
    to.anisotropy_rotation =
        static_cast<float>(std::remainder(number(from, "anisotropyRotation", 0.0), kTwoPi));
    if (!from.Has("anisotropyTexture")) return;
    const tinygltf::Value& info = from.Get("anisotropyTexture");
    const tinygltf::Value* transform = nullptr;
    if (info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform"))
        transform = &info.Get("extensions").Get("KHR_texture_transform");
    const int texcoord = info.Has("texCoord") ? info.Get("texCoord").GetNumberAsInt() : 0;
    to.anisotropy_texture =
        use(info.Get("index").GetNumberAsInt(), texcoord, transform, ColorSpace::linear,
            where_ + ".extensions.KHR_materials_anisotropy.anisotropyTexture");
}

void MaterialReader::read_extensions(const tinygltf::ExtensionMap& from, Material& to,
                                     GltfLobe& lobe) {
    if (const auto* anisotropy = find(from, "KHR_materials_anisotropy"))
        read_anisotropy(*anisotropy, to, lobe);
    if (const auto* ior = find(from, "KHR_materials_ior")) {
        const double n = number(*ior, "ior", 1.5);
        if (n != 0.0 && n < 1.0)
            report_.fail(where_ + ".extensions.KHR_materials_ior.ior", "0, or 1 or more",
                         fmt::format("{}", n));
        // 0 represents infinity: everything is reflected.
        const double root = n == 0.0 ? 1.0 : (n - 1.0) / (n + 1.0);
        to.dielectric_f0 = static_cast<float>(root * root);
    }
    if (const auto* strength = find(from, "KHR_materials_emissive_strength")) {
        // Renderers sum light in half floats, which end at 65504; no lamp needs more.
        to.emissive *= clamped(number(*strength, "emissiveStrength", 1.0), 0.0, 65504.0,
                               "extensions.KHR_materials_emissive_strength.emissiveStrength");
    }
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
    to.normal_texture = use(from.normalTexture, ColorSpace::linear, "normalTexture");
    // 100 times the least slope of an 8-bit map, 1/127, is 38 degrees: steep enough.
    to.normal_scale = clamped(from.normalTexture.scale, -100.0, 100.0, "normalTexture.scale");
    to.occlusion_texture = use(from.occlusionTexture, ColorSpace::linear, "occlusionTexture");
    to.occlusion_strength =
        clamped(from.occlusionTexture.strength, 0.0, 1.0, "occlusionTexture.strength");
    for (int i = 0; i < 3; ++i)
        to.emissive[i] =
            clamped(from.emissiveFactor[static_cast<std::size_t>(i)], 0.0, 1.0, "emissiveFactor");
    to.emissive_texture = use(from.emissiveTexture, ColorSpace::srgb, "emissiveTexture");
    to.alpha_mode = alpha_mode(from.alphaMode);
    to.alpha_cutoff = clamped(from.alphaCutoff, 0.0, 1e6, "alphaCutoff");
    to.double_sided = from.doubleSided;
    read_extensions(from.extensions, to, lobe);
    to.lobe = lobe;
    return to;
}

}  // namespace

std::vector<Material> read_gltf_materials(const tinygltf::Model& model, GltfImages& images,
                                          GltfReport& report) {
    MaterialReader reader(model, images, report);
    std::vector<Material> materials;
    materials.reserve(model.materials.size() + 1);
    for (const tinygltf::Material& material : model.materials)
        materials.push_back(reader.read(material, materials.size()));
    return materials;
}

}  // namespace burnish
