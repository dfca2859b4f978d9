#include "stage/tabulated_apply.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "burnish/error.hpp"
#include "formats/bsdf/tensor_file.hpp"
#include "formats/tabulated/tabulated_file.hpp"
#include "formats/bsdf/rgl_material.hpp"

namespace burnish {
namespace {

constexpr std::string_view kHidden[] = {"mdf",
                                        "brdf",
                                        "alpha_x",
                                        "alpha_y",
                                        "e_x",
                                        "e_y",
                                        "cosine_exponent",
                                        "roughness",
                                        "anisotropy",
                                        "ks",
                                        "lafortune_c",
                                        "metallic",
                                        "base_color",
                                        "metal",
                                        "f0"};

void warn_of_hidden(Scene& scene, const ParameterValues& values) {
    std::vector<std::string_view> hidden;
    for (const std::string_view name : kHidden)
        if (values.is_set(name)) hidden.push_back(name);
    if (hidden.empty()) return;
    scene.warnings.push_back(
        fmt::format("{}: a tabulated material has a lobe and colours of its own: nothing changes",
                    fmt::join(hidden, ", ")));
}

bool sets_other_detail(const ParameterValues& values) {
    const auto names_one = [&](const char* name) {
        return values.is_set(name) && values.text(name) != "none";
    };
    return names_one("weave") || names_one("scratch");
}

// The one that is there already, or the file's.
std::shared_ptr<const TabulatedMaterial> tabulated_named(const Scene& scene,
                                                         const std::string& name) {
    for (const Material& material : scene.materials)
        if (material.tabulated && material.tabulated_file == name) return material.tabulated;
    return load_tabulated(name);
}

// What it takes the place of.
void clear_for_tabulated(Material& m) {
    m.base_color_texture = {};
    m.metallic_roughness_texture = {};
    m.anisotropy_texture = {};
    m.cloth.reset();
    m.conductor.reset();
    m.base_color = glm::vec4(1.0f, 1.0f, 1.0f, m.base_color.a);
    m.metallic = 0.0f;
    m.mdf = Mdf::ggx;
    m.brdf = Brdf::microfacet_separable;
}

}  // namespace

std::shared_ptr<const TabulatedMaterial> load_tabulated(const std::filesystem::path& path) {
    if (is_tensor_file(path)) {
        return std::make_shared<const TabulatedMaterial>(tabulated_from_bsdf(path));
    }
    if (is_tabulated_material(path)) {
        return std::make_shared<const TabulatedMaterial>(read_tabulated_material(path));
    }
    throw Error(path.string(), "",
                "a tabulated material (of burnish capture fit) or an RGL .bsdf file",
                "another file");
}

void apply_tabulated(Scene& scene, std::size_t first, std::size_t count,
                     const ParameterValues& values) {
    const bool set = values.is_set("tabulated");
    const bool other = sets_other_detail(values);
    if (set && other && values.text("tabulated") != "none")
        throw UsageError("tabulated", "", "no weave or scratch map beside it", "both");
    std::shared_ptr<const TabulatedMaterial> tabulated;
    const std::string name = set ? values.text("tabulated") : "none";
    if (name != "none" && count > 0) tabulated = tabulated_named(scene, name);
    bool any = false;
    for (std::size_t i = first; i < first + count; ++i) {
        Material& material = scene.materials[i];
        if (set || other) {
            material.tabulated = tabulated;
            material.tabulated_file = tabulated ? name : "";
        }
        if (!material.tabulated) continue;
        any = true;
        clear_for_tabulated(material);
    }
    if (any) warn_of_hidden(scene, values);
}

}  // namespace burnish
