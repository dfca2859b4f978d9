// What the readers make of good files: values, depth, channels, color encoding.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <thread>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "image/guard/format.hpp"
#include "support/paths.hpp"
#include "support/samples.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

Texture decoded(const Bytes& bytes) {
    return decode_texture(bytes, "sample", ColorSpace::srgb);
}

std::vector<int> bytes_of(const Texture& texture) {
    std::vector<int> values;
    for (const std::byte value : texture.texels) values.push_back(std::to_integer<int>(value));
    return values;
}

float value_at(const Texture& texture, std::size_t index) {
    float value = 0.0f;
    std::uint16_t code = 0;
    switch (texture.type) {
        case TexelType::u8:
            return static_cast<float>(texture.texels[index]) / 255.0f;
        case TexelType::u16:
            std::memcpy(&code, texture.texels.data() + index * 2, 2);
            return static_cast<float>(code) / 65535.0f;
        case TexelType::f32:
            std::memcpy(&value, texture.texels.data() + index * 4, 4);
            return value;
    }
    return value;
}

// ---- every format ---------------------------------------------------------------------------

class EveryFormat : public testing::TestWithParam<Encoding> {};

// Root mean square loss that the encoding may cause, in display values.
double allowed_loss(const Encoding& encoding) {
    // Waves of another length in each channel, whose color 4:2:0 halves.
    if (encoding.label.find("jpeg") != std::string::npos) return 0.08;
    if (encoding.label == "webp_lossy" || encoding.format == "heif") return 0.1;
    if (encoding.label.find("dwaa") != std::string::npos) return 0.02;
    if (encoding.label.find("b44") != std::string::npos) return 0.05;
    // A step of the codes; for half and RGBE one of 8 to 10 bits of mantissa.
    return encoding.pixel_type == "uint16" ? 1.0 / 65535 : 1.0 / 255;
}

TEST_P(EveryFormat, KeepsValuesSizeAndDepth) {
    const Encoding& encoding = GetParam();
    const Image picture = sample_picture(45, 31, encoding.channels);
    const Texture texture = decoded(encode(encoding, picture));
    EXPECT_EQ(texture.width, 45);
    EXPECT_EQ(texture.height, 31);
    ASSERT_EQ(texture.channels, encoding.channels);
    const TexelType type = encoding.pixel_type == "uint8"    ? TexelType::u8
                           : encoding.pixel_type == "uint16" ? TexelType::u16
                                                             : TexelType::f32;
    ASSERT_EQ(texture.type, type);
    EXPECT_EQ(texture.color_space, type == TexelType::f32 ? ColorSpace::linear : ColorSpace::srgb);
    // Float formats with alpha hold it premultiplied, whatever the picture was: made for colors.
    const bool divided = encoding.channels == 4 && encoding.format == "openexr";
    // OpenImageIO's encoder of WebP changes colors under alpha; image_formats_test.cpp has a file of
    // another one.
    const bool alpha_only = encoding.label == "webp_alpha";
    double sum = 0.0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        if (alpha_only && i % 4 != 3) continue;
        float expected = picture.pixels[i];
        if (divided && i % 4 != 3) expected /= picture.pixels[i / 4 * 4 + 3];
        sum += std::pow(static_cast<double>(value_at(texture, i)) - expected, 2);
    }
    EXPECT_LE(std::sqrt(sum / static_cast<double>(picture.pixels.size())), allowed_loss(encoding));
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat, testing::ValuesIn(encodings()),
                         [](const auto& encoding) { return encoding.param.label; });

// ---- PNG by hand ----------------------------------------------------------------------------

TEST(ReadPng, ExpandsPalettes) {
    const std::string palette("\x10\x20\x30\xff\x80\x00", 6);
    // Two pixels of 4 bits a byte: indices 0 1.
    const Texture texture = decoded(png_of(2, 1, 4, 3, {{"PLTE", palette}}, {'\0', '\x01'}));
    EXPECT_EQ(texture.channels, 3);
    EXPECT_EQ(bytes_of(texture), (std::vector<int>{0x10, 0x20, 0x30, 0xff, 0x80, 0x00}));
}

TEST(ReadPng, ExpandsPalettesWithTransparency) {
    const std::string palette("\x10\x20\x30\xff\x80\x00", 6);
    const Texture texture = decoded(
        png_of(2, 1, 8, 3, {{"PLTE", palette}, {"tRNS", {'\x7f'}}}, std::string("\0\0\1", 3)));
    EXPECT_EQ(texture.channels, 4);
    EXPECT_EQ(bytes_of(texture),
              (std::vector<int>{0x10, 0x20, 0x30, 0x7f, 0xff, 0x80, 0x00, 0xff}));
}

