// OpenEXR's data window, display window and layers.
#include <ImfRgbaFile.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "image/image_parts.hpp"
#include "support/paths.hpp"
#include "support/samples.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

struct Window {
    int x, y, width, height;
};

// Differs at every pixel of the plane, is exact in half, and never 0.
float value_at(int x, int y, int c) {
    return 1.0f + static_cast<float>(x + 128) / 256.0f + static_cast<float>(y + 128) +
           0.5f * static_cast<float>(c);
}

void write_exr(const fs::path& path, const OIIO::ImageSpec& spec,
               const std::vector<float>& values) {
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output && output->open(path.string(), spec) &&
                output->write_image(OIIO::TypeFloat, values.data()) && output->close())
        << (output ? output->geterror() : "no encoder");
}

void write_windows(const fs::path& path, const Window& data, const Window& display, int tile) {
    OIIO::ImageSpec spec(data.width, data.height, 3, OIIO::TypeFloat);
    spec.x = data.x;
    spec.y = data.y;
    spec.full_x = display.x;
    spec.full_y = display.y;
    spec.full_width = display.width;
    spec.full_height = display.height;
    spec.tile_width = spec.tile_height = tile;
    std::vector<float> values;
    for (int y = data.y; y < data.y + data.height; ++y)
        for (int x = data.x; x < data.x + data.width; ++x)
            for (int c = 0; c < 3; ++c) values.push_back(value_at(x, y, c));
    write_exr(path, spec, values);
}

bool holds(const Window& window, int x, int y) {
    return x >= window.x && x < window.x + window.width && y >= window.y &&
           y < window.y + window.height;
}

TEST(ExrWindows, ThePictureIsTheDisplayWindow) {
    const TemporaryFolder folder;
    const Window cases[][2] = {
        {{16, 8, 32, 16}, {0, 0, 64, 32}},   // a crop
        {{-4, -2, 72, 36}, {0, 0, 64, 32}},  // overscan
        {{-5, 3, 20, 9}, {0, 0, 16, 16}},    // both
        {{30, 40, 8, 6}, {28, 39, 12, 8}},   // away from the origin
        {{40, 40, 8, 8}, {0, 0, 16, 16}},    // nothing in common
        {{-20, -20, 16, 12}, {-30, -30, 40, 30}},
    };
    for (const int tile : {0, 16})
        for (const auto& [data, display] : cases) {
            const fs::path path = folder / "a.exr";
            write_windows(path, data, display, tile);
            const Image image = read_image(path);
            const Texture texture = read_texture(path, ColorSpace::linear);
            const ImageInfo info = read_image_info(path);
            ASSERT_EQ(image.width, display.width);
            ASSERT_EQ(image.height, display.height);
            EXPECT_EQ(texture.width, display.width);
            EXPECT_EQ(texture.height, display.height);
            EXPECT_EQ(info.width, display.width);
            EXPECT_EQ(info.height, display.height);
            EXPECT_EQ(info.metadata.count("data window"), 1U);
            ASSERT_EQ(texture.texels.size(), image.pixels.size() * sizeof(float));
            EXPECT_EQ(
                std::memcmp(texture.texels.data(), image.pixels.data(), texture.texels.size()), 0);
            for (int y = 0; y < display.height; ++y)
                for (int x = 0; x < display.width; ++x)
                    for (int c = 0; c < 3; ++c) {
                        const int at_x = x + display.x, at_y = y + display.y;
                        const float wanted =
                            holds(data, at_x, at_y) ? value_at(at_x, at_y, c) : 0.0f;
                        ASSERT_EQ(image.at(x, y)[c], wanted) << at_x << ", " << at_y;
                    }
        }
}

