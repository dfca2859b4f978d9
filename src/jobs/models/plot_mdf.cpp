#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "burnish/error.hpp"
#include "jobs/models/plot.hpp"
#include "jobs/models/plot_common.hpp"

namespace burnish {
namespace {

using plot::Figure;
using plot::MdfSubject;
using plot::Panel;
using plot::PanelRow;

constexpr std::array<std::string_view, 3> kMdfKinds = {"disk", "grid", "profile"};
constexpr std::size_t kMostMdfColumns = 5;  // a figure of 1400 px, the width of a screen
constexpr double kDiskSide = 260;

constexpr std::string_view kAboutDisk =
    "Half vectors (h_{x}, h_{y}) in the unperturbed tangent space. The cross marks the perturbed "
    "normal \u00f1. Colors: Ember, even steps in OKLab, black to pale yellow.";
constexpr std::string_view kAboutGrid =
    "Rings every 0.2 and rays every 15\u00b0 of the disk of half vectors before (grey) and after "
    "(blue). C goes to C\u2032 = \u00f1, p to p\u2032; R is where the ray from C through p meets "
    "the rim. Drawn is the map whose inverse D is evaluated with; of deform-smooth that is the "
    "inverse of K11 Eq 5, not Eq 4.";
constexpr std::string_view kAboutProfile =
    "D along the two lines through \u00f1 that are parallel to the axes of the disk of half "
    "vectors.";

MdfSubject subject_of(const MdfPlotRequest& request, Mdf mdf, Method method,
                      Direction<double> normal) {
    const RoughnessPair pair = roughness_pair(request.values);
    const auto [p0, p1] = mdf == Mdf::ashikhmin_shirley ? pair.as_exponents() : pair.as_alpha();
    return {mdf, p0, p1, method, normal, request.normalization};
}

std::string lobes_text(const MdfPlotRequest& request) {
    std::vector<std::string> lobes;
    for (const Mdf mdf : request.mdfs) {
        const MdfSubject s = subject_of(request, mdf, Method::none, {0, 0, 1});
        lobes.push_back(plot::lobe_text(mdf, s.p0, s.p1));
    }
    return fmt::format("{}", fmt::join(lobes, "; "));
}

double side_of(const MdfPlotRequest& request) {
    return request.output.panel_px > 0 ? request.output.panel_px : kDiskSide;
}

Panel disk_of(const MdfPlotRequest& request, const MdfSubject& subject, const plot::Scale& scale,
              std::string title) {
    Panel panel = plot::disk_panel(subject, scale, std::move(title), side_of(request));
    panel.note = "peak " + plot::number_text(plot::peak_of(subject).D);
    return panel;
}

// Adds one row: the subjects with their titles, on one scale.
void add_disk_row(const MdfPlotRequest& request, const std::vector<MdfSubject>& subjects,
                  const std::vector<std::string>& titles, const std::string& label,
                  Figure& figure) {
    PanelRow row{label, {}, plot::disk_bar(subjects, request.scale, request.high)};
    for (std::size_t i = 0; i < subjects.size(); ++i)
        row.panels.push_back(disk_of(request, subjects[i], row.bar->scale, titles[i]));
    add_rows(figure, row, kMostMdfColumns);
}

void add_disks(const MdfPlotRequest& request, Figure& figure) {
    const bool columns_are_normals = request.methods.size() == 1 && request.normals.size() > 1;
    for (const Mdf mdf : request.mdfs) {
        const std::string name = request.mdfs.size() > 1 ? std::string(name_of(mdf)) : "";
        std::vector<MdfSubject> subjects;
        std::vector<std::string> titles;
        if (columns_are_normals) {
            for (const Direction<double> n : request.normals) {
                subjects.push_back(subject_of(request, mdf, request.methods.front(), n));
                titles.push_back(plot::normal_text(n));
            }
            add_disk_row(request, subjects, titles, name, figure);
            continue;
        }
        for (const Direction<double> n : request.normals) {
            subjects.clear();
            titles.clear();
            for (const Method method : request.methods) {
                subjects.push_back(subject_of(request, mdf, method, n));
                titles.emplace_back(name_of(method));
            }
            std::string label = name;
            if (request.normals.size() > 1)
                label += (name.empty() ? "" : ", ") + plot::normal_text(n);
            add_disk_row(request, subjects, titles, label, figure);
        }
    }
}

void add_grids(const MdfPlotRequest& request, Figure& figure) {
    for (const Mdf mdf : request.mdfs) {
        for (const Direction<double> n : request.normals) {
            for (const Method method : request.methods) {
                const MdfSubject subject = subject_of(request, mdf, method, n);
                plot::forward(subject, {0, 0, 1});  // throws if the subject has no map
                MdfSubject original = subject;
                original.method = Method::none;
                const MdfSubject both[] = {original, subject};
                PanelRow row{"", {}, plot::disk_bar(both, request.scale, request.high)};
                if (request.mdfs.size() > 1) row.label = name_of(mdf);
                if (request.normals.size() > 1)
                    row.label += (row.label.empty() ? "" : ", ") + plot::normal_text(n);
                row.panels =
                    plot::grid_panels(subject, row.bar->scale, request.point, side_of(request));
                figure.rows.push_back(std::move(row));
            }
        }
    }
}

void add_profiles(const MdfPlotRequest& request, Figure& figure) {
    for (const Direction<double> n : request.normals) {
        std::vector<MdfSubject> subjects;
        std::vector<std::string> labels;
        for (const Mdf mdf : request.mdfs) {
            for (const Method method : request.methods) {
                subjects.push_back(subject_of(request, mdf, method, n));
                labels.push_back(request.mdfs.size() > 1
                                     ? fmt::format("{}, {}", name_of(mdf), name_of(method))
                                     : std::string(name_of(method)));
            }
        }
        plot::Scale scale = plot::disk_bar(subjects, request.scale, request.high).scale;
        if (!request.high) scale.high *= 1.08;
        PanelRow row;
        if (request.normals.size() > 1) row.label = plot::normal_text(n);
        row.panels = {plot::profile_panel(subjects, labels, plot::ProfileLine::along_x, scale,
                                          "along x through \u00f1"),
                      plot::profile_panel(subjects, labels, plot::ProfileLine::along_y, scale,
                                          "along y through \u00f1")};
        if (request.output.panel_px > 0)
            for (Panel& panel : row.panels) panel.width = request.output.panel_px;
        figure.rows.push_back(std::move(row));
        figure.legend.clear();
        for (std::size_t i = 0; i < labels.size(); ++i)
            figure.legend.push_back({labels[i], plot::series_color(i), plot::series_dash(i)});
    }
}

// Checks the request before any evaluation.
void check(const MdfPlotRequest& request) {
    const auto require = [](bool good, const char* flag, const char* expected) {
        if (!good) throw UsageError(flag, "", expected, "none");
    };
    require(!request.mdfs.empty(), "--mdf", "at least one distribution");
    require(!request.methods.empty(), "--method", "at least one method");
    require(!request.normals.empty(), "--normal", "at least one normal");
    const std::size_t each = request.kind == MdfPlotKind::grid ? 3 : 1;
    const std::size_t panels =
        each * request.mdfs.size() * request.methods.size() * request.normals.size();
    if (panels > plot::kMostPanels)
        throw UsageError("--method", "",
                         fmt::format("at most {} panels in a figure", plot::kMostPanels),
                         fmt::format("{}", panels));
    if (std::hypot(request.point.x, request.point.y) >= 1)
        throw UsageError("--point", "", "a point inside the unit disk",
                         fmt::format("{:g},{:g}", request.point.x, request.point.y));
}

plot::Metadata parameters_of(const MdfPlotRequest& request) {
    std::vector<std::string_view> methods;
    for (const Method method : request.methods) methods.push_back(name_of(method));
    std::vector<std::string> normals;
    for (const Direction<double> n : request.normals)
        normals.push_back(fmt::format("{:.9g},{:.9g},{:.9g}", n.x, n.y, n.z));
    return {
        {"burnish:mdf", lobes_text(request)},
        {"burnish:method", fmt::format("{}", fmt::join(methods, ","))},
        {"burnish:normal", fmt::format("{}", fmt::join(normals, " "))},
        {"burnish:normalization",
         std::string(plot::normalization_names()[static_cast<std::size_t>(request.normalization)])},
        {"burnish:scale",
         std::string(plot::scale_names()[static_cast<std::size_t>(request.scale)])}};
}

}  // namespace

std::span<const std::string_view> mdf_plot_kind_names() {
    return kMdfKinds;
}

Figure mdf_figure(const MdfPlotRequest& request) {
    check(request);
    Figure figure;
    figure.title = lobes_text(request);
    if (request.normals.size() == 1) figure.title += "; " + plot::normal_text(request.normals[0]);
    if (request.kind == MdfPlotKind::disk) {
        if (request.methods.size() == 1 && request.normals.size() > 1)
            figure.title += fmt::format("; {}", name_of(request.methods[0]));
        add_disks(request, figure);
        figure.caption = kAboutDisk;
    } else if (request.kind == MdfPlotKind::grid) {
        add_grids(request, figure);
        figure.caption = kAboutGrid;
    } else {
        add_profiles(request, figure);
        figure.caption = kAboutProfile;
    }
    return figure;
}

void plot_mdf(const MdfPlotRequest& request, const Progress& progress) {
    plot::require_figure_path(request.output.path);
    write_plot(mdf_figure(request), request.output, parameters_of(request), progress);
}

}  // namespace burnish
