#include "viewer/document/second_document.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "burnish/error.hpp"
#include "core/text.hpp"
#include "viewer/document/open_files.hpp"

namespace burnish::viewer {
namespace {

bool is_of_surfaces(std::string_view name) {
    const ParameterGroup group = find_parameter(name)->group;
    return group == ParameterGroup::material || group == ParameterGroup::mesh;
}

void require_material(const Scene& scene, int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= scene.materials.size())
        throw Error("compare", "materials",
                    fmt::format("an index below {}", scene.materials.size()),
                    fmt::format("#{}", index));
}

// What opening the file on a material sets.
ParameterValues values_of_file(const std::string& input, const std::string& file) {
    Document bare;
    bare.input = input;
    Document with = opened(bare, file, 0);
    const auto own = with.material_values.find(0);
    if (own == with.material_values.end())
        throw Error(one_line(file), "",
                    "a material: a captured or measured one, a weave, a folder of scratches or of "
                    "maps, or a map",
                    "a model, a scene or an environment");
    return own->second;
}

}  // namespace

Document seen_as(const Document& held, const Document& now) {
    Document document = held;
    for (const Parameter& p : parameter_table())
        if (!is_of_surfaces(p.name)) document.values.erase(p.name);
    for (const auto& [name, value] : now.values.set_values())
        if (!is_of_surfaces(name)) document.values.set_value(name, value);
    document.lights = now.lights;
    document.dark = now.dark;
    document.environment = now.environment;
    return document;
}

std::string material_name(const Scene& scene, int index) {
    const std::string& name = scene.materials.at(static_cast<std::size_t>(index)).name;
    return name.empty() ? fmt::format("#{}", index) : one_line(name);
}

OtherMaterial::OtherMaterial(const Editor& now, MaterialPair pair) : pair_(std::move(pair)) {
    const Scene& scene = now.stage().scene;
    require_material(scene, pair_.material);
    names_[0] = material_name(scene, pair_.material);
    if (const auto index = scene_material_of(pair_.other)) {
        require_material(scene, *index);
        names_[1] = material_name(scene, *index);
        return;
    }
    file_values_ = values_of_file(now.document().input, pair_.other);
    names_[1] = one_line(std::filesystem::path(pair_.other).filename().string());
}

Editor OtherMaterial::editor_of(const Editor& now) const {
    Editor editor = now;
    if (const auto index = scene_material_of(pair_.other)) {
        // Values of the one over the base of the other might contradict each other.
        Document without = now.document();
        without.material_values.erase(pair_.material);
        editor.set(std::move(without));
        editor.put_in_place(pair_.material, *index);
    }
    editor.set(of(now.document()));
    return editor;
}

Document OtherMaterial::of(const Document& now) const {
    Document document = now;
    if (const auto index = scene_material_of(pair_.other)) {
        document.material_values.erase(pair_.material);
        const auto own = now.material_values.find(*index);
        if (own != now.material_values.end())
            document.material_values[pair_.material] = own->second;
        return document;
    }
    for (const auto& [name, value] : file_values_.set_values())
        set_parameter(document, name, value, pair_.material);
    return document;
}

}  // namespace burnish::viewer
