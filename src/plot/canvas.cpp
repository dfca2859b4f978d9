#include "burnish/plot/canvas.hpp"

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <sstream>

#include "burnish/error.hpp"
#include "plot/svg_text.hpp"

namespace burnish::plot {
namespace {

constexpr const char* kFont = "DejaVu Sans";
constexpr const char* kFontFamilies = "'DejaVu Sans', Verdana, Arial, sans-serif";
constexpr double kScriptSize = 0.72;  // size of raised and lowered text, in sizes of the text
constexpr double kRaise = 0.38, kLower = 0.2;
constexpr double kCapHeight = 0.73;  // height of capitals of DejaVu Sans, in sizes of the text
constexpr double kDescent = 0.24;
constexpr double kSvgRatio = 2;  // pixels per px of pictures inside an SVG

cairo_status_t append(void* to, const unsigned char* bytes, unsigned length) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), length);
    return CAIRO_STATUS_SUCCESS;
}

std::string hex(const Rgb& color) {
    const auto code = [](double v) {
        return static_cast<int>(std::lround(std::clamp(v, 0.0, 1.0) * 255));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", code(color.r), code(color.g), code(color.b));
}

struct Surface {
    cairo_surface_t* surface = nullptr;
    explicit Surface(cairo_surface_t* made) : surface(made) {}
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;
    ~Surface() { cairo_surface_destroy(surface); }
};

void require(cairo_status_t status) {
    if (status == CAIRO_STATUS_SUCCESS) return;
    throw Error("plot", "", "to be drawn", cairo_status_to_string(status));
}

double shift_of(const TextPart& part, double size) {
    return part.level > 0 ? -kRaise * size : part.level < 0 ? kLower * size : 0;
}

}  // namespace

struct Canvas::State {
    cairo_surface_t* surface = nullptr;
    cairo_t* cairo = nullptr;
    double ratio = 1;
    bool is_svg = false;
    std::string bytes;  // of the SVG
    std::string texts;  // <text> elements
    std::size_t row = 0, column = 0;
    std::vector<DataArea> areas;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (cairo) cairo_destroy(cairo);
        if (surface) cairo_surface_destroy(surface);
    }

    void start() {
        require(cairo_surface_status(surface));
        cairo = cairo_create(surface);
        require(cairo_status(cairo));
        cairo_font_options_t* options = cairo_font_options_create();
        // The same letters at the same places in every output.
        cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
        cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
        cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
        cairo_set_font_options(cairo, options);
        cairo_font_options_destroy(options);
        cairo_scale(cairo, ratio, ratio);
    }
    void set_color(const Rgb& color, double opacity = 1) const {
        cairo_set_source_rgba(cairo, color.r, color.g, color.b, opacity);
    }
    void trace(std::span<const Point> points) const {
        cairo_new_path(cairo);
        for (const Point& p : points) cairo_line_to(cairo, p.x, p.y);
    }
    void stroke(const Stroke& s) const {
        set_color(s.color, s.opacity);
        cairo_set_line_width(cairo, s.width);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(cairo, s.dash.empty() ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
        cairo_set_dash(cairo, s.dash.data(), static_cast<int>(s.dash.size()), s.dash_start);
        cairo_stroke(cairo);
    }
    void set_font(const TextStyle& style, int level) const {
        cairo_select_font_face(cairo, kFont, CAIRO_FONT_SLANT_NORMAL,
                               style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(cairo, level == 0 ? style.size : kScriptSize * style.size);
    }
    double width_of(const TextPart& part, const TextStyle& style) const {
        set_font(style, part.level);
        cairo_text_extents_t extents;
        cairo_text_extents(cairo, part.text.c_str(), &extents);
        return extents.x_advance;
    }
    void show(const TextPart& part, Point at, const TextStyle& style) const;
    void write(const std::vector<TextPart>& parts, const std::vector<double>& widths, Point at,
               Point start, const TextStyle& style);
};

Canvas::Canvas(std::unique_ptr<State> state) : state_(std::move(state)) {}
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;
Canvas::~Canvas() = default;

Canvas Canvas::for_picture(double width, double height, double pixel_ratio) {
    auto state = std::make_unique<State>();
    state->ratio = pixel_ratio;
    state->surface = cairo_image_surface_create(
        CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(width * pixel_ratio)),
        static_cast<int>(std::lround(height * pixel_ratio)));
    state->start();
    state->set_color(kWhite);
    cairo_paint(state->cairo);
    return Canvas(std::move(state));
}

