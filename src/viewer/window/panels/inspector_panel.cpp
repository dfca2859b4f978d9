// The lobe inspector: numbers and figures of the picked point, the methods side by side.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "viewer/window/panels.hpp"
#include "viewer/window/panels/lobe_figures.hpp"

namespace burnish::viewer {
namespace {

const ImVec4 kBad{1.0f, 0.45f, 0.4f, 1}, kOff{1.0f, 0.7f, 0.4f, 1}, kGood{0.6f, 0.9f, 0.6f, 1};

std::string number(double v) {
    return std::isfinite(v) ? fmt::format("{:.4g}", v) : "-";
}

void point_row(const char* label, const std::string& text) {
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine(ImGui::GetFontSize() * 5.5f);
    ImGui::TextUnformatted(text.c_str());
}

void point_rows(const App& app) {
    const LobeReport& r = app.picked->report;
    point_row("material", material_name(app.scene(), app.picked->hit.material));
    point_row("n~", fmt::format("{:.3f} {:.3f} {:.3f}, tilt {:.1f} deg, |d| {:.3f}", r.normal.x,
                                r.normal.y, r.normal.z, r.tilt_deg, r.tilt));
    if (r.surface.under_coat || r.surface.under_sheen)
        point_row("layers", fmt::format("the numbers are those of the surface below the {}",
                                        !r.surface.under_sheen  ? "coat"
                                        : !r.surface.under_coat ? "sheen"
                                                                : "coat and the sheen"));
    if (app.scene().lights.empty())
        point_row("light", "none in the scene: as if one shone along n");
    else
        point_row("light", fmt::format("{} of {}", app.light + 1, app.scene().lights.size()));
    if (r.surface.exemplar && r.surface.exemplar->exemplar < 0)
        point_row("exemplar", "none: this texel was not measured");
    else if (r.surface.exemplar)
        point_row("exemplar",
                  fmt::format("{} of {}, texel {}, {}", r.surface.exemplar->exemplar + 1,
                              r.surface.exemplar->material->exemplars, r.surface.exemplar->texel.x,
                              r.surface.exemplar->texel.y));
    if (r.surface.yarn)
        point_row("yarn", fmt::format("{}, end {}, pick {}", r.surface.yarn->warp ? "warp" : "weft",
                                      r.surface.yarn->end + 1, r.surface.yarn->pick + 1));
}

// --- the table of the methods ---------------------------------------------------------------------

// One row of the table; `cell` draws the cell of method number i.
void row(const char* label, const char* tip, const LobeReport& report,
         const std::function<void(std::size_t)>& cell) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", label);
    if (tip[0] != '\0' && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tip);
    for (std::size_t i = 0; i < report.methods.size(); ++i) {
        ImGui::TableNextColumn();
        if (report.methods[i].lobe.has_meaning())
            cell(i);
        else
            ImGui::TextDisabled("-");
    }
}

void text_row(const char* label, const char* tip, const LobeReport& report,
              const std::function<std::string(const MethodReport&)>& text) {
    row(label, tip, report,
        [&](std::size_t i) { ImGui::TextUnformatted(text(report.methods[i]).c_str()); });
}

bool is_gray(const glm::dvec3& v) {
    // Less than the digits that are shown.
    return std::abs(v.x - v.y) <= 1e-5 * std::abs(v.x) &&
           std::abs(v.z - v.y) <= 1e-5 * std::abs(v.x);
}

// A color in one row where every method's is gray, else in three.
void color_rows(const char* label, const char* tip, const LobeReport& report,
                const std::function<glm::dvec3(std::size_t)>& color) {
    bool gray = true;
    for (std::size_t i = 0; i < report.methods.size(); ++i) gray = gray && is_gray(color(i));
    static constexpr std::array<const char*, 3> kNames = {"r", "g", "b"};
    for (int c = 0; c < (gray ? 1 : 3); ++c) {
        const std::string name =
            gray ? label : fmt::format("{} {}", label, kNames[static_cast<std::size_t>(c)]);
        row(name.c_str(), tip, report,
            [&](std::size_t i) { ImGui::TextUnformatted(number(color(i)[c]).c_str()); });
    }
}

void normal_rows(const LobeReport& report) {
    static constexpr std::array<const char*, 3> kNames = {"n~ x", "n~ y", "n~ z"};
    for (int c = 0; c < 3; ++c)
        text_row(kNames[static_cast<std::size_t>(c)],
                 "the normal of the cosines: x along the tangent, z along the surface's normal",
                 report, [c](const MethodReport& m) { return fmt::format("{:.4f}", m.normal[c]); });
}

void energy_rows(const App& app, const LobeReport& report) {
    const std::vector<LobeAlbedo>& all = app.picked->albedos;
    if (all.size() != report.methods.size()) return;
    color_rows("energy", "share of light from everywhere that goes to the eye (albedo)", report,
               [&](std::size_t i) { return all[i].whole; });
    row("error", "the standard error of the energy", report, [&](std::size_t i) {
        if (all[i].gains_energy)
            ImGui::TextColored(kBad, "gains!");
        else
            ImGui::TextDisabled("+- %.4f", all[i].error);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s\nstandard error %.4f",
                              all[i].gains_energy ? "more than all of the light is reflected"
                                                  : "no energy is gained",
                              all[i].error);
    });
}

