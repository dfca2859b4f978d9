#include "jobs/models/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "burnish/error.hpp"
#include "burnish/version.hpp"
#include "core/parallel.hpp"
#include "core/text.hpp"
#include "jobs/models/plot_common.hpp"
#include "verify/properties.hpp"

namespace burnish {
namespace {

using nlohmann::ordered_json;
using verify::Figures;
using verify::Subject;

struct VerifiedRow {
    Subject subject;
    Figures figures;
    std::vector<std::string> broken;

    std::string_view brdf() const { return brdf_names()[static_cast<std::size_t>(subject.brdf)]; }
    std::string_view mdf() const { return mdf_names()[static_cast<std::size_t>(subject.mdf)]; }
    std::string_view method() const {
        return method_names()[static_cast<std::size_t>(subject.method)];
    }
    std::string_view verdict() const {
        if (!broken.empty()) return "broken";
        return verify::is_judged(subject) ? "holds" : "not judged";
    }
};

RoughnessPair checked_pair(const ParameterValues& values) {
    const RoughnessPair pair = roughness_pair(values);
    const auto [x, y] = pair.as_alpha();
    if (std::min(x, y) < verify::kLeastAlphaMeasured) {
        throw UsageError(
            pair.exponents ? "--e-x, --e-y" : "--alpha-x, --alpha-y", "",
            fmt::format(
                "a lobe of alphas from {:g} (e to {:.0f}), the narrowest that the quadratures "
                "resolve",
                verify::kLeastAlphaMeasured, f64::exponent_from_alpha(verify::kLeastAlphaMeasured)),
            fmt::format("{:.4g}", std::min(x, y)));
    }
    return pair;
}

std::vector<int> numbers_or_all(const auto& chosen, std::size_t count) {
    std::vector<int> numbers;
    for (const auto value : chosen) numbers.push_back(static_cast<int>(value));
    for (std::size_t i = 0; chosen.empty() && i < count; ++i)
        numbers.push_back(static_cast<int>(i));
    return numbers;
}

// `without_meaning`: combinations that no model has.
std::vector<VerifiedRow> rows_of(const VerifyRequest& request, std::size_t& without_meaning) {
    const RoughnessPair pair = checked_pair(request.values);
    std::vector<VerifiedRow> rows;
    for (const Brdf brdf : request.brdfs) {
        std::vector<int> mdfs;
        for (const int mdf : numbers_or_all(request.mdfs, mdf_names().size())) {
            const int own = f64::brdf_mdf(static_cast<int>(brdf), mdf);
            if (std::find(mdfs.begin(), mdfs.end(), own) == mdfs.end()) mdfs.push_back(own);
        }
        for (const int mdf : mdfs) {
            const auto [p0, p1] =
                mdf == f64::kMdfAshikhminShirley ? pair.as_exponents() : pair.as_alpha();
            for (const int method : numbers_or_all(request.methods, method_names().size())) {
                if (f64::brdf_takes_method(static_cast<int>(brdf), method)) {
                    rows.push_back({{static_cast<int>(brdf), mdf, p0, p1, method}, {}, {}});
                } else {
                    ++without_meaning;
                }
            }
        }
    }
    if (rows.empty())
        throw UsageError("--method", "", "a method that has a meaning for the model",
                         "phong or lafortune, which have no half vectors to move");
    return rows;
}

// Rows at a time: enough for the cores of a desktop, and progress is reported from one thread.
constexpr std::size_t kRowsMeasuredAtOnce = 16;

void measure_rows(std::vector<VerifiedRow>& rows, const Progress& progress) {
    for (std::size_t from = 0; from < rows.size(); from += kRowsMeasuredAtOnce) {
        progress.step("measure", static_cast<double>(from) / static_cast<double>(rows.size()));
        const std::size_t count = std::min(kRowsMeasuredAtOnce, rows.size() - from);
        parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = from + begin; i < from + end; ++i) {
                progress.throw_if_cancelled();
                rows[i].figures = verify::measure(rows[i].subject);
                rows[i].broken = verify::broken_bounds(rows[i].subject, rows[i].figures);
            }
        });
    }
    progress.step("measure", 1.0);
}

std::string figure_text(double value, const char* format) {
    return std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value);
}

std::string range_text(double least, double most) {
    return std::isnan(least) ? "-" : fmt::format("{:.3f} {:.3f}", least, most);
}

