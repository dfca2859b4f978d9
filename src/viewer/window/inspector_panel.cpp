// The lobe inspector: numbers, disks, lobes in space and polar cuts of the picked point.
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "viewer/window/panels.hpp"

namespace burnish::viewer {
namespace {

// Textures of the disks; made anew when the report changes.
class Disks {
  public:
    unsigned texture(std::size_t index, const LobeDisk& disk) {
        while (textures_.size() <= index) {
            textures_.push_back(0);
            made_of_.push_back({});
        }
        if (made_of_[index] == disk.D.pixels && textures_[index] != 0) return textures_[index];
        made_of_[index] = disk.D.pixels;
        upload(textures_[index], disk);
        return textures_[index];
    }

  private:
    // Fourth root, so that the foot of a narrow lobe is seen beside its peak; a warm scale.
    static void upload(unsigned& texture, const LobeDisk& disk) {
        const auto side = static_cast<std::size_t>(disk.D.width);
        std::vector<std::uint8_t> rgba(side * side * 4);
        for (std::size_t i = 0; i < side * side; ++i) {
            const auto d = static_cast<double>(disk.D.pixels[i]);
            const bool inside = std::isfinite(d);
            const double v =
                inside && disk.most > 0 ? std::pow(std::clamp(d / disk.most, 0.0, 1.0), 0.25) : 0;
            const auto byte = [](double x) {
                return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0, 1.0)));
            };
            rgba[4 * i] = byte(0.06 + 1.1 * v);
            rgba[4 * i + 1] = byte(0.06 + 1.0 * v * v);
            rgba[4 * i + 2] = byte(0.12 + 0.35 * v * (1 - v) + 0.8 * v * v * v * v);
            // Cells of a table that were not measured are shown darker.
            if (i < disk.origin.size() && disk.origin[i] && *disk.origin[i] != NdfOrigin::measured)
                for (std::size_t c = 0; c < 3; ++c)
                    rgba[4 * i + c] = static_cast<std::uint8_t>(rgba[4 * i + c] * 0.6);
            rgba[4 * i + 3] = inside ? 255 : 0;
        }
        if (texture == 0) glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, disk.D.width, disk.D.height, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, rgba.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glBindTexture(GL_TEXTURE_2D, 0);
    }

    std::vector<unsigned> textures_;
    std::vector<std::vector<float>> made_of_;
};

Disks& disks() {
    static Disks all;
    return all;
}

// Half vectors on the disk: n~ (white ring), the light's half vector (yellow dot).
void draw_disk(const LobeReport& report, const MethodReport& m, std::size_t index, float side) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const unsigned texture = disks().texture(index, m.disk);
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), {side, side});
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "D over half vectors seen from above (fourth root)\nring: n~, dot: half vector "
            "of the light, cross: peak");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const auto place = [&](const glm::dvec3& h) {
        return ImVec2{at.x + side * static_cast<float>(0.5 + 0.5 * h.x),
                      at.y + side * static_cast<float>(0.5 - 0.5 * h.y)};
    };
    draw.AddCircle({at.x + side / 2, at.y + side / 2}, side / 2, IM_COL32(150, 150, 150, 200), 48);
    draw.AddCircle(place(report.normal), 5, IM_COL32(255, 255, 255, 255), 0, 1.5f);
    draw.AddCircleFilled(place(report.half), 3, IM_COL32(255, 225, 120, 255));
    const ImVec2 p = place(m.peak);
    draw.AddLine({p.x - 4, p.y}, {p.x + 4, p.y}, IM_COL32(120, 220, 255, 255));
    draw.AddLine({p.x, p.y - 4}, {p.x, p.y + 4}, IM_COL32(120, 220, 255, 255));
}

