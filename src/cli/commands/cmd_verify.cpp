// burnish verify: what the methods promise, measured.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "burnish/error.hpp"
#include "cli/commands/commands.hpp"
#include "cli/parameter_flags.hpp"
#include "cli/plot_flags.hpp"
#include "cli/session.hpp"
#include "core/text.hpp"
#include "jobs/models/verify.hpp"
#include "jobs/models/verify_csv.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kVerifyFooter = R"(
Measures every distribution under every method, over tilts of 15, 30 and 45 degrees along x, along
y and between them, Fresnel 1, and prints a row each:
  highlight    angle between the brightest direction and that of a plate which the method's process
               really has moved, seen along the geometric normal; normal-map and the deformations,
               which have no process, against a plate that really is tilted [deg]
  Int D        of (n~.h) dw, least and most: 1 is a surface that adds up to itself
  furnace      light reflected once under even light, least and most over views; above 1 is energy
               from nowhere
  reciprocity  largest difference of f(i,o) and f(o,i), over the larger
  sampler      p of chi-square, 100,000 draws against their density
  broken       values that are NaN, infinite or negative on hostile frames, in both precisions
`microfacet` and `microfacet-separable` are judged under none, gram-schmidt, rotate-exact,
rotate-arc, follow-grain, slope-shift and stretch: highlight below 1 degree, Int D 1 within 0.002,
furnace at most 1.001, reciprocal. Every row is judged by its sampler and its broken values. The
rest is as published, and is not judged. The exit code is 1 when a bound is broken.

--csv FILE holds values of another program against ours instead. FILE has a header and the columns
  ix, iy, iz   towards the light, unit, in the unperturbed tangent space: x tangent, y bitangent,
               z geometric normal
  ox, oy, oz   towards the eye, unit
  f            the BRDF as one number, without the cosine
in any order; others are not read. It takes one --brdf, --mdf and --method (default microfacet, ggx,
follow-grain), --f0 (default 1) and --normal. It prints the root mean square of the difference over
that of our values, the largest difference, the ratio of energies and both highlights, and says
which method, and which of the usual mistakes, explains the values. The exit code is 1 when the
error is above --tolerance.

Examples:
  burnish verify
  burnish verify --mdf ggx --method follow-grain,normal-map --alpha-x 0.1 --alpha-y 0.5 --json
  burnish verify --csv engine.csv --alpha-x 0.1 --alpha-y 0.5 --normal 0.5,0,0.866)";

struct VerifyFlags {
    VerifyRequest request;
    std::string brdf, mdf, method, csv, normal, tolerance;
};

template <typename Enum>
std::vector<Enum> choices_of(const std::string& list, std::span<const std::string_view> names,
                             std::string_view kind, const std::string& flag) {
    std::vector<Enum> chosen;
    if (list.empty()) return chosen;
    for (const int i : indices_of(list, names, kind, flag)) chosen.push_back(static_cast<Enum>(i));
    return chosen;
}

void verify_table(VerifyFlags& flags, const Session& session) {
    VerifyRequest& request = flags.request;
    request.mdfs = choices_of<Mdf>(flags.mdf, mdf_names(), "distribution", "--mdf");
    request.methods = choices_of<Method>(flags.method, method_names(), "method", "--method");
    if (!flags.brdf.empty())
        request.brdfs = choices_of<Brdf>(flags.brdf, brdf_names(), "model", "--brdf");
    request.command = session.command_line();
    const VerifyReport report = verify_methods(request, session.progress());
    print(report.text);
    if (report.broken > 0)
        throw Error(fmt::format("verify: {} of {} break a bound", report.broken,
                                plural(report.rows, "row")));
}

template <typename Enum>
Enum one_of(const std::string& text, std::span<const std::string_view> names, std::string_view kind,
            const std::string& flag, Enum standard) {
    if (text.empty()) return standard;
    return static_cast<Enum>(index_of_name(names, text, kind, flag));
}

void verify_values(const VerifyFlags& flags, const Session& session) {
    VerifyCsvRequest request;
    request.values = flags.request.values;
    request.input = flags.csv;
    request.brdf = one_of(flags.brdf, brdf_names(), "model", "--brdf", request.brdf);
    request.mdf = one_of(flags.mdf, mdf_names(), "distribution", "--mdf", request.mdf);
    request.method = one_of(flags.method, method_names(), "method", "--method", request.method);
    if (!flags.normal.empty()) {
        const std::vector<double> n = cli::numbers_of(flags.normal, "--normal", -1e6, 1e6);
        if (n.size() != 3)
            throw UsageError("--normal", "", "three numbers X,Y,Z", shown(flags.normal));
        request.normal = {n[0], n[1], n[2]};
    }
    request.json = flags.request.json;
    request.command = session.command_line();
    const double tolerance =
        flags.tolerance.empty() ? 0.01 : cli::number_of(flags.tolerance, "--tolerance", 0, 1e6);
    const VerifyCsvReport report = verify_csv(request, session.progress());
    print_report(report.warnings, {});
    print(report.text);
    if (!(report.error <= tolerance))
        throw Error(fmt::format("verify: {} is {:.3g} off, at most {:g} is asked for",
                                flags.csv == "-" ? "standard input" : flags.csv, report.error,
                                tolerance));
}

// Throws UsageError for flags of the values of --csv without it.
void require_csv(const VerifyFlags& flags) {
    for (const auto& [flag, given] : {std::pair{"--normal", !flags.normal.empty()},
                                      std::pair{"--tolerance", !flags.tolerance.empty()},
                                      std::pair{"--f0", flags.request.values.is_set("f0")}}) {
        if (given) throw UsageError(flag, "", "--csv FILE beside it", "none");
    }
}

}  // namespace

void add_verify_command(CLI::App& parent, Session& session) {
    CLI::App* command = parent.add_subcommand("verify", "Measure what the methods promise");
    const auto flags = std::make_shared<VerifyFlags>();
    command->add_option("--brdf", flags->brdf, listed(brdf_names()) + " (default microfacet)")
        ->type_name("LIST");
    command->add_option("--mdf", flags->mdf, listed(mdf_names()) + " (default all)")
        ->type_name("LIST");
    command->add_option("--method", flags->method, listed(method_names()) + " (default all)")
        ->type_name("LIST");
    command
        ->add_option("--csv", flags->csv,
                     "values of another program to hold against ours; - is standard input")
        ->type_name("FILE");
    command
        ->add_option("--normal", flags->normal,
                     "the perturbed normal of --csv, z > 0 (default 0,0,1)")
        ->type_name("X,Y,Z");
    command
        ->add_option("--tolerance", flags->tolerance,
                     "largest error of --csv that is taken (default 0.01)")
        ->type_name("NUMBER");
    for (const char* name : {"e_x", "e_y", "alpha_x", "alpha_y", "f0"})
        add_parameter_flag(*command, name, flags->request.values);
    command->add_flag("--json", flags->request.json, "print one JSON document");
    command->footer(kVerifyFooter);
    command->callback([flags, &session] {
        if (!flags->csv.empty()) {
            verify_values(*flags, session);
        } else {
            require_csv(*flags);
            verify_table(*flags, session);
        }
    });
}

}  // namespace burnish::cli
