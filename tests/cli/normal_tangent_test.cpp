// NormalTangentTest: domes that are modelled (left of each pair) and the same domes as a normal map on
// a flat square whose texture coordinates are turned (right). With right tangents both look alike.
//
// Seen by an orthographic camera, so that there is no parallax, at a whole number of pixels between
// the two of a pair, as display values in steps of 1/255. Left out: two pixels along the squares'
// edges (antialiased against what is behind) and the corner of the right squares with the drawn arrow.
// Where larger differences come from, each shown by a test that takes its cause away:
// - The flat texels of the 8-bit map are (128, 128, 255): 0.32 degrees off the normal, towards
//   another side in every pair, for the texture coordinates are turned. On the polished metal (3rd
//   column, roughness 0) a reflection moves by up to 1.3 degrees, four texels of the environment.
// - On the domes of the metal the other codes are rounded as coarsely.
// - Where a dome of the dielectrics (columns 1, 2) falls off, the light that leaves the coloured base
//   crosses the surface at the angle of the geometry (shaders/lib/shade.glsl, diffuse_through), which
//   on the right is the square's.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "pictures.hpp"

namespace burnish::test {
namespace {

// Of the model, metres: squares of 0.3, the right one 0.32 beside the left one; domes of radius 0.1.
constexpr double kLeft[3] = {-1.11, -0.31, 0.49};
constexpr double kTop[5] = {0.95, 0.55, 0.15, -0.25, -0.65};
constexpr double kMiddle = -0.125;  // height in the middle of the picture
constexpr int kPixelsPerMetre = 200;
constexpr int kSquare = 60;
constexpr int kPitch = 64;
constexpr int kSide = 456;

enum Zone { inner_dome, dome_edge, flat, no_zone };

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
                if (zone_of(x, y) != zone) continue;
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

void note(const std::string& name, double value) {
    testing::Test::RecordProperty(name, std::to_string(value));
}

struct Setting {
    const char* name;
    const char* environment;  // below the sample data
    const char* light;
};

// Lights that are given are constant: no noise but of the edges.
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
        stage_ = stage_of(model, environment, {s.light}, {{"samples", "32"}, {"width", "456"},
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
    for (int column = 0; column < 3; ++column) {
        for (const Zone zone : {inner_dome, dome_edge, flat}) {
            const Difference d = left_and_right(picture, column, zone);
            std::printf("%s col %d zone %d: mean %.2f worst %.2f within %.1f\n",GetParam().name,column,int(zone),d.mean,d.worst_mean,100*d.within_2);
        }
    }
}

TEST_P(NormalTangentTest, GreenUpsideDownIsSeen) {
    const Image right = shown();
    stage_.scene.materials.at(0).flip_green = true;
    const Image wrong = shown();
    for (int column = 0; column < 3; ++column) {
        std::printf("flip col %d %g vs %g\n",column,left_and_right(wrong, column, inner_dome).mean,left_and_right(right, column, inner_dome).mean);
    }
}

TEST_P(NormalTangentTest, FlatCodes) {
    change_codes([](float code) { return std::abs(code - 127.5f) < 4 ? 127.5f : code; });
    const Image picture = shown();
    for (int column = 0; column < 3; ++column) {
        for (const Zone zone : {inner_dome, dome_edge, flat}) {
            const Difference d = left_and_right(picture, column, zone);
            std::printf("FLAT %s col %d zone %d: mean %.2f worst %.2f within %.1f\n",GetParam().name,column,int(zone),d.mean,d.worst_mean,100*d.within_2);
        }
    }
}
TEST_P(NormalTangentTest, Codes) {
    const Stage stage=stage_;
    change_codes([](float code) { return code+.5f; });
    const Image a = shown();
    stage_=stage;
    change_codes([](float code) { return code-.5f; });
    const Image b = shown();
    for (int column = 0; column < 3; ++column) {
        for (const Zone zone : {inner_dome, dome_edge, flat}) {
            const Difference d = difference(a,right_square,b,right_square, column, zone);
            std::printf("BAND %s col %d zone %d: mean %.2f worst %.2f within %.1f\n",GetParam().name,column,int(zone),d.mean,d.worst_mean,100*d.within_2);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Under, NormalTangentTest, testing::ValuesIn(kSettings),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace burnish::test
