#include "export/gltf_material_text.hpp"

#include <cmath>
#include <glm/common.hpp>

#include "burnish/shading_names.hpp"

namespace burnish {
namespace {

using nlohmann::ordered_json;

// tile = translation * scale: what bake_gltf_material returns for weaves, scratches and flags. A
// rotation comes from a glTF's own transform.
ordered_json transform_of(const glm::mat3& m) {
    const float rotation = std::atan2(-m[0][1], m[0][0]);
    const float scale_u = std::hypot(m[0][0], m[0][1]);
    // The determinant's sign is that of the scale along v.
    const float scale_v = (m[0][0] * m[1][1] - m[0][1] * m[1][0]) / scale_u;
    ordered_json out = {{"offset", {m[2][0], m[2][1]}}, {"scale", {scale_u, scale_v}}};
    if (rotation != 0.0f) out["rotation"] = rotation;
    return out;
}

ordered_json texture(const TextureUse& use) {
    ordered_json out = {{"index", use.texture}};
    if (use.transform != glm::mat3(1.0f))
        out["extensions"]["KHR_texture_transform"] = transform_of(use.transform);
    return out;
}

ordered_json triple(glm::vec3 v) {
    return {v.x, v.y, v.z};
}

ordered_json cloth_json(const Cloth& c, const std::string& draft) {
    ordered_json out = {{"draft", draft},   {"yarns", c.yarns},     {"crimp", c.crimp},
                        {"bulge", c.bulge}, {"gap", c.gap},         {"twist", c.twist},
                        {"fuzz", c.fuzz},   {"alpha_x", c.alpha.x}, {"alpha_y", c.alpha.y}};
    if (c.warp_color) out["warp_color"] = triple(*c.warp_color);
    if (c.weft_color) out["weft_color"] = triple(*c.weft_color);
    return out;
}

ordered_json conductor_json(const Conductor& c) {
    ordered_json out = {{"eta", triple(c.eta)}, {"k", triple(c.k)}};
    if (!c.oxide) return out;
    ordered_json curve = ordered_json::array();
    for (const glm::vec3& term : c.oxide->curve) curve.push_back(triple(term));
    out["oxide"] = {{"thickness_nm", c.oxide->thickness_nm}, {"curve", curve}};
    return out;
}

// `file`: beside the glTF, of the weave's draft or the measured material.
ordered_json extras_of(const Material& m, const std::string& file) {
    ordered_json out = {{"mdf", name_of(m.mdf)},
                        {"brdf", name_of(m.brdf)},
                        {"method", name_of(m.method)},
                        {"conserve", m.conserve},
                        {"single_scattering", m.single_scattering}};
    if (m.process) out["process"] = name_of(*m.process);
    if (m.ks) out["ks"] = *m.ks;
    if (m.brdf == Brdf::lafortune) out["lafortune_c"] = triple(m.lafortune_c);
    if (m.conductor) out["conductor"] = conductor_json(*m.conductor);
    if (has_coat(m) && m.coat.tint != glm::vec3(1.0f)) out["coat_tint"] = triple(m.coat.tint);
    if (!file.empty()) {
        out["color"] = {{"base", triple(glm::vec3(m.base_color))}, {"metallic", m.metallic}};
        out["anisotropy_rotation"] = m.anisotropy_rotation;
        if (const Cloth* cloth = cloth_of(m)) out["cloth"] = cloth_json(*cloth, file);
        if (tabulated_of(m)) out["tabulated"] = file;
    }
    return out;
}

// KHR_materials_specular, clearcoat and sheen, by their factors: what differs from glTF's own.
void put_layers(const Material& m, ordered_json& extensions, std::vector<std::string>& names) {
    const auto put = [&](const char* name, const ordered_json& json) {
        extensions[name] = json;
        names.emplace_back(name);
    };
    if (has_specular_factors(m))
        put("KHR_materials_specular",
            {{"specularFactor", m.specular}, {"specularColorFactor", triple(m.specular_color)}});
    if (has_coat(m))
        put("KHR_materials_clearcoat",
            {{"clearcoatFactor", m.coat.strength}, {"clearcoatRoughnessFactor", m.coat.roughness}});
    if (has_sheen(m))
        put("KHR_materials_sheen", {{"sheenColorFactor", triple(m.sheen.color)},
                                    {"sheenRoughnessFactor", m.sheen.roughness}});
}

}  // namespace

float ior_of(float f0) {
    const float root = std::sqrt(glm::clamp(f0, 0.0f, 1.0f));
    return root < 1.0f ? (1.0f + root) / (1.0f - root) : 0.0f;  // 0 stands for infinity
}

std::vector<std::string> gltf_map_names(const GltfMaterial& baked) {
    std::vector<std::string> names;
    for (const Texture& texture : baked.textures) names.push_back(texture.name + ".png");
    return names;
}

QuadMaterial gltf_material_text(const GltfMaterial& baked, const Material& source,
                                const std::string& name, const std::string& file) {
    const Material& m = baked.material;
    QuadMaterial out;
    out.images = gltf_map_names(baked);
    out.repeats = tabulated_of(source) == nullptr;
    out.extensions = {"KHR_materials_anisotropy"};
    if (baked.tile != glm::mat3(1.0f)) out.extensions.emplace_back("KHR_texture_transform");
    ordered_json& json = out.json;
    json["name"] = name;
    json["pbrMetallicRoughness"] = {
        {"baseColorTexture", texture(m.base_color_texture)},
        {"metallicRoughnessTexture", texture(m.metallic_roughness_texture)}};
    json["normalTexture"] = texture(m.normal_texture);
    json["occlusionTexture"] = texture(m.occlusion_texture);
    if (m.alpha_mode == AlphaMode::mask) {
        json["alphaMode"] = "MASK";
        json["alphaCutoff"] = m.alpha_cutoff;
    }
    if (m.alpha_mode == AlphaMode::blend) json["alphaMode"] = "BLEND";
    if (m.double_sided) json["doubleSided"] = true;
    ordered_json& extensions = json["extensions"];
    extensions["KHR_materials_anisotropy"] = {{"anisotropyStrength", 1.0},
                                              {"anisotropyTexture", texture(m.anisotropy_texture)}};
    // 0.04 is glTF's own.
    if (m.dielectric_f0 != kGltfF0) {
        extensions["KHR_materials_ior"] = {{"ior", ior_of(m.dielectric_f0)}};
        out.extensions.emplace_back("KHR_materials_ior");
    }
    put_layers(m, extensions, out.extensions);
    if (m.emissive_texture) {
        const float brightest = m.emissive.x;
        const float factor = std::min(brightest, 1.0f);
        json["emissiveFactor"] = {factor, factor, factor};
        json["emissiveTexture"] = texture(m.emissive_texture);
        if (brightest > 1.0f) {
            extensions["KHR_materials_emissive_strength"] = {{"emissiveStrength", brightest}};
            out.extensions.emplace_back("KHR_materials_emissive_strength");
        }
    }
    json["extras"]["burnish"] = extras_of(source, file);
    return out;
}

}  // namespace burnish
