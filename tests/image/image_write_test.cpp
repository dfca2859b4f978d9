// Pictures written and read back: values, metadata, refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "plot/sheet.hpp"
#include "support/samples.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

TEST(WriteImage, RoundsDisplayValuesToEightBits) {
    const TemporaryFolder folder;
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    Image image(7, 1, 1);
    image.pixels = {-1.0f, 0.0f, 0.49f / 255.0f, 0.51f / 255.0f, 1.0f, 7.0f, kNan};
    for (const char* name : {"a.png", "a.tif", "a.TIFF"}) {
        write_image(folder / name, image, {});
        const Image back = read_image(folder / name, {.as_data = true});
        EXPECT_EQ(back.pixels, (std::vector<float>{0, 0, 0, 1.0f / 255.0f, 1, 1, 0})) << name;
    }
}

TEST(WriteImage, KeepsEveryCode) {
    const TemporaryFolder folder;
    Image image(256, 1, 4);
    for (int x = 0; x < 256; ++x) {
        const auto value = static_cast<float>(x) / 255.0f;
        for (int c = 0; c < 4; ++c) image.at(x, 0)[c] = c % 2 == 0 ? value : 1.0f - value;
    }
    for (const char* name : {"a.png", "a.tif"}) {
        write_image(folder / name, image, {});
        const Image back = read_image(folder / name, {.as_data = true});
        ASSERT_EQ(back.pixels.size(), image.pixels.size());
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            ASSERT_NEAR(back.pixels[i], image.pixels[i], 1e-6f) << name << " value " << i;
        }
    }
}

TEST(WriteImage, KeepsSixteenBits) {
    const TemporaryFolder folder;
    Image image(1000, 1, 4);
    for (int x = 0; x < 1000; ++x)
        for (int c = 0; c < 4; ++c)
            image.at(x, 0)[c] = static_cast<float>(x) / 999.0f * (c == 3 ? 1.0f : 0.5f);
    for (const char* name : {"a.png", "a.tif"}) {
        write_image(folder / name, image, {}, {.bits = 16, .dither = true});
        EXPECT_EQ(read_image_info(folder / name).pixel_type, "uint16");
        const Image back = read_image(folder / name, {.as_data = true});
        ASSERT_EQ(back.pixels.size(), image.pixels.size());
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            ASSERT_NEAR(back.pixels[i], image.pixels[i], 0.51 / 65535) << name << " value " << i;
    }
    write_image(folder / "a.jpg", image, {}, {.bits = 16});
    EXPECT_EQ(read_image_info(folder / "a.jpg").pixel_type, "uint8");
    EXPECT_THROW(write_image(folder / "b.png", image, {}, {.bits = 12}), Error);
    EXPECT_FALSE(fs::exists(folder / "b.png"));
}

// A constant color that a code holds stays that code everywhere, alpha is never touched, and the same
// picture is the same file.
TEST(WriteImage, DithersNoValueThatACodeHolds) {
    const TemporaryFolder folder;
    Image image(256, 64, 4);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 256; ++x) {
            for (int c = 0; c < 3; ++c) image.at(x, y)[c] = static_cast<float>(x) / 255.0f;
            image.at(x, y)[3] = 0.3f;
        }
    write_image(folder / "a.png", image, {}, {.dither = true});
    const Image back = read_image(folder / "a.png", {.as_data = true});
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 256; ++x) {
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(std::lround(255 * back.at(x, y)[c]), x) << "row " << y;
            ASSERT_EQ(std::lround(255 * back.at(x, y)[3]), 77);  // 76.5, rounded
        }
    write_image(folder / "b.png", image, {}, {.dither = true});
    EXPECT_EQ(read_image(folder / "b.png", {.as_data = true}).pixels, back.pixels);
}

// A value between two codes keeps its mean over a small square of pixels, where rounding alone is off by
// up to 0.5 code. 64 points that are as even as those of a line are off by less than 3 of 64.
TEST(WriteImage, DithersToTheMeanOfTheValue) {
    const TemporaryFolder folder;
    Image image(64, 64, 3);
    for (const float share : {0.1f, 0.25f, 0.5f, 0.8f}) {
        std::ranges::fill(image.pixels, (100.0f + share) / 255.0f);
        write_image(folder / "a.png", image, {}, {.dither = true});
        const Image back = read_image(folder / "a.png", {.as_data = true});
        for (int top = 0; top < 64; top += 8)
            for (int left = 0; left < 64; left += 8) {
                double sum = 0;
                for (int y = top; y < top + 8; ++y)
                    for (int x = left; x < left + 8; ++x) {
                        sum += 255.0 * back.at(x, y)[0];
                        EXPECT_EQ(back.at(x, y)[0], back.at(x, y)[2]);  // gray stays gray
                    }
                EXPECT_NEAR(sum / 64, 100.0 + share, 3.0 / 64) << left << " " << top;
            }
    }
}

