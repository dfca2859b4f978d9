// The canvas of all plots: one drawing code for PNG and SVG (cairo). Lengths are px of a 96 dpi
// page, y points down, angles are in radians, colors are display values.
//
// Threads: one at a time for each canvas.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/image.hpp"
#include "burnish/plot/color_map.hpp"

namespace burnish {
namespace BURNISH_API plot {

struct Point {
    double x = 0, y = 0;
};

struct Box {
    double x = 0, y = 0, width = 0, height = 0;
    double right() const { return x + width; }
    double bottom() const { return y + height; }
    Point center() const { return {x + width / 2, y + height / 2}; }
    Box inset(double left, double top, double right_, double bottom_) const {
        return {x + left, y + top, width - left - right_, height - top - bottom_};
    }
};

struct Stroke {
    Rgb color = kInk;
    double width = 1;
    std::vector<double> dash = {};  // lengths of strokes and gaps; empty: solid
    double opacity = 1;
    double dash_start = 0;  // how far into the dashes a line begins
};

// Dashes that go with series_color(index): solid for the first seven, then dashed, then dotted.
std::vector<double> series_dash(std::size_t index);

enum class Align { left, center, right };  // of the text, at its point
enum class Stand { baseline, top, middle, bottom };

struct TextStyle {
    double size = 13;
    bool bold = false;
    Rgb color = kInk;
    Align align = Align::left;
    Stand stand = Stand::baseline;
    double angle = 0;              // clockwise, about the point
    std::optional<Rgb> halo = {};  // an outline, where text lies on a picture
};

// The place of a data area, by which image maps and tests find it.
struct DataArea {
    std::size_t row = 0, column = 0;  // of the panel in its figure
    std::string name;
    Box box;
};

class Canvas {
  public:
    // A picture of round(width pixel_ratio) x round(height pixel_ratio) pixels, white.
    static Canvas for_picture(double width, double height, double pixel_ratio);
    static Canvas for_svg(double width, double height);
    Canvas(Canvas&&) noexcept;
    Canvas& operator=(Canvas&&) noexcept;
    ~Canvas();

    // Pixels per px: the resolution at which to compute the pictures inside a plot (SVG: 2).
    double pixel_ratio() const;

    void polyline(std::span<const Point> points, const Stroke& stroke);
    void line(Point from, Point to, const Stroke& stroke);
    void polygon(std::span<const Point> points, const Rgb& fill, double opacity = 1);
    void rectangle(const Box& box, const Rgb& fill);
    void frame(const Box& box, const Stroke& stroke);
    void circle(Point center, double radius, const Stroke& stroke);
    void disk(Point center, double radius, const Rgb& fill);
    void arrow(Point from, Point to, const Stroke& stroke, double head = 8);
    void cross(Point center, double arm, const Stroke& stroke, const Rgb& halo);

    // One line of UTF-8. "h_{x}" and "10^{-3}" are set below and above the line; nothing else is
    // special. In SVG it is text, selectable and searchable.
    void text(Point at, std::string_view text, const TextStyle& style);
    double text_width(std::string_view text, const TextStyle& style) const;
    // Lines of as many words as fit into `width`, at least one word each.
    std::vector<std::string> wrapped(std::string_view text, double width,
                                     const TextStyle& style) const;

    // Display values, 1, 3 or 4 channels, stretched over the box: texel edges stay sharp where
    // they are enlarged, and are averaged where they are made smaller.
    void image(const Box& box, const Image& image);

    // Drawing stays inside the box or circle until the returned object is destroyed.
    class Clip {
      public:
        explicit Clip(Canvas& canvas) : canvas_(&canvas) {}
        Clip(const Clip&) = delete;
        Clip& operator=(const Clip&) = delete;
        ~Clip();

      private:
        Canvas* canvas_;
    };
    [[nodiscard]] Clip clip_to(const Box& box);
    [[nodiscard]] Clip clip_to_circle(Point center, double radius);

    void begin_panel(std::size_t row, std::size_t column);  // of the areas marked from here on
    void mark_area(std::string name, const Box& box);
    const std::vector<DataArea>& areas() const;

    // The drawing. Names of `metadata` such as "burnish:command" become elements of <metadata>.
    // Screen readers read `title` and `description` aloud.
    Image picture() const;  // RGB
    std::string svg(std::string_view title, std::string_view description,
                    const std::map<std::string, std::string>& metadata);

  private:
    struct State;
    explicit Canvas(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace plot
}  // namespace burnish
