#include "viewer/document/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <set>

#include "burnish/error.hpp"
#include "core/text.hpp"
#include "viewer/document/load_stage.hpp"

namespace burnish::viewer {
namespace {

void add_flag(std::vector<std::string>& words, const std::string& flag, const std::string& value) {
    if (value.starts_with('-')) {  // else it would be taken for a flag
        words.push_back(flag + "=" + value);
        return;
    }
    words.push_back(flag);
    words.push_back(value);
}

void add_values(std::vector<std::string>& words, const ParameterValues& values, bool compares) {
    for (const auto& [name, value] : values.set_values()) {
        if (compares && name == "method") continue;  // --compare stands in its place
        const Parameter& parameter = *find_parameter(name);
        const std::string flag = flag_of(name);
        if (parameter.kind == ParameterKind::boolean)
            words.push_back(std::get<bool>(value) ? flag : flag + "=false");
        else
            add_flag(words, flag, text_of(parameter, value));
    }
}

// The document that opening the input alone gives: what its file says needs no flag.
Document as_opened(const Document& document, const Stage& stage) {
    try {
        return with_state_of_input({.input = document.input}, stage);
    } catch (const Error&) {  // the file was changed, and its part for the viewer is broken
        return {.input = document.input};
    }
}

bool has_its_lights(const Document& document, const Document& opened) {
    return document.lights == opened.lights && document.dark == opened.dark;
}

std::string why_a_scene(const Document& document, const Document& opened, const Stage& stage) {
    if (!document.material_values.empty()) return "materials of their own";
    const std::set<int> hidden(stage.file.hidden.begin(), stage.file.hidden.end());
    if (document.hidden != hidden) return "hidden parts";
    if (has_its_lights(document, opened)) return "";
    if (!document.dark.empty()) return "lights that are switched off";
    if (!document.lights) return "";
    for (const Light& light : *document.lights)
        if (light_word(light).empty()) return "lights with a color, a range, a cone or an area";
    return "";
}

}  // namespace

std::string CommandLine::text() const {
    std::string line = "burnish";
    for (const std::string& word : words) line += " " + shell_quoted(word);
    return line;
}

std::string light_word(const Light& light) {
    constexpr float kMostLux = 1e6f;  // of --light
    if (light.color != glm::vec3(1.0f) || !(light.intensity >= 0.0f && light.intensity <= kMostLux))
        return "";
    if (light.type == LightType::spot || has_area(light)) return "";
    if (light.type == LightType::point) {
        const glm::vec3& p = light.position;
        return light.range != 0.0f
                   ? ""
                   : fmt::format("point:{},{},{},{}", p.x, p.y, p.z, light.intensity);
    }
    const glm::dvec3 to_light = -glm::normalize(glm::dvec3(light.direction));
    const double azimuth = glm::degrees(std::atan2(to_light.x, to_light.z));
    const double elevation = glm::degrees(std::asin(std::clamp(to_light.y, -1.0, 1.0)));
    std::string near;
    // The fewest digits that give the same floats; of a direction that no angles give, the nearest.
    for (int digits = 3; digits <= 17; ++digits) {
        std::string word =
            fmt::format("{:.{}g},{:.{}g},{}", azimuth, digits, elevation, digits, light.intensity);
        const Light read = parse_light(word);
        if (read.direction == light.direction) return word;
        if (glm::length(read.direction - light.direction) <= 1e-6f && near.empty())
            near = std::move(word);
    }
    return near;
}

CommandLine render_command(const Document& document, const Stage& stage,
                           const std::string& scene_file, const std::string& picture) {
    CommandLine command;
    const Document opened = as_opened(document, stage);
    command.reason = why_a_scene(document, opened, stage);
    command.needs_scene = !command.reason.empty();
    const bool compares = document.compare.mode != CompareMode::off && !document.compare.materials;
    std::vector<std::string>& words = command.words;
    words = {"render", command.needs_scene ? scene_file : document.input};
    if (!command.needs_scene) {
        if (!document.environment.empty()) add_flag(words, "--env", document.environment);
        const bool says_lights = document.lights && !has_its_lights(document, opened);
        if (says_lights && document.lights->empty()) add_flag(words, "--light", "none");
        if (says_lights)
            for (const Light& light : *document.lights)
                add_flag(words, "--light", light_word(light));
        add_values(words, document.values, compares);
    }
    if (compares) {
        std::string methods;
        for (const Method method : document.compare.methods)
            methods += (methods.empty() ? "" : ",") + std::string(name_of(method));
        add_flag(words, "--compare", methods);
    }
    words.push_back("-o");
    words.push_back(picture.starts_with('-') ? "./" + picture : picture);
    return command;
}

}  // namespace burnish::viewer
