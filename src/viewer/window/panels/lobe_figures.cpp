#include "viewer/window/panels/lobe_figures.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "viewer/inspect/table_map.hpp"

namespace burnish::viewer {
namespace {

constexpr ImU32 kWhite = IM_COL32(255, 255, 255, 255), kYellow = IM_COL32(255, 225, 120, 255),
                kBlue = IM_COL32(130, 195, 255, 255), kOrange = IM_COL32(240, 165, 85, 255),
                kRim = IM_COL32(120, 120, 120, 255);
// Device pixels of a unit of the interface; fonts have 14 units.
float unit() {
    return ImGui::GetFontSize() / 14.0f;
}
// Pixels between the lines that mark cells which were not measured.
int hatch() {
    return std::max(static_cast<int>(std::lround(6 * unit())), 3);
}

// --- textures -------------------------------------------------------------------------------------

struct Rgb {
    double red, green, blue;
};

// Fourth root, so that the foot of a narrow lobe is seen beside its peak; from dark to light, so that it reads
// without color.
Rgb heat(double D, double most) {
    const double v = most > 0 ? std::pow(std::clamp(D / most, 0.0, 1.0), 0.25) : 0;
    return {0.06 + 1.1 * v, 0.06 + v * v, 0.12 + 0.35 * v * (1 - v) + 0.8 * v * v * v * v};
}

std::uint8_t byte(double x) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0, 1.0)));
}

// A line is light on dark cells and dark on light ones.
Rgb over_line(Rgb c) {
    const bool dark = 0.3 * c.red + 0.6 * c.green + 0.1 * c.blue < 0.35;
    const double line = dark ? 0.62 : 0.0;
    return {0.3 * c.red + 0.7 * line, 0.3 * c.green + 0.7 * line, 0.3 * c.blue + 0.7 * line};
}

using Origins = std::vector<std::optional<NdfOrigin>>;

// A grid of cells enlarged to side x side pixels.
class Enlarged {
  public:
    Enlarged(const Image& D, const Origins& origin, int side)
        : D_(D), origin_(origin), side_(side) {}

    double value(int x, int y) const { return static_cast<double>(*D_.at(column(x), row(y))); }
    std::optional<NdfOrigin> origin(int x, int y) const {
        const std::size_t cell =
            static_cast<std::size_t>(row(y)) * static_cast<std::size_t>(D_.width) +
            static_cast<std::size_t>(column(x));
        return cell < origin_.size() ? origin_[cell] : std::nullopt;
    }
    // Lines over cells that were not measured, and around them, so that no cell is too small for a line.
    bool is_marked(int x, int y) const {
        const std::optional<NdfOrigin> here = origin(x, y);
        if (!here) return false;
        if (is_hatched(*here, x, y, hatch())) return true;
        const auto differs = [&](int nx, int ny) {
            if (nx >= side_ || ny >= side_) return false;
            const std::optional<NdfOrigin> there = origin(nx, ny);
            return there && *there != *here;
        };
        return differs(x + 1, y) || differs(x, y + 1);
    }

  private:
    int column(int x) const { return x * D_.width / side_; }
    int row(int y) const { return y * D_.height / side_; }

    const Image& D_;
    const Origins& origin_;
    int side_;
};

// In the pixels of the screen, so that the lines are as fine as those.
std::vector<std::uint8_t> pixels_of(const Image& D, double most, const Origins& origin, int side) {
    const Enlarged cells(D, origin, side);
    std::vector<std::uint8_t> rgba;
    rgba.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 4);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double d = cells.value(x, y);
            const bool inside = std::isfinite(d);
            Rgb c = heat(inside ? d : 0, most);
            if (cells.is_marked(x, y)) c = over_line(c);
            for (const double v : {c.red, c.green, c.blue, inside ? 1.0 : 0.0})
                rgba.push_back(byte(v));
        }
    return rgba;
}

// Textures of what was picked, each made once.
class Textures {
  public:
    template <typename Make>
    ImTextureID get(const Picked& picked, std::size_t figure, int side, const Make& make) {
        if (version_ != picked.version) {
            for (const auto& [key, texture] : made_) glDeleteTextures(1, &texture);
            made_.clear();
            version_ = picked.version;
        }
        unsigned& texture = made_[{figure, side}];
        if (texture == 0) texture = uploaded(make(), side);
        return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
    }

  private:
    static unsigned uploaded(const std::vector<std::uint8_t>& rgba, int side) {
        unsigned texture = 0;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     rgba.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glBindTexture(GL_TEXTURE_2D, 0);
        return texture;
    }

