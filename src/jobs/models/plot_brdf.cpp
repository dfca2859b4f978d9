#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <numbers>

#include "burnish/error.hpp"
#include "burnish/f64.hpp"
#include "core/text.hpp"
#include "jobs/models/eval.hpp"
#include "jobs/models/measured_lobe.hpp"
#include "jobs/models/plot.hpp"
#include "jobs/models/plot_common.hpp"

namespace burnish {
namespace {

using plot::BrdfSubject;
using plot::Figure;
using plot::Panel;
using plot::PanelRow;

constexpr std::array<std::string_view, 3> kKinds = {"polar", "surface", "albedo"};
constexpr std::size_t kMostColumns = 4;
constexpr double kPolarWidth = 400, kSurfaceSide = 320;
constexpr std::string_view kFlag = "--brdf";

using Overrides = std::map<std::string, double, std::less<>>;

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(separator, start), text.size());
        parts.emplace_back(text.substr(start, end - start));
        start = end + 1;
    }
    return parts;
}

const BrdfModel& model_of(const BrdfPlotRequest& request, const std::string& name) {
    const auto index =
        static_cast<std::size_t>(index_of_name(brdf_table_names(), name, "model", kFlag));
    if (index < brdf_models().size()) return brdf_models()[index];
    return microfacet_model(static_cast<Mdf>(request.values.choice("mdf")), Smith::correlated);
}

std::vector<std::string_view> parameter_names(const BrdfModel& model) {
    std::vector<std::string_view> names;
    for (const ShapeParameter& parameter : model.parameters) names.push_back(parameter.name);
    return names;
}

// Parses "n=50", "ks=2" of "phong:n=50:ks=2", the words after the name.
Overrides overrides_of(const BrdfModel& model, const std::vector<std::string>& words) {
    Overrides overrides;
    const std::vector<std::string_view> names = parameter_names(model);
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::size_t equals = words[i].find('=');
        if (equals == std::string::npos)
            throw UsageError(kFlag, model.name, "name:parameter=number", shown(words[i]));
        const std::string name = words[i].substr(0, equals), text = words[i].substr(equals + 1);
        index_of_name(names, name, "parameter", fmt::format("{}: {}", kFlag, model.name));
        double value = 0;
        const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
            throw UsageError(kFlag, fmt::format("{}: {}", model.name, name), "a number",
                             shown(text));
        if (!overrides.emplace(name, value).second)
            throw UsageError(kFlag, fmt::format("{}: {}", model.name, name), "it once", "it twice");
    }
    return overrides;
}

// Default parameters of the models, derived from the roughness pair and F0.
class Defaults {
  public:
    Defaults(const BrdfPlotRequest& request, const Overrides& overrides)
        : overrides_(overrides),
          alpha_(roughness_pair(request.values).as_alpha()),
          e_(roughness_pair(request.values).as_exponents()),
          f0_(request.values.is_set("f0") ? request.values.real("f0") : 1.0) {}

    double of(const BrdfModel& model, std::string_view name) const {
        const auto found = overrides_.find(name);
        if (found != overrides_.end()) return found->second;
        const double m = std::sqrt(alpha_.first * alpha_.second);
        const double exponent = f64::exponent_from_alpha(m);
        if (name == "e_x") return e_.first;
        if (name == "e_y") return e_.second;
        if (name == "alpha_x") return alpha_.first;
        if (name == "alpha_y") return alpha_.second;
        if (name == "m") return m;
        if (name == "F0") return f0_;
        if (name == "n") return exponent;  // of lafortune and phong
        if (name == "ks") return scale(model);
        if (name == "Cx" || name == "Cy") return -1;  // lobe about the mirror direction
        if (name == "sigma") return 1;
        // Limited to 1000 wavelengths, the upper end of the model's range.
        if (name == "tau") return std::min(2 * of(model, "sigma") / m, 1000.0);
        return name == "Rs" ? 0 : 1;  // Cz, Rd
    }

  private:
    // 1; for a power of a cosine, the ks whose albedo is 1 at normal incidence.
    double scale(const BrdfModel& model) const {
        for (const ShapeParameter& p : model.parameters)
            if (p.name == std::string_view("n"))
                // Uses the clamped exponent that is drawn: a narrow pair gives one beyond the
                // model's range.
                return (std::clamp(of(model, p.name), p.low, p.high) + 2) / (2 * std::numbers::pi);
        return 1;
    }

