// burnish capture simulate: pictures of a virtual sample with known texels.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <string>

#include "burnish/error.hpp"
#include "cli/commands/commands.hpp"
#include "cli/integer_flag.hpp"
#include "cli/session.hpp"
#include "core/text.hpp"
#include "jobs/capture/capture_simulate.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kCaptureSimulateFooter = R"(
Writes DIR/images, DIR/rig.json (the stack, for `burnish capture fit`) and DIR/truth. The pictures are
made from the analytic distributions in double precision, never from tables. Noise has a standard
deviation of PERCENT of a pixel plus 2 % of a white diffuser. docs/guide/capture.md has more.

Examples:
  burnish capture simulate classes -o sample --noise 1
  burnish capture simulate satin -o satin --rig dome --lights 200 --camera-distance 0 --format png16
  burnish capture simulate classes -o views --rig other_views.json)";

constexpr std::array<std::string_view, 3> kFormats = {"exr", "png16", "png8"};

struct CaptureSimulateFlags {
    CaptureSimulateRequest request;
    std::string size = "64", lights, format = "exr", output;
    double noise_percent = 0.0;
    int seed = 1;
};

void require_range(double value, double low, double high, const char* flag) {
    if (value >= low && value <= high) return;
    throw UsageError(flag, "", fmt::format("{} to {}", low, high), fmt::format("{}", value));
}

void set_lights(CaptureSimulateFlags& flags) {
    if (flags.lights.empty()) return;
    CaptureSimulateRequest& request = flags.request;
    const std::size_t at = flags.lights.find('x');
    if (request.rig == "dome") {
        request.dome_lights = whole_number(flags.lights, {1, 100000}, "--lights");
        return;
    }
    request.leds = whole_number(flags.lights.substr(0, at), {1, 1000}, "--lights");
    request.steps = at == std::string::npos
                        ? request.leds
                        : whole_number(flags.lights.substr(at + 1), {1, 1000}, "--lights");
}

void run_capture_simulate(CaptureSimulateFlags& flags, const Session& session) {
    CaptureSimulateRequest& request = flags.request;
    const std::size_t at = flags.size.find('x');
    constexpr IntegerRange kPixels = {1, 8192};
    request.sample.width = whole_number(flags.size.substr(0, at), kPixels, "--size");
    request.sample.height = at == std::string::npos
                                ? request.sample.width
                                : whole_number(flags.size.substr(at + 1), kPixels, "--size");
    require_range(request.sample.width_mm, 0.1, 10000.0, "--width-mm");
    require_range(request.sample.tilt_deg, 0.0, 30.0, "--tilt");
    require_range(request.placing.camera_tilt_deg, 0.0, 85.0, "--camera-tilt");
    require_range(request.placing.camera_distance_mm, 0.0, 1e5, "--camera-distance");
    require_range(flags.noise_percent, 0.0, 100.0, "--noise");
    require_range(request.camera.clip, 0.0, 1e6, "--clip");
    if (request.sample.eta != 0.0) require_range(request.sample.eta, 1.01, 100.0, "--eta");
    request.camera.noise = flags.noise_percent / 100.0;
    request.camera.seed = static_cast<std::uint64_t>(flags.seed);
    request.format =
        static_cast<StackFormat>(index_of_name(kFormats, flags.format, "format", "--format"));
    set_lights(flags);
    request.output = flags.output;
    request.command = session.command_line();
    const CaptureSimulateResult report = capture_simulate(request, session.progress());
    print(
        fmt::format("{} pictures in {}\n", report.pictures, (request.output / "images").string()));
    print_report({}, report.written);
}

}  // namespace

void add_capture_simulate_command(CLI::App& capture, Session& session) {
    CLI::App* command =
        capture.add_subcommand("simulate", "Make pictures of a sample that is known");
    const auto flags = std::make_shared<CaptureSimulateFlags>();
    CaptureSimulateRequest& request = flags->request;
    std::string names;
    for (const VirtualPreset& preset : virtual_presets())
        names += fmt::format("{}{} ({})", names.empty() ? "" : "; ", preset.name, preset.help);
    command->add_option("material", request.preset, names)->required()->type_name("NAME");
    command->add_option("-o,--output", flags->output, "folder to write into; made when needed")
        ->required()
        ->type_name("DIR");
    command->add_option("--size", flags->size, "pixels (default 64)")->type_name("W|WxH");
    command->add_option("--width-mm", request.sample.width_mm, "of the sample (default 60)")
        ->type_name("MM");
    command
        ->add_option("--eta", request.sample.eta,
                     "index of refraction (default 1.5; 0: no Fresnel)")
        ->type_name("N");
    command->add_option("--tilt", request.sample.tilt_deg, "normals wave by up to this (default 0)")
        ->type_name("DEG");
    command
        ->add_option("--rig", request.rig, "bar (default), dome, or a rig file to take lights from")
        ->type_name("NAME|FILE");
    command
        ->add_option(
            "--lights", flags->lights,
            "of the bar, LEDs x steps (default 40x20); of the dome, how many (default 100)")
        ->type_name("N|NxM");
    command
        ->add_option("--camera-tilt", request.placing.camera_tilt_deg,
                     "from the normal (default 45)")
        ->type_name("DEG");
    command
        ->add_option("--camera-distance", request.placing.camera_distance_mm,
                     "from the sample's middle (default 600; 0: far away)")
        ->type_name("MM");
    command->add_option("--noise", flags->noise_percent, "(default 0)")->type_name("PERCENT");
    command
        ->add_option(
            "--clip", request.camera.clip,
            "pixels end at this many times a white diffuser (default: never in exr, 4 in png)")
        ->type_name("F");
    add_integer(*command, "--seed", flags->seed, {0, 1000000}, "of the noise");
    command->add_option("--format", flags->format, "exr, png16 (linear) or png8 (sRGB)")
        ->capture_default_str()
        ->type_name("NAME");
    command->footer(kCaptureSimulateFooter);
    command->callback([flags, &session] { run_capture_simulate(*flags, session); });
}

}  // namespace burnish::cli
