// Raw camera files: the sensor's own numbers, never the preview, never developed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "support/dng_writer.hpp"
#include "support/paths.hpp"
#include "support/samples.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 96, kHeight = 64;  // patches of 16 x 16

// Above: flat patches of many colors. Below: a ramp from left to right, another slope a channel.
Image patches_and_ramp() {
    Image picture(kWidth, kHeight, 3);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const int column = x / 16, row = y / 16;
            for (int c = 0; c < 3; ++c) {
                const float flat = 0.05f + 0.15f * static_cast<float>((column + 2 * c + row) % 7);
                const float ramp = (0.2f + 0.3f * static_cast<float>(c)) * static_cast<float>(x) /
                                   static_cast<float>(kWidth);
                picture.at(x, y)[c] = y < kHeight / 2 ? flat : ramp;
            }
        }
    return picture;
}

// As the sensor's numbers, developed by hand: a linear 16-bit TIFF.
Image through_tiff(const Image& picture, const fs::path& path) {
    save(path,
         encode({"", "tiff", "uint16", 3, {"compression=none", "tiff:write_exif=0"}}, picture));
    return read_image(path, {.as_data = true});
}

// Two pixels from an edge, where the mosaic is interpolated between equal or evenly rising samples.
bool is_inside(int x, int y) {
    constexpr int kPatch = 16, kReach = 2;
    const auto inside = [](int at, int size) {
        return at % size >= kReach && at % size < size - kReach;
    };
    return y < kHeight / 2 ? inside(x, kPatch) && inside(y, kPatch)
                           : inside(x, kWidth) && inside(y, kHeight / 2);
}

// A step of the sensor's numbers and one of the 16 bits that the decoder gives; rounded once each
// before and after interpolation.
double step_of(const DngSettings& settings) {
    return 1.0 / (settings.white - settings.black) + 2.0 / 65535.0;
}

void expect_sensor_numbers(const fs::path& path, const Image& wanted, const DngSettings& settings) {
    const Image found = read_image(path);
    ASSERT_EQ(found.width, wanted.width);
    ASSERT_EQ(found.height, wanted.height);
    ASSERT_EQ(found.channels, 3);
    double worst = 0.0;
    for (int y = 0; y < wanted.height; ++y)
        for (int x = 0; x < wanted.width; ++x)
            for (int c = 0; c < 3; ++c)
                if (is_inside(x, y))
                    worst = std::max(worst, std::abs(static_cast<double>(found.at(x, y)[c]) -
                                                     static_cast<double>(wanted.at(x, y)[c])));
    EXPECT_LE(worst, step_of(settings)) << path;
}

TEST(RawCamera, IsTheLinearTiffOfTheSameSensorData) {
    const TemporaryFolder folder;
    const Image picture = patches_and_ramp();
    const Image wanted = through_tiff(picture, folder / "linear.tif");
    DngSettings settings;
    save(folder / "plain.dng", dng_of(picture, settings));
    expect_sensor_numbers(folder / "plain.dng", wanted, settings);

    // What a developer of photographs would obey changes nothing.
    settings.orientation = 6;
    settings.as_shot_neutral = {0.3, 1.0, 0.9};
    save(folder / "turned.dng", dng_of(picture, settings));
    expect_sensor_numbers(folder / "turned.dng", wanted, settings);

    settings = {};
    settings.filters = {2, 1, 1, 0};
    settings.black = 0;
    settings.white = 4095;
    settings.has_preview = false;
    save(folder / "other.dng", dng_of(picture, settings));
    expect_sensor_numbers(folder / "other.dng", wanted, settings);
}

// A stack of one material under several lights: sums of lights stay sums, whatever the brightest
// pixel of each picture is.
TEST(RawCamera, DarkPicturesStayDark) {
    const TemporaryFolder folder;
    Image picture = patches_and_ramp();
    const DngSettings settings;
    for (float& value : picture.pixels) value *= 0.125f;
    const Image wanted = through_tiff(picture, folder / "linear.tif");
    save(folder / "dark.dng", dng_of(picture, settings));
    expect_sensor_numbers(folder / "dark.dng", wanted, settings);
}

TEST(RawCamera, ClippedSamplesAreWhiteAndNotReconstructed) {
    const TemporaryFolder folder;
    Image picture(32, 32, 3, 0.25f);
    for (int y = 8; y < 24; ++y)
        for (int x = 8; x < 24; ++x) picture.at(x, y)[1] = 4.0f;  // green only
    save(folder / "clipped.dng", dng_of(picture));
    const Image found = read_image(folder / "clipped.dng");
    const float* pixel = found.at(16, 16);
    EXPECT_NEAR(pixel[0], 0.25, step_of({}));
    EXPECT_EQ(pixel[1], 1.0f);
    EXPECT_NEAR(pixel[2], 0.25, step_of({}));
}