    std::uint64_t version_ = 0;
    std::map<std::pair<std::size_t, int>, unsigned> made_;
};

Textures& textures() {
    static Textures all;
    return all;
}

// --- marks ----------------------------------------------------------------------------------------

// A word beside a place, on the side away from `middle`.
void word(ImVec2 at, float middle, ImU32 color, const char* text) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    const float gap = 7 * unit(), x = at.x < middle ? at.x - size.x - gap : at.x + gap;
    ImGui::GetWindowDrawList()->AddText({x, at.y - size.y}, color, text);
}

constexpr ImU32 kShade = IM_COL32(0, 0, 0, 200);

void ring(ImVec2 at) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddCircle(at, 5 * unit(), kShade, 0, 3.5f * unit());
    draw.AddCircle(at, 5 * unit(), kWhite, 0, 1.5f * unit());
}

void dot(ImVec2 at) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddCircleFilled(at, 4.5f * unit(), kShade);
    draw.AddCircleFilled(at, 3 * unit(), kYellow);
}

void cross(ImVec2 at) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float arm = 5 * unit();
    for (const auto& [color, width] : {std::pair{kShade, 3.5f}, {kBlue, 1.5f}}) {
        draw.AddLine({at.x - arm, at.y}, {at.x + arm, at.y}, color, width * unit());
        draw.AddLine({at.x, at.y - arm}, {at.x, at.y + arm}, color, width * unit());
    }
}

// --- the table ------------------------------------------------------------------------------------

void swatch(NdfOrigin origin, const std::string& text) {
    const float side = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImGui::Dummy({side * 1.6f, side});
    const ImVec2 end{at.x + side * 1.6f, at.y + side};
    draw.AddRectFilled(at, end, IM_COL32(150, 95, 60, 255));
    const auto whole = [](float v) { return static_cast<int>(std::lround(v)); };
    for (int y = 0; y < whole(side); ++y)
        for (int x = 0; x < whole(side * 1.6f); ++x)
            if (is_hatched(origin, x, y, hatch())) {
                const ImVec2 p{at.x + static_cast<float>(x), at.y + static_cast<float>(y)};
                draw.AddRectFilled(p, {p.x + 1, p.y + 1}, IM_COL32(25, 18, 12, 255));
            }
    draw.AddRect(at, end, kRim);
    ImGui::SameLine();
    ImGui::TextUnformatted(text.c_str());
}

void scale_of_values(float width, double most) {
    const float height = ImGui::GetTextLineHeight() * 0.7f;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy({width, height});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    constexpr int kSteps = 48;
    for (int i = 0; i < kSteps; ++i) {
        const double part = (i + 0.5) / kSteps;
        const Rgb c = heat(part * part * part * part, 1);  // even along the fourth root
        draw.AddRectFilled({at.x + width * static_cast<float>(i) / kSteps, at.y},
                           {at.x + width * static_cast<float>(i + 1) / kSteps, at.y + height},
                           IM_COL32(byte(c.red), byte(c.green), byte(c.blue), 255));
    }
    draw.AddRect(at, {at.x + width, at.y + height}, kRim);
    ImGui::TextDisabled("D 0 to %.3g /sr", most);
}

const char* words_of(NdfOrigin origin) {
    switch (origin) {
        case NdfOrigin::measured:
            return "measured";
        case NdfOrigin::completed:
            return "completed from other points";
        case NdfOrigin::extrapolated:
            return "extrapolated";
    }
    return "";
}

void cell_words(const std::optional<TableCell>& cell) {
    if (!cell) return ImGui::TextDisabled("point at a cell\nfor its value");
    ImGui::Text("D %.4g /sr", cell->D);
    ImGui::Text("theta %.1f deg", cell->theta_deg);
    ImGui::Text("azimuth %.1f deg", cell->azimuth_deg);
    ImGui::Text("ring %d, column %d", cell->ring + 1, cell->column + 1);
    ImGui::TextWrapped("%s", words_of(cell->origin));
}

}  // namespace

