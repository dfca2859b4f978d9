// Values of a picture that other values, or their absence, make ineffective.
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "core/text.hpp"
#include "stage/stage_parts.hpp"

namespace burnish {
namespace {

using Names = std::initializer_list<std::string_view>;

class IdleValues {
  public:
    IdleValues(const ParameterValues& values, std::vector<std::string>& warnings)
        : values_(values), warnings_(warnings) {}

    // The form that the viewer reads to dim a parameter.
    void say(Names names, std::string_view why) {
        for (const std::string_view name : names)
            if (values_.is_set(name))
                append_once(warnings_, fmt::format("{}: {}: nothing changes", name, why));
    }

    bool any(Names names) const {
        return std::any_of(names.begin(), names.end(),
                           [&](std::string_view name) { return values_.is_set(name); });
    }

  private:
    const ParameterValues& values_;
    std::vector<std::string>& warnings_;
};

void say_background(const ParameterValues& values, bool lit, IdleValues& idle) {
    const auto background = static_cast<BackgroundKind>(values.choice("background"));
    if (background == BackgroundKind::environment && lit)
        idle.say({"background_color"},
                 "the environment stands before it (--background color shows it)");
    if (background == BackgroundKind::transparent)
        idle.say({"background_color"}, "a transparent background has no color");
    if (background != BackgroundKind::environment)
        idle.say({"background_blur"}, "the environment is not the background");
}

void say_camera(IdleValues& idle) {
    if (idle.any({"camera_index"}))
        idle.say({"camera_azimuth", "camera_elevation", "camera_distance", "camera_zoom",
                  "camera_fov", "camera_position", "camera_target"},
                 "the camera of the file holds (camera_index)");
    else if (idle.any({"camera_position"}))
        idle.say({"camera_azimuth", "camera_elevation", "camera_distance", "camera_zoom"},
                 "camera_position holds");
    else if (idle.any({"camera_distance"}))
        idle.say({"camera_zoom"},
                 "the camera's distance is stated (it scales the view that frames the scene)");
}

}  // namespace

void warn_of_idle_values(const ParameterValues& values, const Environment& environment,
                         const std::vector<Light>& lights, std::vector<std::string>& warnings) {
    IdleValues idle(values, warnings);
    const bool lit = !environment.radiance.pixels.empty();
    if (!lit)
        idle.say({"environment_rotation", "environment_intensity", "image_light",
                  "image_light_samples", "background_blur"},
                 "there is no environment");
    if (static_cast<ImageLight>(values.choice("image_light")) != ImageLight::importance)
        idle.say({"image_light_samples"}, "only image_light importance draws samples");
    if (lights.empty() && !values.boolean("ground")) idle.say({"shadows"}, "there are no lights");
    if (lights.empty() && !lit) idle.say({"ground"}, "there is no light that casts a shadow");
    say_background(values, lit, idle);
    say_camera(idle);
}

void warn_of_idle_lights(const std::vector<std::string>& lights,
                         std::vector<std::string>& warnings) {
    std::string others;
    for (const std::string& word : lights)
        if (word != "none") others += (others.empty() ? "" : ", ") + word;
    if (others.empty() || std::find(lights.begin(), lights.end(), "none") == lights.end()) return;
    append_once(
        warnings,
        fmt::format("--light: none beside {}: none changes nothing, the others are drawn", others));
}

}  // namespace burnish
