#include "plot/axes.hpp"

#include <algorithm>
#include <numbers>

namespace burnish::plot {
namespace {

constexpr double kTickLength = 4;
const Stroke kGridLine{.color = kFaint, .width = 0.8};
const Stroke kTickLine{.color = kInk, .width = 0.8};

}  // namespace

void draw_x_axis(Canvas& canvas, const Box& box, const Scale& scale, const std::string& label,
                 bool grid) {
    TextStyle number = kAxisNumber;
    number.align = Align::center;
    number.stand = Stand::top;
    for (const Tick& tick : scale.ticks(std::max(2, static_cast<int>(box.width / 60)))) {
        const double x = box.x + tick.position * box.width;
        const double length = tick.label.empty() ? 0.6 * kTickLength : kTickLength;
        if (grid && !tick.label.empty()) canvas.line({x, box.y}, {x, box.bottom()}, kGridLine);
        canvas.line({x, box.bottom()}, {x, box.bottom() + length}, kTickLine);
        canvas.text({x, box.bottom() + kTickLength + 3}, tick.label, number);
    }
    TextStyle style = kAxisLabel;
    style.align = Align::center;
    style.stand = Stand::top;
    canvas.text({box.center().x, box.bottom() + 21}, label, style);
}

void draw_y_axis(Canvas& canvas, const Box& box, const Scale& scale, const std::string& label,
                 bool grid) {
    TextStyle number = kAxisNumber;
    number.align = Align::right;
    number.stand = Stand::middle;
    double widest = 0;
    for (const Tick& tick : scale.ticks(std::max(2, static_cast<int>(box.height / 42)))) {
        const double y = box.bottom() - tick.position * box.height;
        const double length = tick.label.empty() ? 0.6 * kTickLength : kTickLength;
        if (grid && !tick.label.empty()) canvas.line({box.x, y}, {box.right(), y}, kGridLine);
        canvas.line({box.x - length, y}, {box.x, y}, kTickLine);
        canvas.text({box.x - kTickLength - 3, y}, tick.label, number);
        widest = std::max(widest, canvas.text_width(tick.label, number));
    }
    TextStyle style = kAxisLabel;
    style.align = Align::center;
    style.angle = -std::numbers::pi / 2;
    canvas.text({box.x - kTickLength - 3 - widest - 7, box.center().y}, label, style);
}

}  // namespace burnish::plot