TEST(WriteImage, KeepsJpegsCloseAndWithoutAlpha) {
    const TemporaryFolder folder;
    Image image(64, 64, 4, 1.0f);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            image.at(x, y)[0] = static_cast<float>(x) / 63.0f;
            image.at(x, y)[1] = static_cast<float>(y) / 63.0f;
            image.at(x, y)[2] = 0.5f;
        }
    }
    write_image(folder / "a.jpg", image, {});
    const Image back = read_image(folder / "a.jpg", {.as_data = true});
    EXPECT_EQ(back.channels, 3);
    EXPECT_LT(rmse(image, back), 0.01);
}

TEST(WriteImage, KeepsLinearValuesInOpenExr) {
    const TemporaryFolder folder;
    Image image = sample_picture(33, 17, 3);
    image.pixels[5] = 12345.678f;
    image.pixels[6] = -0.25f;
    write_image(folder / "a.exr", image, {});
    EXPECT_EQ(read_image(folder / "a.exr").pixels, image.pixels);
    EXPECT_EQ(read_image_info(folder / "a.exr").pixel_type, "float");
    EXPECT_TRUE(holds_linear(folder / "a.EXR"));
    EXPECT_FALSE(holds_linear(folder / "a.png"));
}

TEST(WriteImage, StoresOpenExrAlphaPremultiplied) {
    const TemporaryFolder folder;
    Image image(1, 1, 4);
    image.pixels = {0.8f, 0.4f, 0.2f, 0.5f};
    write_image(folder / "a.exr", image, {});
    const Image back = read_image(folder / "a.exr");
    for (std::size_t i = 0; i < 4; ++i) EXPECT_FLOAT_EQ(back.pixels[i], image.pixels[i]);
    // Four floats at the end of the smallest possible file are not compressed: as they are stored,
    // channels in the order A, B, G, R.
    const Bytes bytes = load(folder / "a.exr");
    float stored[4];
    std::memcpy(stored, bytes.data() + bytes.size() - sizeof(stored), sizeof(stored));
    EXPECT_EQ(stored[0], 0.5f);
    EXPECT_EQ(stored[3], 0.4f);
}

TEST(WriteImage, CarriesMetadataInEveryFormat) {
    const TemporaryFolder folder;
    const std::map<std::string, std::string> metadata = {
        {"burnish:command", "burnish render a.glb --alpha=0.1,0.4 -o \"b c.png\""},
        {"burnish:version", "0.1.0"},
        {"burnish:place", "K\xc3\xb6ln"},
        {"Software", "Burnish 0.1.0"},
    };
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.exr"}) {
        write_image(folder / name, sample_picture(8, 8, 3), metadata);
        const auto found = read_image_info(folder / name).metadata;
        for (const auto& [key, value] : metadata) {
            const auto entry = found.find(key);
            ASSERT_NE(entry, found.end()) << name << ": " << key;
            EXPECT_EQ(entry->second, value) << name;
        }
    }
}

TEST(WriteImage, SurvivesVeryLongMetadata) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.exr"}) {
        write_image(folder / name, sample_picture(8, 8, 3),
                    {{"burnish:command", std::string(200000, 'x')}, {"burnish:b", "a\nb"}});
        EXPECT_EQ(read_image(folder / name).width, 8) << name;
    }
}

TEST(WriteImage, RefusesOtherEndingsBeforeAnythingIsWritten) {
    const TemporaryFolder folder;
    for (const char* name : {"a.gif", "a.hdr", "a", "png"}) {
        EXPECT_THROW(write_image(folder / name, Image(1, 1, 3), {}), UsageError) << name;
        EXPECT_THROW(require_image_extension(folder / name), UsageError) << name;
    }
    EXPECT_NO_THROW(require_image_extension("x.PNG"));
    EXPECT_EQ(folder.entries(), 0U);
}

TEST(WriteImage, RefusesImagesThatAreNone) {
    const TemporaryFolder folder;
    Image ragged(4, 4, 3);
    ragged.pixels.pop_back();
    for (const Image& image : {Image(), Image(1, 1, 2), Image(40000, 1, 1), ragged}) {
        EXPECT_THROW(write_image(folder / "a.png", image, {}), Error);
    }
    EXPECT_EQ(folder.entries(), 0U);
}

TEST(Srgb, IsItsOwnInverseAndMeetsTheStandard) {
    EXPECT_FLOAT_EQ(linear_from_srgb(0.0f), 0.0f);
    EXPECT_FLOAT_EQ(linear_from_srgb(1.0f), 1.0f);
    EXPECT_NEAR(linear_from_srgb(0.5f), 0.21404, 1e-5);  // tabulated in the standard's commentary
    for (int code = 0; code <= 65535; code += 7) {
        const auto value = static_cast<float>(code) / 65535.0f;
        ASSERT_NEAR(srgb_from_linear(linear_from_srgb(value)), value, 1e-6f);
    }
    EXPECT_LT(srgb_from_linear(-0.1f), 0.0f);
}

}  // namespace
}  // namespace burnish::test
