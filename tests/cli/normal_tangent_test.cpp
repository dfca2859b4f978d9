// NormalTangentTest: domes that are modelled (left of each pair) and the same domes as a normal map
// on a flat square whose texture coordinates are turned (right). With right tangents both look
// alike.
//
// Seen by an orthographic camera, so that there is no parallax, at a whole number of pixels between
// the two of a pair, as display values in steps of 1/255. Left out: two pixels along the squares'
// edges (antialiased against what is behind) and the corner of the right squares with the drawn
// arrow.
//
// What is asked: the mean difference over each square, in each of its three zones, is below 2/255;
// on the flat parts and on the domes up to 3/4 of their radius 97 % of the pixels are within 2/255
// in every channel. Where more is left:
//
// The flat parts of the 8-bit map are not flat: nearly half of the texels are (127, 127, 255), the
// rest one to three codes beside, 0.3 degrees and more off the normal, towards another side in
// every pair, for the texture coordinates are turned. On the polished metal (third column,
// roughness 0) under a picture of the world a reflection moves by up to 1.3 degrees, four texels.
// The other codes are rounded as coarsely. A test below takes this cause away; there a column as a
// whole is asked to stay below 2/255.
//
// Where a dielectric dome falls off, light that leaves the colored base crosses the surface at the
// angle of the geometry (diffuse_through(wo.z) in shaders/lib/shade.glsl), which on the right is
// the flat square's. With max(dot(p.n, wo), 0) there instead, 98 % of that zone are within 2/255
// under one light, not 78 %.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ostream>
#include <vector>

#include "pictures.hpp"

namespace burnish::test {
namespace {

// Of the model, metres: squares of 0.3, the right one 0.32 beside the left one; domes of radius
// 0.1.
constexpr double kLeft[3] = {-1.11, -0.31, 0.49};
constexpr double kTop[5] = {0.95, 0.55, 0.15, -0.25, -0.65};
constexpr double kMiddle = -0.125;  // height in the middle of the picture
constexpr int kPixelsPerMetre = 200;
constexpr int kSquare = 60;
constexpr int kPitch = 64;
constexpr int kSide = 456;

enum Zone { inner_dome, dome_edge, flat, no_zone, anywhere };

Zone zone_of(int x, int y) {
    if (std::min({x, y, kSquare - 1 - x, kSquare - 1 - y}) < 2) return no_zone;
    if (x < 0.3 * kSquare && y > 0.7 * kSquare) return no_zone;
    const double r = std::hypot(x + 0.5 - kSquare / 2, y + 0.5 - kSquare / 2) / kPixelsPerMetre;
    return r < 0.075 ? inner_dome : r < 0.105 ? dome_edge : flat;
}

struct Square {
    int x, y;
};

Square left_square(int column, int row) {
    return {static_cast<int>(std::lround(kSide / 2 + kPixelsPerMetre * kLeft[column])),
            static_cast<int>(std::lround(kSide / 2 - kPixelsPerMetre * (kTop[row] - kMiddle)))};
}
Square right_square(int column, int row) {
    return {left_square(column, row).x + kPitch, left_square(column, row).y};
}

struct Difference {
    double mean = 0;        // of |a - b| over pixels and channels, in steps of 1/255
    double worst_mean = 0;  // of the worst of the five squares of the column
    double within_2 = 0;    // share of pixels with all channels within 2/255
};

using SquareOf = Square (*)(int column, int row);

Difference difference(const Image& a, SquareOf square_a, const Image& b, SquareOf square_b,
                      int column, Zone zone) {
    double sum = 0, count = 0, within = 0, worst = 0;
    for (int row = 0; row < 5; ++row) {
        const Square sa = square_a(column, row), sb = square_b(column, row);
        double square_sum = 0, square_count = 0;
        for (int y = 0; y < kSquare; ++y) {
            for (int x = 0; x < kSquare; ++x) {
                const Zone here = zone_of(x, y);
                if (here == no_zone || (zone != anywhere && zone != here)) continue;
                const float* pa = a.at(sa.x + x, sa.y + y);
                const float* pb = b.at(sb.x + x, sb.y + y);
                double largest = 0;
                for (int c = 0; c < 3; ++c) {
                    const double d = std::abs(pa[c] - pb[c]);
                    square_sum += d / 3;
                    largest = std::max(largest, d);
                }
                within += largest <= 2;
                square_count += 1;
            }
        }
        worst = std::max(worst, square_sum / square_count);
        sum += square_sum;
        count += square_count;
    }
    return {sum / count, worst, within / count};
}

Difference left_and_right(const Image& image, int column, Zone zone) {
    return difference(image, left_square, image, right_square, column, zone);
}

void note(int column, Zone zone, const Difference& d) {
    const char* const names[] = {"inner", "edge", "flat", "", "whole"};
    testing::Test::RecordProperty(fmt::format("column_{}_{}", column, names[zone]),
                                  fmt::format("mean {:.2f}, worst {:.2f}, {:.1f} % within 2",
                                              d.mean, d.worst_mean, 100 * d.within_2));
}

struct Setting {
    const char* name;
    const char* environment;  // below the sample data
    const char* light;
};

void PrintTo(const Setting& setting, std::ostream* to) {
    *to << setting.name;
}

constexpr Setting kSettings[] = {{"light", "none", "30,40"},
                                 {"venice", "environments/venice_sunset_1k.hdr", "none"},
                                 {"royal", "environments/royal_esplanade_1k.hdr", "none"}};

class NormalTangentTest : public testing::TestWithParam<Setting> {
  protected:
    void SetUp() override {
        BURNISH_REQUIRE_GL();
        const std::string model = sample_model("NormalTangentTest");
        BURNISH_REQUIRE_SAMPLE(model);
        const Setting& s = GetParam();
        const std::string environment =
            std::string(s.environment) == "none" ? "none" : sample(s.environment).string();
        stage_ = stage_of(model, environment, {s.light},
                          {{"samples", "16"},
                           {"width", "456"},
                           {"height", "456"},
                           {"image_light_samples", "16"}});
        stage_.camera = {};
        stage_.camera.orthographic = true;
        stage_.camera.position = {0.0f, kMiddle, 3.0f};
        stage_.camera.target = {0.0f, kMiddle, 0.0f};
        stage_.camera.ymag = 0.5f * kSide / kPixelsPerMetre;
    }