// The lobe of the light in space, seen from the side and a little from above.
void draw_lobe(const LobeReport& report, const MethodReport& m, float side) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side});
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "reflection of the selected light: radius f cos\nwhite: n~, yellow: light, blue: eye");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const auto place = [&](glm::dvec3 v) {
        // x to the right, z up, y into the picture: seen from 25 degrees above.
        const double up = 0.906 * v.z + 0.423 * v.y;
        return ImVec2{at.x + side * static_cast<float>(0.5 + 0.46 * v.x),
                      at.y + side * static_cast<float>(0.78 - 0.46 * up)};
    };
    std::vector<ImVec2> circle;
    for (int i = 0; i < 48; ++i) {
        const double a = 2 * 3.14159265358979 * i / 48;
        circle.push_back(place({std::cos(a), std::sin(a), 0}));
    }
    draw.AddPolyline(circle.data(), 48, IM_COL32(110, 110, 110, 255), ImDrawFlags_Closed, 1);
    const double scale = m.mesh.most > 0 ? 1.0 / m.mesh.most : 0;
    const auto vertex = [&](int row, int column) {
        const glm::vec3 v =
            m.mesh.vertices[static_cast<std::size_t>(row * m.mesh.columns + column)];
        return place(glm::dvec3(v) * scale);
    };
    const ImU32 line = IM_COL32(235, 160, 80, 150);
    for (int column = 0; column < m.mesh.columns; column += 8) {
        std::vector<ImVec2> points;
        for (int row = 0; row < m.mesh.rows; ++row) points.push_back(vertex(row, column));
        draw.AddPolyline(points.data(), static_cast<int>(points.size()), line, 0, 1);
    }
    for (int row = 4; row < m.mesh.rows; row += 6) {
        std::vector<ImVec2> points;
        for (int column = 0; column < m.mesh.columns; column += 2)
            points.push_back(vertex(row, column));
        draw.AddPolyline(points.data(), static_cast<int>(points.size()), line, ImDrawFlags_Closed,
                         1);
    }
    const auto arrow = [&](glm::dvec3 v, ImU32 color) {
        draw.AddLine(place({0, 0, 0}), place(v), color, 1.5f);
        draw.AddCircleFilled(place(v), 3, color);
    };
    arrow(report.normal, IM_COL32(255, 255, 255, 255));
    arrow(report.to_light, IM_COL32(255, 225, 120, 255));
    arrow(report.to_eye, IM_COL32(120, 190, 255, 255));
}

void draw_cut(const MethodReport& m, float width) {
    const float height = 0.5f * width;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy({width, height});
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("f cos in the plane of incidence, about n~; yellow: the light");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 origin{at.x + width / 2, at.y + height};
    const auto place = [&](double angle, double radius) {
        const float r = 0.48f * width * static_cast<float>(radius);
        return ImVec2{origin.x + r * static_cast<float>(std::sin(angle)),
                      origin.y - r * static_cast<float>(std::cos(angle))};
    };
    std::vector<ImVec2> rim;
    for (int i = -45; i <= 45; ++i) rim.push_back(place(i * 3.14159265358979 / 90, 1));
    draw.AddPolyline(rim.data(), static_cast<int>(rim.size()), IM_COL32(90, 90, 90, 255), 0, 1);
    draw.AddLine(place(-1.5707963, 1), place(1.5707963, 1), IM_COL32(90, 90, 90, 255));
    draw.AddLine(origin, place(m.cuts.light_angle_rad, 1), IM_COL32(255, 225, 120, 255), 1.5f);
    if (!(m.cuts.most > 0)) return;
    std::vector<ImVec2> points;
    for (const PolarPoint& p : m.cuts.incidence)
        points.push_back(place(p.angle_rad, p.radius / m.cuts.most));
    draw.AddPolyline(points.data(), static_cast<int>(points.size()), IM_COL32(235, 160, 80, 255), 0,
                     1.8f);
}

void number_row(const char* label, const std::string& text) {
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine(ImGui::GetFontSize() * 8);
    ImGui::TextUnformatted(text.c_str());
}

std::string rgb(const glm::dvec3& v) {
    return v.x == v.y && v.y == v.z ? fmt::format("{:.4g}", v.x)
                                    : fmt::format("{:.3g} {:.3g} {:.3g}", v.x, v.y, v.z);
}