TEST(ExrWindows, SubsampledChromaHasThemToo) {
    const TemporaryFolder folder;
    const Imath::Box2i display({0, 0}, {39, 23}), data({8, 4}, {31, 19});
    std::vector<Imf::Rgba> pixels(24 * 16, Imf::Rgba(0.5f, 0.25f, 0.125f));
    {
        Imf::RgbaOutputFile file((folder / "yc.exr").c_str(), display, data, Imf::WRITE_YC);
        file.setFrameBuffer(pixels.data() - 8 - std::ptrdiff_t{4} * 24, 1, 24);
        file.writePixels(16);
    }
    const Image image = read_image(folder / "yc.exr");
    ASSERT_EQ(image.width, 40);
    ASSERT_EQ(image.height, 24);
    EXPECT_EQ(image.at(7, 10)[1], 0.0f);
    EXPECT_NEAR(image.at(8, 10)[1], 0.25f, 1e-3);  // half has 11 bits
    EXPECT_NEAR(image.at(31, 19)[0], 0.5f, 5e-3);  // the filter of chroma repeats the border
    EXPECT_EQ(image.at(32, 19)[1], 0.0f);
}

// A display window that a file of a few bytes cannot stand for.
TEST(ExrWindows, HugeDisplayWindowsAreRefused) {
    const TemporaryFolder folder;
    write_windows(folder / "a.exr", {0, 0, 2, 2}, {0, 0, 32000, 32000}, 0);
    EXPECT_NE(error_of([&] { read_image(folder / "a.exr"); }).find("bytes of pixels"),
              std::string::npos);
}

// ---- layers -----------------------------------------------------------------------------------

// One pixel of the channels, of value 1, 2, 3 ... in their order.
void write_channels(const fs::path& path, const std::vector<std::string>& names) {
    OIIO::ImageSpec spec(1, 1, static_cast<int>(names.size()), OIIO::TypeFloat);
    spec.channelnames = names;
    spec.alpha_channel = -1;
    std::vector<float> values;
    for (std::size_t i = 0; i < names.size(); ++i) values.push_back(static_cast<float>(i + 1));
    write_exr(path, spec, values);
}

TEST(ExrLayers, TheFirstThatHasColorIsRead) {
    const TemporaryFolder folder;
    struct Case {
        std::vector<std::string> names;
        std::vector<float> wanted;  // color as stored; alpha last
        bool warns;
    };
    const Case cases[] = {
        {{"ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B",
          "ViewLayer.Combined.A", "ViewLayer.Depth.Z"},
         {1, 2, 3, 4},
         false},
        {{"Depth.Z", "L.R", "L.G", "L.B"}, {2, 3, 4}, false},  // four channels are no RGBA
        {{"Z", "b.R", "b.G", "b.B", "a.R", "a.G", "a.B"}, {5, 6, 7}, true},
        {{"a.R", "a.G", "a.B", "R", "G", "B"}, {4, 5, 6}, false},  // no layer: the picture itself
        {{"R", "G", "B", "Z"}, {1, 2, 3}, false},
        {{"a.red", "a.green", "a.blue", "a.alpha", "n.X", "n.Y"}, {1, 2, 3, 4}, false},
        {{"X", "Y", "Z"}, {1, 2, 3}, false},
    };
    for (const Case& c : cases) {
        const fs::path path = folder / "a.exr";
        write_channels(path, c.names);
        std::vector<std::string> warnings;
        const Image image = read_image(path, {.warnings = &warnings});
        ASSERT_EQ(image.pixels.size(), c.wanted.size()) << c.names[0];
        const float alpha = c.wanted.size() == 4 ? c.wanted[3] : 1.0f;
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(image.pixels[i], c.wanted[i] / alpha);
        EXPECT_EQ(warnings.size(), c.warns ? 1U : 0U);
        EXPECT_EQ(read_image_info(path).warnings, warnings);
        if (c.warns) {
            EXPECT_EQ(warnings[0], path.string() + ": layers a and b: a is read");
        }
    }
}