Canvas Canvas::for_svg(double width, double height) {
    auto state = std::make_unique<State>();
    state->is_svg = true;
    state->surface = cairo_svg_surface_create_for_stream(append, &state->bytes, width, height);
    require(cairo_surface_status(state->surface));
    cairo_svg_surface_set_document_unit(state->surface, CAIRO_SVG_UNIT_PX);
    state->start();
    state->set_color(kWhite);
    cairo_paint(state->cairo);
    return Canvas(std::move(state));
}

double Canvas::pixel_ratio() const {
    return state_->is_svg ? kSvgRatio : state_->ratio;
}

void Canvas::polyline(std::span<const Point> points, const Stroke& stroke) {
    state_->trace(points);
    state_->stroke(stroke);
}

void Canvas::line(Point from, Point to, const Stroke& stroke) {
    const Point ends[] = {from, to};
    polyline(ends, stroke);
}

void Canvas::polygon(std::span<const Point> points, const Rgb& fill, double opacity) {
    state_->trace(points);
    state_->set_color(fill, opacity);
    cairo_fill(state_->cairo);
}

void Canvas::rectangle(const Box& box, const Rgb& fill) {
    cairo_rectangle(state_->cairo, box.x, box.y, box.width, box.height);
    state_->set_color(fill);
    cairo_fill(state_->cairo);
}

void Canvas::frame(const Box& box, const Stroke& stroke) {
    cairo_rectangle(state_->cairo, box.x, box.y, box.width, box.height);
    state_->stroke(stroke);
}

void Canvas::circle(Point center, double radius, const Stroke& stroke) {
    cairo_new_path(state_->cairo);
    cairo_arc(state_->cairo, center.x, center.y, radius, 0, 2 * std::numbers::pi);
    state_->stroke(stroke);
}

void Canvas::disk(Point center, double radius, const Rgb& fill) {
    cairo_new_path(state_->cairo);
    cairo_arc(state_->cairo, center.x, center.y, radius, 0, 2 * std::numbers::pi);
    state_->set_color(fill);
    cairo_fill(state_->cairo);
}

void Canvas::arrow(Point from, Point to, const Stroke& stroke, double head) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0)) return;
    head = std::min(head, 0.6 * length);
    const double ux = (to.x - from.x) / length, uy = (to.y - from.y) / length;
    // The shaft ends inside the head, whose point is at `to`.
    line(from, {to.x - 0.8 * head * ux, to.y - 0.8 * head * uy}, stroke);
    const double half = 0.36 * head;
    const Point triangle[] = {to,
                              {to.x - head * ux - half * uy, to.y - head * uy + half * ux},
                              {to.x - head * ux + half * uy, to.y - head * uy - half * ux}};
    polygon(triangle, stroke.color, stroke.opacity);
}

void Canvas::cross(Point center, double arm, const Stroke& stroke, const Rgb& halo) {
    Stroke wide = stroke;
    wide.color = halo;
    wide.width += 2.5;
    for (const Stroke& s : {wide, stroke}) {
        line({center.x - arm, center.y}, {center.x + arm, center.y}, s);
        line({center.x, center.y - arm}, {center.x, center.y + arm}, s);
    }
}

double Canvas::text_width(std::string_view text, const TextStyle& style) const {
    double width = 0;
    for (const TextPart& part : parts_of(text)) width += state_->width_of(part, style);
    return width;
}

std::vector<std::string> Canvas::wrapped(std::string_view text, double width,
                                         const TextStyle& style) const {
    std::vector<std::string> lines;
    std::istringstream words{std::string(text)};
    for (std::string word; words >> word;) {
        const std::string longer = lines.empty() ? word : lines.back() + " " + word;
        if (!lines.empty() && text_width(longer, style) <= width) {
            lines.back() = longer;
        } else {
            lines.push_back(word);
        }
    }
    return lines;
}