TEST(ReadPng, SpreadsFewBitsOverTheByte) {
    // 0 1 2 3 of 2 bits.
    const Texture texture = decoded(png_of(4, 1, 2, 0, {}, {'\0', '\x1b'}));
    EXPECT_EQ(texture.channels, 1);
    EXPECT_EQ(bytes_of(texture), (std::vector<int>{0, 85, 170, 255}));
}

TEST(ReadPng, KeepsSixteenBitsInOrder) {
    const Texture texture = decoded(png_of(1, 1, 16, 0, {}, std::string("\0\x12\x34", 3)));
    ASSERT_EQ(texture.type, TexelType::u16);
    std::uint16_t code = 0;
    std::memcpy(&code, texture.texels.data(), sizeof(code));
    EXPECT_EQ(code, 0x1234);
}

TEST(ReadPng, DoesNotMultiplyByAlpha) {
    const Texture texture =
        decoded(png_of(2, 1, 8, 6, {}, std::string("\0\xc8\x64\x32\x01\xc8\x64\x32\0", 9)));
    EXPECT_EQ(bytes_of(texture), (std::vector<int>{0xc8, 0x64, 0x32, 1, 0xc8, 0x64, 0x32, 0}));
}

TEST(ReadPng, PutsTheFirstRowOnTop) {
    const Texture texture = decoded(png_of(1, 2, 8, 0, {}, std::string("\0\x0a\0\x14", 4)));
    EXPECT_EQ(bytes_of(texture), (std::vector<int>{10, 20}));
}

// ---- linear float ---------------------------------------------------------------------------

TEST(ReadImage, DecodesTheSrgbCurveButNotAlpha) {
    const TemporaryFolder folder;
    save(folder / "a.png", png_of(1, 1, 8, 6, {}, std::string("\0\xbc\x0a\xff\x80", 5)));
    const Image image = read_image(folder / "a.png");
    ASSERT_EQ(image.channels, 4);
    // Values of the definition (IEC 61966-2-1) worked out by hand: 188 -> 0.5029, 10 ->
    // 10/255/12.92.
    EXPECT_NEAR(image.pixels[0], 0.50289, 1e-5);
    EXPECT_NEAR(image.pixels[1], 10.0 / 255.0 / 12.92, 1e-7);
    EXPECT_EQ(image.pixels[2], 1.0f);
    EXPECT_FLOAT_EQ(image.pixels[3], 128.0f / 255.0f);
    const Image data = read_image(folder / "a.png", {.as_data = true});
    EXPECT_FLOAT_EQ(data.pixels[0], 188.0f / 255.0f);
}

TEST(ReadImage, BelievesAFileThatSaysItIsLinear) {
    const TemporaryFolder folder;
    // gAMA of 100000 is a gamma of 1.
    const std::string one("\x00\x01\x86\xa0", 4);
    save(folder / "a.png", png_of(1, 1, 8, 0, {{"gAMA", one}}, std::string("\0\x80", 2)));
    EXPECT_FLOAT_EQ(read_image(folder / "a.png").pixels[0], 128.0f / 255.0f);
}

TEST(ReadImage, SpreadsGrayWithAlpha) {
    const TemporaryFolder folder;
    save(folder / "a.png", png_of(1, 1, 8, 4, {}, std::string("\0\x80\x40", 3)));
    const Image image = read_image(folder / "a.png", {.as_data = true});
    const float gray = 128.0f / 255.0f;
    EXPECT_EQ(image.pixels, (std::vector<float>{gray, gray, gray, 64.0f / 255.0f}));
}

TEST(ReadImage, LeavesFloatFormatsAsTheyAre) {
    const TemporaryFolder folder;
    Image picture(2, 2, 3, 0.25f);
    for (std::size_t i = 0; i < 3; ++i) picture.pixels[i] = 1000.0f;  // exact as RGBE too
    for (const char* format : {"openexr", "hdr"}) {
        const fs::path path = folder / format;  // told by content, not by name
        save(path, encode({format, format, "float", 3, {}}, picture));
        EXPECT_EQ(read_image(path).pixels, picture.pixels) << format;
    }
}

