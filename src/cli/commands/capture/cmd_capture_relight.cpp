// burnish capture relight: a fitted material under the lights of a rig.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/commands/commands.hpp"
#include "cli/rig_flags.hpp"
#include "cli/session.hpp"
#include "jobs/capture/capture_relight.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kCaptureRelightFooter = R"(
Writes into DIR: a picture of each light, linear, in the units of the rig's intensities, named after the
rig's own (p01.jpg: p01.exr), else 0000.exr, 0001.exr ...; rig.json, which names them; with --compare also
compare.csv. Under a rig that states no intensities pictures are as bright as those that the material was
fitted to, where the fit chose the intensities. A light of the rig that has a camera is seen from there.
PSNR is relative to the brightest sample of the stack that is not clipped. The flags of rigs as the fit
had them, for both rigs. docs/guide/relight-and-export.md says more.

Examples:
  burnish capture relight brass.exr --rig dome.json -o relit
  burnish capture relight brass.exr --rig capture/rig.json --compare capture/rig.json -o relit)";

struct CaptureRelightFlags {
    CaptureRelightRequest request;
    std::string material, rig, compare, output;
    RigFlags rig_flags;
    bool each_light = false;
};

// The total errors in two lines; with `each_light`, a table of the lights before them.
std::string describe(const StackError& error, bool each_light) {
    std::string out;
    if (each_light) {
        out += "light   samples        RMSE     PSNR\n";
        for (std::size_t k = 0; k < error.lights.size(); ++k)
            out += fmt::format("{:5} {:9} {:11.4g} {:5.1f} dB\n", k, error.lights[k].samples,
                               error.lights[k].rmse, error.lights[k].psnr);
    }
    out += fmt::format(
        "PSNR {:.1f} dB in the median of {} lights, {:.1f} in the mean, {:.1f} at "
        "worst (light {})\n",
        error.psnr_median, error.lights.size(), error.psnr_mean, error.psnr_worst, error.worst);
    out += fmt::format("RMSE {:.4g} over {} samples, the brightest of which is {:.4g}\n",
                       error.rmse, error.samples, error.peak);
    return out;
}

void run_capture_relight(CaptureRelightFlags& flags, const Session& session) {
    CaptureRelightRequest& request = flags.request;
    request.material = flags.material;
    request.rig = flags.rig;
    if (!flags.compare.empty()) request.compare = flags.compare;
    request.overrides = flags.rig_flags.overrides();
    request.output = flags.output;
    request.command = session.command_line();
    CaptureRelightResult report = capture_relight(request, session.progress());
    // Hundreds of pictures are not listed; the rig file names them.
    std::erase_if(report.written, [](const auto& path) { return path.extension() == ".exr"; });
    print_report(report.warnings, report.written);
    if (report.error) print(describe(*report.error, flags.each_light));
}

}  // namespace

void add_capture_relight_command(CLI::App& capture, Session& session) {
    CLI::App* command =
        capture.add_subcommand("relight", "Render a fitted material under the lights of a rig");
    const auto flags = std::make_shared<CaptureRelightFlags>();
    command->add_option("material", flags->material, "of burnish capture fit")
        ->required()
        ->type_name("MATERIAL");
    command->add_option("--rig", flags->rig, "lights and cameras; needs no pictures")
        ->required()
        ->type_name("RIG");
    command->add_option("-o,--output", flags->output, "folder to write into; made when needed")
        ->required()
        ->type_name("DIR");
    CLI::Option* compare = command->add_option(
        "--compare", flags->compare,
        "a rig with pictures, as many and as large: print PSNR and RMSE against them");
    compare->type_name("STACK");
    command->add_flag("--each-light", flags->each_light, "print the error of every light, too")
        ->needs(compare);
    flags->rig_flags.add_to(*command);
    command->footer(kCaptureRelightFooter);
    command->callback([flags, &session] { run_capture_relight(*flags, session); });
}

}  // namespace burnish::cli