void table_figure(const Picked& picked, float side, float scale) {
    const SurfaceAt& at = picked.report.surface;
    if (!at.exemplar || at.exemplar->exemplar < 0 || picked.report.methods.empty()) return;
    const int pixels = std::max(static_cast<int>(side), 16);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const TableMap map = table_map(at, 1);  // its highest value
    ImGui::Image(textures().get(picked, 1000, pixels,
                                [&] {
                                    const TableMap m = table_map(at, pixels);
                                    return pixels_of(m.D, m.most, m.origin, pixels);
                                }),
                 {static_cast<float>(pixels), static_cast<float>(pixels)});
    const bool hovered = ImGui::IsItemHovered();
    const float half = 0.5f * static_cast<float>(pixels);
    const auto place = [&](glm::dvec2 p) {
        return ImVec2{corner.x + half * static_cast<float>(1 + p.x),
                      corner.y + half * static_cast<float>(1 - p.y)};
    };
    ImGui::GetWindowDrawList()->AddCircle(place({0, 0}), half, kRim, 64);
    ring(place({0, 0}));
    const MethodReport& m = picked.report.methods.front();
    if (const auto h = table_place(m.lobe, picked.report.half, picked.report.to_eye))
        dot(place(*h));
    std::optional<TableCell> cell;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (hovered)
        cell = table_cell(at, {static_cast<double>((mouse.x - corner.x) / half - 1),
                               static_cast<double>(1 - (mouse.y - corner.y) / half)});
    ImGui::SameLine();
    ImGui::BeginGroup();
    const ExemplarAt& e = *at.exemplar;
    swatch(NdfOrigin::measured, fmt::format("measured {:.0f} %", 100 * e.measured));
    swatch(NdfOrigin::completed, fmt::format("completed {:.0f} %", 100 * e.completed));
    swatch(NdfOrigin::extrapolated, fmt::format("extrapolated {:.0f} %", 100 * e.extrapolated));
    scale_of_values(std::min(ImGui::GetContentRegionAvail().x, 150 * scale), map.most);
    ImGui::Spacing();
    cell_words(cell);
    ImGui::EndGroup();
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled(
        "Half vectors seen from above, as the table has them: middle: the texel's normal, rim: its "
        "horizon, "
        "rings: equal steps of sqrt(theta). Dot: the light's half vector under %s.",
        std::string(name_of(m.method)).c_str());
    ImGui::PopTextWrapPos();
}

void disk_figure(const Picked& picked, std::size_t index, float side, bool large) {
    const LobeReport& report = picked.report;
    const MethodReport& m = report.methods[index];
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const int pixels = std::max(static_cast<int>(side), 16);
    // The report's disk is coarse: enough for a small figure.
    const auto make = [&] {
        const LobeDisk disk =
            pixels > 2 * m.disk.D.width ? lobe_disk(m.lobe, report.to_eye, pixels) : m.disk;
        return pixels_of(disk.D, disk.most, disk.origin, pixels);
    };
    ImGui::Image(textures().get(picked, index, pixels, make), {side, side});
    const auto place = [&](const glm::dvec3& h) {
        return ImVec2{at.x + side * static_cast<float>(0.5 + 0.5 * h.x),
                      at.y + side * static_cast<float>(0.5 - 0.5 * h.y)};
    };
    const ImVec2 middle{at.x + side / 2, at.y + side / 2};
    ImGui::GetWindowDrawList()->AddCircle(middle, side / 2, kRim, 64);
    ring(place(report.normal));
    dot(place(report.half));
    cross(place(m.peak));
    if (!large) return;
    // The peak is often at n~: their words stand on both sides.
    word(place(report.normal), at.x + side, kWhite, "n~");
    word(place(report.half), at.x, kYellow, "h");
    word(place(m.peak), at.x, kBlue, "peak");
}

namespace {

// Seen from the side and 25 degrees above, with the light at the left and the eye at the right: the plane
// through both is that of the figure as far as it stands upright.
struct SideView {
    ImVec2 corner;
    float side;
    glm::dvec2 right{1.0, 0.0};  // unit, of the tangent plane