constexpr const char* kVerifyColumns =
    "{:<20} {:<17} {:<13} {:>9}  {:>11}  {:>11}  {:>11}  {:>7}  {:>6}  {}\n";

std::string table_text(const std::vector<VerifiedRow>& rows) {
    const auto line = [](auto... cells) {
        return fmt::format(fmt::runtime(kVerifyColumns), cells...);
    };
    std::string text = line("model", "distribution", "method", "highlight", "Int D", "furnace",
                            "reciprocity", "sampler", "broken", "");
    text += line("", "", "", "deg", "least most", "least most", "", "p", "values", "");
    for (const VerifiedRow& row : rows) {
        const Figures& f = row.figures;
        text += line(row.brdf(), row.mdf(), row.method(), figure_text(f.highlight_deg, "{:.2f}"),
                     range_text(f.energy_least, f.energy_most),
                     range_text(f.albedo_least, f.albedo_most),
                     figure_text(f.reciprocity, "{:.1e}"), figure_text(f.sampler_p, "{:.2f}"),
                     fmt::format("{}", f.hostile.broken_f32 + f.hostile.broken_f64), row.verdict());
    }
    return text;
}

std::string report_text(const std::vector<VerifiedRow>& rows, std::size_t without_meaning,
                        std::size_t broken) {
    std::string text = table_text(rows) + "\n";
    for (const VerifiedRow& row : rows) {
        for (const std::string& bound : row.broken)
            text += fmt::format("{}, {}, {}: {}\n", row.brdf(), row.mdf(), row.method(), bound);
    }
    if (without_meaning > 0)
        text += plural(without_meaning, "combination") +
                " left out: the model has no half vectors to move\n";
    const auto judged = static_cast<std::size_t>(std::count_if(
        rows.begin(), rows.end(), [](const auto& row) { return verify::is_judged(row.subject); }));
    text += fmt::format("{}, {} judged, {} broken\n", plural(rows.size(), "row"), judged, broken);
    return text;
}

// NaN, which JSON has no word for, is null.
ordered_json number_entry(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json row_entry(const VerifiedRow& row) {
    const Figures& f = row.figures;
    ordered_json entry;
    entry["brdf"] = row.brdf();
    entry["mdf"] = row.mdf();
    entry["p0"] = row.subject.p0;
    entry["p1"] = row.subject.p1;
    entry["method"] = row.method();
    entry["highlight_deg"] = number_entry(f.highlight_deg);
    entry["energy"] = {number_entry(f.energy_least), number_entry(f.energy_most)};
    entry["furnace"] = {number_entry(f.albedo_least), number_entry(f.albedo_most)};
    entry["reciprocity"] = number_entry(f.reciprocity);
    entry["sampler_p"] = number_entry(f.sampler_p);
    entry["broken_values_f32"] = f.hostile.broken_f32;
    entry["broken_values_f64"] = f.hostile.broken_f64;
    entry["hostile_combinations"] = f.hostile.combinations;
    entry["judged"] = verify::is_judged(row.subject);
    entry["broken_bounds"] = row.broken;
    return entry;
}

std::string report_json(const std::vector<VerifiedRow>& rows, const std::string& command,
                        std::size_t broken) {
    ordered_json out;
    out["version"] = version();
    out["command"] = command;
    out["bounds"] = {{"highlight_deg", verify::kMostHighlightDeg},
                     {"energy_error", verify::kMostEnergyError},
                     {"furnace", verify::kMostAlbedo},
                     {"reciprocity", verify::kMostAsymmetry},
                     {"sampler_p", verify::kLeastSamplerP}};
    out["broken"] = broken;
    for (const VerifiedRow& row : rows) out["rows"].push_back(row_entry(row));
    // replace: the command may hold bytes that are no UTF-8.
    return out.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

VerifyReport verify_methods(const VerifyRequest& request, const Progress& progress) {
    std::size_t without_meaning = 0;
    std::vector<VerifiedRow> rows = rows_of(request, without_meaning);
    measure_rows(rows, progress);
    VerifyReport report;
    report.rows = rows.size();
    report.broken = static_cast<std::size_t>(std::count_if(
        rows.begin(), rows.end(), [](const auto& row) { return !row.broken.empty(); }));
    report.text = request.json ? report_json(rows, request.command, report.broken)
                               : report_text(rows, without_meaning, report.broken);
    return report;
}

}  // namespace burnish