void copy_row(App& app, const LobeReport& r) {
    row("CSV", "rows that `burnish brdf eval` or `burnish mdf eval` evaluate to the same numbers",
        r, [&](std::size_t i) {
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::SmallButton("copy")) app.copy_lobe(i);
            ImGui::PopID();
        });
}

void number_table(App& app, const LobeReport& r) {
    const int columns = static_cast<int>(r.methods.size()) + 1;
    if (!ImGui::BeginTable("numbers", columns,
                           ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchSame |
                               ImGuiTableFlags_BordersInnerV))
        return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 4.4f);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    for (const MethodReport& m : r.methods) {
        ImGui::TableNextColumn();
        std::string name(name_of(m.method));
        const bool wide = ImGui::CalcTextSize(name.c_str()).x > ImGui::GetContentRegionAvail().x;
        if (const std::size_t dash = name.find('-'); wide && dash != name.npos)
            name.insert(dash + 1, "\n");
        ImGui::TextUnformatted(name.c_str());
    }
    row("highlight", "angle between the peak of the lobe and that of follow-grain", r,
        [&](std::size_t i) {
            const double off = r.methods[i].highlight_error_deg;
            ImGui::TextColored(off > 1 ? kOff : kGood, "%.1f deg off", off);
        });
    text_row("D", "the distribution at the light's half vector, per steradian", r,
             [](const MethodReport& m) { return number(m.D); });
    text_row("G", "masking and shadowing", r, [](const MethodReport& m) { return number(m.G); });
    color_rows("F", "Fresnel's reflectance", r, [&](std::size_t i) { return r.methods[i].F; });
    text_row("gain", "factor by light that facets reflect more than once, of the brightest channel",
             r, [](const MethodReport& m) {
                 return number(std::max({m.gain.x, m.gain.y, m.gain.z}));
             });
    color_rows("f", "the reflectance, with its diffuse term, per steradian", r,
               [&](std::size_t i) { return r.methods[i].f; });
    normal_rows(r);
    const bool table = r.surface.exemplar.has_value();
    text_row("alpha x", "roughness along the lobe's x axis", r, [&](const MethodReport&) {
        return table ? "table" : fmt::format("{:.4f}", r.alpha.x);
    });
    text_row("alpha y", "roughness along the lobe's y axis", r, [&](const MethodReport&) {
        return table ? "table" : fmt::format("{:.4f}", r.alpha.y);
    });
    text_row("grain",
             "direction of the groove as the method tilts it, from the tangent, seen from above", r,
             [](const MethodReport& m) {
                 if (!m.grain_deg) return std::string("none");
                 // 179.96 is nearly 0, not 180.
                 return fmt::format("{:.1f} deg",
                                    std::fmod(std::round(10 * *m.grain_deg), 1800) / 10);
             });
    energy_rows(app, r);
    copy_row(app, r);
    ImGui::EndTable();
}

// --- figures --------------------------------------------------------------------------------------

using Figure = void (*)(const Picked&, std::size_t, float, bool);

// The figures of all methods in a row. Under the mouse: the same large, with words.
void figure_row(const App& app, const char* title, const char* legend, Figure figure) {
    const std::vector<MethodReport>& methods = app.picked->report.methods;
    const auto scale = static_cast<float>(app.ui_scale);
    ImGui::Spacing();
    ImGui::TextDisabled("%s", title);
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const auto count = static_cast<float>(methods.size());
    const float side = std::floor((ImGui::GetContentRegionAvail().x - gap * (count - 1)) / count);
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        if (!methods[i].lobe.has_meaning()) {
            ImGui::Dummy({side, side});
            continue;
        }
        figure(*app.picked, i, side, false);
        if (!ImGui::IsItemHovered()) continue;
        ImGui::BeginTooltip();
        ImGui::TextUnformatted(std::string(name_of(methods[i].method)).c_str());
        figure(*app.picked, i, 340 * scale, true);
        ImGui::PushTextWrapPos(340 * scale);
        ImGui::TextDisabled("%s", legend);
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
}

}  // namespace

void inspector_panel(App& app) {
    if (!app.picked) {
        ImGui::TextWrapped(
            "Click on the surface: this shows its lobe there, under several methods.");
        return;
    }
    point_rows(app);
    number_table(app, app.picked->report);
    figure_row(
        app, "D over half vectors: ring n~, dot h of the light, cross peak",
        "D over half vectors, seen from above, fourth root. Lines: cells that were not measured.",
        disk_figure);
    figure_row(app, "the lobe in space: n~, h, l light, v eye",
               "f cos of the selected light in every direction to the eye, seen from the side. n~: "
               "normal, h: half vector, l: light, v: eye.",
               lobe_figure);
    figure_row(app, "cut in the plane of incidence",
               "f cos about n~; all methods on one scale. Yellow: the light.", cut_figure);
    if (!app.picked->report.surface.exemplar) return;
    ImGui::Spacing();
    ImGui::TextDisabled("the table of the exemplar");
    const auto scale = static_cast<float>(app.ui_scale);
    table_figure(*app.picked, std::floor(0.55f * ImGui::GetContentRegionAvail().x), scale);
}

}  // namespace burnish::viewer
