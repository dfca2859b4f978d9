#include "viewer/document/open_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "burnish/builtin_meshes.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/rig.hpp"
#include "burnish/scene_file.hpp"
#include "burnish/stage.hpp"
#include "burnish/tabulated_file.hpp"
#include "burnish/wif.hpp"
#include "formats/bsdf/tensor_file.hpp"
#include "stage/map_set.hpp"
#include "viewer/document/file_names.hpp"

namespace burnish::viewer {
namespace {

namespace fs = std::filesystem;

enum class FileKind { model, scene, environment, picture, weave, tabulated, folder, rig };

constexpr std::string_view kBuiltin = "builtin:";

bool is_builtin_mesh(const std::string& name) {
    const auto names = builtin_names();
    return is_builtin(name) &&
           std::find(names.begin(), names.end(), name.substr(kBuiltin.size())) != names.end();
}

// A lat-long picture, unless its name says that it is a map of a surface.
bool is_environment(const fs::path& path) {
    if (map_role_of(path)) return false;
    const ImageInfo info = read_image_info(path);
    return std::abs(static_cast<double>(info.width) / std::max(info.height, 1) / 2.0 - 1.0) <= 0.02;
}

FileKind kind_of(const std::string& path) {
    std::error_code error;
    if (is_builtin(path)) return is_builtin_mesh(path) ? FileKind::model : FileKind::environment;
    if (!fs::exists(path, error)) throw Error(path, "", "a file or a folder", "none");
    if (fs::is_directory(path, error)) return FileKind::folder;
    if (is_tensor_file(path)) return FileKind::tabulated;
    if (is_wif_file(path)) return FileKind::weave;
    if (is_tabulated_material(path)) return FileKind::tabulated;  // before pictures: both are EXR
    if (is_image_file(path))
        return is_environment(path) ? FileKind::environment : FileKind::picture;
    if (is_rig_file(path)) return FileKind::rig;  // before scenes: both are JSON
    return is_scene_file(path) ? FileKind::scene : FileKind::model;
}

std::string_view parameter_of_role(MapRole role) {
    switch (role) {
        case MapRole::base_color:
        case MapRole::opacity:
            return "base_color_map";
        case MapRole::roughness:
            return "roughness_map";
        case MapRole::glossiness:
            return "glossiness_map";
        case MapRole::metallic:
            return "metallic_map";
        case MapRole::occlusion:
            return "ao_map";
        case MapRole::orm:
            return "orm_map";
        case MapRole::anisotropy:
            return "anisotropy_map";
        case MapRole::height:
            return "height_map";
        case MapRole::emissive:
            return "emissive_map";
        case MapRole::mask_map:
        case MapRole::metallic_roughness:
        case MapRole::metallic_smoothness:
        case MapRole::occlusion_roughness:
            throw Error(fmt::format("a {} map", map_role_name(role)), "",
                        "the folder that it is in: no parameter names such a map alone",
                        "the picture");
        case MapRole::normal:
        case MapRole::normal_directx:
            break;
    }
    return "normal_map";
}

// A document with another input: what belonged to the former one is gone.
Document with_input(const Document& document, const std::string& input, bool scene_file) {
    Document opened;
    opened.input = input;
    if (scene_file) return opened;
    opened.environment = document.environment;
    for (const auto& [name, value] : document.values.set_values()) {
        const ParameterGroup group = find_parameter(name)->group;
        if (group == ParameterGroup::render || group == ParameterGroup::environment)
            opened.values.set_value(name, value);
    }
    opened.compare = document.compare;
    return opened;
}

// Something to put a material onto.
void need_input(Document& document) {
    if (document.input.empty()) document.input = "builtin:sphere";
}

void put_material(Document& document, std::string_view name, const std::string& file,
                  std::optional<int> material) {
    need_input(document);
    // A whole material takes the place of what the same layer says, as it does of lower layers.
    ParameterValues& layer = material ? document.material_values[*material] : document.values;
    ParameterValues put;
    put.set_value(name, file);
    if (name == "maps" || name == "weave") layer = values_over(layer, put, std::nullopt);
    set_parameter(document, name, file, material);
}

void put_picture(Document& document, const std::string& path, std::optional<int> material,
                 std::vector<std::string>* notes) {
    const std::optional<MapRole> role = map_role_of(path);
    const std::string_view parameter = parameter_of_role(role.value_or(MapRole::normal));
    put_material(document, parameter, path, material);
    if (role == MapRole::normal_directx) set_parameter(document, "flip_green", true, material);
    if (notes != nullptr && !role)
        notes->push_back(
            fmt::format("{}: its name states no role, such as \"color\" or \"roughness\": taken as "
                        "a normal map",
                        one_line(path)));
}

void put_folder(Document& document, const std::string& path, std::optional<int> material) {
    std::error_code error;
    const bool scratches = fs::exists(fs::path(path) / "scratch.json", error) &&
                           fs::exists(fs::path(path) / "normal.png", error);
    if (!scratches) find_map_set(path);  // throws where it holds no maps
    put_material(document, scratches ? "scratch" : "maps", path, material);
}

// Materials that `burnish capture fit` has made, in the folder of the rig, and when.
std::vector<std::pair<fs::file_time_type, std::string>> materials_beside(const std::string& rig) {
    std::error_code error;
    std::vector<std::pair<fs::file_time_type, std::string>> found;
    const fs::path folder = fs::path(rig).parent_path();
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code unreadable;
        if (entry->path().extension() != ".exr" || !entry->is_regular_file(unreadable)) continue;
        if (is_tabulated_material(entry->path()))
            found.emplace_back(entry->last_write_time(unreadable), entry->path().string());
    }
    return found;
}

// Of several the one that was written last.
std::string fitted_beside(const std::string& rig, std::vector<std::string>* notes) {
    const auto found = materials_beside(rig);
    const fs::path folder = fs::path(rig).parent_path();
    if (found.empty())
        throw Error(
            rig, "", "a material, which a rig is not yet",
            fmt::format("a rig and no fitted material beside it: run `burnish capture fit {} "
                        "-o {}` first, and open what it writes",
                        one_line(rig), (folder / "material.exr").string()));
    const std::string chosen = std::max_element(found.begin(), found.end())->second;
    if (notes != nullptr)
        notes->push_back(fmt::format("{}: a rig; {} beside it is shown", one_line(rig),
                                     one_line(fs::path(chosen).filename().string())));
    return chosen;
}

}  // namespace