void point_numbers(const LobeReport& r) {
    number_row("n~", fmt::format("{:.3f} {:.3f} {:.3f}", r.normal.x, r.normal.y, r.normal.z));
    number_row("tilt", fmt::format("{:.1f} deg, |d| {:.3f}", r.tilt_deg, r.tilt));
    if (r.surface.exemplar) {
        number_row("exemplar",
                   fmt::format("{} of texel {}, {}", r.surface.exemplar->exemplar,
                               r.surface.exemplar->texel.x, r.surface.exemplar->texel.y));
        number_row("cells", fmt::format("{:.0f} % measured, {:.0f} % completed",
                                        100 * r.surface.exemplar->measured,
                                        100 * r.surface.exemplar->completed));
    } else {
        number_row("alpha", fmt::format("{:.3f} along, {:.3f} across", r.alpha.x, r.alpha.y));
    }
    if (r.surface.yarn)
        number_row("yarn",
                   fmt::format("{}, end {}, pick {}", r.surface.yarn->warp ? "warp" : "weft",
                               r.surface.yarn->end + 1, r.surface.yarn->pick + 1));
    number_row("grain", r.grain_deg ? fmt::format("{:.1f} deg from the tangent", *r.grain_deg)
                                    : "isotropic");
}

void method_block(App& app, const LobeReport& r, const MethodReport& m, std::size_t i) {
    ImGui::PushID(static_cast<int>(i));
    ImGui::Separator();
    ImGui::TextUnformatted(std::string(name_of(m.method)).c_str());
    if (!m.lobe.has_meaning()) {
        ImGui::TextDisabled("no meaning for this model");
        return ImGui::PopID();
    }
    ImGui::SameLine();
    const bool off = m.highlight_error_deg > 1.0;
    ImGui::TextColored(off ? ImVec4{1.0f, 0.7f, 0.4f, 1} : ImVec4{0.6f, 0.9f, 0.6f, 1},
                       "highlight %.1f deg off", m.highlight_error_deg);
    const float side = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    draw_disk(r, m, i, side);
    ImGui::SameLine();
    draw_lobe(r, m, side);
    draw_cut(m, ImGui::GetContentRegionAvail().x);
    number_row("D, G", fmt::format("{:.4g}, {:.3f}", m.D, m.G));
    number_row("F", rgb(m.F));
    number_row("f", rgb(m.f));
    number_row("f cos", rgb(m.f_cos));
    if (i < app.picked->albedos.size()) {
        const LobeAlbedo& a = app.picked->albedos[i];
        const std::string text =
            fmt::format("{:.2f} {:.2f} {:.2f} +- {:.4f}", a.whole.x, a.whole.y, a.whole.z, a.error);
        if (a.gains_energy)
            ImGui::TextColored({1.0f, 0.45f, 0.4f, 1}, "albedo %s: gains energy", text.c_str());
        else
            number_row("albedo", text);
    }
    if (ImGui::SmallButton("copy rows for brdf eval")) {
        if (const auto rows = csv_rows(r, m)) {
            app.window.set_clipboard(csv_header() + "\n" + *rows);
            app.say("copied rows for `burnish brdf eval`");
        } else if (const auto row = mdf_csv_row(r, m)) {
            app.window.set_clipboard(mdf_csv_header() + "\n" + *row);
            app.say("copied a row for `burnish mdf eval`: brdf eval has no row for this method");
        } else {
            app.say("no row of numbers says the same as this lobe");
        }
    }
    ImGui::PopID();
}

}  // namespace

void inspector_panel(App& app) {
    if (!app.picked) {
        ImGui::TextWrapped(
            "Click on the surface: this shows its lobe there, under several methods.");
        return;
    }
    const LobeReport& report = app.picked->report;
    const std::string& material =
        app.scene().materials[static_cast<std::size_t>(app.picked->hit.material)].name;
    if (!material.empty()) ImGui::TextDisabled("%s", material.c_str());
    point_numbers(report);
    for (std::size_t i = 0; i < report.methods.size(); ++i)
        method_block(app, report, report.methods[i], i);
}

}  // namespace burnish::viewer
