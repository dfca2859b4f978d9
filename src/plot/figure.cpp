#include "burnish/plot/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/files.hpp"

namespace burnish::plot {
namespace {

constexpr double kMargin = 18, kGap = 18;
constexpr double kRowLabel = 26;                   // width of the column of row labels
constexpr double kBarWidth = 14, kBarColumn = 92;  // the column includes numbers and label
constexpr double kLegendLine = 21, kSwatch = 30;
constexpr double kLeastTextWidth = 380;  // the caption of a single panel is not squeezed
constexpr double kMostPixels = 64e6;     // 770 MB while a picture is made

const TextStyle kTitle{.size = 17, .bold = true};
const TextStyle kPanelTitle{.size = 13, .bold = true, .align = Align::center};
const TextStyle kLabel{.size = 13, .bold = true, .align = Align::center};
const TextStyle kNote{.size = 11.5, .color = kGray, .align = Align::center};
const TextStyle kCaption{.size = 12.5};
const TextStyle kEntry{.size = 12.5};
const TextStyle kTickText{.size = 11.5};

double line_height(const TextStyle& style) {
    return std::ceil(1.32 * style.size);
}

using Lines = std::vector<std::string>;

struct PlacedPanel {
    Lines title, note;
    Box box;
};

struct PlacedRow {
    double top = 0, panels_top = 0, panels_height = 0;
    std::vector<PlacedPanel> panels;
};

struct Layout {
    double width = 0, height = 0;
    bool labels = false, bars = false;
    double bar_x = 0;
    Lines title, caption;
    std::vector<PlacedRow> rows;
    double legend_top = 0, caption_top = 0;
    std::vector<Point> legend;  // left ends of the entries' middles
};

void check(const Figure& figure) {
    std::size_t panels = 0;
    for (const PanelRow& row : figure.rows) panels += row.panels.size();
    if (panels >= 1 && panels <= kMostPanels) return;
    throw UsageError("figure", "", fmt::format("1 to {} panels", kMostPanels),
                     std::to_string(panels));
}

std::vector<double> column_widths(const Figure& figure) {
    std::vector<double> widths;
    for (const PanelRow& row : figure.rows) {
        widths.resize(std::max(widths.size(), row.panels.size()), 0);
        for (std::size_t c = 0; c < row.panels.size(); ++c)
            widths[c] = std::max(widths[c], std::round(row.panels[c].width));
    }
    return widths;
}

double place_rows(const Figure& figure, const Canvas& measure, double y, Layout& layout) {
    const std::vector<double> widths = column_widths(figure);
    for (const PanelRow& row : figure.rows) {
        PlacedRow& placed = layout.rows.emplace_back();
        placed.top = y;
        double x = kMargin + (layout.labels ? kRowLabel : 0);
        std::size_t title_lines = 0, note_lines = 0;
        for (std::size_t c = 0; c < row.panels.size(); ++c) {
            const Panel& panel = row.panels[c];
            PlacedPanel& p = placed.panels.emplace_back();
            p.title = measure.wrapped(panel.title, widths[c], kPanelTitle);
            p.note = measure.wrapped(panel.note, widths[c], kNote);
            title_lines = std::max(title_lines, p.title.size());
            note_lines = std::max(note_lines, p.note.size());
            placed.panels_height = std::max(placed.panels_height, std::round(panel.height));
            // A panel narrower than its column is centered in it.
            p.box = {std::round(x + (widths[c] - panel.width) / 2), 0, std::round(panel.width),
                     std::round(panel.height)};
            x += widths[c] + kGap;
        }
        placed.panels_top = y + static_cast<double>(title_lines) * line_height(kPanelTitle) + 4;
        for (PlacedPanel& p : placed.panels) p.box.y = placed.panels_top;
        y = placed.panels_top + placed.panels_height + kGap +
            static_cast<double>(note_lines) * line_height(kNote);
    }
    return y;
}

double place_legend(const Figure& figure, const Canvas& measure, double y, Layout& layout) {
    layout.legend_top = y;
    if (figure.legend.empty()) return y;
    double x = kMargin;
    y += kLegendLine / 2;
    for (const LegendEntry& entry : figure.legend) {
        const double width = kSwatch + 8 + measure.text_width(entry.label, kEntry);
        if (x > kMargin && x + width > layout.width - kMargin) {
            x = kMargin;
            y += kLegendLine;
        }
        layout.legend.push_back({x, y});
        x += width + 22;
    }
    return y + kLegendLine;
}

Layout lay_out(const Figure& figure) {
    const Canvas measure = Canvas::for_picture(1, 1, 1);
    Layout layout;
    for (const PanelRow& row : figure.rows) {
        layout.labels = layout.labels || !row.label.empty();
        layout.bars = layout.bars || row.bar.has_value();
    }
    double right = kMargin + (layout.labels ? kRowLabel : 0);
    for (const double width : column_widths(figure)) right += width + kGap;
    layout.bar_x = right;
    right += layout.bars ? kBarColumn : -kGap;
    layout.width = std::max(right + kMargin, kLeastTextWidth + 2 * kMargin);
    const double text_width = layout.width - 2 * kMargin;
    layout.title = measure.wrapped(figure.title, text_width, kTitle);
    double y = kMargin + static_cast<double>(layout.title.size()) * line_height(kTitle) +
               (layout.title.empty() ? 0 : 8);
    y = place_rows(figure, measure, y, layout) - kGap + 8;
    y = place_legend(figure, measure, y, layout);
    layout.caption = measure.wrapped(figure.caption, text_width, kCaption);
    layout.caption_top = y + (layout.caption.empty() ? 0 : 4);
    layout.height = layout.caption_top + kMargin - 4 +
                    static_cast<double>(layout.caption.size()) * line_height(kCaption);
    layout.height = std::ceil(layout.height);
    return layout;
}

// Lines of text under one another, the first with its top at `at.y`.
void draw_lines(Canvas& canvas, const Lines& lines, Point at, TextStyle style) {
    style.stand = Stand::baseline;
    double y = at.y + style.size;
    for (const std::string& line : lines) {
        canvas.text({at.x, y}, line, style);
        y += line_height(style);
    }
}

void draw_bar(Canvas& canvas, const ColorBar& bar, const Box& box) {
    // At least two strips per pixel, so that no step shows.
    const int strips = static_cast<int>(std::lround(2 * canvas.pixel_ratio() * box.height));
    Image ramp(1, std::max(strips, 2), 3);
    for (int y = 0; y < ramp.height; ++y) {
        const double t = 1 - (y + 0.5) / ramp.height;
        const Rgb c = bar.diverging ? diverging_color(2 * t - 1) : sequential_color(t);
        ramp.at(0, y)[0] = static_cast<float>(c.r);
        ramp.at(0, y)[1] = static_cast<float>(c.g);
        ramp.at(0, y)[2] = static_cast<float>(c.b);
    }
    canvas.image(box, ramp);
    canvas.frame(box, {.color = kInk, .width = 0.8});
    double widest = 0;
    TextStyle text = kTickText;
    text.stand = Stand::middle;
    for (const Tick& tick : bar.scale.ticks(std::max(2, static_cast<int>(box.height / 45)))) {
        const double y = box.bottom() - tick.position * box.height;
        canvas.line({box.right(), y}, {box.right() + (tick.label.empty() ? 3 : 5), y},
                    {.width = 0.8});
        canvas.text({box.right() + 8, y}, tick.label, text);
        widest = std::max(widest, canvas.text_width(tick.label, text));
    }
    if (bar.above) {
        const Rgb top = bar.diverging ? diverging_color(1) : sequential_color(1);
        const Point arrow[] = {
            {box.x, box.y - 2}, {box.right(), box.y - 2}, {box.x + box.width / 2, box.y - 12}};
        canvas.polygon(arrow, top);
        const Point outline[] = {arrow[0], arrow[1], arrow[2], arrow[0]};
        canvas.polyline(outline, {.width = 0.8});
        canvas.text({box.right() + 8, box.y - 10}, "to " + number_text(*bar.above, 2), text);
    }
    TextStyle label = kTickText;
    label.size = 12.5;
    label.align = Align::center;
    label.stand = Stand::middle;
    label.angle = -std::numbers::pi / 2;
    canvas.text({box.right() + 8 + widest + 14, box.center().y}, bar.label, label);
    canvas.mark_area("bar", box);
}

void draw_row(Canvas& canvas, const PanelRow& row, const PlacedRow& placed, const Layout& layout,
              std::size_t index) {
    if (!row.label.empty()) {
        TextStyle style = kLabel;
        style.angle = -std::numbers::pi / 2;
        canvas.text({kMargin + kLabel.size, placed.panels_top + placed.panels_height / 2},
                    row.label, style);
    }
    for (std::size_t c = 0; c < row.panels.size(); ++c) {
        const PlacedPanel& p = placed.panels[c];
        const double title_height = static_cast<double>(p.title.size()) * line_height(kPanelTitle);
        draw_lines(canvas, p.title,
                   {p.box.center().x + row.panels[c].middle, placed.panels_top - 4 - title_height},
                   kPanelTitle);
        canvas.begin_panel(index, c);
        if (row.panels[c].draw) row.panels[c].draw(canvas, p.box);
        draw_lines(canvas, p.note, {p.box.center().x + row.panels[c].middle, p.box.bottom() + 2},
                   kNote);
    }
    if (row.bar) {
        // As high as the data of a panel with an axis below.
        const Box box{layout.bar_x, placed.panels_top + 14, kBarWidth,
                      std::max(placed.panels_height - 14 - 30, 60.0)};
        canvas.begin_panel(index, row.panels.size());
        draw_bar(canvas, *row.bar, box);
    }
}

void draw(Canvas& canvas, const Figure& figure, const Layout& layout) {
    draw_lines(canvas, layout.title, {kMargin, kMargin}, kTitle);
    for (std::size_t r = 0; r < figure.rows.size(); ++r)
        draw_row(canvas, figure.rows[r], layout.rows[r], layout, r);
    for (std::size_t i = 0; i < figure.legend.size(); ++i) {
        const LegendEntry& entry = figure.legend[i];
        const Point at = layout.legend[i];
        canvas.line(at, {at.x + kSwatch, at.y},
                    {.color = entry.color, .width = 2.4, .dash = entry.dash});
        TextStyle style = kEntry;
        style.stand = Stand::middle;
        canvas.text({at.x + kSwatch + 8, at.y}, entry.label, style);
    }
    draw_lines(canvas, layout.caption, {kMargin, layout.caption_top}, kCaption);
}

Layout checked_layout(const Figure& figure, double pixel_ratio) {
    check(figure);
    Layout layout = lay_out(figure);
    const double width = layout.width * pixel_ratio, height = layout.height * pixel_ratio;
    if (!(pixel_ratio > 0) || !(std::max(width, height) <= kMostSidePx) ||
        width * height > kMostPixels || std::min(width, height) < 1)
        throw UsageError("figure", "size",
                         fmt::format("at most {:.0f} pixels a side and {:.0f} million in all",
                                     kMostSidePx, kMostPixels / 1e6),
                         fmt::format("{:.0f} x {:.0f}", width, height));
    return layout;
}

bool is_svg(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (extension == ".svg") return true;
    if (extension == ".png") return false;
    throw UsageError(path.string(), "", "a name ending in .png or .svg",
                     extension.empty() ? "no ending" : shown(extension));
}

}  // namespace

DrawnFigure draw_figure(const Figure& figure, double pixel_ratio) {
    const Layout layout = checked_layout(figure, pixel_ratio);
    Canvas canvas = Canvas::for_picture(layout.width, layout.height, pixel_ratio);
    draw(canvas, figure, layout);
    return {canvas.picture(), pixel_ratio, canvas.areas()};
}

std::string figure_svg(const Figure& figure, const Metadata& metadata) {
    const Layout layout = checked_layout(figure, 1);
    Canvas canvas = Canvas::for_svg(layout.width, layout.height);
    draw(canvas, figure, layout);
    return canvas.svg(figure.title, figure.caption, metadata);
}

void require_figure_path(const std::filesystem::path& path) {
    is_svg(path);
}

void write_figure(const Figure& figure, const std::filesystem::path& path, const Metadata& metadata,
                  double pixel_ratio) {
    const bool svg = is_svg(path);
    require_writable(path);
    if (svg) {
        write_text_file(path, figure_svg(figure, metadata));
    } else {
        write_image(path, draw_figure(figure, pixel_ratio).image, metadata);
    }
}

}  // namespace burnish::plot
