// Pictures of luminance and subsampled chroma, written by OpenEXR itself.
#include <ImfRgbaFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "support/samples.hpp"

namespace burnish::test {
namespace {

constexpr int kWidth = 38, kHeight = 22;  // even, as OpenEXR wants of subsampled pictures

// Linear color that changes slowly, so that chroma at half the resolution loses little.
Imf::Rgba color_at(int x, int y) {
    const float u = static_cast<float>(x) / kWidth, v = static_cast<float>(y) / kHeight;
    return {0.2f + 0.5f * u, 0.3f + 0.4f * v, 0.6f - 0.3f * u, 0.25f + 0.5f * v};
}

// The picture with its first pixel at (left, top); premultiplied, as OpenEXR stores it.
void write_yc(const std::filesystem::path& path, Imf::RgbaChannels channels, int left, int top) {
    std::vector<Imf::Rgba> pixels;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            Imf::Rgba p = color_at(x, y);
            if ((channels & Imf::WRITE_A) != 0) {
                p.r *= p.a;
                p.g *= p.a;
                p.b *= p.a;
            }
            pixels.push_back(p);
        }
    const Imath::Box2i window({left, top}, {left + kWidth - 1, top + kHeight - 1});
    Imf::RgbaOutputFile file(path.c_str(), window, window, channels);
    file.setFrameBuffer(pixels.data() - left - static_cast<std::ptrdiff_t>(top) * kWidth, 1,
                        kWidth);
    file.writePixels(kHeight);
}

// Half has 11 bits, chroma is interpolated between every second pixel of a smooth picture. Within
// 13 pixels of an edge OpenEXR's reconstruction filter of 27 taps repeats the border.
constexpr float kTolerance = 0.02f;

void expect_picture(const Image& image, int channels) {
    ASSERT_EQ(image.width, kWidth);
    ASSERT_EQ(image.height, kHeight);
    ASSERT_EQ(image.channels, channels);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Imf::Rgba wanted = color_at(x, y);
            const float* p = image.at(x, y);
            EXPECT_NEAR(p[0], wanted.r, kTolerance) << x << " " << y;
            EXPECT_NEAR(p[1], wanted.g, kTolerance) << x << " " << y;
            EXPECT_NEAR(p[2], wanted.b, kTolerance) << x << " " << y;
            if (channels == 4) {
                EXPECT_NEAR(p[3], wanted.a, 1e-3f) << x << " " << y;
            }
        }
}

TEST(SubsampledExr, IsReadAsColor) {
    const TemporaryFolder folder;
    write_yc(folder / "yc.exr", Imf::WRITE_YC, 0, 0);
    expect_picture(read_image(folder / "yc.exr"), 3);
    const ImageInfo info = read_image_info(folder / "yc.exr");
    EXPECT_EQ(info.width, kWidth);
    EXPECT_EQ(info.pixel_type, "half");
}

TEST(SubsampledExr, HasAlphaAndAWindowOfItsOwn) {
    const TemporaryFolder folder;
    write_yc(folder / "yca.exr", Imf::WRITE_YCA, 6, -4);  // even: chroma starts with the window
    expect_picture(read_image(folder / "yca.exr"), 4);
    const Texture texture = read_texture(folder / "yca.exr", ColorSpace::srgb);
    EXPECT_EQ(texture.type, TexelType::f32);
    EXPECT_EQ(texture.color_space, ColorSpace::linear);
}

TEST(SubsampledExr, CutShortIsRefused) {
    const TemporaryFolder folder;
    write_yc(folder / "yc.exr", Imf::WRITE_YC, 0, 0);
    const Bytes whole = load(folder / "yc.exr");
    for (const std::size_t size : {whole.size() / 2, whole.size() - 1}) {
        const std::span<const std::byte> cut = std::span(whole).first(size);
        EXPECT_THROW(decode_texture(cut, "cut.exr", ColorSpace::linear), Error) << size;
    }
}

}  // namespace
}  // namespace burnish::test
