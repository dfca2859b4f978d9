// Scene files: docs/reference/scene-file.md is the schema in words.
#include "burnish/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <span>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/load_model.hpp"
#include "burnish/scratch_settings.hpp"
#include "burnish/shading_names.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "formats/json_text.hpp"

namespace burnish {

namespace {

constexpr std::string_view kFormat = "burnish-scene";
// Ten thousand objects with every key take two megabytes.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;
constexpr std::size_t kMostObjects = 10000, kMostLights = 1000;
constexpr double kFar = 1e6;                        // meters, as in the parameter table
constexpr double kSmallest = 1e-6, kLargest = 1e6;  // scale factors
constexpr std::string_view kBuiltinPrefix = "builtin:";

// Throws Error for a name that is not in `known`; suggests the nearest one.
[[noreturn]] void refuse_name(const JsonPlace& place, std::span<const std::string_view> known,
                              const std::string& kind) {
    const std::string_view nearest = nearest_name(known, place.text());
    throw Error(
        place.file(), place.path(),
        fmt::format("{} ({})", kind,
                    known.empty() ? "there are none" : fmt::to_string(fmt::join(known, " "))),
        nearest.empty() ? shown(place.text())
                        : fmt::format("{}; did you mean '{}'?", shown(place.text()), nearest));
}

// Resolves a file name in a scene file relative to the scene file; absolute paths stay.
std::string beside(const std::filesystem::path& scene_file, const std::string& name) {
    if (name.starts_with(kBuiltinPrefix) || name == "none") return name;
    return (scene_file.parent_path() / name).string();
}

bool is_among(std::span<const std::string_view> names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// Whether the value `name` of the text parameter `key` is a file name.
bool names_file(std::string_view key, std::string_view name) {
    if (key == "scratch") return !is_among(scratch_preset_names(), name);
    if (key == "weave") return !is_among(draft_names(), name);
    return key.ends_with("_map") || key == "maps" || key == "tabulated";
}

// --- parameters -------------------------------------------------------------------------------

glm::vec3 read_numbers(const JsonPlace& place) {
    glm::vec3 numbers(0.0f);
    for (std::size_t i = 0; i < 3; ++i) {
        const nlohmann::json& number = place.value()[i];
        if (!number.is_number()) place.at(i).fail("a number");
        numbers[static_cast<int>(i)] = static_cast<float>(number.get<double>());
    }
    return numbers;
}

// Sets `key` to the JSON value at `place`. A number out of the range of int suits no parameter.
void read_parameter(const JsonPlace& place, const Parameter& parameter,
                    const std::filesystem::path& file, ParameterValues& values) {
    const nlohmann::json& value = place.value();
    const std::string where = place.file() + ": " + place.path();
    const auto set = [&](const ParameterValue& typed) {
        values.set_value(parameter.name, typed, where);
    };
    using Kind = ParameterKind;
    switch (parameter.kind) {
        case Kind::real:
            if (!value.is_number()) place.fail("a number");
            return set(value.get<double>());
        case Kind::integer: {
            if (!value.is_number_integer()) place.fail("a whole number");
            const double number = value.get<double>();
            if (number < parameter.low || number > parameter.high)
                return values.set(parameter.name, value.dump(), where);  // throws Error
            return set(value.get<int>());
        }
        case Kind::boolean:
            if (!value.is_boolean()) place.fail("true or false");
            return set(value.get<bool>());
        case Kind::color:
            if (value.is_string()) return values.set(parameter.name, place.text(), where);
            if (!value.is_array() || value.size() != 3) place.fail("[r, g, b] or \"#rrggbb\"");
            return set(read_numbers(place));
        case Kind::vector:
            if (!value.is_array() || value.size() != 3) place.fail("[x, y, z]");
            return set(read_numbers(place));
        case Kind::choice:
            return values.set(parameter.name, place.text(), where);
        case Kind::text: {
            const std::string text = place.text();
            return set(names_file(parameter.name, text) ? beside(file, text) : text);
        }
    }
}

ParameterValues read_parameters(const JsonPlace& place, const std::filesystem::path& file,
                                bool only_material) {
    place.require_object();
    ParameterValues values;
    for (const std::string& key : place.keys()) {
        const Parameter* parameter = find_parameter(key);
        try {
            if (!parameter) values.set(key, "", place.file() + ": " + place.path());
            const JsonPlace member = place.at(key);
            if (only_material && parameter->group != ParameterGroup::material)
                throw Error(place.file(), member.path(), "a parameter of materials", shown(key));
            read_parameter(member, *parameter, file, values);
        } catch (const UsageError& error) {
            throw Error(error.what());  // an error of the file, not of the command line
        }
    }
    return values;
}

// --- lights -----------------------------------------------------------------------------------

glm::vec3 read_color(const JsonPlace& place) {
    if (!place.is_text()) return place.triple(0.0, 1.0);
    ParameterValues parser;
    try {
        parser.set("base_color", place.text(), "");
    } catch (const UsageError&) {
        place.fail("[r, g, b] from 0 to 1 or \"#rrggbb\"");
    }
    return parser.vec3("base_color");
}

glm::vec3 read_direction(const JsonPlace& place) {
    const glm::vec3 direction = place.triple(-kFar, kFar);
    // The square of a shorter vector would underflow, and no such vector is an intended direction.
    if (glm::length(direction) < 1e-12f) place.fail("a direction that is not zero");
    return glm::normalize(direction);
}

LightType read_light_type(const JsonPlace& place) {
    constexpr std::array<std::string_view, 3> kTypes = {"directional", "point", "spot"};
    const std::string name = place.text();
    const auto found = std::find(kTypes.begin(), kTypes.end(), name);
    if (found == kTypes.end()) refuse_name(place, kTypes, "a type of light");
    return static_cast<LightType>(found - kTypes.begin());
}

Light read_light(const JsonPlace& place) {
    using Keys = std::vector<std::string_view>;
    static const Keys directional_keys = {"type", "color", "intensity", "direction"};
    static const Keys point_keys = {"type", "color", "intensity", "position", "range"};
    static const Keys spot_keys = {"type",  "color",     "intensity",      "position",
                                   "range", "direction", "inner_cone_deg", "outer_cone_deg"};
    place.require_object();
    Light light;
    light.type = read_light_type(place.at("type"));
    const bool directional = light.type == LightType::directional;
    const bool spot = light.type == LightType::spot;
    place.require_object(directional ? directional_keys : spot ? spot_keys : point_keys);
    if (place.has("color")) light.color = read_color(place.at("color"));
    if (place.has("intensity"))
        light.intensity = static_cast<float>(place.at("intensity").number(0.0, 1e9));
    if (directional || spot) light.direction = read_direction(place.at("direction"));
    if (directional) return light;
    light.position = place.at("position").triple(-kFar, kFar);
    if (place.has("range")) light.range = static_cast<float>(place.at("range").number(0.0, kFar));
    if (!spot) return light;
    const double outer =
        place.has("outer_cone_deg") ? place.at("outer_cone_deg").number(0.1, 90.0) : 45.0;
    const double inner =
        place.has("inner_cone_deg") ? place.at("inner_cone_deg").number(0.0, outer) : 0.0;
    light.outer_cone = static_cast<float>(glm::radians(outer));
    light.inner_cone = static_cast<float>(glm::radians(inner));
    return light;
}

// --- objects ----------------------------------------------------------------------------------

glm::mat4 read_transform(const JsonPlace& place) {
    glm::mat4 m(1.0f);
    if (place.has("translate")) m = glm::translate(m, place.at("translate").triple(-kFar, kFar));
    if (place.has("rotate_deg")) {
        const glm::vec3 turn = glm::radians(place.at("rotate_deg").triple(-3600.0, 3600.0));
        m = glm::rotate(m, turn.z, glm::vec3(0, 0, 1));  // rotates about x first, then y, then z
        m = glm::rotate(m, turn.y, glm::vec3(0, 1, 0));
        m = glm::rotate(m, turn.x, glm::vec3(1, 0, 0));
    }
    if (place.has("scale")) {
        const JsonPlace scale = place.at("scale");
        const glm::vec3 factors =
            scale.value().is_array()
                ? scale.triple(kSmallest, kLargest)
                : glm::vec3(static_cast<float>(scale.number(kSmallest, kLargest)));
        m = glm::scale(m, factors);
    }
    return m;
}

// A model that is already in the scene: its first mesh and texture there, and its other data.
struct LoadedModel {
    int first_mesh = 0, first_texture = 0;
    Scene rest;                                 // without meshes and textures
    std::map<std::string, int> first_material;  // by name of the parameter set, "" for none
};

class SceneFileReader {
  public:
    SceneFileReader(const std::filesystem::path& path, const nlohmann::json& document)
        : path_(path), file_(path.string()), root_(file_, document) {}

    SceneFile read() {
        constexpr std::array<std::string_view, 7> kKeys = {
            "format", "version", "objects", "materials", "lights", "environment", "parameters"};
        root_.require_object();
        if (!root_.has("format"))
            throw Error(file_, "format", fmt::format("\"{}\"", kFormat), "none");
        if (root_.at("format").text() != kFormat)
            root_.at("format").fail(
                "burnish-scene (burnish info says what other files of Burnish's hold)");
        if (root_.at("version").value() != 1) root_.at("version").fail("1");
        root_.require_object(kKeys);
        out_.scene.name = path_.stem().string();
        read_parameter_sets();
        if (root_.has("objects")) {
            const JsonPlace objects = root_.at("objects");
            objects.require_array(kMostObjects);
            for (std::size_t i = 0; i < objects.size(); ++i) add_object(objects.at(i));
        }
        if (root_.has("lights")) {
            const JsonPlace lights = root_.at("lights");
            lights.require_array(kMostLights);
            for (std::size_t i = 0; i < lights.size(); ++i)
                out_.scene.lights.push_back(read_light(lights.at(i)));
        }
        if (root_.has("environment"))
            out_.environment = beside(path_, root_.at("environment").text());
        return std::move(out_);
    }

  private:
    // Material parameters in "parameters" apply to every material unless its named set overrides
    // them. The other parameters go to the caller.
    void read_parameter_sets() {
        if (root_.has("parameters")) {
            const ParameterValues all = read_parameters(root_.at("parameters"), path_, false);
            for (const auto& [name, value] : all.set_values()) {
                const bool material = find_parameter(name)->group == ParameterGroup::material;
                (material ? common_ : out_.values).set_value(name, value);
            }
        }
        if (!root_.has("materials")) return;
        const JsonPlace materials = root_.at("materials");
        materials.require_object();
        for (const std::string& name : materials.keys())
            sets_.emplace(name, read_parameters(materials.at(name), path_, true));
    }

    void add_object(const JsonPlace& place) {
        constexpr std::array<std::string_view, 5> kKeys = {"model", "material", "translate",
                                                           "rotate_deg", "scale"};
        place.require_object(kKeys);
        std::string set;
        if (place.has("material")) {
            set = place.at("material").text();
            if (!sets_.contains(set)) {
                std::vector<std::string_view> names;
                for (const auto& [name, values] : sets_) names.push_back(name);
                refuse_name(place.at("material"), names, "a name under \"materials\"");
            }
        }
        LoadedModel& model = loaded(place.at("model"));
        const int first_material = materials_of(model, set, place);
        add_instances(model, first_material, read_transform(place));
    }

    LoadedModel& loaded(const JsonPlace& place) {
        const std::string name = beside(path_, place.text());
        if (name.ends_with(".json"))
            throw Error(place.file(), place.path(), "a model: scenes hold no scenes",
                        shown(place.text()));
        if (const auto found = models_.find(name); found != models_.end()) return found->second;
        LoadedModel model;
        try {
            model.rest = load_model(name, out_.values.integer("triangles"));
        } catch (const Interrupted&) {
            throw;
        } catch (const Error& error) {
            throw Error(file_ + ": " + place.path() + ": " + error.what());
        }
        model.first_mesh = static_cast<int>(out_.scene.meshes.size());
        model.first_texture = static_cast<int>(out_.scene.textures.size());
        std::move(model.rest.meshes.begin(), model.rest.meshes.end(),
                  std::back_inserter(out_.scene.meshes));
        std::move(model.rest.textures.begin(), model.rest.textures.end(),
                  std::back_inserter(out_.scene.textures));
        out_.scene.warnings.insert(out_.scene.warnings.end(), model.rest.warnings.begin(),
                                   model.rest.warnings.end());
        model.rest.meshes.clear();
        model.rest.textures.clear();
        return models_.emplace(name, std::move(model)).first->second;
    }

    // Index of the first of the model's materials with the named set of parameters.
    int materials_of(LoadedModel& model, const std::string& set, const JsonPlace& place) {
        const auto [found, is_new] =
            model.first_material.try_emplace(set, static_cast<int>(out_.scene.materials.size()));
        if (!is_new) return found->second;
        for (Material material : model.rest.materials) {
            for (TextureUse* use :
                 {&material.base_color_texture, &material.metallic_roughness_texture,
                  &material.normal_texture, &material.occlusion_texture, &material.emissive_texture,
                  &material.anisotropy_texture})
                if (*use) use->texture += model.first_texture;
            if (!set.empty() && model.rest.materials.size() == 1) material.name = set;
            if (!set.empty() && model.rest.materials.size() > 1) material.name += " as " + set;
            out_.scene.materials.push_back(material);
        }
        ParameterValues values = common_;
        if (!set.empty()) values.merge(sets_.at(set));
        out_.layers.resize(out_.scene.materials.size(), {values, file_ + ": " + place.path()});
        require_consistent(values, out_.layers.back().place);
        return found->second;
    }

    static void require_consistent(const ParameterValues& values, const std::string& place) {
        try {
            require_one_roughness(values, false);
        } catch (const UsageError& error) {
            throw Error(place + ": " + error.what());
        }
    }

    void add_instances(const LoadedModel& model, int first_material, const glm::mat4& placing) {
        Scene& scene = out_.scene;
        for (Instance instance : model.rest.instances) {
            instance.mesh += model.first_mesh;
            instance.material += first_material;
            instance.transform = placing * instance.transform;
            scene.instances.push_back(instance);
        }
        const glm::mat3 turn(placing);
        const auto placed = [&](const glm::vec3& p) {
            return glm::vec3(placing * glm::vec4(p, 1));
        };
        for (Light light : model.rest.lights) {
            light.position = placed(light.position);
            light.direction = glm::normalize(turn * light.direction);
            scene.lights.push_back(light);
        }
        for (Camera camera : model.rest.cameras) {
            camera.position = placed(camera.position);
            camera.target = placed(camera.target);
            camera.up = glm::normalize(turn * camera.up);
            scene.cameras.push_back(camera);
        }
    }

    std::filesystem::path path_;
    std::string file_;
    JsonPlace root_;
    SceneFile out_;
    ParameterValues common_;
    std::map<std::string, ParameterValues> sets_;
    std::map<std::string, LoadedModel> models_;
};

}  // namespace

SceneFile load_scene_file(const std::filesystem::path& path) {
    const std::string text = read_text_file(path, kMostBytes);
    const nlohmann::json document = parse_json(path.string(), text);
    return SceneFileReader(path, document).read();
}

bool is_scene_file(const std::filesystem::path& path) {
    // The first 64 KiB contain "format". A scene file with broken JSON is still recognized, so that
    // the error is about its JSON.
    constexpr std::size_t kLookedAt = 65536;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return false;
    std::ifstream file(path, std::ios::binary);
    std::string head(kLookedAt, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    if (path.extension() == ".json") return true;
    const std::size_t first = head.find_first_not_of("\xef\xbb\xbf \t\r\n");
    return first != std::string::npos && head[first] == '{' &&
           head.find("\"burnish-scene\"") != std::string::npos;
}

}  // namespace burnish
