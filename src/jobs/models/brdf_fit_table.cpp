#include "jobs/models/brdf_fit_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "burnish/error.hpp"
#include "burnish/version.hpp"
#include "core/files.hpp"
#include "jobs/models/brdf_fit_plot.hpp"
#include "jobs/models/plot_common.hpp"

namespace burnish {
namespace {

using nlohmann::ordered_json;

std::string_view metric_name(FitMetric metric) {
    return fit_metric_names()[static_cast<std::size_t>(metric)];
}

const BrdfModel& model_of(const BrdfFit& fit) {
    return *std::find_if(brdf_models().begin(), brdf_models().end(),
                         [&](const BrdfModel& model) { return model.name == fit.model; });
}

// Behind a number at a bound of its range, in the table for reading.
std::string_view mark(bool at_bound) {
    return at_bound ? "*" : "";
}

// "alpha_x 0.12, F0 1*": omits ks, which the scale contains.
std::string shape_text(const BrdfFit& fit) {
    const auto parameters = model_of(fit).parameters;
    std::string text;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (parameters[i].name == "ks") continue;
        text += fmt::format("{}{} {:.4g}{}", text.empty() ? "" : ", ", parameters[i].name,
                            fit.lobe[i], mark(fit.lobe_at_bound[i]));
    }
    return text;
}

std::string rgb_text(const FitRgb& rgb, const std::array<bool, 3>& at_bound) {
    return fmt::format("{:.3g}{} {:.3g}{} {:.3g}{}", rgb[0], mark(at_bound[0]), rgb[1],
                       mark(at_bound[1]), rgb[2], mark(at_bound[2]));
}

// The numbers at a bound of their range: "kd_r", "ks_g", "F0".
std::vector<std::string> names_at_bound(const BrdfFit& fit) {
    std::vector<std::string> names;
    const auto add_color = [&](std::string_view name, const std::array<bool, 3>& at_bound) {
        for (std::size_t c = 0; c < 3; ++c)
            if (at_bound[c]) names.push_back(fmt::format("{}_{}", name, "rgb"[c]));
    };
    add_color("kd", fit.kd_at_bound);
    add_color("ks", fit.ks_at_bound);
    const auto parameters = model_of(fit).parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (fit.lobe_at_bound[i]) names.emplace_back(parameters[i].name);
    return names;
}

ordered_json fit_entry(const BrdfFit& fit, const MeasuredFit& of) {
    ordered_json entry;
    entry["model"] = fit.model;
    entry["rms"] = fit.rms;
    entry["relative_rms"] = of.of_black.rms > 0 ? fit.rms / of.of_black.rms : 0.0;
    entry["log"] = fit.log_rms;
    entry["kd"] = fit.kd;
    entry["ks"] = fit.ks;
    const auto parameters = model_of(fit).parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (parameters[i].name != "ks")
            entry["shape"][std::string(parameters[i].name)] = fit.lobe[i];
    entry["at_bound"] = names_at_bound(fit);
    entry["start"] = fit.start;
    entry["iterations"] = fit.iterations;
    entry["converged"] = fit.converged;
    return entry;
}

ordered_json curve_entry(const PlaneCurve& curve, const MeasuredFit& of) {
    ordered_json entry;
    entry["theta_o_deg"] = curve.theta_o_deg;
    entry["theta_i_deg"] = curve.theta_deg;
    entry["measured"] = curve.measured;
    for (std::size_t m = 0; m < of.fits.size(); ++m)
        entry["fitted"][of.fits[m].model] = curve.fitted[m];
    return entry;
}

}  // namespace

std::string fit_lines(const MeasuredFit& fit) {
    std::string text = fmt::format(
        "{}: {}\n  {} samples within {:g} degrees, {}; root mean square of f cos {:.4g}\n",
        fit.file, fit.description, fit.samples, fit.most_deg,
        fit.isotropic ? "isotropic" : "anisotropic", fit.of_black.rms);
    text += fmt::format("  {:<18} {:>10} {:>9} {:>10}  {:<22} {:<22} {}\n", "model", "rms",
                        "relative", "log", "kd (r g b)", "ks (r g b)", "shape");
    bool marked = false;
    for (const BrdfFit& one : fit.fits) {
        text += fmt::format(
            "  {:<18} {:>10.4g} {:>8.1f}% {:>10.4g}  {:<22} {:<22} {}{}\n", one.model, one.rms,
            fit.of_black.rms > 0 ? 100 * one.rms / fit.of_black.rms : 0.0, one.log_rms,
            rgb_text(one.kd, one.kd_at_bound), rgb_text(one.ks, one.ks_at_bound), shape_text(one),
            one.converged ? "" : " (still moving)");
        marked = marked || !names_at_bound(one).empty();
    }
    if (marked) text += "  * at an end of the range that is searched\n";
    return text;
}

