// burnish brdf fit: fits reflection models to measured materials.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/commands/commands.hpp"
#include "cli/session.hpp"
#include "core/text.hpp"
#include "jobs/models/brdf_fit.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kBrdfFitFooter = R"(
FILE is a measured material of the RGL database (.bsdf, color or spectral). Each model is fitted
with a Lambertian term by non-linear least squares: f = kd/pi + ks lobe, kd and ks for each color,
one lobe for all. What is made small is the root mean square over solid angle and colors of the
difference in
  rms   f cos(theta_i): Ngan, Durand & Matusik 2005. Peaks decide
  log   ln(1 + f cos(theta_i)): Low et al. 2012. Peaks and the rest both count
Both errors are printed, best model first. A .csv holds a row a model, its p0..p4 those of brdf eval;
a .json also the curves, measured and fitted, in the plane of incidence. --plot draws these curves:
the measurement and the four best fits, or all models that --model names. A * marks numbers that
ended at an end of the range that is searched.
docs/evidence/measured-fits.md shows what came out for some materials.

Examples:
  burnish brdf fit paper_white_rgb.bsdf
  burnish brdf fit satin.bsdf vinyl.bsdf --model ggx,cook-torrance,ward --metric log -o fits.json
  burnish brdf fit satin.bsdf --model ggx,lafortune --plot satin.svg)";

struct BrdfFitFlags {
    MeasuredFitRequest request;
    std::string models = "all", metric = "rms", plot;
};

}  // namespace

void add_brdf_fit_command(CLI::App& brdf, Session& session) {
    CLI::App* command = brdf.add_subcommand("fit", "Fit measured materials by the models");
    const auto flags = std::make_shared<BrdfFitFlags>();
    MeasuredFitRequest& request = flags->request;
    command->add_option("input", request.inputs, "measured materials")
        ->required()
        ->type_name("FILE...");
    command
        ->add_option("--model", flags->models,
                     fmt::format("all, or some of {}", fmt::join(fit_model_names(), ", ")))
        ->capture_default_str()
        ->type_name("all|NAME,...");
    command->add_option("--metric", flags->metric, "rms or log: what is made small")
        ->capture_default_str()
        ->type_name("NAME");
    command->add_option("--samples", request.options.samples, "directions, 200 to 200000")
        ->capture_default_str()
        ->type_name("N");
    command
        ->add_option("--most-angle", request.options.most_deg,
                     "leave out directions further from the normal")
        ->capture_default_str()
        ->type_name("DEG");
    command->add_option("-o,--output", request.output, "table to write, .csv or .json")
        ->type_name("FILE");
    command
        ->add_option("--plot", flags->plot,
                     "picture to write, .png or .svg: the measurement and its fits")
        ->type_name("FILE");
    command->footer(kBrdfFitFooter);
    command->callback([flags, &session] {
        MeasuredFitRequest& asked = flags->request;
        asked.models = parse_fit_models(flags->models, "--model");
        asked.options.fit.metric = static_cast<FitMetric>(
            index_of_name(fit_metric_names(), flags->metric, "metric", "--metric"));
        asked.command = asked.plot.command = session.command_line();
        asked.plot.path = flags->plot;
        print(fit_measured_files(asked, session.progress()));
    });
}

}  // namespace burnish::cli
