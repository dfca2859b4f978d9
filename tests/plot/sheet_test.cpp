#include "plot/sheet.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "support/samples.hpp"

namespace burnish::test {
namespace {

// Pixels of `image` in the box that are brighter than `level`.
int bright_pixels(const Image& image, int x0, int y0, int x1, int y1, float level) {
    int count = 0;
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) count += image.at(x, y)[0] > level ? 1 : 0;
    }
    return count;
}

TEST(Sheet, PlacesCellsOnAGrid) {
    const SheetOptions options{.padding_px = 10, .background = 0.2f};
    const Image sheet = compose_sheet({{{Image(30, 20, 3, 1.0f), ""}, {Image(40, 25, 1, 0.5f), ""}},
                                       {{Image(), ""}, {Image(12, 8, 3, 0.75f), ""}}},
                                      options);
    EXPECT_EQ(sheet.width, 10 + 30 + 10 + 40 + 10);
    EXPECT_EQ(sheet.height, 10 + 25 + 10 + 8 + 10);
    EXPECT_EQ(sheet.at(9, 10)[0], 0.2f);
    EXPECT_EQ(sheet.at(10, 10)[0], 1.0f);
    EXPECT_EQ(sheet.at(39, 29)[2], 1.0f);
    EXPECT_EQ(sheet.at(39, 30)[2], 0.2f);
    EXPECT_EQ(sheet.at(50, 34)[1], 0.5f);
    EXPECT_EQ(sheet.at(61, 52)[1], 0.75f);
    EXPECT_EQ(sheet.at(10, 45)[1], 0.2f);  // the empty cell
}

TEST(Sheet, DrawsLabelsInTheirPlace) {
    const Image sheet = compose_sheet({{{Image(120, 40, 3, 0.0f), "follow-grain"}}});
    const int label_bottom = sheet.height - 40 - 12;
    const int ink = bright_pixels(sheet, 0, 12, sheet.width, label_bottom, 0.5f);
    EXPECT_GT(ink, 100);
    EXPECT_LT(ink, 1500);
    // Neither the image below nor the border above is written on.
    EXPECT_EQ(bright_pixels(sheet, 12, label_bottom, 132, sheet.height - 12, 0.01f), 0);
    EXPECT_EQ(bright_pixels(sheet, 0, 0, sheet.width, 12, 0.3f), 0);
}

TEST(Sheet, WrapsLongLabelsAndWidensForLongWords) {
    const Image image(140, 20, 3, 0.0f);
    const Image one = compose_sheet({{{image, "short"}}});
    const Image three = compose_sheet({{{image, "many words of a label that need some lines"}}});
    EXPECT_EQ(three.width, one.width);
    EXPECT_GT(three.height, one.height + 30);
    const Image word = compose_sheet({{{image, "a_single_word_that_is_wider_than_its_picture"}}});
    EXPECT_GT(word.width, one.width + 100);
    EXPECT_EQ(word.height, one.height);
    for (const Image* sheet : {&three, &word}) {
        // Nothing is cut off: the borders stay clear.
        const Image& all = *sheet;
        EXPECT_EQ(bright_pixels(all, all.width - 11, 0, all.width, all.height, 0.3f), 0);
        EXPECT_EQ(bright_pixels(all, 0, 0, all.width, 11, 0.3f), 0);
    }
}

TEST(Sheet, LabelsAreUtf8) {
    const Image image(300, 8, 3, 0.0f);
    const auto same = [&](const std::string& a, const std::string& b) {
        return compose_sheet({{{image, a}}}).pixels == compose_sheet({{{image, b}}}).pixels;
    };
    EXPECT_FALSE(same("\u03b1 = 0.1", "? = 0.1"));
    EXPECT_FALSE(same("K\u00f6ln", "K\u00fcln"));
    // Bytes that are no UTF-8 become U+FFFD, and a line break ends a word as a space does.
    EXPECT_TRUE(same("a\xff", "a\ufffd"));
    EXPECT_TRUE(same("K\u00f6ln\nb", "K\u00f6ln b"));
}

TEST(Sheet, LaysTransparentImagesOverTheBackground) {
    Image image(1, 1, 4);
    image.pixels = {1.0f, 1.0f, 1.0f, 0.25f};
    const SheetOptions options{.padding_px = 0, .background = 0.2f};
    EXPECT_FLOAT_EQ(compose_sheet({{{image, ""}}}, options).pixels[0], 0.4f);
}

