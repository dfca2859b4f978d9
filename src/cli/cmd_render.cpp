// burnish render: a picture, a comparison of methods, or a turntable.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/parameters.hpp"
#include "burnish/render.hpp"
#include "cli/commands.hpp"
#include "cli/session.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kExamples = R"(
Examples:
  burnish render model.glb --env sky.hdr -o picture.png
  burnish render builtin:sphere --metal steel --alpha-x 0.08 --alpha-y 0.4 \
      --normal-map builtin:bumps --compare none,normal-map,deform-smooth,follow-grain -o sheet.png
  burnish render scene.json --turntable 48 -o turn.png)";

struct Flags {
    RenderRequest request;
    std::string output;
    std::string size;
    std::string compare;
};

std::string flag_of(std::string_view parameter) {
    std::string flag = "--" + std::string(parameter);
    std::replace(flag.begin(), flag.end(), '_', '-');
    return flag;
}

std::string_view heading(ParameterGroup group) {
    switch (group) {
        case ParameterGroup::material: return "Material (of every surface; default: the file's)";
        case ParameterGroup::render: return "Picture";
        case ParameterGroup::camera: return "Camera (default: the file's first, else framed)";
        case ParameterGroup::environment: return "Environment";
        case ParameterGroup::mesh: return "Built-in meshes";
    }
    return "";
}

std::string help_of(const Parameter& parameter) {
    std::string text(parameter.help);
    if (!parameter.unit.empty()) text += fmt::format(" [{}]", parameter.unit);
    if (!parameter.choices.empty())
        text += fmt::format(": {}", fmt::join(parameter.choices, ", "));
    if (!parameter.default_text.empty()) text += fmt::format(" (default {})", parameter.default_text);
    return text;
}

// One flag a row of the parameter table.
void add_parameter_flags(CLI::App& command, const std::shared_ptr<Flags>& flags) {
    for (const Parameter& parameter : parameter_table()) {
        const std::string flag = flag_of(parameter.name);
        const std::string name(parameter.name);
        const auto set = [flags, name, flag](const std::string& text) {
            flags->request.stage.values.set(name, text, flag);
        };
        CLI::Option* option =
            parameter.kind == ParameterKind::boolean
                ? command.add_flag_callback(flag, [set] { set("true"); }, help_of(parameter))
                : command.add_option_function<std::string>(flag, set, help_of(parameter))
                      ->type_name("");
        option->group(std::string(heading(parameter.group)));
    }
}

void set_size(ParameterValues& values, const std::string& size) {
    const std::size_t x = size.find('x');
    if (x == std::string::npos)
        throw UsageError("--size", "", "WIDTHxHEIGHT, such as 1280x720", shown(size));
    values.set("width", size.substr(0, x), "--size");
    values.set("height", size.substr(x + 1), "--size");
}

std::vector<Method> parse_methods(const std::string& list) {
    std::vector<Method> methods;
    std::size_t start = 0;
    while (start <= list.size()) {
        const std::size_t comma = std::min(list.find(',', start), list.size());
        methods.push_back(static_cast<Method>(index_of_name(
            method_names(), list.substr(start, comma - start), "method", "--compare")));
        start = comma + 1;
    }
    return methods;
}

void run(Flags& flags, const Session& session) {
    RenderRequest& request = flags.request;
    if (!flags.size.empty()) set_size(request.stage.values, flags.size);
    if (!flags.compare.empty()) request.compare = parse_methods(flags.compare);
    request.output = flags.output;
    request.command = session.command_line();
    const RenderReport report = render(request, session.progress());
    for (const std::string& warning : report.warnings)
        std::fprintf(stderr, "burnish: warning: %s\n", warning.c_str());
    std::string text;
    for (const auto& path : report.written) text += path.string() + '\n';
    print(text);
}

}  // namespace

void add_render_command(CLI::App& parent, Session& session) {
    CLI::App* command = parent.add_subcommand("render", "Render a model or a scene file");
    const auto flags = std::make_shared<Flags>();
    RenderRequest& request = flags->request;
    command->add_option("input", request.stage.input,
                        ".gltf, .glb, .obj, a scene .json, or builtin:sphere, plane, cylinder, "
                        "torus, drape")
        ->required()
        ->type_name("MODEL|SCENE");
    command->add_option("-o,--output", flags->output,
                        ".png, .jpg, .tif (tone mapped) or .exr (linear)")
        ->required()
        ->type_name("FILE");
    command->add_option("--env", request.stage.environment,
                        "lat-long .hdr or .exr, builtin:studio (default), builtin:white or none")
        ->type_name("FILE");
    command->add_option("--light", request.stage.lights,
                        "AZIMUTH,ELEVATION[,INTENSITY] in degrees and lux, point:X,Y,Z[,INTENSITY], "
                        "or none; may be repeated; instead of the file's lights")
        ->type_name("LIGHT")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
    command->add_option("--size", flags->size, "WIDTHxHEIGHT: --width and --height in one")
        ->type_name("WxH");
    command->add_option("--compare", flags->compare,
                        "METHOD,METHOD,...: one labelled sheet with difference images")
        ->type_name("LIST");
    command->add_option("--turntable", request.turntable, "N pictures of a full turn")
        ->type_name("N")
        ->check(CLI::Range(1, 9999));
    command->add_option("--gl-device", request.gl_device,
                        "GL device by its number in `burnish info --devices`")
        ->type_name("N")
        ->check(CLI::Range(0, 255));
    add_parameter_flags(*command, flags);
    command->footer(kExamples);
    command->callback([flags, &session] { run(*flags, session); });
}

}  // namespace burnish::cli
