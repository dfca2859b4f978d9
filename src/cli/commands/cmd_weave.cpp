// burnish weave: maps of woven cloth.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "cli/commands/commands.hpp"
#include "cli/integer_flag.hpp"
#include "cli/parameter_flags.hpp"
#include "cli/session.hpp"
#include "jobs/maps/weave.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kWeaveFooter = R"(
Writes into DIR: height.exr (millimetres), height.png, normal.png (+y up), direction.png (fibres, double
angle), color.png (sRGB), id.png (warp or weft, number of the yarn), draft.wif, preview.png, weave.json.
The tile repeats without a seam. docs/reference/map-folders.md says what each holds.

Examples:
  burnish weave twill-2-2 -o twill --repeats 4 --weave-twist 30
  burnish weave examples/weaves/houndstooth.wif -o check --size 4096 --yarn-mm 0.8)";

constexpr IntegerRange kTexels = {16, 16384};
constexpr IntegerRange kRepeats = {1, 4096};

struct WeaveFlags {
    WeaveRequest request;
    std::string size, repeats, output;
};

// Two values from "A" or "A<between>B".
struct Pair {
    std::string first, second;
};

Pair parted(const std::string& text, char between) {
    const std::size_t at = text.find(between);
    if (at == std::string::npos) return {text, ""};
    return {text.substr(0, at), text.substr(at + 1)};
}

void run_weave(WeaveFlags& flags, const Session& session) {
    WeaveRequest& request = flags.request;
    if (!flags.size.empty()) {
        const Pair size = parted(flags.size, 'x');
        request.width = whole_number(size.first, kTexels, "--size");
        if (flags.size.find('x') != std::string::npos)
            request.height = whole_number(size.second, kTexels, "--size");
    }
    if (!flags.repeats.empty()) {
        const bool both = flags.repeats.find(',') != std::string::npos;
        const Pair repeats = parted(flags.repeats, ',');
        request.repeats_u = whole_number(repeats.first, kRepeats, "--repeats");
        request.repeats_v =
            both ? whole_number(repeats.second, kRepeats, "--repeats") : *request.repeats_u;
    }
    request.output = flags.output;
    request.command = session.command_line();
    const WeaveReport report = make_weave_maps(request, session.progress());
    print_report(report.warnings, report.written,
                 {fmt::format("process: {} (render with --process {})", name_of(kWeaveProcess),
                              name_of(kWeaveProcess))});
}

}  // namespace

void add_weave_command(CLI::App& parent, Session& session) {
    CLI::App* command = parent.add_subcommand("weave", "Make maps of woven cloth");
    const auto flags = std::make_shared<WeaveFlags>();
    command
        ->add_option("weave", flags->request.weave,
                     fmt::format("{}, or a weaving draft (.wif)", fmt::join(draft_names(), ", ")))
        ->required()
        ->type_name("NAME|FILE");
    command->add_option("-o,--output", flags->output, "folder to write into; made when needed")
        ->required()
        ->type_name("DIR");
    command
        ->add_option("--size", flags->size,
                     "texels, 16 to 16384 a side; a width alone makes texels square (default: the "
                     "longer side 2048)")
        ->type_name("W|WxH");
    command
        ->add_option("--repeats", flags->repeats,
                     "repeats of the draft on the tile (default: at least 16 yarns a side)")
        ->type_name("U[,V]");
    command
        ->add_option("--yarn-mm", flags->request.yarn_mm,
                     "from yarn to yarn on the surface (default 1)")
        ->type_name("MM");
    command->add_flag(
        "--orm", flags->request.orm,
        "also ao.png, orm.png (occlusion, roughness, metallic) and anisotropy.png, of "
        "a usual cloth");
    for (const std::string_view name : weave_map_parameters())
        add_parameter_flag(*command, name, flags->request.values)->group("Yarns");
    command->footer(kWeaveFooter);
    command->callback([flags, &session] { run_weave(*flags, session); });
}

}  // namespace burnish::cli