    const Overrides& overrides_;
    std::pair<double, double> alpha_, e_;
    double f0_;
};

BrdfSubject measured_subject(const std::string& path) {
    BrdfSubject subject;
    subject.label = std::filesystem::path(path).stem().string();
    subject.measured = measured_reflection(std::make_shared<const RglBrdf>(RglBrdf::load(path)));
    return subject;
}

BrdfSubject subject_of(const BrdfPlotRequest& request, const std::string& text) {
    if (names_measured(text)) return measured_subject(text);
    const std::vector<std::string> words = split(text, ':');
    BrdfSubject subject;
    subject.model = &model_of(request, words.front());
    subject.label = subject.model->name;
    const Overrides overrides = overrides_of(*subject.model, words);
    const Defaults defaults(request, overrides);
    for (std::size_t i = 0; i < subject.model->parameters.size(); ++i) {
        const ShapeParameter& parameter = subject.model->parameters[i];
        const double value = defaults.of(*subject.model, parameter.name);
        // A default computed from a pair may be out of range and is clamped; a given value may not.
        subject.p[i] = std::clamp(value, parameter.low, parameter.high);
        if (overrides.contains(parameter.name) && subject.p[i] != value)
            throw UsageError(kFlag, fmt::format("{}: {}", subject.model->name, parameter.name),
                             fmt::format("a number from {} to {}", parameter.low, parameter.high),
                             fmt::format("{}", value));
    }
    return subject;
}

std::string caption_of(const std::vector<BrdfSubject>& subjects) {
    std::string text;
    for (const BrdfSubject& subject : subjects)
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ",
                            subject.model ? subject.model->name : std::string_view(subject.label),
                            plot::parameters_text(subject));
    return text + ".";
}

// What f of the lines is.
std::string about_f(const std::vector<BrdfSubject>& subjects) {
    const auto measured = [](const BrdfSubject& subject) { return !subject.model; };
    std::string text = "Specular f per steradian, without the cosine";
    if (std::any_of(subjects.begin(), subjects.end(), measured))
        text += fmt::format("; of a measured material all of f, its luminance, to {}\u00b0",
                            kMostShownDeg);
    return text + ". ";
}

std::string incidence_text(const BrdfPlotRequest& request, double incidence_deg) {
    std::string text = "light at " + plot::number_text(incidence_deg) + "\u00b0";
    if (request.azimuth_deg != 0)
        text += ", azimuth " + plot::number_text(request.azimuth_deg) + "\u00b0";
    return text;
}

void add_polar(const BrdfPlotRequest& request, const std::vector<BrdfSubject>& subjects,
               Figure& figure) {
    for (const plot::ScaleKind kind : request.scales) {
        PanelRow row;
        for (const double incidence : request.incidences_deg) {
            const plot::PolarPlot polar{subjects,        incidence, request.azimuth_deg,
                                        request.cut_deg, kind,      request.high};
            const double width = request.output.panel_px;
            row.panels.push_back(plot::polar_panel(polar, incidence_text(request, incidence),
                                                   width > 0 ? width : kPolarWidth));
        }
        add_rows(figure, row, kMostColumns);
    }
    figure.legend = plot::legend_of(subjects);
    figure.title = request.cut_deg ? fmt::format("Reflection in the cut at azimuth {}\u00b0",
                                                 plot::number_text(*request.cut_deg))
                                   : "Reflection in the plane of incidence";
    figure.caption = about_f(subjects) + caption_of(subjects);
}

void add_surfaces(const BrdfPlotRequest& request, const std::vector<BrdfSubject>& subjects,
                  Figure& figure) {
    for (const plot::ScaleKind kind : request.scales) {
        for (const double incidence : request.incidences_deg) {
            PanelRow row;
            if (request.incidences_deg.size() > 1) row.label = incidence_text(request, incidence);
            for (const BrdfSubject& subject : subjects)
                row.panels.push_back(plot::surface_panel(
                    subject, incidence, request.azimuth_deg, kind, request.view, subject.label,
                    request.output.panel_px > 0 ? request.output.panel_px : kSurfaceSide));
            add_rows(figure, row, kMostColumns);
        }
    }
    figure.title = "Lobes over the hemisphere";
    if (request.incidences_deg.size() == 1)
        figure.title += ", " + incidence_text(request, request.incidences_deg.front());
    figure.caption =
        "Distance from the origin: f over the largest f of the panel. x tangent, y bitangent, n "
        "normal; dashes: the mirror direction; circles at quarters of the radius. " +
        caption_of(subjects);
}

