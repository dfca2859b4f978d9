#include "burnish/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <iterator>
#include <set>
#include <span>
#include <utility>

#include "burnish/builtin_meshes.hpp"
#include "burnish/environments.hpp"
#include "burnish/error.hpp"
#include "burnish/load_model.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/scene_file.hpp"
#include "core/text.hpp"
#include "scene/camera/angles.hpp"
#include "scene/camera/framing.hpp"
#include "stage/eye_check.hpp"
#include "stage/normal_map_check.hpp"
#include "stage/stage_parts.hpp"

namespace burnish {

namespace {

// A white plate facing the light has radiance 1.
constexpr double kDefaultLightIntensity = 3.14159265;

std::vector<double> parse_numbers(std::string_view text, std::string_view whole) {
    std::vector<double> numbers;
    while (true) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const std::string_view part = text.substr(0, comma);
        double value = 0;
        const auto [end, status] = std::from_chars(part.data(), part.data() + part.size(), value);
        if (status != std::errc{} || end != part.data() + part.size() || !std::isfinite(value)) {
            throw UsageError("--light", "",
                             "AZIMUTH,ELEVATION[,INTENSITY] or "
                             "point:X,Y,Z[,INTENSITY]",
                             shown(whole));
        }
        numbers.push_back(value);
        if (comma == text.size()) return numbers;
        text.remove_prefix(comma + 1);
    }
}

double light_intensity(const std::vector<double>& numbers, std::size_t place) {
    if (numbers.size() <= place) return kDefaultLightIntensity;
    const double intensity = numbers[place];
    if (intensity < 0 || intensity > 1e6)
        throw UsageError("--light", "intensity", "a number from 0 to 1000000",
                         fmt::format("{}", intensity));
    return intensity;
}

void require_count(const std::vector<double>& numbers, std::size_t least, std::string_view word) {
    if (numbers.size() == least || numbers.size() == least + 1) return;
    throw UsageError("--light", "", fmt::format("{} or {} numbers", least, least + 1), shown(word));
}

bool any_set(const ParameterValues& values, std::initializer_list<std::string_view> names) {
    return std::any_of(names.begin(), names.end(),
                       [&](std::string_view name) { return values.is_set(name); });
}

// Corners of the part of the ground that a view of the model shows with it: half the model's height
// beyond its sides, where the shadow of a light at 60 degrees ends.
std::vector<glm::vec3> ground_corners(const Bounds& bounds) {
    const float margin = 0.5f * (bounds.high.y - bounds.low.y);
    std::vector<glm::vec3> corners;
    for (const float x : {bounds.low.x - margin, bounds.high.x + margin})
        for (const float z : {bounds.low.z - margin, bounds.high.z + margin})
            corners.emplace_back(x, bounds.low.y, z);
    return corners;
}

// The distance at which a camera towards `away` (unit) sees every vertex and every point of `more`.
double framing_distance(const Scene& scene, std::span<const glm::vec3> more, glm::vec3 target,
                        glm::vec3 away, double yfov, double aspect) {
    const glm::vec3 up_hint = std::abs(away.y) < 0.999f ? glm::vec3{0, 1, 0} : glm::vec3{0, 0, 1};
    Framing framing(target, away, up_hint, yfov, aspect);
    for (const Instance& instance : scene.instances) {
        if (instance.mesh < 0) continue;
        for (const glm::vec3& p : scene.meshes[static_cast<std::size_t>(instance.mesh)].positions)
            framing.include(glm::vec3(instance.transform * glm::vec4(p, 1.0f)));
    }
    for (const glm::vec3& p : more) framing.include(p);
    return framing.distance();
}

}  // namespace

RenderSettings render_settings(const ParameterValues& values) {
    RenderSettings settings;
    settings.width = values.integer("width");
    settings.height = values.integer("height");
    settings.samples = values.integer("samples");
    settings.image_light = static_cast<ImageLight>(values.choice("image_light"));
    settings.image_light_samples = values.integer("image_light_samples");
    settings.shadows = values.boolean("shadows");
    settings.ground = values.boolean("ground");
    settings.visibility = values.boolean("visibility");
    settings.bounces = values.integer("bounces");
    settings.visibility_rays = values.integer("visibility_rays");
    settings.environment_intensity = static_cast<float>(values.real("environment_intensity"));
    settings.environment_rotation =
        static_cast<float>(glm::radians(values.real("environment_rotation")));
    settings.background = static_cast<BackgroundKind>(values.choice("background"));
    settings.background_color = values.vec3("background_color");
    settings.background_blur = static_cast<float>(values.real("background_blur"));
    settings.seed = static_cast<unsigned>(values.integer("seed"));
    return settings;
}

