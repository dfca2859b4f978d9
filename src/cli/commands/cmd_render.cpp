// burnish render: a picture, a comparison of methods, or a turntable.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/render.hpp"
#include "burnish/turntable.hpp"
#include "cli/commands/commands.hpp"
#include "cli/integer_flag.hpp"
#include "cli/scene_flags.hpp"
#include "cli/session.hpp"
#include "core/text.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kExamples = R"(
Examples:
  burnish render model.glb --env sky.hdr -o picture.png
  burnish render builtin:sphere --metal steel --alpha-x 0.08 --alpha-y 0.4 \
      --normal-map builtin:bumps --compare none,normal-map,deform-smooth,follow-grain -o sheet.png
  burnish render scene.json --turntable 24 --samples 4 --size 480x270 -o turn.png
  burnish render scene.json --turntable 96 --turn light -o turn.mp4
Without a GPU a picture of the default size and samples takes about a minute on two cores;
--samples 8 is a preview.)";

struct RenderFlags {
    SceneFlags scene;
    RenderRequest request;  // without its stage
    std::string output;
    std::optional<std::string> compare;
    std::optional<std::string> turn, frames;
    int fps = 0;  // 0: none was given
};

constexpr int kMostFrames = 9999;

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

FrameRange parse_frames(const std::string& text) {
    const std::size_t dash = text.find('-');
    const auto number = [](const std::string& word) {
        return whole_number(word, {0, kMostFrames - 1}, "--frames");
    };
    if (dash == text.npos) return {number(text), number(text)};
    return {number(text.substr(0, dash)), number(text.substr(dash + 1))};
}

void set_turntable(const RenderFlags& flags, RenderRequest& request) {
    if (flags.turn)
        request.turn =
            static_cast<Turn>(index_of_name(turn_names(), *flags.turn, "thing to turn", "--turn"));
    if (flags.frames) request.frames = parse_frames(*flags.frames);
    if (flags.fps > 0) request.fps = flags.fps;
}

void run_render(RenderFlags& flags, const Session& session) {
    RenderRequest& request = flags.request;
    request.stage = stage_request(flags.scene);
    if (flags.compare) request.compare = parse_methods(*flags.compare);
    set_turntable(flags, request);
    request.output = flags.output;
    request.command = session.command_line();
    const RenderReport report = render(request, session.progress());
    print_report(report.warnings, report.written, report.notes);
}

void add_turntable_flags(CLI::App& command, RenderFlags& flags) {
    constexpr const char* kGroup = "Turntable";
    RenderRequest& request = flags.request;
    add_integer(command, "--turntable", request.turntable, {1, kMostFrames},
                "pictures of a full turn, numbered from OUT_0000, or a film of them")
        ->type_name("COUNT")
        ->group(kGroup);
    command
        .add_option("--turn", flags.turn,
                    "what turns, counter-clockwise as seen from above: object (default; camera, "
                    "lights and environment stand), light (with the environment) or camera")
        ->type_name("NAME")
        ->group(kGroup);
    command
        .add_option("--frames", flags.frames,
                    "A-B, or one number: these of the COUNT frames alone, counted from 0, the last "
                    "included; files keep their numbers")
        ->type_name("RANGE")
        ->group(kGroup);
    command
        .add_flag("--resume", request.resume,
                  "keep pictures of this turn that are there, and draw the others")
        ->group(kGroup);
    add_integer(command, "--fps", flags.fps, {1, 120},
                fmt::format("frames a second of a film; default {}", kDefaultFilmRate))
        ->group(kGroup);
    command
        .add_flag("--keep-frames", request.keep_frames,
                  "do not delete the pictures of a film, which are in OUT_frames")
        ->group(kGroup);
}

}  // namespace

void add_render_command(CLI::App& parent, Session& session) {
    CLI::App* command = parent.add_subcommand("render", "Render a model or a scene file");
    const auto flags = std::make_shared<RenderFlags>();
    RenderRequest& request = flags->request;
    command
        ->add_option(
            "-o,--output", flags->output,
            ".png, .jpg, .tif (tone mapped) or .exr (linear); with --turntable the "
            "pictures are numbered: turn.exr is written as turn_0000.exr, turn_0001.exr ...; or a "
            "film: .mp4, .webm, .apng (of the program ffmpeg)")
        ->required()
        ->type_name("FILE");
    add_scene_flags(*command, flags->scene);
    command
        ->add_option("--compare", flags->compare,
                     "METHOD,METHOD,...: one labelled sheet with difference images; instead of "
                     "--method")
        ->type_name("LIST");
    add_turntable_flags(*command, *flags);
    add_gl_device(*command, request.gl_device);
    add_scene_parameter_flags(*command, flags->scene);
    command->footer(kExamples);
    command->callback([flags, &session] { run_render(*flags, session); });
}

}  // namespace burnish::cli