void add_albedo(const BrdfPlotRequest& request, const std::vector<BrdfSubject>& subjects,
                Figure& figure) {
    PanelRow row;
    row.panels = {plot::albedo_panel(subjects, request.azimuth_deg, "light along x"),
                  plot::albedo_panel(subjects, request.azimuth_deg + 90, "light along y")};
    if (request.azimuth_deg != 0) {
        row.panels[0].title =
            fmt::format("light at azimuth {}\u00b0", plot::number_text(request.azimuth_deg));
        row.panels[1].title =
            fmt::format("light at azimuth {}\u00b0", plot::number_text(request.azimuth_deg + 90));
    }
    if (request.output.panel_px > 0)
        for (Panel& panel : row.panels) panel.width = request.output.panel_px;
    figure.rows.push_back(std::move(row));
    figure.legend = plot::legend_of(subjects);
    figure.title = "Albedo over the angle of incidence";
    figure.caption =
        "Share of the light that leaves, of a white surface where F0 and ks are 1. "
        "Above 1 there is energy from nowhere. " +
        caption_of(subjects);
}

void check(const BrdfPlotRequest& request) {
    const auto require = [](bool good, const char* flag, const char* expected) {
        if (!good) throw UsageError(flag, "", expected, "none");
    };
    require(!request.brdfs.empty(), "--brdf", "at least one model");
    require(!request.scales.empty(), "--scale", "at least one scale");
    require(!request.incidences_deg.empty(), "--incidence", "at least one angle");
    const std::size_t each = request.kind == BrdfPlotKind::surface ? request.brdfs.size() : 1;
    const std::size_t panels = each * request.scales.size() * request.incidences_deg.size();
    if (request.kind != BrdfPlotKind::albedo && panels > plot::kMostPanels)
        throw UsageError(kFlag, "", fmt::format("at most {} panels in a figure", plot::kMostPanels),
                         fmt::format("{}", panels));
    if (request.kind != BrdfPlotKind::surface && request.brdfs.size() > 21)
        throw UsageError(kFlag, "", "at most 21 lines that can be told apart",
                         std::to_string(request.brdfs.size()));
}

}  // namespace

std::span<const std::string_view> brdf_plot_kind_names() {
    return kKinds;
}

std::vector<BrdfSubject> brdf_subjects(const BrdfPlotRequest& request) {
    std::vector<BrdfSubject> subjects;
    for (const std::string& text : request.brdfs) subjects.push_back(subject_of(request, text));
    for (BrdfSubject& subject : subjects) {
        if (!subject.model) continue;
        const auto same = [&](const BrdfSubject& other) { return other.model == subject.model; };
        if (std::count_if(subjects.begin(), subjects.end(), same) > 1)
            subject.label =
                fmt::format("{} ({})", subject.model->name, plot::parameters_text(subject));
    }
    return subjects;
}

namespace {

Figure figure_of(const BrdfPlotRequest& request, const std::vector<BrdfSubject>& subjects) {
    Figure figure;
    if (request.kind == BrdfPlotKind::polar) {
        add_polar(request, subjects, figure);
    } else if (request.kind == BrdfPlotKind::surface) {
        add_surfaces(request, subjects, figure);
    } else {
        add_albedo(request, subjects, figure);
    }
    return figure;
}

}  // namespace

Figure brdf_figure(const BrdfPlotRequest& request) {
    check(request);
    return figure_of(request, brdf_subjects(request));
}

void plot_brdf(const BrdfPlotRequest& request, const Progress& progress) {
    plot::require_figure_path(request.output.path);
    check(request);
    const std::vector<BrdfSubject> subjects = brdf_subjects(request);
    const plot::Metadata parameters = {
        {"burnish:brdf", caption_of(subjects)},
        {"burnish:incidence_deg", fmt::format("{}", fmt::join(request.incidences_deg, ","))},
        {"burnish:azimuth_deg", fmt::format("{}", request.azimuth_deg)}};
    write_plot(figure_of(request, subjects), request.output, parameters, progress);
}

}  // namespace burnish