void Canvas::State::show(const TextPart& part, Point at, const TextStyle& style) const {
    set_font(style, part.level);
    cairo_move_to(cairo, at.x, at.y);
    if (style.halo) {
        cairo_text_path(cairo, part.text.c_str());
        set_color(*style.halo);
        cairo_set_line_width(cairo, 0.24 * style.size);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        cairo_set_dash(cairo, nullptr, 0, 0);
        cairo_stroke(cairo);
        cairo_move_to(cairo, at.x, at.y);
    }
    set_color(style.color);
    cairo_show_text(cairo, part.text.c_str());
}

// The text is rotated about `at`. `start` is the left end of its baseline before the rotation.
void Canvas::State::write(const std::vector<TextPart>& parts, const std::vector<double>& widths,
                          Point at, Point start, const TextStyle& style) {
    std::string element = fmt::format("<text xml:space=\"preserve\" font-family=\"{}\" fill=\"{}\"",
                                      kFontFamilies, hex(style.color));
    if (style.bold) element += " font-weight=\"bold\"";
    if (style.angle != 0)
        element += fmt::format(" transform=\"rotate({:.2f} {:.2f} {:.2f})\"",
                               style.angle * 180 / std::numbers::pi, at.x, at.y);
    if (style.halo)
        element += fmt::format(
            " stroke=\"{}\" stroke-width=\"{:.2f}\" stroke-linejoin=\"round\" "
            "paint-order=\"stroke\"",
            hex(*style.halo), 0.24 * style.size);
    element += ">";
    double x = start.x;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        // textLength keeps the measured width, whatever font the reader has.
        element += fmt::format(
            "<tspan x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\" "
            "textLength=\"{:.2f}\">{}</tspan>",
            x, start.y + shift_of(parts[i], style.size),
            parts[i].level == 0 ? style.size : kScriptSize * style.size, widths[i],
            xml_escaped(parts[i].text));
        x += widths[i];
    }
    texts += element + "</text>\n";
}

void Canvas::text(Point at, std::string_view text, const TextStyle& style) {
    const std::vector<TextPart> parts = parts_of(text);
    std::vector<double> widths;
    double width = 0;
    for (const TextPart& part : parts) {
        widths.push_back(state_->width_of(part, style));
        width += widths.back();
    }
    Point start = at;
    if (style.align == Align::center) start.x -= width / 2;
    if (style.align == Align::right) start.x -= width;
    if (style.stand == Stand::top) start.y += kCapHeight * style.size;
    if (style.stand == Stand::middle) start.y += kCapHeight * style.size / 2;
    if (style.stand == Stand::bottom) start.y -= kDescent * style.size;
    if (state_->is_svg) {
        state_->write(parts, widths, at, start, style);
        return;
    }
    cairo_t* cairo = state_->cairo;
    cairo_save(cairo);
    cairo_translate(cairo, at.x, at.y);
    cairo_rotate(cairo, style.angle);
    cairo_translate(cairo, -at.x, -at.y);
    double x = start.x;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        state_->show(parts[i], {x, start.y + shift_of(parts[i], style.size)}, style);
        x += widths[i];
    }
    cairo_restore(cairo);
}

