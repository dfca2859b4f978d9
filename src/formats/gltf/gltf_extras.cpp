#include "formats/gltf/gltf_extras.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/load_tabulated.hpp"
#include "burnish/parameters.hpp"
#include "burnish/shading_names.hpp"
#include "burnish/wif.hpp"
#include "core/text.hpp"
#include "formats/json_text.hpp"

namespace burnish {
namespace {

// Numbers of a material as in the parameter table, so that a file states nothing that flags refuse.
float number(const JsonPlace& place, std::string_view parameter) {
    const Parameter& p = *find_parameter(parameter);
    return static_cast<float>(place.number(p.low, p.high));
}

glm::vec3 triple(const JsonPlace& place, double low, double high) {
    const auto v = place.triple(low, high);
    return {v[0], v[1], v[2]};
}

template <typename Name>
void read_name(const JsonPlace& root, std::string_view key, std::span<const std::string_view> names,
               Name& to) {
    if (!root.has(key)) return;
    const JsonPlace place = root.at(key);
    const std::string name = place.text();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] != name) continue;
        to = static_cast<Name>(i);
        return;
    }
    place.fail(fmt::format("{}", fmt::join(names, ", ")));
}

// A file beside the glTF: a name without folders.
std::filesystem::path beside(const JsonPlace& place, const std::filesystem::path& folder) {
    const std::string name = place.text();
    if (name.empty() || name.find_first_of("/\\:") != name.npos || name.front() == '.')
        place.fail("the name of a file beside the glTF");
    return folder / name;
}

// Terms of films on metals lie below 20.
OxideFilm read_oxide(const JsonPlace& place) {
    OxideFilm film;
    film.thickness_nm = number(place.at("thickness_nm"), "oxide");
    const JsonPlace curve = place.at("curve");
    const std::size_t terms = curve.value().is_array() ? curve.value().size() : 0;
    if (terms != kFresnelTerms) curve.fail(fmt::format("{} colors", kFresnelTerms));
    for (std::size_t i = 0; i < kFresnelTerms; ++i)
        film.curve[i] = triple(curve.at(i), -1000.0, 1000.0);
    return film;
}

Conductor read_conductor(const JsonPlace& place) {
    // Refractive indices of metals lie below 10.
    Conductor c{triple(place.at("eta"), 0.0, 100.0), triple(place.at("k"), 0.0, 100.0)};
    if (place.has("oxide")) c.oxide = read_oxide(place.at("oxide"));
    return c;
}

Cloth read_cloth(const JsonPlace& place, const std::filesystem::path& folder,
                 std::vector<std::string>& warnings) {
    static constexpr std::pair<std::string_view, float Cloth::*> kNumbers[] = {
        {"yarns", &Cloth::yarns},
        {"crimp", &Cloth::crimp},
        {"bulge", &Cloth::bulge},
        {"gap", &Cloth::gap},
        {"fuzz", &Cloth::fuzz}};
    Cloth cloth;
    cloth.draft =
        std::make_shared<const Draft>(load_wif(beside(place.at("draft"), folder), warnings));
    for (const auto& [name, member] : kNumbers)
        cloth.*member = number(place.at(name), fmt::format("weave_{}", name));
    // Radians: 85 degrees.
    cloth.twist = static_cast<float>(place.at("twist").number(-1.4836, 1.4836));
    if (place.has("warp_color")) cloth.warp_color = triple(place.at("warp_color"), 0.0, 1.0);
    if (place.has("weft_color")) cloth.weft_color = triple(place.at("weft_color"), 0.0, 1.0);
    cloth.alpha = {number(place.at("alpha_x"), "alpha_x"), number(place.at("alpha_y"), "alpha_y")};
    return cloth;
}

// The maps stand for a lobe that is restored. What is left of them is where they lie.
void drop_maps(Material& m) {
    TextureUse place = m.normal_texture;
    place.texture = -1;
    m.base_color_texture = m.metallic_roughness_texture = m.occlusion_texture = m.emissive_texture =
        m.anisotropy_texture = TextureUse{};
    m.normal_texture = place;
}

void read_switch(const JsonPlace& root, std::string_view key, bool& value) {
    if (!root.has(key)) return;
    if (!root.at(key).value().is_boolean()) root.at(key).fail("true or false");
    value = root.at(key).value().get<bool>();
}

Material restored(const JsonPlace& root, const std::filesystem::path& folder, Material m,
                  std::vector<std::string>& warnings) {
    constexpr std::array<std::string_view, 14> kKeys = {"mdf",
                                                        "brdf",
                                                        "method",
                                                        "process",
                                                        "conserve",
                                                        "single_scattering",
                                                        "ks",
                                                        "lafortune_c",
                                                        "conductor",
                                                        "cloth",
                                                        "tabulated",
                                                        "color",
                                                        "anisotropy_rotation",
                                                        "coat_tint"};
    root.require_object(kKeys);
    read_name(root, "mdf", mdf_names(), m.mdf);
    read_name(root, "brdf", brdf_names(), m.brdf);
    if (root.has("process")) {
        read_name(root, "process", process_names(), m.process.emplace());
        m.method = method_of(*m.process);
    }
    read_name(root, "method", method_names(), m.method);
    read_switch(root, "conserve", m.conserve);
    read_switch(root, "single_scattering", m.single_scattering);
    if (root.has("ks")) m.ks = number(root.at("ks"), "ks");
    if (root.has("lafortune_c")) m.lafortune_c = triple(root.at("lafortune_c"), -10.0, 10.0);
    if (root.has("conductor")) m.conductor = read_conductor(root.at("conductor"));
    if (root.has("coat_tint")) m.coat.tint = triple(root.at("coat_tint"), 0.0, 1.0);
    const bool replaces = root.has("cloth") || root.has("tabulated");
    if (!replaces) return m;
    drop_maps(m);
    if (root.has("cloth")) {
        m.lobe = read_cloth(root.at("cloth"), folder, warnings);
        m.normal_texture = TextureUse{};
    } else {
        const std::filesystem::path file = beside(root.at("tabulated"), folder);
        m.lobe = Tabulated{load_tabulated(file), file.string()};
        m.alpha_mode = AlphaMode::opaque;
    }
    const JsonPlace color = root.at("color");
    m.base_color = glm::vec4(triple(color.at("base"), 0.0, 1.0), 1.0f);
    m.metallic = number(color.at("metallic"), "metallic");
    if (root.has("anisotropy_rotation"))
        m.anisotropy_rotation =
            static_cast<float>(root.at("anisotropy_rotation").number(-1e4, 1e4));
    return m;
}

}  // namespace

void apply_gltf_extras(std::string_view json, const std::filesystem::path& folder,
                       const std::string& key, GltfReport& report, Material& material) {
    try {
        const nlohmann::json document = nlohmann::json::parse(json);
        std::vector<std::string> warnings;
        material = restored(JsonPlace(key, document), folder, material, warnings);
        for (std::string& line : warnings) report.warn(std::move(line));
        if (cloth_of(material) || tabulated_of(material))
            report.warn(
                fmt::format("{}: the {} that was exported is drawn, not its maps (export with "
                            "--no-extras to draw them)",
                            key, cloth_of(material) ? "weave" : "measured material"));
    } catch (const Error& error) {
        const std::string fault = error.what();
        report.warn(fmt::format("{}{}; the material's maps are drawn",
                                fault.starts_with(key) ? "" : key + ": ", fault));
    }
}

}  // namespace burnish
