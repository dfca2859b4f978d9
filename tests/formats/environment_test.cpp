#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "burnish/environments.hpp"
#include "burnish/image_io.hpp"
#include "scene/light/studio.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using std::numbers::pi;
using test::error_line;
using test::ScratchFolder;

struct Moments {
    double u, v, solid_angle;  // centroid weighted by radiance, and its integral over the sphere
};

Moments moments_of(const Image& map) {
    Moments m{0, 0, 0};
    for (int y = 0; y < map.height; ++y) {
        const double v = (y + 0.5) / map.height;
        const double texel = 2.0 * pi * pi / (map.width * map.height) * std::sin(pi * v);
        for (int x = 0; x < map.width; ++x) {
            const double weight = texel * static_cast<double>(map.at(x, y)[0]);
            m.u += weight * (x + 0.5) / map.width;
            m.v += weight * v;
            m.solid_angle += weight;
        }
    }
    m.u /= m.solid_angle;
    m.v /= m.solid_angle;
    return m;
}

Image one_box(const glm::vec3& towards, float width_deg, float height_deg) {
    const std::array<SoftBox, 1> box = {
        {{towards, width_deg, height_deg, 0.0f, 0.0f, 0.0f, glm::vec3(1.0f), 1.0f}}};
    return render_studio(1024, 512, box, false);
}

TEST(Studio, DirectionsAreThoseOfTheConvention) {
    EXPECT_LT(glm::length(direction_of(0.5, 0.5) - glm::vec3(0, 0, -1)), 1e-6f);
    EXPECT_LT(glm::length(direction_of(0.75, 0.5) - glm::vec3(1, 0, 0)), 1e-6f);
    EXPECT_LT(glm::length(direction_of(0.1, 0.0) - glm::vec3(0, 1, 0)), 1e-6f);
    for (int i = 1; i < 20; ++i) {
        const double u = i / 20.0, v = 0.9 - 0.04 * i;
        const glm::vec3 d = direction_of(u, v);
        const double x = static_cast<double>(d.x), z = static_cast<double>(d.z);
        EXPECT_NEAR(0.5 + std::atan2(x, -z) / (2.0 * pi), u, 1e-6);
        EXPECT_NEAR(std::acos(static_cast<double>(d.y)) / pi, v, 1e-6);
    }
}

TEST(Studio, ABoxStandsWhereItWasPut) {
    const Moments right = moments_of(one_box({5, 0, 0}, 30, 20));
    EXPECT_NEAR(right.u, 0.75, 1e-3);
    EXPECT_NEAR(right.v, 0.5, 1e-3);
    const Moments ahead_and_up = moments_of(one_box({0, 1, -1}, 5, 5));
    EXPECT_NEAR(ahead_and_up.u, 0.5, 1e-3);
    EXPECT_NEAR(ahead_and_up.v, 0.25, 1e-3);
}

// A pyramid with apex angles a and b subtends 4 asin(sin(a/2) sin(b/2)) steradians.
TEST(Studio, ABoxFillsItsSolidAngle) {
    for (const auto& [a, b] : {std::pair{60.0f, 40.0f}, {20.0f, 20.0f}, {120.0f, 10.0f}}) {
        const double half_a = static_cast<double>(a) * pi / 360.0;
        const double half_b = static_cast<double>(b) * pi / 360.0;
        const double expected = 4.0 * std::asin(std::sin(half_a) * std::sin(half_b));
        EXPECT_NEAR(moments_of(one_box({1, 2, 3}, a, b)).solid_angle / expected, 1.0, 0.01);
        EXPECT_NEAR(moments_of(one_box({0, 1, 0}, a, b)).solid_angle / expected, 1.0, 0.01);
    }
}

TEST(Studio, IsWellExposedAndSmooth) {
    const Environment studio = load_environment("builtin:studio");
    const Image& map = studio.radiance;
    EXPECT_EQ(studio.name, "builtin:studio");
    ASSERT_EQ(map.width, 1024);
    ASSERT_EQ(map.height, 512);
    ASSERT_EQ(map.channels, 3);
    const double mean = moments_of(map).solid_angle / (4.0 * pi);
    EXPECT_GT(mean, 0.3);
    EXPECT_LT(mean, 0.5);
    float brightest = 0.0f, darkest = 1.0f, steepest = 0.0f;
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const float value = *map.at(x, y);
            ASSERT_TRUE(std::isfinite(value));
            brightest = std::max(brightest, value);
            darkest = std::min(darkest, value);
            // Rows near the poles are excluded: one direction spans many texels of u there.
            if (std::abs(y - 255) > 150) continue;
            steepest = std::max(steepest, std::abs(value - *map.at((x + 1) % map.width, y)));
        }
    }
    EXPECT_GT(brightest, 5.0f);
    EXPECT_LT(brightest, 15.0f);
    EXPECT_GT(darkest, 0.0f) << "no metal is black in a room";
    // A hard edge would change by the full 12 between adjacent texels.
    EXPECT_LT(steepest, 0.85f * brightest);
}