void Canvas::image(const Box& box, const Image& image) {
    if (image.empty() || !(box.width > 0 && box.height > 0)) return;
    const Surface source(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height));
    require(cairo_surface_status(source.surface));
    unsigned char* bytes = cairo_image_surface_get_data(source.surface);
    const int stride = cairo_image_surface_get_stride(source.surface);
    // NaN becomes 0, as in write_image.
    const auto share = [](float v) { return v > 0.0f ? std::min(v, 1.0f) : 0.0f; };
    for (int y = 0; y < image.height; ++y) {
        auto* row =
            reinterpret_cast<std::uint32_t*>(bytes + static_cast<std::ptrdiff_t>(y) * stride);
        for (int x = 0; x < image.width; ++x) {
            const float* p = image.at(x, y);
            const float alpha = image.channels == 4 ? share(p[3]) : 1.0f;
            const auto code = [&](int c) {
                const float v = share(p[image.channels >= 3 ? c : 0]) * alpha;
                return static_cast<std::uint32_t>(v * 255.0f + 0.5f);
            };
            row[x] = static_cast<std::uint32_t>(alpha * 255.0f + 0.5f) << 24 | code(0) << 16 |
                     code(1) << 8 | code(2);
        }
    }
    cairo_surface_mark_dirty(source.surface);
    cairo_t* cairo = state_->cairo;
    cairo_save(cairo);
    cairo_rectangle(cairo, box.x, box.y, box.width, box.height);
    cairo_clip(cairo);
    cairo_translate(cairo, box.x, box.y);
    cairo_scale(cairo, box.width / image.width, box.height / image.height);
    cairo_set_source_surface(cairo, source.surface, 0, 0);
    const bool enlarged = box.width * pixel_ratio() >= image.width - 0.5;
    cairo_pattern_set_filter(cairo_get_source(cairo),
                             enlarged ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_BEST);
    cairo_paint(cairo);
    cairo_restore(cairo);
}

Canvas::Clip::~Clip() {
    cairo_restore(canvas_->state_->cairo);
}

Canvas::Clip Canvas::clip_to(const Box& box) {
    cairo_save(state_->cairo);
    cairo_rectangle(state_->cairo, box.x, box.y, box.width, box.height);
    cairo_clip(state_->cairo);
    return Clip(*this);
}

Canvas::Clip Canvas::clip_to_circle(Point center, double radius) {
    cairo_save(state_->cairo);
    cairo_new_path(state_->cairo);
    cairo_arc(state_->cairo, center.x, center.y, radius, 0, 2 * std::numbers::pi);
    cairo_clip(state_->cairo);
    return Clip(*this);
}

void Canvas::begin_panel(std::size_t row, std::size_t column) {
    state_->row = row;
    state_->column = column;
}

void Canvas::mark_area(std::string name, const Box& box) {
    state_->areas.push_back({state_->row, state_->column, std::move(name), box});
}

const std::vector<DataArea>& Canvas::areas() const {
    return state_->areas;
}

Image Canvas::picture() const {
    require(cairo_status(state_->cairo));
    cairo_surface_flush(state_->surface);
    const unsigned char* bytes = cairo_image_surface_get_data(state_->surface);
    const int stride = cairo_image_surface_get_stride(state_->surface);
    Image image(cairo_image_surface_get_width(state_->surface),
                cairo_image_surface_get_height(state_->surface), 3);
    for (int y = 0; y < image.height; ++y) {
        const auto* row =
            reinterpret_cast<const std::uint32_t*>(bytes + static_cast<std::ptrdiff_t>(y) * stride);
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c)
                image.at(x, y)[c] = static_cast<float>(row[x] >> (16 - 8 * c) & 0xFFu) / 255.0f;
    }
    return image;
}

std::string Canvas::svg(std::string_view title, std::string_view description,
                        const std::map<std::string, std::string>& metadata) {
    require(cairo_status(state_->cairo));
    cairo_surface_finish(state_->surface);
    require(cairo_surface_status(state_->surface));
    std::string& text = state_->bytes;
    const std::size_t open = text.find("<svg");
    const std::size_t start = open == text.npos ? open : text.find('>', open);
    const std::size_t end = text.rfind("</svg>");
    if (start == text.npos || end == text.npos)
        throw Error("plot", "", "an SVG document", "something else");
    // The texts come last, so that they lie above all shapes.
    return text.substr(0, start + 1) + "\n" + svg_header(title, description, metadata) +
           text.substr(start + 1, end - start - 1) + state_->texts + text.substr(end);
}

std::vector<double> series_dash(std::size_t index) {
    if (index < 7) return {};
    if (index < 14) return {7, 3};
    return {2, 2.5};
}

}  // namespace burnish::plot
