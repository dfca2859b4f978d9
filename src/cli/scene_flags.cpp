#include "cli/scene_flags.hpp"

#include <CLI/CLI.hpp>
#include <string_view>

#include "burnish/error.hpp"
#include "burnish/parameters.hpp"
#include "cli/parameter_flags.hpp"
#include "core/text.hpp"

namespace burnish::cli {
namespace {

std::string_view heading(ParameterGroup group) {
    switch (group) {
        case ParameterGroup::material:
            return "Material (of every surface; default: the file's)";
        case ParameterGroup::render:
            return "Picture";
        case ParameterGroup::camera:
            return "Camera (default: the file's first, else framed)";
        case ParameterGroup::environment:
            return "Environment";
        case ParameterGroup::mesh:
            return "Built-in meshes";
    }
    return "";
}

void set_size(ParameterValues& values, const std::string& size) {
    const std::size_t x = size.find_first_of("xX");
    if (x == std::string::npos)
        throw UsageError("--size", "", "WIDTHxHEIGHT, such as 1280x720", shown(size));
    if (values.is_set("width") || values.is_set("height"))
        throw UsageError("--size", "", "no --width or --height beside it", "both");
    values.set("width", size.substr(0, x), "--size");
    values.set("height", size.substr(x + 1), "--size");
}

}  // namespace

void add_scene_flags(CLI::App& command, SceneFlags& flags, bool needs_input) {
    command
        .add_option("input", flags.stage.input,
                    ".gltf, .glb, .obj, a scene .json, or builtin:sphere, plane, cylinder, "
                    "torus, drape, pot")
        ->required(needs_input)
        ->type_name("MODEL|SCENE");
    command
        .add_option("--env", flags.stage.environment,
                    "lat-long .hdr or .exr; builtin:studio (default), builtin:white; "
                    "builtin:black: dark, black behind the model; none: dark, "
                    "--background-color behind it")
        ->type_name("FILE");
    command
        .add_option("--light", flags.stage.lights,
                    "AZIMUTH,ELEVATION[,INTENSITY] in degrees and lux, point:X,Y,Z[,INTENSITY], "
                    "or none; may be repeated; instead of the file's lights")
        ->type_name("LIGHT")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
    command.add_option("--size", flags.size, "WIDTHxHEIGHT: --width and --height in one")
        ->type_name("WxH");
}

void add_scene_parameter_flags(CLI::App& command, SceneFlags& flags) {
    for (const Parameter& parameter : parameter_table())
        add_parameter_flag(command, parameter.name, flags.stage.values)
            ->group(std::string(heading(parameter.group)));
}

StageRequest stage_request(const SceneFlags& flags) {
    StageRequest request = flags.stage;
    if (!flags.size.empty()) set_size(request.values, flags.size);
    return request;
}

}  // namespace burnish::cli
