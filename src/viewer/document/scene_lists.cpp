#include "viewer/document/scene_lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <limits>
#include <set>

#include "burnish/conductors.hpp"
#include "burnish/error.hpp"
#include "burnish/tabulated_material.hpp"

namespace burnish::viewer {
namespace {

std::string kind_of(const Material& material, const ParameterValues& values) {
    if (tabulated_of(material)) return "captured";
    if (cloth_of(material)) return "weave";
    if (values.is_set("scratch") && values.text("scratch") != "none") return "scratch";
    return material.conductor || material.metallic > 0.5f ? "metal" : "dielectric";
}

// Of some texels: lists are made for every frame, and materials have millions.
glm::vec3 mean_diffuse(const TabulatedMaterial& t) {
    constexpr std::size_t kMostTexels = 4096;
    const std::size_t texels = t.diffuse.pixels.size() / 3, step = texels / kMostTexels + 1;
    glm::dvec3 sum(0.0);
    std::size_t count = 0;
    for (std::size_t i = 0; i < texels; i += step, ++count) {
        const float* p = t.diffuse.pixels.data() + 3 * i;
        sum += glm::dvec3(p[0], p[1], p[2]);
    }
    return glm::vec3(sum / static_cast<double>(std::max<std::size_t>(count, 1)));
}

glm::vec3 color_of(const Material& m) {
    if (const Tabulated* t = tabulated_of(m)) return mean_diffuse(*t->material);
    if (const Cloth* c = cloth_of(m)) return c->warp_color.value_or(glm::vec3(m.base_color));
    return m.conductor ? normal_reflectance(*m.conductor) : glm::vec3(m.base_color);
}

}  // namespace

std::vector<MaterialRow> material_rows(const Stage& stage) {
    const std::vector<Material>& materials = stage.scene.materials;
    const std::vector<ParameterValues>& values = stage.materials.values();
    std::vector<MaterialRow> rows;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const Material& m = materials[i];
        MaterialRow row;
        row.name = m.name.empty() ? fmt::format("#{}", i) : one_line(m.name);
        row.kind = kind_of(m, i < values.size() ? values[i] : ParameterValues());
        row.color = glm::clamp(color_of(m), 0.0f, 1.0f);
        row.has_texture = static_cast<bool>(m.base_color_texture);
        row.objects = static_cast<int>(
            std::ranges::count(stage.scene.instances, static_cast<int>(i), &Instance::material));
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<ObjectRow> object_rows(const Document& document, const Stage& stage) {
    std::vector<ObjectRow> rows;
    for (std::size_t i = 0; i < stage.shown_meshes.size(); ++i) {
        ObjectRow row;
        const int index = stage.shown_meshes[i];
        row.material = stage.scene.instances[i].material;
        row.shown = !document.hidden.contains(static_cast<int>(i));
        if (index >= 0) {
            const Mesh& mesh = stage.scene.meshes[static_cast<std::size_t>(index)];
            row.triangles = mesh.indices.size() / 3;
            row.name = one_line(mesh.name);
        }
        if (row.name.empty()) row.name = fmt::format("object {}", i);
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<Light> all_lights(const Document& document, const Stage& stage) {
    return document.lights ? *document.lights : stage.file.scene.lights;
}

Bounds bounds_of_object(const Stage& stage, std::size_t index) {
    if (index >= stage.shown_meshes.size() || stage.shown_meshes[index] < 0) return {};
    const Bounds box =
        bounds_of(stage.scene.meshes[static_cast<std::size_t>(stage.shown_meshes[index])]);
    const glm::mat4& world = stage.scene.instances[index].transform;
    constexpr float kFar = std::numeric_limits<float>::max();
    Bounds bounds{glm::vec3(kFar), glm::vec3(-kFar)};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 at((corner & 1) != 0 ? box.high.x : box.low.x,
                           (corner & 2) != 0 ? box.high.y : box.low.y,
                           (corner & 4) != 0 ? box.high.z : box.low.z);
        const glm::vec3 placed(world * glm::vec4(at, 1.0f));
        bounds.low = glm::min(bounds.low, placed);
        bounds.high = glm::max(bounds.high, placed);
    }
    return bounds;
}

void show_alone(Document& document, const Stage& stage, int index) {
    std::set<int> others;
    for (int i = 0; i < static_cast<int>(stage.shown_meshes.size()); ++i)
        if (i != index) others.insert(i);
    if (document.hidden == others) others.clear();
    document.hidden = std::move(others);
}

}  // namespace burnish::viewer
