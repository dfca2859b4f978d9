// burnish capture report: a page on a capture and its fit.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/commands/commands.hpp"
#include "cli/integer_flag.hpp"
#include "cli/rig_flags.hpp"
#include "cli/session.hpp"
#include "jobs/capture/capture_report.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kCaptureReportFooter = R"(
Writes into DIR: index.html, which opens from disk and needs no scripts and no network, and its pictures:
what the lights cover, the exemplars before and after completion, maps, three pictures of lights beside
what the material and Ward's models make of them, and renderings. STACK is the rig that the material was
fitted to. Without --hold-out it is as the material's file says; where that says nothing, lights judge
that took part, and the page says so. The flags of rigs as the fit had them.
docs/guide/capture.md says more.

Examples:
  burnish capture fit sample/rig.json -o sample.exr --hold-out 10
  burnish capture report sample.exr --stack sample/rig.json -o report)";

struct CaptureReportFlags {
    CaptureReportRequest request;
    std::string material, stack, output;
    RigFlags rig;
    int hold_out = 0;
};

void run_capture_report(CaptureReportFlags& flags, bool hold_out, const Session& session) {
    CaptureReportRequest& request = flags.request;
    request.material = flags.material;
    request.stack = flags.stack;
    request.output = flags.output;
    request.overrides = flags.rig.overrides();
    if (hold_out) request.hold_out = flags.hold_out;
    request.command = session.command_line();
    CaptureReportResult result = capture_report(request, session.progress());
    // The pictures are not listed; the page shows them.
    std::erase_if(result.written, [](const auto& path) { return path.extension() == ".png"; });
    print_report(result.warnings, result.written);
}

}  // namespace

void add_capture_report_command(CLI::App& capture, Session& session) {
    CLI::App* command = capture.add_subcommand("report", "Show a capture and its fit as a page");
    const auto flags = std::make_shared<CaptureReportFlags>();
    command->add_option("material", flags->material, "of burnish capture fit")
        ->required()
        ->type_name("MATERIAL");
    command->add_option("--stack", flags->stack, "the rig with the pictures it was fitted to")
        ->required()
        ->type_name("RIG");
    command->add_option("-o,--output", flags->output, "folder to write into; made when needed")
        ->required()
        ->type_name("DIR");
    CLI::Option* hold_out = add_integer(*command, "--hold-out", flags->hold_out, {2, 1000},
                                        "every n-th light judges, as the fit had it");
    command
        ->add_option("--render", flags->request.model,
                     "what to render (default: builtin:sphere and builtin:drape)")
        ->type_name("MODEL");
    flags->rig.add_to(*command);
    add_gl_device(*command, flags->request.gl_device);
    command->footer(kCaptureReportFooter);
    command->callback([flags, hold_out, &session] {
        run_capture_report(*flags, hold_out->count() > 0, session);
    });
}

}  // namespace burnish::cli
