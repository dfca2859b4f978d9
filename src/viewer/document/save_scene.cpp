#include "viewer/document/save_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "burnish/builtin_meshes.hpp"
#include "burnish/error.hpp"
#include "core/files.hpp"
#include "formats/scene_parts.hpp"
#include "viewer/document/file_names.hpp"
#include "viewer/document/json_numbers.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/document/scene_lists.hpp"
#include "viewer/document/viewer_section.hpp"

namespace burnish::viewer {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// --- file names ---------------------------------------------------------------------------------

std::string in_utf8(const std::string& text) {
    const std::string json =
        nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    return nlohmann::json::parse(json).get<std::string>();
}

// Names of files as a scene file in `folder` states them.
class FileNames {
  public:
    explicit FileNames(const fs::path& scene_file, const fs::path& cache = {})
        : folder_(real_folder(fs::absolute(scene_file).parent_path())),
          own_(fs::absolute(scene_file).stem().string() + ".scratch"),
          cache_(cache.empty() ? fs::path() : real_folder(cache)) {}

    // `key`: the text parameter, "" for a model or an environment.
    std::string name(const std::string& from_here, std::string_view key = "") const {
        if (!is_file(from_here, key)) return from_here;
        fs::path file = absolute_name(from_here);
        if (!cache_.empty() && file.parent_path() == cache_) {
            const fs::path copy = folder_ / own_ / file.filename();
            copies_[file] = copy;
            file = copy;
        }
        std::string written =
            (shares_a_folder(file) ? file.lexically_relative(folder_) : file).string();
        if (!is_file(written, key)) written = "./" + written;  // a file called "none" or "brushed"
        if (in_utf8(written) != written)
            throw Error(one_line(from_here), "", "a file name in UTF-8, as a scene file holds it",
                        "another encoding: rename the file");
        return written;
    }

    // Folders of the cache, and where the scene has copies of them.
    const std::map<fs::path, fs::path>& copies() const { return copies_; }

  private:
    static bool is_file(const std::string& name, std::string_view key) {
        return !is_builtin(name) && name != "none" && (key.empty() || names_file(key, name));
    }

    bool shares_a_folder(const fs::path& file) const {
        auto of_file = file.begin(), of_folder = folder_.begin();
        if (of_file == file.end() || of_folder == folder_.end()) return false;
        ++of_file;  // the root
        ++of_folder;
        return of_file != file.end() && of_folder != folder_.end() && *of_file == *of_folder;
    }