float robust_limit(const ParameterValues& values) {
    if (!values.boolean("robust_mean")) return 0.0f;
    // The default tone map shows 2 as 0.96 of what a display can show, and everything brighter above it.
    return 2.0f * static_cast<float>(std::exp2(-values.real("exposure")));
}

WriteOptions write_options(const ParameterValues& values) {
    return {.bits = values.choice("bit_depth") == 0 ? 8 : 16, .dither = values.boolean("dither")};
}

Light parse_light(std::string_view word) {
    constexpr std::string_view kPoint = "point:";
    Light light;
    if (word.starts_with(kPoint)) {
        const std::vector<double> n = parse_numbers(word.substr(kPoint.size()), word);
        require_count(n, 3, word);
        light.type = LightType::point;
        light.position = {n[0], n[1], n[2]};
        light.intensity = static_cast<float>(light_intensity(n, 3));
    } else {
        const std::vector<double> n = parse_numbers(word, word);
        require_count(n, 2, word);
        if (std::abs(n[1]) > 90.0)
            throw UsageError("--light", "elevation", "a number from -90 to 90",
                             fmt::format("{:g}", n[1]));
        light.type = LightType::directional;
        light.direction = -glm::vec3(direction_at({n[0], n[1]}));
        light.intensity = static_cast<float>(light_intensity(n, 2));
    }
    return light;
}

Camera place_camera(const Scene& scene, const ParameterValues& values, double aspect,
                    bool all_around) {
    if (values.is_set("camera_index")) {
        const int index = values.integer("camera_index");
        const std::size_t count = scene.cameras.size();
        if (count == 0) throw UsageError("--camera-index: the file has no cameras");
        if (index >= static_cast<int>(count))
            throw UsageError("--camera-index", "", fmt::format("at most {}", count - 1),
                             std::to_string(index));
        return scene.cameras[static_cast<std::size_t>(index)];
    }
    const bool asked =
        any_set(values, {"camera_azimuth", "camera_elevation", "camera_distance", "camera_fov",
                         "camera_position", "camera_target", "camera_zoom"});
    if (!asked && !scene.cameras.empty()) return scene.cameras.front();

    Camera camera;
    // A camera that is placed by numbers alone needs no look at the vertices.
    const bool placed = values.is_set("camera_position") && values.is_set("camera_target");
    const Bounds bounds = placed ? Bounds{} : bounds_of(scene);
    camera.yfov = static_cast<float>(glm::radians(values.real("camera_fov")));
    camera.target = values.is_set("camera_target") ? values.vec3("camera_target") : bounds.center();
    if (values.is_set("camera_position")) {
        camera.position = values.vec3("camera_position");
    } else {
        const double azimuth = values.real("camera_azimuth");
        const double elevation = values.real("camera_elevation");
        const glm::vec3 away(direction_at({azimuth, elevation}));
        double distance = 0;
        if (values.is_set("camera_distance")) {
            distance = values.real("camera_distance");
        } else {
            const int views = all_around ? 24 : 1;
            const std::vector<glm::vec3> ground =
                values.boolean("ground") ? ground_corners(bounds) : std::vector<glm::vec3>{};
            for (int i = 0; i < views; ++i) {
                const glm::vec3 from(direction_at({azimuth + 360.0 * i / views, elevation}));
                distance = std::max(distance, framing_distance(scene, ground, camera.target, from,
                                                               camera.yfov, aspect));
            }
            distance /= values.real("camera_zoom");
        }
        camera.position = camera.target + static_cast<float>(distance) * away;
    }
    const glm::vec3 view = camera.target - camera.position;
    if (glm::dot(view, view) == 0.0f)
        throw UsageError("--camera-position", "", "a place other than the target", "the target");
    // For a vertical view +y cannot be the up direction; -z is up for a view from above, as on a
    // map.
    if (glm::length(glm::cross(glm::normalize(view), camera.up)) < 1e-4f)
        camera.up = {0.0f, 0.0f, view.y > 0 ? 1.0f : -1.0f};
    return camera;
}

