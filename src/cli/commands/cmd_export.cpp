// burnish export material: a material for other programs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "burnish/error.hpp"
#include "burnish/parameters.hpp"
#include "cli/commands/commands.hpp"
#include "cli/integer_flag.hpp"
#include "cli/parameter_flags.hpp"
#include "cli/session.hpp"
#include "cli/usage.hpp"
#include "jobs/export_material.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kExportFooter = R"(
Writes into DIR: base_color.png, orm.png (occlusion, roughness, metallic), normal.png (+y up),
anisotropy.png (KHR_materials_anisotropy), emissive.png where it glows, material.gltf (a quad with these
maps), material.json (what each map means) and preview.png. Of a weave or a scratch map the maps show a
tile that repeats. A scene with several materials gives a folder for each.
docs/guide/export.md says what glTF cannot say.

Examples:
  burnish export material --metal gold --alpha-x 0.08 --alpha-y 0.3 --scratch brushed -o gold
  burnish export material --weave satin-5 --warp-color '#802020' -o satin --size 1024
  burnish export material scene.json --material door -o door --bits 8)";

constexpr IntegerRange kTexels = {16, 16384};

struct ExportFlags {
    ExportMaterialRequest request;
    std::string size, output, bits = "16";
    std::optional<double> tile_mm;
    bool no_preview = false, no_extras = false;
};

void run_export(ExportFlags& flags, const Session& session) {
    ExportMaterialRequest& request = flags.request;
    if (request.stage.input.empty()) request.stage.input = "builtin:plane";
    if (!flags.size.empty()) {
        const std::size_t x = flags.size.find('x');
        request.width = whole_number(flags.size.substr(0, x), kTexels, "--size");
        if (x != std::string::npos)
            request.height = whole_number(flags.size.substr(x + 1), kTexels, "--size");
    }
    if (flags.bits != "8" && flags.bits != "16")
        throw UsageError("--bits", "", "8 or 16", shown(flags.bits));
    request.bits = flags.bits == "8" ? 8 : 16;
    if (flags.tile_mm && !(*flags.tile_mm >= 1e-3 && *flags.tile_mm <= 1e6))
        throw UsageError("--tile-mm", "", "a number from 0.001 to 1000000",
                         fmt::format("{:g}", *flags.tile_mm));
    request.tile_mm = flags.tile_mm;
    request.preview = !flags.no_preview;
    request.extras = !flags.no_extras;
    request.output = flags.output;
    request.command = session.command_line();
    const ExportMaterialReport report = export_material(request, session.progress());
    print_report(report.warnings, report.written, report.notes);
}

}  // namespace

void add_export_command(CLI::App& parent, Session& session) {
    CLI::App* group = parent.add_subcommand("export", "Write a material for other programs");
    require_command(*group);
    CLI::App* command = group->add_subcommand("material", "Write any material as maps and as glTF");
    const auto flags = std::make_shared<ExportFlags>();
    ExportMaterialRequest& request = flags->request;
    command
        ->add_option("input", request.stage.input,
                     "model or scene whose materials are exported; none: what the flags say")
        ->type_name("MODEL|SCENE");
    command->add_option("-o,--output", flags->output, "folder to write into; made when needed")
        ->required()
        ->type_name("DIR");
    command
        ->add_option("--material", request.material,
                     "name or index of one material (default: all of them)")
        ->type_name("NAME|INDEX");
    command
        ->add_option("--size", flags->size,
                     "texels, 16 to 16384 a side; a width alone makes texels square (default: the "
                     "longer side 2048)")
        ->type_name("W|WxH");
    command->add_option("--bits", flags->bits, "of all maps but colors: 8 or 16 (default 16)")
        ->type_name("BITS");
    command
        ->add_option("--tile-mm", flags->tile_mm,
                     "width of the tile in millimeters (default: what the material states)")
        ->type_name("MM");
    command->add_flag("--no-preview", flags->no_preview, "no preview.png, which needs OpenGL");
    command->add_flag("--no-extras", flags->no_extras,
                      "glTF's own words alone: read back, burnish draws the maps too");
    add_gl_device(*command, request.gl_device);
    for (const Parameter& parameter : parameter_table())
        if (parameter.group == ParameterGroup::material)
            add_parameter_flag(*command, parameter.name, request.stage.values)->group("Material");
    command->footer(kExportFooter);
    command->callback([flags, &session] { run_export(*flags, session); });
}

}  // namespace burnish::cli
