// burnish brdf plot: figures of reflection models.
#include <CLI/CLI.hpp>
#include <memory>

#include "burnish/error.hpp"
#include "cli/parameter_flags.hpp"
#include "cli/plot_flags.hpp"
#include "cli/session.hpp"
#include "core/text.hpp"
#include "jobs/models/eval.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kBrdfPlotFooter = R"(
Lists are separated by commas. One roughness pair drives every model: what a model has no flag for
comes from it, m = sqrt(alpha_x alpha_y), exponents 2/m^2 - 2, tau = 2 sigma/m; ks is 1, or
(n + 2)/(2 pi) where it scales a power of a cosine, F0 is 1 unless --f0 says otherwise. A model can
have its own: --brdf ggx,phong:n=50:ks=2, with the names that brdf eval --help lists and that
the figure's caption repeats. FILE.bsdf is a measured material of the RGL database, drawn by its
luminance and up to 85 degrees.

Kinds
  polar     f in the plane of incidence, or in the cut at --cut; a line a model
  surface   the lobe over the hemisphere, in perspective of no kind: parallel lines stay parallel
  albedo    the share of the light that leaves, over the angle of incidence

Examples:
  burnish brdf plot --brdf ward,ward-duer,ward-gmd --alpha-x 0.15 --alpha-y 0.4 --incidence 30,60 \
      --scale linear,log -o ward.png
  burnish brdf plot --kind surface --brdf ggx,beckmann,phong --alpha-x 0.2 --incidence 45 -o lobes.png
  burnish brdf plot --kind albedo --brdf ward,ward-duer,ward-gmd,ggx --alpha-x 0.15 --alpha-y 0.4 \
      -o albedo.svg
  burnish brdf plot --brdf satin.bsdf --incidence 30,60 --scale log -o satin.png)";

struct BrdfPlotFlags {
    ParameterValues values;
    std::string brdf, kind = "polar", scale = "linear", incidence = "45", azimuth = "0", cut, high;
    std::string view_azimuth, view_elevation;
    OutputFlags output;
};

BrdfPlotRequest request_of_brdf_plot(const BrdfPlotFlags& flags, const Session& session) {
    BrdfPlotRequest request;
    request.values = flags.values;
    request.brdfs = words_of(flags.brdf);
    request.kind = static_cast<BrdfPlotKind>(
        index_of_name(brdf_plot_kind_names(), flags.kind, "kind", "--kind"));
    request.scales.clear();
    for (const int i : indices_of(flags.scale, plot::scale_names(), "scale", "--scale"))
        request.scales.push_back(static_cast<plot::ScaleKind>(i));
    request.incidences_deg = numbers_of(flags.incidence, "--incidence", 0, 89.9);
    request.azimuth_deg = number_of(flags.azimuth, "--azimuth", -360, 360);
    if (!flags.cut.empty()) request.cut_deg = number_of(flags.cut, "--cut", -360, 360);
    if (!flags.high.empty()) request.high = number_of(flags.high, "--max", 1e-12, 1e12);
    if (!flags.view_azimuth.empty())
        request.view.azimuth_deg = number_of(flags.view_azimuth, "--view-azimuth", -360, 360);
    if (!flags.view_elevation.empty())
        request.view.elevation_deg = number_of(flags.view_elevation, "--view-elevation", 0, 90);
    request.output = output_of(flags.output, session);
    return request;
}

}  // namespace

void add_brdf_plot_command(CLI::App& brdf, Session& session) {
    CLI::App* command = brdf.add_subcommand("plot", "Draw reflection models, as .png or .svg");
    const auto flags = std::make_shared<BrdfPlotFlags>();
    add_output_flags(*command, flags->output);
    const auto add = [&](const char* flag, std::string& target, const std::string& help,
                         const char* type) {
        return command->add_option(flag, target, help)->type_name(type);
    };
    add("--kind", flags->kind, listed(brdf_plot_kind_names()) + " (default polar)", "NAME");
    add("--brdf", flags->brdf, listed(brdf_table_names()) + ", or measured FILE.bsdf", "LIST")
        ->required();
    for (const char* name : {"e_x", "e_y", "alpha_x", "alpha_y", "f0", "mdf"})
        add_parameter_flag(*command, name, flags->values);
    add("--incidence", flags->incidence,
        "of the light, from the normal [deg] (0 to 89.9; default 45)", "LIST");
    add("--azimuth", flags->azimuth, "of the light, from x towards y [deg] (default 0)", "NUMBER");
    add("--cut", flags->cut, "azimuth of the polar cut [deg] (default: the plane of incidence)",
        "NUMBER");
    add("--scale", flags->scale, listed(plot::scale_names()) + " (default linear)", "LIST");
    add("--max", flags->high, "f at the rim of the polar cut (default: the largest)", "NUMBER");
    add("--view-azimuth", flags->view_azimuth, "of the viewer of a surface [deg] (default -75)",
        "NUMBER");
    add("--view-elevation", flags->view_elevation,
        "of the viewer above the surface [deg] (0 to 90; default 25)", "NUMBER");
    command->footer(kBrdfPlotFooter);
    command->callback([flags, &session] {
        plot_brdf(request_of_brdf_plot(*flags, session), session.progress());
        print_report({}, {flags->output.path});
    });
}

}  // namespace burnish::cli