    Image shown() const { return shown_in_steps(picture_of(stage_), ToneMap::khronos_neutral); }
    Texture& normal_map() {
        const int index = stage_.scene.materials.at(0).normal_texture.texture;
        return stage_.scene.textures.at(static_cast<std::size_t>(index));
    }
    // Every code of the 8-bit map becomes a float: code / 255 of `change(code)`, red and green.
    template <typename Change>
    void change_codes(const Change& change) {
        Texture& map = normal_map();
        ASSERT_EQ(map.type, TexelType::u8);
        const std::size_t count =
            static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
        const std::size_t channels = static_cast<std::size_t>(map.channels);
        std::vector<float> texels(3 * count);
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                const auto code = static_cast<float>(map.texels[i * channels + c]);
                texels[3 * i + c] = (c < 2 ? change(code) : code) / 255.0f;
            }
        }
        map.type = TexelType::f32;
        map.channels = 3;
        map.texels.resize(texels.size() * sizeof(float));
        std::memcpy(map.texels.data(), texels.data(), map.texels.size());
    }

    Stage stage_;
};

TEST_P(NormalTangentTest, MappedDomesLookLikeModelledOnes) {
    const Image picture = shown();
    const bool lit_by_picture = !stage_.environment.radiance.empty();
    for (int column = 0; column < 3; ++column) {
        const bool reflects = column == 2 && lit_by_picture;  // see the next test
        const Difference whole = left_and_right(picture, column, anywhere);
        note(column, anywhere, whole);
        EXPECT_LT(whole.mean, 2.0) << "column " << column;
        for (const Zone zone : {inner_dome, dome_edge, flat}) {
            const Difference d = left_and_right(picture, column, zone);
            note(column, zone, d);
            if (reflects) {
                EXPECT_LT(d.mean, 2.5) << "column " << column << ", zone " << zone;
                continue;
            }
            EXPECT_LT(d.worst_mean, 2.0) << "column " << column << ", zone " << zone;
            EXPECT_GT(d.within_2, zone == dome_edge ? 0.65 : 0.97)
                << "column " << column << ", zone " << zone;
        }
    }
}

class NormalTangentMetalTest : public NormalTangentTest {};

// The polished metal differs by no more than the rounding of the map's codes to whole numbers does:
// half a code up against half a code down. With the flat codes flat, its squares agree.
TEST_P(NormalTangentMetalTest, WhatDiffersOnTheMetalIsTheRoundingOfTheMap) {
    const Image as_is = shown();
    const Texture map = normal_map();
    change_codes([](float code) { return code + 0.5f; });
    const Image up = shown();
    normal_map() = map;
    change_codes([](float code) { return code - 0.5f; });
    const Image down = shown();
    for (const Zone zone : {inner_dome, dome_edge, flat}) {
        EXPECT_LT(left_and_right(as_is, 2, zone).mean,
                  difference(up, right_square, down, right_square, 2, zone).mean)
            << "zone " << zone;
    }

    normal_map() = map;
    change_codes([](float code) { return std::abs(code - 127.5f) < 4.0f ? 127.5f : code; });
    const Image flattened = shown();
    EXPECT_LT(left_and_right(flattened, 2, flat).worst_mean, 0.6);
    EXPECT_GT(left_and_right(flattened, 2, flat).within_2, 0.99);
    EXPECT_LT(left_and_right(flattened, 2, inner_dome).worst_mean, 1.0);
}

class NormalTangentMistakeTest : public NormalTangentTest {};

// That these differences can be large: the green channel read upside down.
TEST_P(NormalTangentMistakeTest, GreenUpsideDownIsFarOff) {
    stage_.scene.materials.at(0).flip_green = true;
    const Image wrong = shown();
    for (const int column : {0, 1})
        EXPECT_GT(left_and_right(wrong, column, inner_dome).mean, 15.0) << "column " << column;
}

std::string name_of_setting(const testing::TestParamInfo<Setting>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Under, NormalTangentTest, testing::ValuesIn(kSettings), name_of_setting);
INSTANTIATE_TEST_SUITE_P(Under, NormalTangentMetalTest, testing::Values(kSettings[1]),
                         name_of_setting);
INSTANTIATE_TEST_SUITE_P(Under, NormalTangentMistakeTest, testing::Values(kSettings[0]),
                         name_of_setting);

}  // namespace
}  // namespace burnish::test
