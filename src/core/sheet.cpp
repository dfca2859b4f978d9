#include "core/sheet.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "burnish/error.hpp"
#include "core/image_format.hpp"

namespace burnish {
namespace {

constexpr const char* kDefaultFonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                         "DejaVuSans", "DejaVu Sans", ""};

// The label's place above an image, and its baseline in it, in units of the font size: descenders
// of Latin text reach 0.25 below the baseline, capitals and accents 1.0 above.
constexpr double kLabelHeight = 1.6;
constexpr double kBaseline = 1.15;

struct Layout {
    std::vector<int> column_x, column_width;
    std::vector<int> row_y, row_height, label_height;
    int width = 0;
    int height = 0;
};

// A font that OpenImageIO can load, or nothing with the reason.
struct Font {
    bool found = false;
    std::string name;
    std::string error;
};

Font find_font(const SheetOptions& options) {
    Font font;
    const auto try_font = [&](const std::string& name) {
        const OIIO::ROI size = OIIO::ImageBufAlgo::text_size("Hg", options.font_px, name);
        font.found = size.defined() && size.width() > 0;
        font.name = name;
        if (!font.found && font.error.empty()) font.error = one_line(OIIO::geterror());
        return font.found;
    };
    if (!options.font.empty()) {
        try_font(options.font);
        return font;
    }
    for (const char* name : kDefaultFonts) {
        if (try_font(name)) break;
    }
    return font;
}

int text_width(const std::string& text, const Font& font, int font_px) {
    if (!font.found || text.empty()) return 0;
    const OIIO::ROI size = OIIO::ImageBufAlgo::text_size(text, font_px, font.name);
    return size.defined() ? std::max(size.xend, 0) : 0;
}

Layout lay_out(const std::vector<std::vector<SheetCell>>& rows, const SheetOptions& options,
               const Font& font) {
    Layout layout;
    std::int64_t x = options.padding_px, y = options.padding_px;
    for (const std::vector<SheetCell>& row : rows) {
        int height = 0;
        bool labelled = false;
        for (std::size_t column = 0; column < row.size(); ++column) {
            if (layout.column_width.size() <= column) layout.column_width.push_back(0);
            int& width = layout.column_width[column];
            width = std::max({width, row[column].image.width,
                              text_width(one_line(row[column].label), font, options.font_px)});
            height = std::max(height, row[column].image.height);
            labelled = labelled || !row[column].label.empty();
        }
        layout.row_y.push_back(static_cast<int>(y));
        layout.row_height.push_back(height);
        layout.label_height.push_back(
            labelled ? static_cast<int>(std::ceil(kLabelHeight * options.font_px)) : 0);
        y += layout.label_height.back() + height + options.padding_px;
        check_image_size(1, y, "contact sheet");
    }
    for (const int width : layout.column_width) {
        layout.column_x.push_back(static_cast<int>(x));
        x += width + options.padding_px;
        check_image_size(x, 1, "contact sheet");
    }
    layout.width = static_cast<int>(x);
    layout.height = static_cast<int>(y);
    return layout;
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
// orange holds for colour-blind eyes too.
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

Sheet compose_sheet(const std::vector<std::vector<SheetCell>>& rows, const SheetOptions& options) {
    const Font font = find_font(options);
    const Layout layout = lay_out(rows, options, font);
    check_image_size(layout.width, layout.height, "contact sheet");
    Sheet sheet;
    sheet.image = Image(layout.width, layout.height, 3, options.background);
    // The buffer draws into the pixels of the sheet.
    OIIO::ImageBuf canvas(OIIO::ImageSpec(layout.width, layout.height, 3, OIIO::TypeFloat),
                          sheet.image.pixels.data());
    const std::array<float, 3> color = {options.text, options.text, options.text};
    bool label_missing = false;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (std::size_t column = 0; column < rows[row].size(); ++column) {
            const SheetCell& cell = rows[row][column];
            const int x = layout.column_x[column], y = layout.row_y[row];
            paste(cell.image, sheet.image, x, y + layout.label_height[row], options.background);
            const std::string label = one_line(cell.label);
            if (label.empty()) continue;
            const int baseline = y + static_cast<int>(std::lround(kBaseline * options.font_px));
            label_missing |= !font.found || !OIIO::ImageBufAlgo::render_text(
                                                canvas, x, baseline, label, options.font_px,
                                                font.name, OIIO::cspan<float>(color));
        }
    }
    if (label_missing) {
        sheet.warning = "contact sheet without labels: no font could be loaded (install " +
                        std::string("fonts-dejavu-core): ") + font.error;
    }
    return sheet;
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
