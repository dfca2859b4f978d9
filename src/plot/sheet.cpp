#include "plot/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "burnish/error.hpp"
#include "burnish/plot/canvas.hpp"
#include "image/guard/format.hpp"

namespace burnish {
namespace {

// Height of a line of a label, and the distance from the last baseline to the image, in units of
// the font size: descenders of Latin text reach 0.25 below the baseline, capitals 0.75 above.
constexpr double kLineHeight = 1.3;
constexpr double kDescent = 0.4;

// Labels of small images are not wrapped into columns of single words.
constexpr int kLeastLabelWidth = 8;

using Rows = std::vector<std::vector<SheetCell>>;
using Lines = std::vector<std::string>;

struct Layout {
    std::vector<std::vector<Lines>> labels;  // by row and column
    std::vector<int> column_x;
    std::vector<int> image_y;  // by row
    int width = 0;
    int height = 0;
};

int line_height(const SheetOptions& options) {
    return static_cast<int>(std::lround(kLineHeight * options.font_px));
}

plot::TextStyle text_style(const SheetOptions& options) {
    return {.size = static_cast<double>(options.font_px), .color = plot::kBlack};
}

int text_width(const plot::Canvas& measure, const std::string& text, const SheetOptions& options) {
    return static_cast<int>(std::ceil(measure.text_width(text, text_style(options))));
}

std::vector<int> widths_of_images(const Rows& rows) {
    std::vector<int> widths;
    for (const std::vector<SheetCell>& row : rows) {
        widths.resize(std::max(widths.size(), row.size()), 0);
        for (std::size_t column = 0; column < row.size(); ++column) {
            widths[column] = std::max(widths[column], row[column].image.width);
        }
    }
    return widths;
}

Layout lay_out(const Rows& rows, const SheetOptions& options) {
    const plot::Canvas measure = plot::Canvas::for_picture(1, 1, 1);
    Layout layout;
    std::vector<int> widths = widths_of_images(rows);
    std::int64_t x = options.padding_px, y = options.padding_px;
    for (const std::vector<SheetCell>& row : rows) {
        std::vector<Lines>& labels = layout.labels.emplace_back();
        std::size_t lines = 0;
        int height = 0;
        for (std::size_t column = 0; column < row.size(); ++column) {
            const int room = std::max(widths[column], kLeastLabelWidth * options.font_px);
            labels.push_back(measure.wrapped(row[column].label, room, text_style(options)));
            for (const std::string& line : labels.back()) {
                widths[column] = std::max(widths[column], text_width(measure, line, options));
            }
            lines = std::max(lines, labels.back().size());
            height = std::max(height, row[column].image.height);
        }
        y += static_cast<std::int64_t>(lines) * line_height(options);
        layout.image_y.push_back(static_cast<int>(y));
        y += height + options.padding_px;
        check_image_size(1, y, "contact sheet");
    }
    for (const int width : widths) {
        layout.column_x.push_back(static_cast<int>(x));
        x += width + options.padding_px;
        check_image_size(x, 1, "contact sheet");
    }
    layout.width = static_cast<int>(x);
    layout.height = static_cast<int>(y);
    return layout;
}

// The lines in black on white, the last one nearest to the lower edge.
Image label_picture(const Lines& lines, const SheetOptions& options) {
    const plot::Canvas measure = plot::Canvas::for_picture(1, 1, 1);
    int width = 1;
    for (const std::string& line : lines)
        width = std::max(width, text_width(measure, line, options));
    const int height = static_cast<int>(lines.size()) * line_height(options);
    plot::Canvas canvas = plot::Canvas::for_picture(width, height, 1);
    double baseline = height - kDescent * options.font_px;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        canvas.text({0, std::round(baseline)}, *line, text_style(options));
        baseline -= kLineHeight * options.font_px;
    }
    return canvas.picture();
}

// Writes the lines above `image_y`.
void draw_label(Image& sheet, const Lines& lines, int left, int image_y,
                const SheetOptions& options) {
    if (lines.empty()) return;
    const Image label = label_picture(lines, options);
    const int top = image_y - label.height;
    for (int y = std::max(0, -top); y < label.height; ++y) {
        for (int x = 0; x < std::min(label.width, sheet.width - left); ++x) {
            const float coverage = 1.0f - label.at(x, y)[0];
            float* target = sheet.at(left + x, top + y);
            for (int c = 0; c < 3; ++c) target[c] += coverage * (options.text - target[c]);
        }
    }
}

void paste(const Image& from, Image& sheet, int left, int top, float background) {
    for (int y = 0; y < from.height; ++y) {
        for (int x = 0; x < from.width; ++x) {
            const float* source = from.at(x, y);
            float* target = sheet.at(left + x, top + y);
            const float alpha = from.channels == 4 ? source[3] : 1.0f;
            for (int c = 0; c < 3; ++c) {
                const float value = source[from.channels >= 3 ? c : 0];
                target[c] = background + alpha * (value - background);
            }
        }
    }
}

void check_same_size(const Image& a, const Image& b) {
    const auto size = [](const Image& image) {
        return fmt::format("{} x {} x {}", image.width, image.height, image.channels);
    };
    const int colors_a = std::min(a.channels, 3), colors_b = std::min(b.channels, 3);
    if (a.width == b.width && a.height == b.height && colors_a == colors_b) return;
    throw Error("comparison", "", "two images of one size", size(a) + " and " + size(b));
}

using Rgb = std::array<float, 3>;

// Three stops from black: lightness grows with the difference on both sides, and blue against
// orange holds for color-blind eyes too.
Rgb ramp(float amount, const Rgb& middle, const Rgb& end) {
    Rgb color{};
    for (std::size_t c = 0; c < 3; ++c) {
        color[c] = amount < 0.5f ? 2.0f * amount * middle[c]
                                 : middle[c] + (2.0f * amount - 1.0f) * (end[c] - middle[c]);
    }
    return color;
}

Rgb difference_color(float scaled) {
    constexpr Rgb kOrange = {0.90f, 0.40f, 0.05f}, kYellow = {1.0f, 0.95f, 0.65f};
    constexpr Rgb kBlue = {0.10f, 0.40f, 0.90f}, kCyan = {0.75f, 0.97f, 1.0f};
    constexpr Rgb kMagenta = {1.0f, 0.0f, 1.0f};
    if (std::isnan(scaled)) return kMagenta;
    const float amount = std::min(std::abs(scaled), 1.0f);
    return scaled > 0.0f ? ramp(amount, kOrange, kYellow) : ramp(amount, kBlue, kCyan);
}

// The difference of the channel that differs most; NaN when one of them is.
float largest_difference(const float* a, const float* b, int colors) {
    float largest = 0.0f;
    for (int c = 0; c < colors; ++c) {
        const float difference = b[c] - a[c];
        if (std::isnan(difference)) return difference;
        if (std::abs(difference) > std::abs(largest)) largest = difference;
    }
    return largest;
}

}  // namespace

