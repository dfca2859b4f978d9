// burnish capture directions: a rig from pictures of mirror balls.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "burnish/error.hpp"
#include "cli/commands/commands.hpp"
#include "cli/rig_flags.hpp"
#include "cli/session.hpp"
#include "core/constants.hpp"
#include "jobs/capture/capture_directions.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kCaptureDirectionsFooter = R"(
PICTUREs show one or more mirror balls under one light each, all from the same camera. --ball is a ball's
outline: its middle and radius in pixels, counted from the top left corner of the picture as it is stored:
an Exif orientation is not applied. Several balls
give the mean of their directions. Printed for each light: the direction, its angle theta from the normal
and phi, counter-clockwise from +x, and how far the highlight spreads about it. RIG is JSON of ours (.json)
or an .lp file. Balls that lie beside the sample are to be cut off the pictures, or masked, before a fit:
docs/guide/capture.md says how, and how exact the directions are.

Examples:
  burnish capture directions ball/*.jpg --ball 412.5,388,160 --pictures sample/*.tif --width-mm 60 -o rig.json
  burnish capture directions p*.png --ball 200,190,90 --ball 1800,1210,92 -o rig.lp)";

struct CaptureDirectionsFlags {
    std::vector<std::string> balls, circles, pictures;
    std::string output, ball_response;
    RigFlags rig;
};

ProbeCircle parse_circle(const std::string& text) {
    ProbeCircle c;
    char rest = 0;
    const bool three =
        std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &c.x, &c.y, &c.radius, &rest) == 3;
    if (!three || !std::isfinite(c.x) || !std::isfinite(c.y))
        throw UsageError("--ball", "", "X,Y,R in pixels", shown(text));
    // A smaller ball does not resolve the highlight of a lamp (light_probe.hpp).
    if (!(c.radius >= 4.0) || !std::isfinite(c.radius))
        throw UsageError("--ball", "", "a radius of at least 4 pixels", shown(text));
    return c;
}

std::string describe(const FoundDirection& light, bool several) {
    const Vec3d& d = light.direction;
    const double theta = std::atan2(std::hypot(d[0], d[1]), d[2]) * kDegreesPerRadian;
    const double phi = std::atan2(d[1], d[0]) * kDegreesPerRadian;
    return fmt::format("{}: {:.4f} {:.4f} {:.4f}, theta {:.1f}, phi {:.1f}, spread {:.1f} deg{}\n",
                       one_line(light.picture.filename().string()), d[0], d[1], d[2], theta,
                       phi < 0.0 ? phi + 360.0 : phi, light.spread_deg,
                       several ? fmt::format(", balls {:.1f} deg apart", light.apart_deg) : "");
}

void run_capture_directions(const CaptureDirectionsFlags& flags, const Session& session) {
    CaptureDirectionsRequest request;
    request.balls.assign(flags.balls.begin(), flags.balls.end());
    request.pictures.assign(flags.pictures.begin(), flags.pictures.end());
    for (const std::string& text : flags.circles) request.circles.push_back(parse_circle(text));
    request.rig = flags.rig.overrides();
    if (!flags.ball_response.empty())
        request.ball_response = parse_response(flags.ball_response, "--ball-response");
    request.output = flags.output;
    const CaptureDirectionsResult report = capture_directions(request, session.progress());
    std::string text;
    for (const FoundDirection& light : report.lights)
        text += describe(light, request.circles.size() > 1);
    print(text);
    print_report(report.warnings, report.written);
}

}  // namespace

void add_capture_directions_command(CLI::App& capture, Session& session) {
    CLI::App* command = capture.add_subcommand(
        "directions", "Find where lights stood from pictures of mirror balls");
    const auto flags = std::make_shared<CaptureDirectionsFlags>();
    command->add_option("balls", flags->balls, "pictures of the balls, one a light, in order")
        ->required()
        ->type_name("PICTURE");
    command
        ->add_option(
            "--ball", flags->circles,
            "outline of a mirror ball in pixels: its middle, from the top left corner, and "
            "radius; may be given again")
        ->required()
        ->allow_extra_args(false)
        ->type_name("X,Y,R");
    command
        ->add_option("--pictures", flags->pictures,
                     "of the sample, in the same order (default: those of the balls)")
        ->type_name("FILE");
    command->add_option("-o,--output", flags->output, "the rig, .json or .lp")
        ->required()
        ->type_name("RIG");
    flags->rig.add_to_new(*command);
    command
        ->add_option("--ball-response", flags->ball_response,
                     "linear or srgb: what the pictures of the balls hold, where they differ from "
                     "the sample's")
        ->type_name("NAME");
    command->footer(kCaptureDirectionsFooter);
    command->callback([flags, &session] { run_capture_directions(*flags, session); });
}

}  // namespace burnish::cli