TEST(RawCamera, IsToldByContentAndByName) {
    const TemporaryFolder folder;
    const Image picture = patches_and_ramp();
    // A preview before sensor data, without the tag of DNG; a DNG without a preview; both under
    // the name of a TIFF.
    DngSettings maker;
    maker.says_dng = false;
    DngSettings bare;
    bare.has_preview = false;
    for (const DngSettings& settings : {maker, bare, DngSettings{}}) {
        save(folder / "camera.tif", dng_of(picture, settings));
        const ImageInfo info = read_image_info(folder / "camera.tif");
        EXPECT_EQ(info.format, "raw camera");
        EXPECT_EQ(info.width, kWidth);
        EXPECT_EQ(info.height, kHeight);
        EXPECT_EQ(info.pixel_type, "uint16");
        ASSERT_EQ(info.warnings.size(), 1U);
        EXPECT_NE(info.warnings[0].find("linear camera RGB"), std::string::npos);
    }
    std::vector<std::string> warnings;
    const Texture texture = read_texture(folder / "camera.tif", ColorSpace::srgb, &warnings);
    EXPECT_EQ(texture.color_space, ColorSpace::linear);
    EXPECT_EQ(warnings.size(), 1U);
    EXPECT_TRUE(is_image_file(folder / "camera.tif"));

    for (const char* name : {"a.dng", "b.NEF", "sub.d/c.Cr3", "d.rw2"})
        EXPECT_TRUE(is_raw_camera_name(name)) << name;
    for (const char* name : {"a.tif", "nef", "a.nef.png", "a"})
        EXPECT_FALSE(is_raw_camera_name(name)) << name;
}

TEST(RawCamera, WhatIsNoneIsNotReadAsAPicture) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& name, const Bytes& bytes) {
        save(folder / name, bytes);
        const std::string line = error_of([&] { read_image(folder / name); });
        EXPECT_NE(line.find("raw camera"), std::string::npos) << line;
        EXPECT_NE(line.find("linear 16-bit TIFF"), std::string::npos) << line;
    };
    // An ordinary TIFF under the name of a raw file.
    const Bytes tiff = encode({"", "tiff", "uint8", 3, {"compression=none", "tiff:write_exif=0"}},
                              sample_picture(16, 12, 3));
    refused("renamed.NEF", tiff);
    const std::string text = "no picture at all";
    const auto words = std::as_bytes(std::span(text));
    refused("text.dng", Bytes(words.begin(), words.end()));
    save(folder / "fine.tif", tiff);
    EXPECT_EQ(read_image(folder / "fine.tif").width, 16);

    // A preview before a gray picture, which no camera wrote.
    DngSettings settings;
    settings.says_dng = false;
    Bytes pages = dng_of(patches_and_ramp(), settings);
    using namespace std::string_view_literals;
    const auto mosaic = std::as_bytes(std::span("\6\1\3\0\1\0\0\0\x23\x80"sv));
    const auto found = std::search(pages.begin(), pages.end(), mosaic.begin(), mosaic.end());
    ASSERT_NE(found, pages.end());
    found[8] = std::byte{1};
    found[9] = std::byte{0};
    refused("preview_first.tif", pages);
}

// LibRaw fills what is missing with black.
TEST(RawCamera, CutShortIsRefused) {
    const Bytes whole = dng_of(patches_and_ramp());
    EXPECT_NO_THROW(decode_texture(whole, "a.dng", ColorSpace::linear));
    std::vector<std::uint16_t> samples(std::size_t{32} * 24, 1000);
    samples.resize(samples.size() - 32);  // a row less
    EXPECT_NE(error_of([&] {
                  decode_texture(dng_of(32, 24, samples), "a.dng", ColorSpace::linear);
              }).find("cut short"),
              std::string::npos);
    for (const std::size_t left : {whole.size() - 1, whole.size() / 2, std::size_t{700},
                                   std::size_t{100}, std::size_t{20}}) {
        const std::string line = error_of(
            [&] { decode_texture(std::span(whole).first(left), "a.dng", ColorSpace::linear); });
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        EXPECT_EQ(line.rfind("a.dng: ", 0), 0U) << line;
    }
}

TEST(RawCamera, FlippedBytesAreSurvived) {
    const Bytes good = dng_of(patches_and_ramp());
    constexpr std::size_t kDirectories = 900;  // bytes of headers, where flips hurt most
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::mt19937 random(seed);
        Bytes bytes = good;
        for (unsigned i = 0; i < 1 + seed % 8; ++i)
            bytes[random() % kDirectories] = static_cast<std::byte>(random() % 256);
        SCOPED_TRACE(seed);
        try {
            const Texture texture = decode_texture(bytes, "a.dng", ColorSpace::linear);
            EXPECT_FALSE(texture.empty());
        } catch (const Error& error) {
            const std::string line = error.what();
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        }
    }
}

TEST(RawCamera, OtherContainersAreKnownByTheirFirstBytes) {
    using namespace std::string_literals;
    for (const std::string& head :
         {"FUJIFILMCCD-RAW 0201FF383501"s, "IIRO\x08\0\0\0"s, "\0\0\0\x18"s + "ftypcrx \0\0\0\1"s,
          "IIU\0\x18\0\0\0"s, "II\x1a\0\0\0HEAPCCDR"s, "FOVb\0\0\2\0"s}) {
        Bytes bytes(4096);
        std::memcpy(bytes.data(), head.data(), head.size());
        const std::string line =
            error_of([&] { decode_texture(bytes, "a.img", ColorSpace::linear); });
        EXPECT_NE(line.find("raw camera"), std::string::npos) << line;
    }
}

TEST(RawCamera, SampleFilesShowTheSensorAndNotThePreview) {
    const fs::path path = data_folder() / "field/08_raw_camera/p00.dng";
    if (!fs::exists(path)) GTEST_SKIP() << "no sample data at " << data_folder();
    const Image image = read_image(path);
    EXPECT_EQ(image.width, 256);  // the preview has 16 x 12
    EXPECT_EQ(image.height, 192);
}

}  // namespace
}  // namespace burnish::test