Image compose_sheet(const Rows& rows, const SheetOptions& options) {
    const Layout layout = lay_out(rows, options);
    check_image_size(layout.width, layout.height, "contact sheet");
    Image sheet(layout.width, layout.height, 3, options.background);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (std::size_t column = 0; column < rows[row].size(); ++column) {
            const int x = layout.column_x[column], y = layout.image_y[row];
            paste(rows[row][column].image, sheet, x, y, options.background);
            draw_label(sheet, layout.labels[row][column], x, y, options);
        }
    }
    return sheet;
}

float difference_gain(const Image& reference, const std::vector<Image>& others) {
    constexpr float kVisible = 1.0f / 255.0f;  // less is no difference in an 8-bit picture
    constexpr double kClipped = 0.02;
    constexpr std::array kNice = {32.0f, 24.0f, 16.0f, 12.0f, 8.0f, 6.0f,
                                  4.0f,  3.0f,  2.0f,  1.5f,  1.0f};
    std::vector<float> sizes;
    const int colors = std::min(reference.channels, 3);
    for (const Image& other : others) {
        check_same_size(reference, other);
        for (int y = 0; y < other.height; ++y) {
            for (int x = 0; x < other.width; ++x) {
                const float size =
                    std::abs(largest_difference(reference.at(x, y), other.at(x, y), colors));
                if (size > kVisible) sizes.push_back(size);  // false for NaN
            }
        }
    }
    if (sizes.empty()) return 1.0f;
    const auto high = sizes.begin() + static_cast<std::ptrdiff_t>(
                                          (1.0 - kClipped) * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), high, sizes.end());
    for (const float gain : kNice)
        if (gain * *high <= 1.0f) return gain;
    return 1.0f;
}

Image difference_image(const Image& a, const Image& b, float gain) {
    check_same_size(a, b);
    Image result(a.width, a.height, 3);
    const int colors = std::min(a.channels, 3);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const Rgb color =
                difference_color(gain * largest_difference(a.at(x, y), b.at(x, y), colors));
            std::copy(color.begin(), color.end(), result.at(x, y));
        }
    }
    return result;
}

double rmse(const Image& a, const Image& b) {
    check_same_size(a, b);
    const int colors = std::min(a.channels, 3);
    double sum = 0.0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            for (int c = 0; c < colors; ++c) {
                const double difference = static_cast<double>(b.at(x, y)[c]) - a.at(x, y)[c];
                sum += difference * difference;
            }
        }
    }
    const double count = static_cast<double>(a.width) * a.height * colors;
    return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

}  // namespace burnish