TEST(Sheet, RefusesAbsurdSizes) {
    const SheetCell cell{Image(20000, 1, 1), ""};
    EXPECT_THROW(compose_sheet({{cell, cell}}), Error);
}

TEST(Difference, IsBlackWhereEqualWarmWhereBrighter) {
    Image a(3, 1, 3, 0.5f), b = a;
    b.at(1, 0)[1] = 0.6f;
    b.at(2, 0)[2] = 0.4f;
    const Image difference = difference_image(a, b, 4.0f);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(difference.at(0, 0)[c], 0.0f);
    EXPECT_GT(difference.at(1, 0)[0], 2.0f * difference.at(1, 0)[2]);  // orange
    EXPECT_GT(difference.at(2, 0)[2], 2.0f * difference.at(2, 0)[0]);  // blue
}

TEST(Difference, GrowsInLightnessUpToOneOverGain) {
    float last = -1.0f;
    for (int step = 0; step <= 10; ++step) {
        const Image a(1, 1, 1, 0.0f), b(1, 1, 1, 0.025f * static_cast<float>(step));
        const Image color = difference_image(a, b, 4.0f);
        const float luma =
            0.2126f * color.pixels[0] + 0.7152f * color.pixels[1] + 0.0722f * color.pixels[2];
        EXPECT_GT(luma, last);
        last = luma;
    }
    const Image a(1, 1, 1, 0.0f);
    EXPECT_EQ(difference_image(a, Image(1, 1, 1, 0.25f), 4.0f).pixels,
              difference_image(a, Image(1, 1, 1, 0.9f), 4.0f).pixels);
}

// Differences of 1/256 .. n/256 over one row.
Image even_steps(int n) {
    Image image(n, 1, 1);
    for (int x = 0; x < n; ++x) image.at(x, 0)[0] = static_cast<float>(x + 1) / 256.0f;
    return image;
}

TEST(Difference, GainClipsNoMoreThanAFewOfThePixelsThatDiffer) {
    const Image black(200, 1, 1, 0.0f);
    // The 98 % quantile of 1..200 of 256 is 0.77: times 1 it fits, times 1.5 it does not.
    EXPECT_EQ(difference_gain(black, {even_steps(200)}), 1.0f);
    const Image low(20, 1, 1, 0.0f);
    EXPECT_EQ(difference_gain(low, {even_steps(20)}), 12.0f);  // 19/256 x 12 = 0.89
    // One pixel in a hundred may clip, one in ten may not; all the same is no difference at all.
    Image spiked(100, 1, 1, 0.1f);
    spiked.at(50, 0)[0] = 0.9f;
    const Image flat(100, 1, 1, 0.0f);
    EXPECT_EQ(difference_gain(flat, {spiked}), 8.0f);
    for (int x = 0; x < 10; ++x) spiked.at(x, 0)[0] = -0.9f;
    EXPECT_EQ(difference_gain(flat, {spiked}), 1.0f);
    EXPECT_EQ(difference_gain(flat, {flat, Image(100, 1, 1, 0.001f)}), 1.0f);
    EXPECT_EQ(difference_gain(flat, {Image(100, 1, 1, std::nanf(""))}), 1.0f);
}

TEST(Difference, ShowsNanInMagenta) {
    const Image a(1, 1, 3, 0.0f), b(1, 1, 3, std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(difference_image(a, b).pixels, (std::vector<float>{1.0f, 0.0f, 1.0f}));
}

TEST(Rmse, IsTheRootOfTheMeanSquareOverColors) {
    Image a(2, 1, 4, 0.0f), b(2, 1, 4, 0.0f);
    b.at(0, 0)[0] = 3.0f;
    b.at(1, 0)[2] = 4.0f;
    b.at(1, 0)[3] = 100.0f;  // alpha
    EXPECT_DOUBLE_EQ(rmse(a, b), std::sqrt(25.0 / 6.0));
    EXPECT_EQ(rmse(a, a), 0.0);
    EXPECT_THROW(rmse(a, Image(1, 2, 4)), Error);
    EXPECT_THROW(difference_image(a, Image(2, 1, 1)), Error);
}

}  // namespace
}  // namespace burnish::test
