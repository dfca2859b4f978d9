#include "scene/tabulated_apply.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "burnish/error.hpp"
#include "scene/tensor_file.hpp"

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
    if (!values.is_set("tabulated") || count == 0) return;
    for (const char* other : {"weave", "scratch"}) {
        if (values.is_set(other) && values.text(other) != "none")
            throw UsageError("tabulated", "", fmt::format("no {} beside it", other), "both");
    }
    const std::string name = values.text("tabulated");
    std::shared_ptr<const TabulatedMaterial> tabulated;
    if (name != "none") {
        tabulated = tabulated_named(scene, name);
        warn_of_hidden(scene, values);
    }
    for (std::size_t i = first; i < first + count; ++i) {
        Material& material = scene.materials[i];
        material.tabulated = tabulated;
        material.tabulated_file = tabulated ? name : "";
        if (tabulated) clear_for_tabulated(material);
    }
}

}  // namespace burnish