// Parts of 1 x 1 pixels; the channels of part k hold k + 1.
void write_parts(const fs::path& path, const std::vector<std::vector<std::string>>& parts) {
    std::vector<OIIO::ImageSpec> specs;
    for (const auto& names : parts) {
        OIIO::ImageSpec spec(1, 1, static_cast<int>(names.size()), OIIO::TypeFloat);
        spec.channelnames = names;
        spec.attribute("oiio:subimagename", "part" + std::to_string(specs.size()));
        specs.push_back(spec);
    }
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output->open(path.string(), static_cast<int>(specs.size()), specs.data()));
    for (std::size_t k = 0; k < specs.size(); ++k) {
        if (k > 0) {
            ASSERT_TRUE(output->open(path.string(), specs[k], OIIO::ImageOutput::AppendSubimage));
        }
        const std::vector<float> values(parts[k].size(), static_cast<float>(k + 1));
        ASSERT_TRUE(output->write_image(OIIO::TypeFloat, values.data()));
    }
    ASSERT_TRUE(output->close());
}

TEST(ExrLayers, TheFirstPartThatHasColorIsRead) {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.exr";
    std::vector<std::string> warnings;
    write_parts(path, {{"Z"}, {"R", "G", "B"}, {"N.X", "N.Y", "N.Z"}});
    EXPECT_EQ(read_image(path, {.warnings = &warnings}).pixels, (std::vector<float>{2, 2, 2}));
    EXPECT_TRUE(warnings.empty());
    write_parts(path, {{"Z"}, {"a.R", "a.G", "a.B"}, {"b.R", "b.G", "b.B"}});
    EXPECT_EQ(read_image(path, {.warnings = &warnings}).pixels, (std::vector<float>{2, 2, 2}));
    EXPECT_EQ(warnings,
              (std::vector<std::string>{path.string() +
                                        ": parts part1, part2 have R, G and B: part1 is read"}));
    write_parts(path, {{"Z"}, {"N.X", "N.Y", "N.Z"}});
    EXPECT_EQ(read_image(path).channels, 1);
}

// More pixels than one: a part is read with the channels of its own, whatever a later part has.
TEST(ExrLayers, AColorPartIsReadBeforeAPartOfOtherChannels) {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.exr";
    const ImagePart color{
        "color",
        2,
        1,
        {{"R", false, {1, 2}}, {"G", false, {3, 4}}, {"B", false, {5, 6}}, {"A", false, {1, 1}}},
        {},
        {},
        {}};
    write_image_parts(path, {color, {"depth", 2, 1, {{"Z", false, {7, 8}}}, {}, {}, {}}});
    EXPECT_EQ(read_image(path).pixels, (std::vector<float>{1, 3, 5, 1, 2, 4, 6, 1}));
}

TEST(ExrLayers, AreNamedWhenNoneHasColor) {
    const TemporaryFolder folder;
    write_channels(folder / "a.exr", {"n.X", "n.Y", "n.Z", "d.Z", "m.id"});
    const std::string line = error_of([&] { read_image(folder / "a.exr"); });
    EXPECT_NE(line.find("channels: expected 1 to 4, or R, G and B of one layer, found "),
              std::string::npos)
        << line;
    for (const char* name : {"n.X", "n.Y", "n.Z", "d.Z", "m.id"})
        EXPECT_NE(line.find(name), std::string::npos) << line;
    EXPECT_EQ(read_image_info(folder / "a.exr").channels, 5);
}

TEST(ExrWindows, SampleFilesAreAlikeInTheirWindow) {
    const fs::path folder = data_folder() / "field/12_exr_windows_layers";
    if (!fs::exists(folder)) GTEST_SKIP() << "no sample data at " << data_folder();
    for (const char* name : {"crop_same_aspect.exr", "overscan.exr", "layer_multi.exr"}) {
        const Image image = read_image(folder / name);
        EXPECT_EQ(image.width, 64) << name;
        EXPECT_EQ(image.height, 32) << name;
    }
    const Image plain = read_image(folder / "plain.exr");
    const Image overscan = read_image(folder / "overscan.exr");
    ASSERT_EQ(plain.pixels.size(), overscan.pixels.size());
    for (std::size_t i = 0; i < plain.pixels.size(); ++i)
        EXPECT_NEAR(plain.pixels[i], overscan.pixels[i], 1e-3f * std::abs(plain.pixels[i]));
}

}  // namespace
}  // namespace burnish::test