TEST(Environment, BuiltInConstants) {
    for (const float value : load_environment("builtin:white").radiance.pixels)
        ASSERT_EQ(value, 1.0f);
    for (const float value : load_environment("builtin:black").radiance.pixels)
        ASSERT_EQ(value, 0.0f);
    EXPECT_NE(error_line<UsageError>([] { load_environment("builtin:stduio"); }).find("'studio'"),
              std::string::npos);
}

TEST(Environment, FilesOfOneThreeAndFourChannels) {
    const ScratchFolder folder;
    for (const int channels : {1, 3, 4}) {
        Image image(16, 8, channels, 0.5f);
        image.at(3, 2)[0] = 40.0f;
        if (channels == 4)
            for (int i = 0; i < 16 * 8; ++i)
                image.pixels[static_cast<std::size_t>(4 * i + 3)] = 1.0f;
        const std::string path = (folder / "e.exr").string();
        write_image(path, image, {});
        const Image read = load_environment(path).radiance;
        ASSERT_EQ(read.channels, 3);
        EXPECT_EQ(read.at(3, 2)[0], 40.0f);
        EXPECT_EQ(read.at(3, 2)[1], channels == 1 ? 40.0f : 0.5f);
        EXPECT_EQ(read.at(15, 7)[2], 0.5f);
    }
}

TEST(Environment, RefusesWhatIsNoRadianceMap) {
    const ScratchFolder folder;
    const std::string path = (folder / "e.exr").string();
    const auto line_for = [&](const Image& image) {
        write_image(path, image, {});
        return error_line([&] { load_environment(path); });
    };
    EXPECT_NE(line_for(Image(16, 16, 3)).find("16x16"), std::string::npos);
    EXPECT_NE(line_for(Image(2, 1, 3)).find("2x1"), std::string::npos);
    Image bad(16, 8, 3, 1.0f);
    bad.at(5, 6)[1] = 1e13f;
    EXPECT_NE(line_for(bad).find("pixel 5,6"), std::string::npos);
    EXPECT_THROW(load_environment((folder / "absent.hdr").string()), Error);
    EXPECT_THROW(load_environment(folder.write("text.hdr", "no picture").string()), Error);
}

TEST(Environment, ValuesThatAreNotFiniteAreReplacedAndCounted) {
    const ScratchFolder folder;
    const std::string path = (folder / "e.exr").string();
    Image image(16, 8, 3, 1.0f);
    image.at(5, 6)[1] = std::numeric_limits<float>::infinity();
    image.at(6, 6)[0] = std::numeric_limits<float>::infinity();
    image.at(7, 6)[2] = -std::numeric_limits<float>::infinity();
    image.at(8, 6)[0] = std::numeric_limits<float>::quiet_NaN();
    write_image(path, image, {});
    std::vector<std::string> warnings;
    const Image read = load_environment(path, &warnings).radiance;
    EXPECT_EQ(read.at(5, 6)[1], 65504.0f);
    EXPECT_EQ(read.at(6, 6)[0], 65504.0f);
    EXPECT_EQ(read.at(7, 6)[2], 0.0f);
    EXPECT_EQ(read.at(8, 6)[0], 0.0f);
    EXPECT_EQ(read.at(8, 6)[1], 1.0f);
    EXPECT_EQ(warnings, (std::vector<std::string>{
                            path + ": 3 values are infinite: 65504 is used, 0 for minus infinity",
                            path + ": 1 value is not a number: 0 is used"}));
}

TEST(Environment, AFileOfIntegersSaysThatLightIsClipped) {
    const ScratchFolder folder;
    const Image image(16, 8, 3, 0.5f);
    for (const char* name : {"e.png", "e.jpg", "e.tif"}) {
        write_image(folder / name, image, {});
        std::vector<std::string> warnings;
        load_environment((folder / name).string(), &warnings);
        ASSERT_EQ(warnings.size(), 1U) << name;
        EXPECT_NE(warnings[0].find("8 bits a channel: light brighter than white is clipped"),
                  std::string::npos);
        EXPECT_NE(warnings[0].find(".hdr or .exr"), std::string::npos);
    }
    write_image(folder / "e.exr", image, {});
    std::vector<std::string> warnings;
    load_environment((folder / "e.exr").string(), &warnings);
    EXPECT_TRUE(warnings.empty());
}

TEST(Environment, NegativeRinging) {
    const ScratchFolder folder;
    Image image(16, 8, 3, 1.0f);
    image.at(0, 0)[2] = -0.25f;
    write_image(folder / "e.exr", image, {});
    EXPECT_EQ(load_environment((folder / "e.exr").string()).radiance.at(0, 0)[2], 0.0f);
}

TEST(Environment, RealOnes) {
    if (test::sample_data().empty()) GTEST_SKIP() << "no sample data (BURNISH_DATA)";
    for (const char* name : {"royal_esplanade_1k.hdr", "venice_sunset_1k.hdr"}) {
        const Environment e =
            load_environment((test::sample_data() / "environments" / name).string());
        EXPECT_EQ(e.radiance.width, 1024);
        EXPECT_GT(*std::max_element(e.radiance.pixels.begin(), e.radiance.pixels.end()), 10.0f);
        // Every environment is brighter above the horizon than below.
        const Moments m = moments_of(e.radiance);
        EXPECT_LT(m.v, 0.5);
    }
}

}  // namespace
}  // namespace burnish