    SideView(ImVec2 at, float size, const LobeReport& report) : corner(at), side(size) {
        const glm::dvec2 across(report.to_eye - report.to_light);
        // 1e-3: light and eye one above the other, where the tangent is as good as any direction.
        if (glm::length(across) > 1e-3) right = glm::normalize(across);
    }
    ImVec2 operator()(glm::dvec3 v) const {
        const double x = right.x * v.x + right.y * v.y, depth = right.x * v.y - right.y * v.x;
        const double up = 0.906 * v.z + 0.423 * depth;
        return {corner.x + side * static_cast<float>(0.5 + 0.42 * x),
                corner.y + side * static_cast<float>(0.72 - 0.42 * up)};
    }
};

void wires(ImDrawList& draw, const SideView& place, const LobeMesh& mesh) {
    const double scale = mesh.most > 0 ? 1.0 / mesh.most : 0;
    const auto vertex = [&](int row, int column) {
        return place(
            glm::dvec3(mesh.vertices[static_cast<std::size_t>(row * mesh.columns + column)]) *
            scale);
    };
    constexpr ImU32 kLine = IM_COL32(240, 165, 85, 110);
    // A thin skin, which is brighter where it is seen twice: the lobe reads as a body.
    constexpr int kColumns = 4, kRows = 3;
    for (int row = 0; row + kRows < mesh.rows; row += kRows)
        for (int column = 0; column < mesh.columns; column += kColumns) {
            const int next = (column + kColumns) % mesh.columns;
            draw.AddQuadFilled(vertex(row, column), vertex(row, next), vertex(row + kRows, next),
                               vertex(row + kRows, column), IM_COL32(240, 165, 85, 26));
        }
    std::vector<ImVec2> points;
    for (int column = 0; column < mesh.columns; column += 8) {
        points.clear();
        for (int row = 0; row < mesh.rows; ++row) points.push_back(vertex(row, column));
        draw.AddPolyline(points.data(), static_cast<int>(points.size()), kLine, 0, 1);
    }
    for (int row = 4; row < mesh.rows; row += 6) {
        points.clear();
        for (int column = 0; column < mesh.columns; column += 2)
            points.push_back(vertex(row, column));
        draw.AddPolyline(points.data(), static_cast<int>(points.size()), kLine, ImDrawFlags_Closed,
                         1);
    }
}

}  // namespace

void lobe_figure(const Picked& picked, std::size_t index, float side, bool large) {
    const LobeReport& report = picked.report;
    const SideView place(ImGui::GetCursorScreenPos(), side, report);
    ImGui::Dummy({side, side});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    std::vector<ImVec2> circle;
    for (int i = 0; i < 48; ++i) {
        const double a = kTwoPi * i / 48;
        circle.push_back(place({std::cos(a), std::sin(a), 0}));
    }
    draw.AddPolyline(circle.data(), 48, kRim, ImDrawFlags_Closed, 1);
    wires(draw, place, report.methods[index].mesh);
    const ImVec2 origin = place({0, 0, 0});
    draw.AddLine(origin, place({1, 0, 0}), kRim);
    if (large) word(place({1, 0, 0}), origin.x, kRim, "tangent");
    const auto arrow = [&](glm::dvec3 v, ImU32 color, float width, const char* name) {
        const ImVec2 tip = place(v);
        draw.AddLine(origin, tip, color, width * unit());
        draw.AddCircleFilled(tip, (2.0f + width) * unit(), color);
        word(tip, origin.x, color, name);
    };
    arrow(report.normal, kWhite, 1.5f, large ? "n~" : "n");
    arrow(report.half, IM_COL32(255, 225, 120, 160), 1.0f, "h");
    arrow(report.to_light, kYellow, 1.5f, "l");
    arrow(report.to_eye, kBlue, 1.5f, "v");
}

void cut_figure(const Picked& picked, std::size_t index, float side, bool large) {
    const MethodReport& m = picked.report.methods[index];
    const float height = 0.5f * side + 6;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, height});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 origin{at.x + side / 2, at.y + height - 2};
    const auto place = [&](double angle, double radius) {
        const float r = 0.48f * side * static_cast<float>(radius);
        return ImVec2{origin.x + r * static_cast<float>(std::sin(angle)),
                      origin.y - r * static_cast<float>(std::cos(angle))};
    };
    std::vector<ImVec2> rim;
    for (int i = -45; i <= 45; ++i) rim.push_back(place(i * kPi / 90, 1));
    draw.AddPolyline(rim.data(), static_cast<int>(rim.size()), kRim, 0, 1);
    draw.AddLine(place(-kHalfPi, 1), place(kHalfPi, 1), kRim);
    draw.AddLine(origin, place(0, 1), IM_COL32(255, 255, 255, 110));
    draw.AddLine(origin, place(m.cuts.light_angle_rad, 1), kYellow, 1.5f);
    if (large) {
        word(place(0, 0.9), origin.x, kWhite, "n~");
        word(place(m.cuts.light_angle_rad, 0.8), origin.x, kYellow, "light");
    }
    // All methods on one scale, so that their heights compare.
    double most = 0;
    for (const MethodReport& other : picked.report.methods) most = std::max(most, other.cuts.most);
    if (!(most > 0)) return;
    std::vector<ImVec2> points;
    for (const PolarPoint& p : m.cuts.incidence)
        points.push_back(place(p.angle_rad, p.radius / most));
    draw.AddPolyline(points.data(), static_cast<int>(points.size()), kOrange, 0, 1.8f * unit());
}

}  // namespace burnish::viewer