bool is_unfitted_rig(const std::string& path) {
    std::error_code error;
    return fs::is_regular_file(path, error) && is_rig_file(path) &&
           materials_beside(fs::absolute(path, error).string()).empty();
}

Document first_document() {
    Document document;
    document.input = "builtin:sphere";
    document.environment = std::string(kDefaultEnvironment);
    const auto set = [&](std::string_view name, std::string_view text) {
        document.values.set(name, text, "");
    };
    set("metal", "steel");
    set("scratch", "brushed");
    set("alpha_x", "0.1");
    set("alpha_y", "0.4");
    set("method", "follow-grain");
    return document;
}

Document opened(Document document, const std::string& path, std::optional<int> material,
                std::vector<std::string>* notes) {
    if (path.empty()) throw Error("file", "", "a name", "none");
    const std::string file = absolute_name(path);
    switch (kind_of(file)) {
        case FileKind::model:
            return with_input(document, file, false);
        case FileKind::scene:
            return with_input(document, file, true);
        case FileKind::environment:
            document.environment = file;
            return document;
        case FileKind::picture:
            put_picture(document, file, material, notes);
            return document;
        case FileKind::weave:
            put_material(document, "weave", file, material);
            return document;
        case FileKind::tabulated:
            put_material(document, "tabulated", file, material);
            return document;
        case FileKind::folder:
            put_folder(document, file, material);
            return document;
        case FileKind::rig:
            put_material(document, "tabulated", fitted_beside(file, notes), material);
            return document;
    }
    return document;
}

Document document_for(std::span<const std::string> paths, std::vector<std::string>* notes) {
    if (paths.empty()) return first_document();
    std::vector<std::string> ordered(paths.begin(), paths.end());
    std::stable_partition(ordered.begin(), ordered.end(), [](const std::string& path) {
        const FileKind kind = kind_of(absolute_name(path));
        return kind == FileKind::model || kind == FileKind::scene;
    });
    Document document;
    for (const std::string& path : ordered)
        document = opened(std::move(document), path, std::nullopt, notes);
    need_input(document);
    return document;
}

}  // namespace burnish::viewer
