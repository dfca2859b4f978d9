// burnish capture export: a fitted material as maps and as glTF.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/commands/commands.hpp"
#include "cli/session.hpp"
#include "jobs/capture/capture_export.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kCaptureExportFooter = R"(
Writes into DIR: diffuse.exr, specular.exr, normal.exr (unit vectors), grain_angle.exr (degrees of the
groove, counter-clockwise from +x, 0 to 180), alpha.exr (red: across the groove, green: along it, blue:
distance of the table from that GGX lobe, 0 to 1) and material.gltf with its textures, a flat quad as
large as the sample with KHR_materials_anisotropy. docs/reference/map-folders.md says what each holds.

Examples:
  burnish capture export brass.exr -o brass
  burnish render brass/material.gltf --camera-azimuth 0 --camera-elevation 40 -o brass.png)";

struct CaptureExportFlags {
    std::string material, output;
};

void run_capture_export(const CaptureExportFlags& flags, const Session& session) {
    const CaptureExportRequest request = {flags.material, flags.output, session.command_line()};
    const CaptureExportResult report = capture_export(request, session.progress());
    print_report(report.warnings, report.written);
}

}  // namespace

void add_capture_export_command(CLI::App& capture, Session& session) {
    CLI::App* command =
        capture.add_subcommand("export", "Write a fitted material as maps and as glTF");
    const auto flags = std::make_shared<CaptureExportFlags>();
    command->add_option("material", flags->material, "of burnish capture fit")
        ->required()
        ->type_name("MATERIAL");
    command->add_option("-o,--output", flags->output, "folder to write into; made when needed")
        ->required()
        ->type_name("DIR");
    command->footer(kCaptureExportFooter);
    command->callback([flags, &session] { run_capture_export(*flags, session); });
}

}  // namespace burnish::cli
