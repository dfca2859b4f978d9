// Figures: what lies where, what does not fit, what cannot be written.
#include "burnish/plot/figure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/plot/panels.hpp"

namespace burnish::plot {
namespace {

namespace fs = std::filesystem;

Image checks(int width, int height) {
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                image.at(x, y)[c] = static_cast<float>((x * 7 + y * 13 + c * 31) % 256) / 255.0f;
    return image;
}

TEST(Figure, PicturesAreShownTexelForTexel) {
    const Image picture = checks(120, 80);
    Figure figure;
    figure.title = "A title that is longer than the picture and has to be wrapped into lines";
    figure.rows = {{"row", {picture_panel(picture, "a"), picture_panel(checks(60, 60), "b")}}};
    const DrawnFigure drawn = draw_figure(figure, 2);
    ASSERT_EQ(drawn.areas.size(), 2u);
    const Box box = drawn.areas[0].box;
    EXPECT_EQ(box.width, 60);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(drawn.image.at(static_cast<int>(2 * box.x) + x,
                                           static_cast<int>(2 * box.y) + y)[c],
                            picture.at(x, y)[c], 1e-6f);
}

// Panels of different sizes, rows of different lengths: none on another, none outside.
TEST(Figure, NothingOverlaps) {
    Figure figure;
    figure.title = "title";
    figure.caption = "caption";
    for (int row = 0; row < 3; ++row) {
        PanelRow& r = figure.rows.emplace_back();
        for (int column = 0; column <= row; ++column)
            r.panels.push_back(
                picture_panel(checks(80 + 60 * column, 100), "a wide title of several words"));
        r.panels.back().note = "a note of some words, to be wrapped";
    }
    figure.rows[1].bar = ColorBar{{ScaleKind::linear, 0, 1}, "D", 12.0, false};
    const DrawnFigure drawn = draw_figure(figure, 1);
    ASSERT_EQ(drawn.areas.size(), 7u);
    for (std::size_t i = 0; i < drawn.areas.size(); ++i) {
        const Box a = drawn.areas[i].box;
        EXPECT_GE(a.x, 0);
        EXPECT_LE(a.right(), drawn.image.width);
        EXPECT_LE(a.bottom(), drawn.image.height);
        for (std::size_t j = 0; j < i; ++j) {
            const Box b = drawn.areas[j].box;
            EXPECT_TRUE(a.right() <= b.x || b.right() <= a.x || a.bottom() <= b.y ||
                        b.bottom() <= a.y)
                << i << " " << j;
        }
    }
}

TEST(Figure, MorePanelsThanFitAreRefused) {
    Figure figure;
    EXPECT_THROW(draw_figure(figure), UsageError);
    figure.rows.emplace_back();
    EXPECT_THROW(draw_figure(figure), UsageError);
    figure.rows[0].panels.resize(kMostPanels + 1);
    EXPECT_THROW(draw_figure(figure), UsageError);
    figure.rows[0].panels.resize(100);  // 100 x 260 px x 2 is wider than a picture may be
    EXPECT_THROW(draw_figure(figure), UsageError);
    Figure one;
    one.rows = {{"", {picture_panel(checks(8, 8), "")}}};
    EXPECT_THROW(draw_figure(one, 0), UsageError);
    EXPECT_THROW(draw_figure(one, 1e9), UsageError);
}

class FigureFile : public testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            fs::temp_directory_path() /
            ("burnish-figure-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
             "-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)));
        fs::create_directory(folder_);
        figure_.title = "a title";
        figure_.rows = {{"", {picture_panel(checks(40, 40), "panel")}}};
    }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path folder_;
    Figure figure_;
};

TEST_F(FigureFile, PngHasItsMetadata) {
    const fs::path path = folder_ / "a.png";
    write_figure(figure_, path, {{"burnish:command", "burnish x"}, {"burnish:version", "1"}});
    const ImageInfo info = read_image_info(path);
    EXPECT_EQ(info.metadata.at("burnish:command"), "burnish x");
    EXPECT_EQ(info.metadata.at("burnish:version"), "1");
    EXPECT_EQ(info.channels, 3);
}

TEST_F(FigureFile, OtherEndingsAndPlacesThatAreNotThereAreRefused) {
    EXPECT_THROW(write_figure(figure_, folder_ / "a.jpg", {}), UsageError);
    EXPECT_THROW(write_figure(figure_, folder_ / "a", {}), UsageError);
    EXPECT_THROW(write_figure(figure_, folder_ / "none" / "a.png", {}), Error);
    EXPECT_THROW(write_figure(figure_, folder_ / "none" / "a.svg", {}), Error);
    fs::create_directory(folder_ / "dir.svg");
    EXPECT_THROW(write_figure(figure_, folder_ / "dir.svg", {}), Error);
}

TEST_F(FigureFile, AFailureLeavesTheOldFile) {
    const fs::path path = folder_ / "a.svg";
    std::ofstream(path) << "old";
    figure_.rows[0].panels[0].draw = [](Canvas&, const Box&) { throw Error("stop"); };
    EXPECT_THROW(write_figure(figure_, path, {}), Error);
    std::string text;
    std::ifstream(path) >> text;
    EXPECT_EQ(text, "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}), 1);
}

// A line that leaves through the top is cut at the axis and said to be.
TEST(LinePanel, LinesKeepToTheirAxes) {
    LinePlot plot;
    plot.x = {"x", {ScaleKind::linear, 0, 1}};
    plot.y = {"y", {ScaleKind::linear, 0, 1}};
    plot.lines = {series(
        0, "a", {{0, 0.5}, {0.5, 1e300}, {1, std::numeric_limits<double>::quiet_NaN()}, {1, 0.2}})};
    Figure figure;
    figure.rows = {{"", {line_panel(plot, "title")}}};
    const DrawnFigure drawn = draw_figure(figure, 1);
    const Box box = drawn.areas.at(0).box;
    for (int y = 0; y < static_cast<int>(box.y) - 2; ++y)
        for (int x = static_cast<int>(box.x); x < static_cast<int>(box.right()); ++x) {
            const float* p = drawn.image.at(x, y);
            // Blue is the line's alone; the title is grey.
            EXPECT_LT(p[2] - p[0], 0.1f) << x << " " << y;
        }
}

TEST(BarPanel, LengthsAreValues) {
    Figure figure;
    std::vector<Bar> bars(3);
    bars[0].value = 1;
    bars[1].value = 0.5;
    figure.rows = {{"", {bar_panel({bars, "ms"}, "title")}}};
    const DrawnFigure drawn = draw_figure(figure, 1);
    const Box box = drawn.areas.at(0).box;
    const auto length = [&](int row) {
        int pixels = 0;
        const int y = static_cast<int>(box.y + 26 * row + 18);  // off the whisker's middle
        for (int x = static_cast<int>(box.x) + 1; x < static_cast<int>(box.right()); ++x) {
            const float* p = drawn.image.at(x, y);
            if (p[2] > p[0] + 0.3f) ++pixels;
        }
        return pixels;
    };
    EXPECT_NEAR(length(0), box.width, 3);
    EXPECT_NEAR(length(1), box.width / 2, 3);
    EXPECT_EQ(length(2), 0);
}

}  // namespace
}  // namespace burnish::plot