TEST(ReadImage, RefusesNotFiniteValuesUnlessAsked) {
    const TemporaryFolder folder;
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Image picture(3, 2, 3, 0.25f);
        picture.at(2, 1)[1] = bad;
        const fs::path path = folder / "bad.exr";
        save(path, encode({"", "openexr", "half", 3, {}}, picture));
        const std::string line = error_of([&] { read_image(path); });
        EXPECT_EQ(line, path.string() + ": pixel (2, 1): expected finite values, found " +
                            (std::isnan(bad) ? "NaN" : "infinity") +
                            " (`oiiotool IN --fixnan box3 -o OUT` replaces such pixels)");
        EXPECT_THROW(read_texture(path, ColorSpace::linear), Error);
        EXPECT_NO_THROW(read_image(path, {.finite_only = false}));
    }
}

TEST(ReadImage, TakesTheColorOfManyChannels) {
    const TemporaryFolder folder;
    Image picture(4, 4, 6);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i] = 0.5f * static_cast<float>(i % 6);
    save(folder / "many.tif", encode({"", "tiff", "float", 6, {"tiff:write_exif=0"}}, picture));
    const Image image = read_image(folder / "many.tif");
    EXPECT_EQ(image.channels, 4);
    // OpenImageIO takes the fourth for alpha and the file says that it is not premultiplied.
    EXPECT_EQ(std::vector<float>(image.pixels.begin(), image.pixels.begin() + 3),
              (std::vector<float>{0.0f, 0.5f, 1.0f}));
}

TEST(ReadImage, GivesTheSameFromManyThreads) {
    const Bytes bytes = encode(encodings()[0], sample_picture(64, 64, 3));
    const Texture expected = decoded(bytes);
    std::vector<std::thread> threads;
    std::array<bool, 8> same{};
    for (bool& result : same) {
        threads.emplace_back([&] {
            result = true;
            for (int i = 0; i < 10; ++i)
                result = result && decoded(bytes).texels == expected.texels;
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_TRUE(std::all_of(same.begin(), same.end(), [](bool result) { return result; }));
}

// ---- telling formats ------------------------------------------------------------------------

TEST(ImageFormat, IsToldByContent) {
    const TemporaryFolder folder;
    save(folder / "wrong.jpg", encode(encodings()[0], sample_picture(4, 4, 3)));
    EXPECT_EQ(read_image_info(folder / "wrong.jpg").format, "PNG");
    EXPECT_TRUE(is_image_file(folder / "wrong.jpg"));
    EXPECT_EQ(read_texture(folder / "wrong.jpg", ColorSpace::srgb).width, 4);
    save(folder / "text.png", std::as_bytes(std::span("no picture")));
    EXPECT_FALSE(is_image_file(folder / "text.png"));
    EXPECT_FALSE(is_image_file(folder / "missing.png"));
    EXPECT_FALSE(is_image_file(folder.path()));
}

TEST(ImageFormat, SaysWhatWasFoundInstead) {
    const TemporaryFolder folder;
    const std::pair<std::string, std::string> cases[] = {{"", "found an empty file"},
                                                         {"GIF89a", "found a GIF file"},
                                                         {"xyz", "found a file of another kind"}};
    for (const auto& [content, words] : cases) {
        const fs::path path = folder / "a.png";
        save(path, std::as_bytes(std::span(content)));
        const std::string line = error_of([&] { read_image(path); });
        EXPECT_EQ(line, path.string() +
                            ": expected a PNG, JPEG, WebP, TIFF, OpenEXR, Radiance HDR, TGA, "
                            "BMP, HEIF, AVIF or raw camera image, " +
                            words);
    }
    EXPECT_NE(error_of([&] { read_image(folder.path()); }).find("found a folder"),
              std::string::npos);
    EXPECT_NE(error_of([&] { read_image(folder / "no.png"); }).find("no such file"),
              std::string::npos);
}

TEST(ImageInfo, ReportsRealFiles) {
    const fs::path root = data_folder();
    const fs::path environment = root / "environments/venice_sunset_1k.hdr";
    if (!fs::exists(environment)) GTEST_SKIP() << "no sample data at " << root;
    const ImageInfo info = read_image_info(environment);
    EXPECT_EQ(info.format, "Radiance HDR");
    EXPECT_EQ(info.width, 1024);
    EXPECT_EQ(info.height, 512);
    const Image image = read_image(environment);
    const auto [low, high] = std::minmax_element(image.pixels.begin(), image.pixels.end());
    EXPECT_GE(*low, 0.0f);
    EXPECT_GT(*high, 10.0f);  // the sun
}

}  // namespace
}  // namespace burnish::test