    fs::path folder_, own_, cache_;
    mutable std::map<fs::path, fs::path> copies_;
};

// The file whose presence says that a folder of scratches is whole is copied last.
void copy_scratches(const fs::path& from, const fs::path& to) {
    const fs::path description = "scratch.json";
    std::error_code error;
    if (fs::exists(to / description, error)) return;
    fs::create_directories(to, error);
    if (error)
        throw Error(to.string(), "", "a folder for the scene's scratches",
                    reason_of(error.value()));
    std::vector<fs::path> names;
    for (fs::directory_iterator entry(from, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->path().filename() != description) names.push_back(entry->path().filename());
    if (error)
        throw Error(from.string(), "", "the folder of generated scratches",
                    reason_of(error.value()));
    names.push_back(description);
    for (const fs::path& name : names) write_bytes(to / name, read_file(from / name));
}

// --- values -------------------------------------------------------------------------------------

Json json_of_value(const Parameter& parameter, const ParameterValue& value,
                   const FileNames& files) {
    switch (parameter.kind) {
        case ParameterKind::real:
            return std::get<double>(value);
        case ParameterKind::integer:
            return std::get<int>(value);
        case ParameterKind::boolean:
            return std::get<bool>(value);
        case ParameterKind::color:
        case ParameterKind::vector:
            return json_of(std::get<glm::vec3>(value));
        case ParameterKind::choice:
            return text_of(parameter, value);
        case ParameterKind::text:
            return files.name(std::get<std::string>(value), parameter.name);
    }
    return {};
}

// The values of materials, or all others.
Json json_of_values(const ParameterValues& values, bool of_materials, const FileNames& files) {
    Json out = Json::object();
    for (const auto& [name, value] : values.set_values()) {
        const Parameter& parameter = *find_parameter(name);
        if ((parameter.group == ParameterGroup::material) == of_materials)
            out[name] = json_of_value(parameter, value, files);
    }
    return out;
}

Json json_of_area_light(const Light& light, const FileNames& files) {
    const bool tube = light.type == LightType::tube;
    Json out;
    out["type"] = tube ? "tube" : light.type == LightType::disc ? "disc" : "rectangle";
    out["position"] = json_of(light.position);
    out["direction"] = json_of(light.direction);
    if (tube) {
        out["length"] = decimal_of(light.size.x);
        out["radius"] = 0.5 * decimal_of(light.size.y);
    } else {
        out["size"] = Json::array({decimal_of(light.size.x), decimal_of(light.size.y)});
        if (light.up != Light{}.up) out["up"] = json_of(light.up);
        if (light.two_sided) out["two_sided"] = true;
    }
    if (!light.visible) out["visible"] = false;
    if (!light.texture.file.empty()) out["texture"] = files.name(light.texture.file);
    out["radiance"] = decimal_of(light.intensity);
    if (light.color != glm::vec3(1.0f)) out["color"] = json_of(light.color);
    return out;
}

Json json_of_light(const Light& light, const FileNames& files) {
    require_valid(light);
    if (has_area(light)) return json_of_area_light(light, files);
    static constexpr std::string_view kTypes[] = {"directional", "point", "spot"};
    const bool spot = light.type == LightType::spot, point = light.type == LightType::point;
    Json out;
    out["type"] = kTypes[static_cast<std::size_t>(light.type)];
    if (!point) out["direction"] = json_of(light.direction);
    if (point || spot) {
        out["position"] = json_of(light.position);
        if (light.range != 0.0f) out["range"] = decimal_of(light.range);
    }
    out["intensity"] = decimal_of(light.intensity);
    if (light.color != glm::vec3(1.0f)) out["color"] = json_of(light.color);
    if (!spot) return out;
    // The float that is nearest to a right angle is larger than it.
    const double outer = std::min(glm::degrees(static_cast<double>(light.outer_cone)), 90.0);
    out["outer_cone_deg"] = outer;
    out["inner_cone_deg"] = std::min(glm::degrees(static_cast<double>(light.inner_cone)), outer);
    return out;
}

// --- materials ----------------------------------------------------------------------------------

// Sets of parameters under "materials", and what objects say of them. Materials that objects share
// are told by the first of them.
class MaterialSets {
  public:
    MaterialSets(const Stage& stage, const FileNames& files) : stage_(stage), files_(files) {}

    // The member "material" of an object; null where it has none.
    Json material_of(const SceneFile::Object& object) {
        const auto known = by_first_.find(object.first_material);
        if (known != by_first_.end()) return known->second;
        std::vector<std::string> names;
        std::map<std::string, std::string> own;  // set, as text, to its name: of this object alone
        for (int i = 0; i < object.materials; ++i)
            names.push_back(set_name(object.first_material + i, own));
        Json member;
        const bool one = std::all_of(names.begin(), names.end(), [&](const std::string& name) {
            return name == names.front();
        });
        if (one && !names.empty() && !names.front().empty()) {
            member["*"] = names.front();
        } else {
            for (std::size_t i = 0; i < names.size(); ++i)
                if (!names[i].empty()) member[fmt::format("#{}", i)] = names[i];
        }
        // Two objects of one model that say the same share their materials: these do not.
        if (!bare_.insert(object.model).second || !member.is_null()) {
            if (member.is_null()) member["#0"] = add(Json::object(), "as it is");
        }
        by_first_.emplace(object.first_material, member);
        return member;
    }

    const Json& sets() const { return sets_; }

  private:
    // "" for a material with nothing set.
    std::string set_name(int index, std::map<std::string, std::string>& own) {
        const auto i = static_cast<std::size_t>(index);
        const LayeredMaterials& materials = stage_.materials;
        const std::string name = in_utf8(materials.base()[i].name);
        Json set = json_of_values(materials.values()[i], true, files_);
        if (materials.layers()[i].renamed) set["name"] = name;
        if (set.empty()) return "";
        const std::string text = set.dump();
        const auto known = own.find(text);
        if (known != own.end()) return known->second;
        return own[text] = add(std::move(set), name.empty() ? "material" : name);
    }

    std::string add(Json set, const std::string& wished) {
        std::string name = wished;
        for (int i = 2; sets_.contains(name); ++i) name = fmt::format("{} {}", wished, i);
        sets_[name] = std::move(set);
        return name;
    }

    const Stage& stage_;
    const FileNames& files_;
    Json sets_ = Json::object();
    std::map<int, Json> by_first_;
    std::set<std::string> bare_;  // models of which some materials have nothing set
};

// --- the file -----------------------------------------------------------------------------------

Json json_of_object(const SceneFile::Object& object, const Document& document,
                    MaterialSets& materials, const FileNames& files) {
    const SceneFile::Object nowhere;
    Json out;
    out["model"] = files.name(object.model);
    if (Json member = materials.material_of(object); !member.is_null())
        out["material"] = std::move(member);
    if (object.translate != nowhere.translate) out["translate"] = json_of(object.translate);
    if (object.rotate_deg != nowhere.rotate_deg) out["rotate_deg"] = json_of(object.rotate_deg);
    if (object.scale != nowhere.scale) out["scale"] = json_of(object.scale);
    for (int i = 0; i < object.instances; ++i)
        if (document.hidden.contains(object.first_instance + i)) out["hidden"].push_back(i);
    return out;
}

void add_lights(Json& root, const Document& document, const SceneFile& file,
                const FileNames& files) {
    const bool replaced = document.lights || !document.dark.empty();
    if (file.drops_lights || (replaced && file.model_lights > 0)) root["model_lights"] = false;
    const std::vector<Light> lights = drawn_lights(document, file.scene.lights);
    for (std::size_t i = replaced ? 0 : static_cast<std::size_t>(file.model_lights);
         i < lights.size(); ++i)
        root["lights"].push_back(json_of_light(lights[i], files));
}

bool is_flat(const Json& json) {
    return std::all_of(json.begin(), json.end(), [](const Json& item) {
        return !item.is_structured() || (item.is_array() && item.size() <= 3);
    });
}

// Lists of numbers, and objects that fit on a line, on one line.
void write_json(const Json& json, int indent, std::string& out) {
    constexpr std::size_t kLine = 100;
    const std::string line = json.dump(-1);
    const bool short_line = line.size() + static_cast<std::size_t>(indent) <= kLine;
    if (!json.is_structured() || json.empty() || (short_line && indent > 0 && is_flat(json))) {
        out += line;
        return;
    }
    out += json.is_array() ? "[\n" : "{\n";
    const std::string margin(static_cast<std::size_t>(indent) + 2, ' ');
    bool first = true;
    for (const auto& item : json.items()) {
        if (!first) out += ",\n";
        first = false;
        out += margin;
        if (json.is_object()) out += Json(item.key()).dump() + ": ";
        write_json(item.value(), indent + 2, out);
    }
    out += "\n" + margin.substr(2) + (json.is_array() ? "]" : "}");
}

std::string text_of_scene(const Document& document, const Stage& stage, const FileNames& files,
                          const std::string& autosave_of = {}) {
    require_valid(document);
    MaterialSets materials(stage, files);
    Json root;
    root["format"] = "burnish-scene";
    root["version"] = 1;
    root["objects"] = Json::array();
    for (const SceneFile::Object& object : stage.file.objects)
        root["objects"].push_back(json_of_object(object, document, materials, files));
    if (!materials.sets().empty()) root["materials"] = materials.sets();
    add_lights(root, document, stage.file, files);
    const std::string& environment =
        document.environment.empty() ? stage.file.environment : document.environment;
    if (!environment.empty()) root["environment"] = files.name(environment);
    if (Json parameters = json_of_values(stage.values, false, files); !parameters.empty())
        root["parameters"] = std::move(parameters);
    const auto file_name = [&](const std::string& file) { return files.name(file); };
    const std::vector<Light> lights = all_lights(document, stage);
    Json viewer = viewer_section(document, lights, file_name);
    if (!autosave_of.empty()) viewer["scene"] = in_utf8(autosave_of);
    if (!viewer.is_null()) root["viewer"] = std::move(viewer);
    std::string text;
    write_json(root, 0, text);
    return text + "\n";
}

}  // namespace

std::string scene_text(const Document& document, const Stage& stage, const fs::path& where) {
    return text_of_scene(document, stage, FileNames(where));
}

void save_scene(const Document& document, const Stage& stage, const fs::path& where,
                const fs::path& cache, const std::string& autosave_of) {
    const FileNames files(where, cache);
    const std::string text = text_of_scene(document, stage, files, autosave_of);
    for (const auto& [from, to] : files.copies()) copy_scratches(from, to);
    write_text_file(where, text);
}

}  // namespace burnish::viewer
