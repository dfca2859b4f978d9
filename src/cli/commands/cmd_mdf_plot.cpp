// burnish mdf plot: figures of distributions under a perturbed normal.
#include <CLI/CLI.hpp>
#include <memory>

#include "burnish/error.hpp"
#include "cli/parameter_flags.hpp"
#include "cli/plot_flags.hpp"
#include "cli/session.hpp"
#include "core/text.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kMdfPlotFooter = R"(
Lists are separated by commas. --tilt and --azimuth give a normal for every pair of their values;
with neither and no --normal the normal is tilted by 30 degrees at azimuth 40.

Kinds
  disk      D over the disk of half vectors; rows of normals, columns of methods
  grid      how a method moves the disk: original, warped grid, moved (K11 Fig 7)
  profile   D along the lines through the perturbed normal that are parallel to the axes

Examples:
  burnish mdf plot --mdf ashikhmin-shirley --e-x 200 --e-y 10 \
      --method none,normal-map,deform-smooth,follow-grain --tilt 30 --azimuth 40 -o disks.png
  burnish mdf plot --kind grid --method deform-linear,deform-smooth --tilt 30 -o grids.svg
  burnish mdf plot --mdf ward --alpha-x 0.1 --alpha-y 0.5 --method rotate-exact --tilt 15,30,45,60 \
      -o ward.png)";

struct MdfPlotFlags {
    ParameterValues values;
    std::string mdf = "ashikhmin-shirley", method = "none,normal-map,deform-smooth,follow-grain";
    std::string tilt, azimuth, kind = "disk", normalization = "paper", scale = "linear", high,
                               point;
    std::vector<std::string> normals;
    OutputFlags output;
};

std::vector<Direction<double>> normals_of(const MdfPlotFlags& flags) {
    std::vector<Direction<double>> normals;
    for (const std::string& text : flags.normals) {
        const std::vector<double> v = numbers_of(text, "--normal", -1e6, 1e6);
        Direction<double> n;
        if (v.size() == 3) n = {v[0], v[1], v[2]};
        if (v.size() != 3 || !make_unit(n) || !(n.z > 0))
            throw UsageError("--normal", "", "x,y,z of a normal of the upper hemisphere, z > 0",
                             shown(text));
        normals.push_back(n);
    }
    if (!normals.empty() && flags.tilt.empty() && flags.azimuth.empty()) return normals;
    // 89.9: at 90 degrees the disk would show the lobe edge-on.
    const auto tilts = numbers_of(flags.tilt.empty() ? "30" : flags.tilt, "--tilt", 0, 89.9);
    const auto azimuths =
        numbers_of(flags.azimuth.empty() ? "40" : flags.azimuth, "--azimuth", -360, 360);
    for (const double tilt : tilts)
        for (const double azimuth : azimuths) normals.push_back(plot::tilted_normal(tilt, azimuth));
    return normals;
}

template <typename Name>
Name name_in(const std::string& text, std::span<const std::string_view> names,
             std::string_view kind, const char* flag) {
    return static_cast<Name>(index_of_name(names, text, kind, flag));
}

MdfPlotRequest request_of_mdf_plot(const MdfPlotFlags& flags, const Session& session) {
    MdfPlotRequest request;
    request.values = flags.values;
    for (const int i : indices_of(flags.mdf, mdf_names(), "distribution", "--mdf"))
        request.mdfs.push_back(static_cast<Mdf>(i));
    for (const int i : indices_of(flags.method, method_names(), "method", "--method"))
        request.methods.push_back(static_cast<Method>(i));
    request.normals = normals_of(flags);
    request.kind = name_in<MdfPlotKind>(flags.kind, mdf_plot_kind_names(), "kind", "--kind");
    request.normalization = name_in<plot::Normalization>(
        flags.normalization, plot::normalization_names(), "normalisation", "--normalisation");
    request.scale = name_in<plot::ScaleKind>(flags.scale, plot::scale_names(), "scale", "--scale");
    if (!flags.high.empty()) request.high = number_of(flags.high, "--max", 1e-12, 1e12);
    if (!flags.point.empty()) {
        const std::vector<double> p = numbers_of(flags.point, "--point", -1, 1);
        if (p.size() != 2) throw UsageError("--point", "", "x,y", shown(flags.point));
        request.point = {p[0], p[1]};
    }
    request.output = output_of(flags.output, session);
    return request;
}

}  // namespace

void add_mdf_plot_command(CLI::App& mdf, Session& session) {
    CLI::App* command = mdf.add_subcommand("plot", "Draw distributions, as .png or .svg");
    const auto flags = std::make_shared<MdfPlotFlags>();
    add_output_flags(*command, flags->output);
    const auto add = [&](const char* flag, std::string& target, const std::string& help,
                         const char* type) {
        command->add_option(flag, target, help)->type_name(type);
    };
    add("--kind", flags->kind, listed(mdf_plot_kind_names()) + " (default disk)", "NAME");
    add("--mdf", flags->mdf, listed(mdf_names()) + " (default ashikhmin-shirley)", "LIST");
    for (const char* name : {"e_x", "e_y", "alpha_x", "alpha_y"})
        add_parameter_flag(*command, name, flags->values);
    add("--method", flags->method, listed(method_names()), "LIST");
    add("--tilt", flags->tilt, "of the perturbed normal [deg] (0 to 89.9)", "LIST");
    add("--azimuth", flags->azimuth, "to where it is tilted, from x towards y [deg]", "LIST");
    command->add_option("--normal", flags->normals, "x,y,z of a perturbed normal; may be repeated")
        ->type_name("X,Y,Z")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
    add("--normalisation", flags->normalization,
        "of D: " + listed(plot::normalization_names()) + " (default paper; see mdf eval --help)",
        "NAME");
    add("--scale", flags->scale, listed(plot::scale_names()) + " (default linear)", "NAME");
    add("--max", flags->high, "top of the scale (default: the largest peak)", "NUMBER");
    add("--point", flags->point, "of grid: p on the unit disk (default -0.25,0.45)", "X,Y");
    command->footer(kMdfPlotFooter);
    command->callback([flags, &session] {
        plot_mdf(request_of_mdf_plot(*flags, session), session.progress());
        print_report({}, {flags->output.path});
    });
}

}  // namespace burnish::cli
