#include "viewer/generate/save_maps.hpp"

#include <fmt/format.h>

#include "burnish/error.hpp"
#include "core/text.hpp"
#include "viewer/generate/scratches.hpp"

namespace burnish::viewer {
namespace {

constexpr const char* kCommand = "burnish view";

std::string name_of_material(const Stage& stage, int material) {
    const std::string& name = stage.scene.materials[static_cast<std::size_t>(material)].name;
    return name.empty() ? fmt::format("material #{}", material) : one_line(name);
}

ScratchRequest scratch_request(const std::string& scratch, const std::filesystem::path& folder) {
    ScratchRequest request;
    request.recipe = scratch_choice(scratch).recipe;
    request.output = folder;
    request.command = kCommand;
    return request;
}

WeaveRequest weave_request(const ParameterValues& values, const std::filesystem::path& folder) {
    WeaveRequest request;
    request.weave = values.text("weave");
    for (const std::string_view name : weave_map_parameters()) {
        const auto found = values.set_values().find(name);
        if (found != values.set_values().end()) request.values.set_value(name, found->second);
    }
    if (values.is_set("weave_yarns_per_cm"))
        request.yarn_mm = 10.0 / values.real("weave_yarns_per_cm");
    request.output = folder;
    request.command = kCommand;
    return request;
}

}  // namespace

MapsRequest maps_request(const Stage& stage, std::optional<int> material,
                         const std::filesystem::path& folder) {
    const auto& all = stage.materials.values();
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        if (material && *material != i) continue;
        const ParameterValues& values = all[static_cast<std::size_t>(i)];
        const std::string name = name_of_material(stage, i);
        if (const std::string scratch = scratches_of(stage, i); !scratch.empty())
            return {scratch_request(scratch, folder), "scratches of " + name};
        if (names_one(values, "weave")) return {weave_request(values, folder), "weave of " + name};
    }
    throw Error(material ? name_of_material(stage, *material) : std::string("the scene"), "",
                "scratches or a weave, whose maps can be saved",
                "neither; `save gltf` saves the maps of any material");
}

SavedMaps make_maps(const MapsRequest& request, const Progress& progress) {
    if (const auto* scratch = std::get_if<ScratchRequest>(&request.maps)) {
        ScratchReport report = make_scratch_maps(*scratch, progress);
        return {std::move(report.written), std::move(report.warnings)};
    }
    WeaveReport report = make_weave_maps(std::get<WeaveRequest>(request.maps), progress);
    return {std::move(report.written), std::move(report.warnings)};
}

}  // namespace burnish::viewer
