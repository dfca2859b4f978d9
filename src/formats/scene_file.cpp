// Scene files: docs/reference/scene-file.md is the schema in words.
#include "burnish/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <glm/mat3x3.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <span>

#include "burnish/error.hpp"
#include "burnish/load_model.hpp"
#include "burnish/shading_names.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "formats/json_text.hpp"
#include "formats/scene_parts.hpp"
#include "scene/material/texture_uses.hpp"

namespace burnish {

namespace {

constexpr std::string_view kFormat = "burnish-scene";
// Ten thousand objects with every key take two megabytes.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;
constexpr std::size_t kMostObjects = 10000, kMostLights = 1000, kMostHidden = 1000000;
constexpr std::string_view kBuiltinPrefix = "builtin:";

// Resolves a file name in a scene file relative to the scene file; absolute paths stay.
std::string beside(const std::filesystem::path& scene_file, const std::string& name) {
    if (name.starts_with(kBuiltinPrefix) || name == "none") return name;
    return (scene_file.parent_path() / name).string();
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
        if (only_material && key == "name") continue;  // no parameter, but of the set itself
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

// --- objects ----------------------------------------------------------------------------------

// A model that is already in the scene: its first mesh and texture there, and its other data.
struct LoadedModel {
    int first_mesh = 0, first_texture = 0;
    Scene rest;                                 // without meshes and textures
    std::map<std::string, int> first_material;  // by the text of the member "material", "" for none
};

// A set of parameters under "materials".
struct ParameterSet {
    ParameterValues values;
    std::string name;  // of the materials that it is laid over; "": the usual one
};

// A key of the object form of "material" that stands for one material by its place: "#12".
bool is_index(std::string_view key) {
    return key.size() > 1 && key.size() <= 6 && key.front() == '#' &&
           std::all_of(key.begin() + 1, key.end(), [](char c) { return c >= '0' && c <= '9'; });
}

class SceneFileReader {
  public:
    SceneFileReader(const std::filesystem::path& path, const nlohmann::json& document,
                    const ParameterValues& over)
        : path_(path), file_(path.string()), root_(file_, document), over_(over) {}

    SceneFile read() {
        constexpr std::array<std::string_view, 9> kKeys = {
            "format",       "version",     "objects",    "materials", "lights",
            "model_lights", "environment", "parameters", "viewer"};
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
        if (root_.has("model_lights")) {
            if (!root_.at("model_lights").value().is_boolean())
                root_.at("model_lights").fail("true or false");
            out_.drops_lights = !root_.at("model_lights").value().get<bool>();
        }
        if (root_.has("objects")) {
            const JsonPlace objects = root_.at("objects");
            objects.require_array(kMostObjects);
            for (std::size_t i = 0; i < objects.size(); ++i) add_object(objects.at(i));
        }
        out_.model_lights = static_cast<int>(out_.scene.lights.size());
        if (root_.has("lights")) {
            const JsonPlace lights = root_.at("lights");
            lights.require_array(kMostLights);
            for (std::size_t i = 0; i < lights.size(); ++i)
                out_.scene.lights.push_back(read_light(lights.at(i), path_.parent_path()));
        }
        if (root_.has("environment"))
            out_.environment = beside(path_, root_.at("environment").text());
        if (root_.has("viewer")) {
            root_.at("viewer").require_object();
            out_.viewer = root_.at("viewer").value().dump();
        }
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
        for (const std::string& name : materials.keys()) {
            const JsonPlace place = materials.at(name);
            ParameterSet set{read_parameters(place, path_, true), ""};
            if (place.has("name")) set.name = place.at("name").text();
            sets_.emplace(name, std::move(set));
        }
    }

    void add_object(const JsonPlace& place) {
        constexpr std::array<std::string_view, 6> kKeys = {"model",      "material", "translate",
                                                           "rotate_deg", "scale",    "hidden"};
        place.require_object(kKeys);
        LoadedModel& model = loaded(place.at("model"));
        SceneFile::Object object;
        object.model = model_name(place.at("model"));
        object.first_material = materials_of(model, place);
        object.materials = static_cast<int>(model.rest.materials.size());
        object.first_instance = static_cast<int>(out_.scene.instances.size());
        object.instances = static_cast<int>(model.rest.instances.size());
        read_placing(place, object);
        add_instances(model, object);
        if (place.has("hidden")) read_hidden(place.at("hidden"), object);
        out_.objects.push_back(std::move(object));
    }

    std::string model_name(const JsonPlace& place) const { return beside(path_, place.text()); }

    // A file that is spelled in two ways is one model.
    static std::string identity_of(const std::string& model) {
        if (model.starts_with(kBuiltinPrefix)) return model;
        std::error_code error;
        const std::filesystem::path real = std::filesystem::weakly_canonical(model, error);
        return error ? model : real.string();
    }

    LoadedModel& loaded(const JsonPlace& place) {
        const std::string name = model_name(place);
        if (name.ends_with(".json"))
            throw Error(place.file(), place.path(), "a model: scenes hold no scenes",
                        shown(place.text()));
        const std::string identity = identity_of(name);
        if (const auto found = models_.find(identity); found != models_.end()) return found->second;
        LoadedModel model;
        try {
            const bool above = over_.is_set("triangles");
            model.rest = load_model(name, (above ? over_ : out_.values).integer("triangles"));
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
        return models_.emplace(identity, std::move(model)).first->second;
    }

    // The name of a set of parameters, held against "materials".
    std::string set_named_at(const JsonPlace& place) const {
        std::string set = place.text();
        if (sets_.contains(set)) return set;
        std::vector<std::string_view> names;
        for (const auto& [name, values] : sets_) names.push_back(name);
        refuse_name(place, names, "a name under \"materials\"");
    }

    // The set of every material of the model, "" for none. Of the keys of an object, "#index" is the
    // most particular, then come a material's name and "*".
    std::vector<std::string> sets_of(const LoadedModel& model, const JsonPlace& place) const {
        const std::vector<Material>& materials = model.rest.materials;
        if (place.is_text()) return {materials.size(), set_named_at(place)};
        if (!place.value().is_object())
            place.fail("a name under \"materials\", or an object {...}");
        std::vector<std::string> sets(materials.size());
        for (const int pass : {0, 1, 2}) {
            for (const std::string& key : place.keys()) {
                if (pass != (key == "*" ? 0 : is_index(key) ? 2 : 1)) continue;
                const std::string set = set_named_at(place.at(key));
                const std::vector<std::size_t> named = materials_named(model, place, key);
                for (const std::size_t i : named) sets[i] = set;
            }
        }
        return sets;
    }

    static std::vector<std::size_t> materials_named(const LoadedModel& model,
                                                    const JsonPlace& place,
                                                    const std::string& key) {
        const std::vector<Material>& materials = model.rest.materials;
        std::vector<std::size_t> named;
        if (is_index(key)) {
            const std::size_t index = std::stoul(key.substr(1));
            if (index >= materials.size())
                throw Error(place.file(), place.path(),
                            fmt::format("an index below {}, as the model has {}", materials.size(),
                                        plural(materials.size(), "material")),
                            shown(key));
            return {index};
        }
        for (std::size_t i = 0; i < materials.size(); ++i)
            if (key == "*" || materials[i].name == key) named.push_back(i);
        if (!named.empty() || key == "*") return named;
        std::vector<std::string_view> names;
        for (const Material& material : materials) names.push_back(material.name);
        const std::string_view nearest = nearest_name(names, key);
        throw Error(place.file(), place.path(),
                    "the name of a material of the model, \"#index\" or \"*\"",
                    nearest.empty() ? shown(key)
                                    : fmt::format("{}; did you mean '{}'?", shown(key), nearest));
    }

    // Index of the first of the model's materials with the named sets of parameters.
    int materials_of(LoadedModel& model, const JsonPlace& object) {
        const bool has_sets = object.has("material");
        const std::string key = has_sets ? object.at("material").value().dump() : "";
        const auto found = model.first_material.find(key);
        if (found != model.first_material.end()) return found->second;
        const std::vector<std::string> sets =
            has_sets ? sets_of(model, object.at("material"))
                     : std::vector<std::string>(model.rest.materials.size());
        const int first = static_cast<int>(out_.scene.materials.size());
        const bool one_for_all = has_sets && object.at("material").is_text();
        for (std::size_t i = 0; i < sets.size(); ++i)
            add_material(model, i, sets[i], one_for_all, object);
        model.first_material.emplace(key, first);
        return first;
    }

    // `one_for_all`: the set is laid over the whole model, which names its materials.
    void add_material(const LoadedModel& model, std::size_t index, const std::string& set,
                      bool one_for_all, const JsonPlace& object) {
        Material material = model.rest.materials[index];
        for (TextureUse* use : texture_uses(material))
            if (*use) use->texture += model.first_texture;
        SceneFile::Layer layer{common_, file_ + ": " + object.path(), false};
        if (!set.empty()) {
            const ParameterSet& named = sets_.at(set);
            layer.values.merge(named.values);
            layer.renamed = one_for_all || !named.name.empty();
            if (!named.name.empty())
                material.name = named.name;
            else if (one_for_all)
                material.name =
                    model.rest.materials.size() == 1 ? set : material.name + " as " + set;
        }
        require_consistent(layer.values, layer.place);
        out_.scene.materials.push_back(std::move(material));
        out_.layers.push_back(std::move(layer));
    }

    static void require_consistent(const ParameterValues& values, const std::string& place) {
        try {
            require_one_roughness(values, false);
        } catch (const UsageError& error) {
            throw Error(place + ": " + error.what());
        }
    }

    void add_instances(const LoadedModel& model, const SceneFile::Object& object) {
        Scene& scene = out_.scene;
        const glm::mat4 placing = placing_of(object);
        for (Instance instance : model.rest.instances) {
            instance.mesh += model.first_mesh;
            instance.material += object.first_material;
            instance.transform = placing * instance.transform;
            scene.instances.push_back(instance);
        }
        const glm::mat3 turn(placing);
        const auto placed = [&](const glm::vec3& p) {
            return glm::vec3(placing * glm::vec4(p, 1));
        };
        for (Light light : model.rest.lights) {
            if (out_.drops_lights) break;
            light.position = placed(light.position);
            light.direction = unit(turn * light.direction);
            scene.lights.push_back(light);
        }
        for (Camera camera : model.rest.cameras) {
            camera.position = placed(camera.position);
            camera.target = placed(camera.target);
            camera.up = unit(turn * camera.up);
            scene.cameras.push_back(camera);
        }
    }

    void read_hidden(const JsonPlace& place, const SceneFile::Object& object) {
        place.require_array(kMostHidden);
        for (std::size_t i = 0; i < place.size(); ++i) {
            const nlohmann::json& index = place.value()[i];
            if (!index.is_number_integer() || index < 0 || index >= object.instances)
                place.at(i).fail(
                    fmt::format("the index of a part of the model, below {}", object.instances));
            out_.hidden.push_back(object.first_instance + index.get<int>());
        }
        const auto of_object = std::find_if(out_.hidden.begin(), out_.hidden.end(),
                                            [&](int i) { return i >= object.first_instance; });
        std::sort(of_object, out_.hidden.end());
        out_.hidden.erase(std::unique(of_object, out_.hidden.end()), out_.hidden.end());
    }

    std::filesystem::path path_;
    std::string file_;
    JsonPlace root_;
    const ParameterValues& over_;
    SceneFile out_;
    ParameterValues common_;
    std::map<std::string, ParameterSet> sets_;
    std::map<std::string, LoadedModel> models_;
};

}  // namespace

SceneFile load_scene_file(const std::filesystem::path& path, const ParameterValues& over) {
    const std::string text = read_text_file(path, kMostBytes);
    const nlohmann::json document = parse_json(path.string(), text);
    return SceneFileReader(path, document, over).read();
}

SceneFile scene_file_of_model(const std::string& path_or_builtin, int triangles) {
    SceneFile file;
    file.scene = load_model(path_or_builtin, triangles);
    SceneFile::Object& object = file.objects.emplace_back();
    object.model = path_or_builtin;
    object.materials = static_cast<int>(file.scene.materials.size());
    object.instances = static_cast<int>(file.scene.instances.size());
    file.layers.resize(file.scene.materials.size());
    file.model_lights = static_cast<int>(file.scene.lights.size());
    return file;
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