std::string fit_csv(std::span<const MeasuredFit> fits, const std::string& command) {
    std::string text = fmt::format("# burnish {}: {}\n", version(), one_line(command));
    text +=
        "# f = kd / pi + ks lobe(p0..p4) per steradian without the cosine; p0..p4 as in brdf eval\n"
        "file,metric,rank,brdf,rms,relative_rms,log,kd_r,kd_g,kd_b,ks_r,ks_g,ks_b,p0,p1,p2,p3,p4,"
        "at_bound\n";
    const auto add = [&](double value) { text += fmt::format(",{}", value); };
    for (const MeasuredFit& fit : fits) {
        // Quotes are doubled inside a quoted field.
        std::string name;
        for (const char c : one_line(fit.file))
            name += c == '"' ? std::string("\"\"") : std::string(1, c);
        for (std::size_t rank = 0; rank < fit.fits.size(); ++rank) {
            const BrdfFit& one = fit.fits[rank];
            text +=
                fmt::format("\"{}\",{},{},{}", name, metric_name(fit.metric), rank + 1, one.model);
            add(one.rms);
            add(fit.of_black.rms > 0 ? one.rms / fit.of_black.rms : 0.0);
            add(one.log_rms);
            for (const double value : one.kd) add(value);
            for (const double value : one.ks) add(value);
            for (std::size_t i = 0; i < kMostBrdfParameters; ++i)
                text += i < one.lobe_size ? fmt::format(",{}", one.lobe[i]) : ",";
            text += fmt::format(",{}", fmt::join(names_at_bound(one), " "));
            text += '\n';
        }
    }
    return text;
}

std::string fit_json(std::span<const MeasuredFit> fits, const std::string& command) {
    ordered_json out;
    out["format"] = "burnish-fit";
    out["version"] = 1;
    out["made"] = {{"version", version()}, {"command", command}};
    out["brdf"] = "kd / pi + ks lobe(shape), per steradian without the cosine";
    for (const MeasuredFit& fit : fits) {
        ordered_json entry;
        entry["file"] = fit.file;
        entry["description"] = fit.description;
        entry["isotropic"] = fit.isotropic;
        entry["metric"] = metric_name(fit.metric);
        entry["samples"] = fit.samples;
        entry["most_deg"] = fit.most_deg;
        entry["measured_rms"] = fit.of_black.rms;
        for (const BrdfFit& one : fit.fits) entry["fits"].push_back(fit_entry(one, fit));
        for (const PlaneCurve& curve : fit.curves)
            entry["curves"].push_back(curve_entry(curve, fit));
        out["materials"].push_back(std::move(entry));
    }
    // Names of files need not be UTF-8.
    return out.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

namespace {

enum class Output { none, csv, json };

Output output_kind(const std::string& path) {
    if (path.empty()) return Output::none;
    const std::string extension = std::filesystem::path(path).extension().string();
    if (extension == ".csv") return Output::csv;
    if (extension == ".json") return Output::json;
    throw UsageError("--output", "", "a name that ends in .csv or .json", shown(path));
}

// Lines of all models would hide one another: the best few, unless models were chosen.
constexpr std::size_t kBestDrawn = 4;

void write_fit_plot(const MeasuredFitRequest& request, std::span<const MeasuredFit> fits,
                    const Progress& progress) {
    const std::size_t most = request.models.empty() ? kBestDrawn : request.models.size();
    write_plot(fit_figure(fits, most, request.plot.panel_px), request.plot,
               {{"burnish:files", fmt::format("{}", fmt::join(request.inputs, " "))}}, progress);
}

}  // namespace

std::string fit_measured_files(const MeasuredFitRequest& request, const Progress& progress) {
    const Output kind = output_kind(request.output);
    if (kind != Output::none) require_writable(request.output);
    if (!request.plot.path.empty()) plot::require_figure_path(request.plot.path);
    std::vector<MeasuredFit> fits;
    std::string text;
    for (std::size_t i = 0; i < request.inputs.size(); ++i) {
        const Progress part = progress.with_report([&](std::string_view stage, double done) {
            progress.step(stage, (static_cast<double>(i) + done) /
                                     static_cast<double>(request.inputs.size()));
        });
        fits.push_back(fit_measured(request.inputs[i], request.models, part, request.options));
        text += fit_lines(fits.back());
    }
    if (kind == Output::csv) write_text_file(request.output, fit_csv(fits, request.command));
    if (kind == Output::json) write_text_file(request.output, fit_json(fits, request.command));
    if (!request.plot.path.empty()) write_fit_plot(request, fits, progress);
    return text;
}

}  // namespace burnish
