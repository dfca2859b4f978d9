// burnish capture fit: a material from a stack of pictures.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <string>

#include "burnish/error.hpp"
#include "cli/commands/commands.hpp"
#include "cli/integer_flag.hpp"
#include "cli/rig_flags.hpp"
#include "cli/session.hpp"
#include "core/text.hpp"
#include "jobs/capture/capture_fit.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kCaptureFitFooter = R"(
STACK is a rig file (JSON of ours, .lp or .dome) whose lights name pictures of one flat sample from one
camera: docs/reference/rig-file.md. MATERIAL (.exr) is a tabulated material: distributions of microfacet normals, and
for each texel which it has, turned by how much, with diffuse and specular color. It renders with
`burnish render --tabulated`. An interrupted fit goes on where it was when it is called again.
docs/guide/capture.md says what is done, how well, and what a stack cannot support.

Examples:
  burnish capture simulate classes -o sample --noise 1
  burnish capture fit sample/rig.json -o sample.exr --eta 1.5
  burnish capture fit dome/lights.lp -o coin.exr --camera 0,-1,1 --width-mm 40 --hold-out 10)";

struct CaptureFitFlags {
    CaptureFitRequest request;
    RigFlags rig;
    std::string grid, until, output;
    double eta = -1.0, f0 = -1.0;
    int seed = 1;
    bool no_models = false;
};

void set_grid(CaptureFitFlags& flags) {
    if (flags.grid.empty()) return;
    const std::size_t at = flags.grid.find('x');
    NdfGrid& grid = flags.request.settings.grid;
    grid.rings = whole_number(flags.grid.substr(0, at), {8, 128}, "--grid");
    if (at == std::string::npos)
        throw UsageError("--grid", "", "RINGSxAZIMUTHS", shown(flags.grid));
    grid.azimuths = whole_number(flags.grid.substr(at + 1), {24, 384}, "--grid");
    if (grid.azimuths % 24 != 0)
        throw UsageError("--grid", "azimuths", "a multiple of 24", fmt::to_string(grid.azimuths));
}

void set_fresnel(CaptureFitFlags& flags) {
    if (flags.eta >= 0.0 && flags.f0 >= 0.0)
        throw UsageError("--eta and --f0 say the same thing in two ways: give one of them");
    auto& eta = flags.request.settings.eta;
    if (flags.eta >= 0.0) {
        if (flags.eta != 0.0 && !(flags.eta >= 1.01 && flags.eta <= 100.0))
            throw UsageError("--eta", "", "1.01 to 100, or 0 for none",
                             fmt::format("{}", flags.eta));
        eta = flags.eta;
    } else if (flags.f0 >= 0.0) {
        if (!(flags.f0 > 0.0 && flags.f0 <= 1.0))
            throw UsageError("--f0", "", "above 0, at most 1", fmt::format("{}", flags.f0));
        // F(1) = ((eta - 1) / (eta + 1))^2; for metals near 1 the reflectance hardly depends on the
        // angle.
        const double root = std::sqrt(flags.f0);
        eta = root > 0.98 ? 0.0 : (1.0 + root) / (1.0 - root);
    }
}