Stage open_stage(const std::string& input, const ParameterValues& values) {
    require_one_roughness(values, true);
    Stage stage;
    const bool scene_file = !is_builtin(input) && is_scene_file(input);
    stage.file = scene_file ? load_scene_file(input, values)
                            : scene_file_of_model(input, values.integer("triangles"));
    stage.values = stage.file.values;
    stage.values.merge(values);
    stage.scene = std::move(stage.file.scene);
    stage.file.scene = Scene{};
    const auto is_built_in = [](const SceneFile::Object& object) {
        return is_builtin(object.model);
    };
    if (values.is_set("triangles") && std::ranges::none_of(stage.file.objects, is_built_in))
        stage.scene.warnings.emplace_back(
            "triangles: only built-in meshes have it: nothing changes");
    stage.file.scene.lights = stage.scene.lights;
    stage.file.scene.warnings = stage.scene.warnings;
    stage.file.scene.notes = stage.scene.notes;
    stage.materials = LayeredMaterials(stage.scene.materials, std::move(stage.file.layers));
    stage.file.layers.clear();
    if (stage.scene.instances.empty()) throw Error(input, "", "something to draw", "no triangles");
    return stage;
}

Environment load_environment_of(const Stage& stage, const std::string& input,
                                const std::string& asked, std::vector<std::string>& warnings) {
    const std::string& name = asked.empty() ? stage.file.environment : asked;
    if (name == "none") return {};
    if (name.empty()) return load_environment(std::string(kDefaultEnvironment));
    if (!asked.empty()) return load_environment(name, &warnings);
    try {
        return load_environment(name, &warnings);
    } catch (const Interrupted&) {
        throw;
    } catch (const Error& error) {
        throw Error(input + ": environment: " + error.what());
    }
}

void take_remarks(Stage& stage, Remarks remarks) {
    stage.warnings.materials = std::move(remarks.warnings);
    stage.scene.notes = stage.file.scene.notes;
    for (std::string& line : remarks.notes) append_once(stage.scene.notes, std::move(line));
}

void find_odd_normal_maps(Stage& stage) {
    std::vector<std::string> others;
    std::swap(others, stage.scene.warnings);
    warn_of_odd_normal_maps(stage.scene);
    std::swap(others, stage.scene.warnings);
    stage.warnings.normal_maps = std::move(others);
}

std::vector<std::string> all_warnings(const Stage& stage) {
    std::vector<std::string> all;
    for (const std::vector<std::string>* part :
         {&stage.file.scene.warnings, &stage.warnings.materials, &stage.warnings.normal_maps,
          &stage.warnings.environment, &stage.warnings.values})
        for (const std::string& line : *part)
            if (std::ranges::find(all, line) == all.end()) all.push_back(line);
    return all;
}

void set_values_of_picture(Stage& stage, bool all_around) {
    stage.settings = render_settings(stage.values);
    stage.camera =
        place_camera(stage.scene, stage.values,
                     static_cast<double>(stage.settings.width) / stage.settings.height, all_around);
    stage.exposure_ev = stage.values.real("exposure");
    stage.tone_map = static_cast<ToneMap>(stage.values.choice("tone_map"));
}

void hide_instances(Stage& stage, const std::set<int>& hidden) {
    for (std::size_t i = 0; i < stage.shown_meshes.size(); ++i)
        stage.scene.instances[i].mesh =
            hidden.contains(static_cast<int>(i)) ? -1 : stage.shown_meshes[i];
}

void remember_meshes(Stage& stage) {
    stage.shown_meshes.clear();
    for (const Instance& instance : stage.scene.instances)
        stage.shown_meshes.push_back(instance.mesh);
}

Stage set_stage(const StageRequest& request, bool all_around) {
    Stage stage = open_stage(request.input, request.values);
    take_remarks(stage, stage.materials.apply(stage.scene, stage.values));
    remember_meshes(stage);
    find_odd_normal_maps(stage);
    if (!request.lights.empty()) {
        stage.scene.lights.clear();
        for (const std::string& word : request.lights)
            if (word != "none") stage.scene.lights.push_back(parse_light(word));
    }
    stage.environment =
        load_environment_of(stage, request.input, request.environment, stage.warnings.environment);
    set_values_of_picture(stage, all_around);
    warn_of_idle_values(stage.values, stage.environment, stage.scene.lights, stage.warnings.values);
    warn_of_idle_lights(request.lights, stage.warnings.values);
    warn_of_eye_inside(stage.scene, stage.values, stage.camera, stage.warnings.values);
    hide_instances(stage, {stage.file.hidden.begin(), stage.file.hidden.end()});
    stage.scene.warnings = all_warnings(stage);
    return stage;
}

}  // namespace burnish
