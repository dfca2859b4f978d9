#include "jobs/models/verify_csv.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "burnish/error.hpp"
#include "burnish/version.hpp"
#include "core/csv_columns.hpp"
#include "core/text.hpp"
#include "jobs/models/plot_common.hpp"
#include "verify/foreign_values.hpp"

namespace burnish {
namespace {

using verify::Comparison;
using verify::Sightings;
using verify::vec3;

constexpr std::array<std::string_view, 7> kValueColumns = {"ix", "iy", "iz", "ox", "oy", "oz", "f"};
constexpr std::size_t kMostValueRows = 4000000;  // half a gigabyte
constexpr double kUnitTolerance = 1e-3;          // three digits of a unit direction
constexpr double kRoundedLength = 1e-6;          // six digits: no change of length worth a word

struct ValueTable {
    Sightings at;
    std::vector<double> f;
    std::vector<std::size_t> lines;  // of each row, in the file
    std::size_t normalized = 0, negative = 0;

    std::string place(std::size_t row) const {
        return fmt::format("row {} (line {})", row + 1, lines[row]);
    }
};

std::string source_name(const std::string& input) {
    return input == "-" ? "standard input" : input;
}

vec3 unit_direction(const CsvRow& row, std::size_t first, bool& changed) {
    Direction<double> v{row.number<double>(first), row.number<double>(first + 1),
                        row.number<double>(first + 2)};
    const double length = std::hypot(v.x, v.y, v.z);
    if (!(std::abs(length - 1) <= kUnitTolerance))
        row.fail(
            first,
            fmt::format("the start of a unit direction, of length 1 within {:g}", kUnitTolerance),
            fmt::format("a length of {:.6g}", length));
    changed = changed || std::abs(length - 1) > kRoundedLength;
    return vec3{v.x, v.y, v.z} * (1 / length);
}

void add_value_row(const CsvRow& row, ValueTable& table) {
    if (table.f.size() == kMostValueRows)
        row.fail(0, fmt::format("at most {} rows", kMostValueRows), "more");
    bool changed = false;
    const vec3 wi = unit_direction(row, 0, changed), wo = unit_direction(row, 3, changed);
    const double f = row.number<double>(6);
    // Squares of values are summed.
    if (!(std::abs(f) < 1e100)) row.fail(6, "a value below 1e100", shown(row.text(6)));
    table.at.wi.push_back(wi);
    table.at.wo.push_back(wo);
    table.f.push_back(f);
    table.lines.push_back(row.line());
    table.normalized += changed;
    table.negative += f < 0;
}

ValueTable read_values(const VerifyCsvRequest& request, const Progress& progress) {
    Direction<double> n = request.normal;
    if (!make_unit(n) || !(n.z > 0))
        throw UsageError(
            "--normal", "", "a normal of the upper hemisphere, Z > 0",
            fmt::format("{:g},{:g},{:g}", request.normal.x, request.normal.y, request.normal.z));
    ValueTable table;
    table.at.n = {n.x, n.y, n.z};
    table.at.f0 = request.values.is_set("f0") ? request.values.real("f0") : 1.0;
    read_csv_rows(
        request.input, kValueColumns, [&](const CsvRow& row) { add_value_row(row, table); },
        progress);
    if (table.f.empty())
        throw Error(source_name(request.input), "", "a row of values below the header", "none");
    return table;
}

verify::Subject subject_asked(const VerifyCsvRequest& request) {
    const int brdf = static_cast<int>(request.brdf), method = static_cast<int>(request.method);
    if (!f64::brdf_takes_method(brdf, method))
        throw UsageError("--method", "",
                         fmt::format("a method that has a meaning for {}, which has no half "
                                     "vectors to move",
                                     name_of(request.brdf)),
                         name_of(request.method));
    const int mdf = f64::brdf_mdf(brdf, static_cast<int>(request.mdf));
    const RoughnessPair pair = roughness_pair(request.values);
    const auto [p0, p1] = mdf == f64::kMdfAshikhminShirley ? pair.as_exponents() : pair.as_alpha();
    return {brdf, mdf, p0, p1, method};
}

std::vector<std::string> warnings_of(const ValueTable& table, const std::string& input) {
    std::vector<std::string> warnings;
    if (table.normalized > 0)
        warnings.push_back(
            fmt::format("{}: {} with a direction that is not quite unit; it is normalized", input,
                        plural(table.normalized, "row")));
    if (table.negative > 0)
        warnings.push_back(fmt::format(
            "{}: {} with a negative f, which no surface reflects; it is compared as it is", input,
            plural(table.negative, "row")));
    return warnings;
}

std::string direction_text(vec3 v) {
    return fmt::format("({:.4f}, {:.4f}, {:.4f})", v.x, v.y, v.z);
}

std::string comparison_text(const ValueTable& table, const Comparison& c,
                            const std::string& words) {
    const vec3 theirs = table.at.wi[c.brightest], ours = table.at.wi[c.our_brightest];
    std::string text = fmt::format("rows                {}\n", table.f.size());
    text += fmt::format("relative RMS error  {:.4g}\n", c.error);
    text += fmt::format("largest difference  {:.4g} at {}: theirs {:.6g}, ours {:.6g}\n",
                        std::abs(table.f[c.worst] - c.ours_at_worst), table.place(c.worst),
                        table.f[c.worst], c.ours_at_worst);
    text += std::isnan(c.energy_ratio)
                ? "energy              ours is 0 in every row\n"
                : fmt::format("energy              {:.4g} of ours\n", c.energy_ratio);
    text += fmt::format("brightest           theirs under light from {}, {}\n",
                        direction_text(theirs), table.place(c.brightest));
    text += fmt::format("                    ours under light from {}, {}; {:.1f} degrees apart\n",
                        direction_text(ours), table.place(c.our_brightest),
                        verify::angle_deg(theirs, ours));
    return text + "verdict             " + words + "\n";
}

nlohmann::ordered_json place_entry(const ValueTable& table, std::size_t row) {
    const vec3 wi = table.at.wi[row], wo = table.at.wo[row];
    return {{"row", row + 1},
            {"line", table.lines[row]},
            {"to_light", {wi.x, wi.y, wi.z}},
            {"to_eye", {wo.x, wo.y, wo.z}}};
}

std::string comparison_json(const ValueTable& table, const Comparison& c, const std::string& words,
                            const std::string& command) {
    const auto number = [](double value) {
        return std::isfinite(value) ? nlohmann::ordered_json(value)
                                    : nlohmann::ordered_json(nullptr);
    };
    const verify::Subject& fitted = c.fit.guess.subject;
    nlohmann::ordered_json out;
    out["version"] = version();
    out["command"] = command;
    out["rows"] = table.f.size();
    out["relative_rms"] = number(c.error);
    out["energy_ratio"] = number(c.energy_ratio);
    out["largest_difference"] = place_entry(table, c.worst);
    out["largest_difference"]["theirs"] = table.f[c.worst];
    out["largest_difference"]["ours"] = c.ours_at_worst;
    out["brightest_theirs"] = place_entry(table, c.brightest);
    out["brightest_ours"] = place_entry(table, c.our_brightest);
    out["brightest_apart_deg"] =
        verify::angle_deg(table.at.wi[c.brightest], table.at.wi[c.our_brightest]);
    out["fit"] = {{"method", name_of(static_cast<Method>(fitted.method))},
                  {"brdf", name_of(static_cast<Brdf>(fitted.brdf))},
                  {"mdf", name_of(static_cast<Mdf>(fitted.mdf))},
                  {"alphas", verify::words_of_slip(c.fit.guess.alpha)},
                  {"value", verify::words_of_slip(c.fit.guess.value)},
                  {"scale", c.fit.guess.scale},
                  {"relative_rms", number(c.fit.error)}};
    out["alike"] = nlohmann::ordered_json::array();
    for (const int method : c.alike) out["alike"].push_back(name_of(static_cast<Method>(method)));
    out["verdict"] = words;
    return out.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

VerifyCsvReport verify_csv(const VerifyCsvRequest& request, const Progress& progress) {
    const verify::Subject asked = subject_asked(request);
    const ValueTable table = read_values(request, progress);
    progress.step("compare", 0.0);
    const Comparison comparison = verify::compare(asked, table.at, table.f);
    progress.step("compare", 1.0);
    const std::string words = verify::verdict(asked, table.at, comparison);
    VerifyCsvReport report;
    report.error = comparison.error;
    report.warnings = warnings_of(table, source_name(request.input));
    report.text = request.json ? comparison_json(table, comparison, words, request.command)
                               : comparison_text(table, comparison, words);
    return report;
}

}  // namespace burnish