// A summary of the result as text.
std::string describe(const CaptureFitResult& r, const CaptureFitRequest& request) {
    std::string text = fmt::format(
        "{} x {} pixels, {} lights{}, half vectors {:.1f} degrees apart, {:.2g} % clipped, {:.2g} "
        "% "
        "black\n",
        r.width, r.height, r.lights, r.raw ? " of raw files" : "", r.fit.spacing_deg,
        100.0 * r.fit.census.clipped_share, 100.0 * r.fit.census.black_share);
    if (r.fit.exemplars > 0) {
        text += fmt::format("{} from {} points, eta {:.3g}{}, {:.2g} % of the light unexplained\n",
                            plural(static_cast<std::size_t>(r.fit.exemplars), "exemplar"),
                            r.fit.training_points, r.fit.eta,
                            request.settings.eta ? "" : " (estimated)", 100.0 * r.unexplained);
        text += fmt::format(
            "of the hemisphere {:.0f} % is measured, {:.0f} % completed from other exemplars, "
            "{:.0f} % extrapolated\n",
            100.0 * r.fit.completion.measured, 100.0 * r.fit.completion.completed_share,
            100.0 * r.fit.completion.extrapolated);
    }
    if (request.until)
        text += fmt::format(
            "stopped after {}: no material yet; the same command without --until goes on from {}\n",
            capture_stage_names()[static_cast<std::size_t>(*request.until)], r.stages.string());
    if (!r.held_out.empty())
        text += fmt::format("on the {} held out, PSNR by their brightest sample, {:.3g}:\n",
                            plural(r.held_out_lights, "light"), r.held_out.front().peak);
    for (const HeldOutError& e : r.held_out)
        text += fmt::format("  {:<18} {:5.1f} dB, RMSE {:.3g}\n", e.model, e.psnr, e.rmse);
    return text;
}

void run_capture_fit(CaptureFitFlags& flags, const Session& session) {
    CaptureFitRequest& request = flags.request;
    request.overrides = flags.rig.overrides();
    set_grid(flags);
    set_fresnel(flags);
    if (request.settings.hold_out == 1)  // no light would be left to fit
        throw UsageError("--hold-out", "", "0, or a whole number from 2 to 1000", "1");
    if (!flags.until.empty())
        request.until = static_cast<CaptureStage>(
            index_of_name(capture_stage_names(), flags.until, "stage", "--until"));
    request.settings.models = !flags.no_models;
    request.settings.seed = static_cast<std::uint64_t>(flags.seed);
    request.output = flags.output;
    if (request.output.extension() != ".exr")
        throw UsageError("-o", "", "a file name that ends in .exr", shown(flags.output));
    request.command = session.command_line();
    const CaptureFitResult result = capture_fit(request, session.progress());
    print(describe(result, request));
    print_report(result.warnings, result.written);
}

}  // namespace

void add_capture_fit_command(CLI::App& capture, Session& session) {
    CLI::App* command = capture.add_subcommand("fit", "Fit a material to a stack of pictures");
    const auto flags = std::make_shared<CaptureFitFlags>();
    CaptureFitRequest& request = flags->request;
    CaptureFitSettings& settings = request.settings;
    command->add_option("stack", request.stack, "a rig file whose lights name pictures")
        ->required()
        ->type_name("STACK");
    command->add_option("-o,--output", flags->output, "the material, .exr")
        ->required()
        ->type_name("MATERIAL");
    command
        ->add_option("--eta", flags->eta, "index of refraction; 0: no Fresnel (default: estimated)")
        ->type_name("N");
    command->add_option("--f0", flags->f0, "reflectance of a facet head on, in place of --eta")
        ->type_name("F");
    add_integer(*command, "--exemplars", settings.exemplars, {1, 6400}, "distributions at most");
    command->add_option("--grid", flags->grid, "cells of a distribution (default 32x96)")
        ->type_name("RINGSxAZIMUTHS");
    add_integer(
        *command, "--training-points", settings.training_points, {16, 1000000},
        "pixels at most that exemplars are made from; default: 8192, and no more than have 4 "
        "million samples");
    command->add_flag("--normals", settings.normals,
                      "fit each pixel's normal too; without, the sample is flat");
    command->add_flag("--no-models", flags->no_models,
                      "leave out the analytic models of every pixel");
    add_integer(*command, "--hold-out", settings.hold_out, {0, 1000},
                "every n-th light takes no part; 0: all do");
    add_integer(*command, "--seed", flags->seed, {0, 1000000}, "of the clustering");
    flags->rig.add_to(*command);
    command
        ->add_option("--until", flags->until,
                     "stop after this stage: pictures, exemplars or texels")
        ->type_name("STAGE");
    command->add_flag("--keep-stages", request.keep_stages, "leave MATERIAL.stages for later runs");
    command->footer(kCaptureFitFooter);
    command->callback([flags, &session] { run_capture_fit(*flags, session); });
}

}  // namespace burnish::cli
