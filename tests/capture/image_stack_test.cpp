// Samples read from a stack equal the pictures within the coding error; clipped samples are
// infinite.
#include "capture/stack/image_stack.hpp"

#include <gtest/gtest.h>

#include "stack_support.hpp"

namespace burnish {
namespace {

using test::ScratchFolder;

constexpr float kClipped = std::numeric_limits<float>::infinity();

ImageStack stack_of(const Rig& rig, const ScratchFolder& folder) {
    return ImageStack(rig, folder / "cache", {});
}

TEST(ImageStack, FloatPicturesComeBackWithinTheCodingsError) {
    const ScratchFolder folder;
    std::vector<Image> pictures;
    std::vector<std::string> names;
    const double brightest[] = {5, 0.02, 3000};
    for (std::uint32_t k = 0; k < 3; ++k) {
        pictures.push_back(test::random_picture(13, 9, brightest[k], k));
        names.push_back("p" + std::to_string(k) + ".exr");
        write_image(folder / names.back(), pictures.back(), {});
    }
    const ImageStack stack = stack_of(test::rig_of(folder, names), folder);
    EXPECT_EQ(stack.width(), 13);
    EXPECT_EQ(stack.height(), 9);
    EXPECT_EQ(stack.pixels(), 117u);
    ASSERT_EQ(stack.lights(), 3u);
    const std::vector<float> samples = test::all_samples(stack);
    float top = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& pixels = pictures[k].pixels;
        const auto largest = static_cast<double>(*std::max_element(pixels.begin(), pixels.end()));
        top = std::max(top, static_cast<float>(largest));
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const auto value = static_cast<double>(pixels[i]);
            EXPECT_NEAR(static_cast<double>(samples[(i / 3 * 3 + k) * 3 + i % 3]), value,
                        test::coding_error(value, largest))
                << k << " " << i;
        }
    }
    EXPECT_EQ(stack.census().clipped_share, 0);
    EXPECT_EQ(stack.census().black_share, 0);
    EXPECT_FLOAT_EQ(static_cast<float>(stack.census().brightest), top);
    EXPECT_EQ(stack.mask(), std::vector<std::uint8_t>(117, 1));
}

TEST(ImageStack, CodedPicturesAreLinearisedAndTheirLastCodeIsClipped) {
    const std::vector<int> codes = {0, 1, 7, 20, 77, 128, 200, 254, 255, 255, 130};
    for (const RigResponse response : {RigResponse::srgb, RigResponse::linear}) {
        const ScratchFolder folder;
        write_image(folder / "a.png", test::coded_picture(11, 4, codes), {});
        const ImageStack stack = stack_of(test::rig_of(folder, {"a.png"}, response), folder);
        const std::vector<float> samples = test::all_samples(stack);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const int code = codes[i % codes.size()];
            const double value =
                response == RigResponse::srgb ? test::linear_of_code(code) : code / 255.0;
            if (code == 255) {
                EXPECT_EQ(samples[i], kClipped);
                continue;
            }
            EXPECT_NEAR(static_cast<double>(samples[i]), value, test::coding_error(value, 1))
                << code;
        }
        EXPECT_NEAR(stack.census().clipped_share, 2.0 / 11, 1e-12);
        EXPECT_NEAR(stack.census().black_share, 1.0 / 11, 1e-12);
    }
}

// The same light with four times the exposure: float pictures agree, and integer pictures agree
// where they are not clipped.
TEST(ImageStack, BracketsAreOnePicture) {
    const ScratchFolder folder;
    const Image once = test::random_picture(12, 5, 2, 3);
    Image four = once;
    for (float& v : four.pixels) v *= 4;
    write_image(folder / "1.exr", once, {});
    write_image(folder / "4.exr", four, {});
    Rig rig = test::rig_of(folder, {"1.exr"});
    rig.lights[0].images.push_back({folder / "4.exr", 4.0});
    const std::vector<float> samples = test::all_samples(stack_of(rig, folder));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto value = static_cast<double>(once.pixels[i]);
        EXPECT_NEAR(static_cast<double>(samples[i]), value, test::coding_error(value, 2));
    }
}

TEST(ImageStack, BracketsOfCodesUseWhatIsNotClipped) {
    const ScratchFolder folder;
    // Linear codes; the long exposure is four times the short one and clips at 255.
    const std::vector<int> shorter = {1, 10, 30, 60, 63, 80, 200, 254, 255};
    std::vector<int> longer;
    for (const int code : shorter) longer.push_back(std::min(4 * code, 255));
    write_image(folder / "s.png", test::coded_picture(9, 3, shorter), {});
    write_image(folder / "l.png", test::coded_picture(9, 3, longer), {});
    Rig rig = test::rig_of(folder, {"s.png"});
    rig.lights[0].images.push_back({folder / "l.png", 4.0});
    for (const bool swapped : {false, true}) {
        if (swapped) std::swap(rig.lights[0].images[0], rig.lights[0].images[1]);
        const ImageStack stack = stack_of(rig, folder);
        const std::vector<float> samples = test::all_samples(stack);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const int code = shorter[i % shorter.size()];
            if (code == 255) {
                EXPECT_EQ(samples[i], kClipped);
                continue;
            }
            EXPECT_NEAR(static_cast<double>(samples[i]), code / 255.0,
                        test::coding_error(code / 255.0, 1))
                << code << (swapped ? " longer first" : "");
        }
        EXPECT_NEAR(stack.census().clipped_share, 1.0 / 9, 1e-12);
    }
}

// Samples are divided by the flat field, which is scaled to a mean of 1 and is at least 1 %.
TEST(ImageStack, WhiteTargetsAreDividedBy) {
    const ScratchFolder folder;
    const Image picture = test::random_picture(8, 4, 3, 5);
    Image white(8, 4, 3);
    double mean = 0;
    for (std::size_t i = 0; i < white.pixels.size(); ++i) {
        white.pixels[i] = i < 3 ? 0.0f : 2.0f + 0.05f * static_cast<float>(i);
        mean += static_cast<double>(white.pixels[i]) / static_cast<double>(white.pixels.size());
    }
    write_image(folder / "p.exr", picture, {});
    write_image(folder / "w.exr", white, {});
    Rig rig = test::rig_of(folder, {"p.exr"});
    rig.white = folder / "w.exr";
    const std::vector<float> samples = test::all_samples(stack_of(rig, folder));
    double largest = 0;
    std::vector<double> expected;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double flat = std::max(static_cast<double>(white.pixels[i]) / mean, 0.01);
        expected.push_back(static_cast<double>(picture.pixels[i]) / flat);
        largest = std::max(largest, expected.back());
    }
    for (std::size_t i = 0; i < samples.size(); ++i)
        EXPECT_NEAR(static_cast<double>(samples[i]), expected[i],
                    test::coding_error(expected[i], largest) + 2e-6 * expected[i])
            << i;
}

TEST(ImageStack, NegativeSamplesAreNone) {
    const ScratchFolder folder;
    Image picture = test::random_picture(6, 6, 1, 6);
    picture.pixels[10] = -0.5f;
    picture.pixels[11] = 0;
    write_image(folder / "p.exr", picture, {});
    const ImageStack stack = stack_of(test::rig_of(folder, {"p.exr"}), folder);
    const std::vector<float> samples = test::all_samples(stack);
    EXPECT_EQ(samples[10], 0.0f);
    EXPECT_EQ(samples[11], 0.0f);
    EXPECT_NEAR(stack.census().black_share, 2.0 / 108, 1e-12);
}

// Repeated codes at the top of a dark picture are not clipped: codes clip at 255 only.
TEST(ImageStack, DarkCodedPicturesAreWhole) {
    const ScratchFolder folder;
    write_image(folder / "a.png", test::coded_picture(11, 4, {0, 90, 200, 200, 17}), {});
    const ImageStack stack = stack_of(test::rig_of(folder, {"a.png"}), folder);
    for (const float v : test::all_samples(stack)) EXPECT_LT(v, 0.8f);
    EXPECT_EQ(stack.census().clipped_share, 0);
}

// A float picture does not state where its sensor clips; repeats of the stack's largest value do.
TEST(ImageStack, PlateausOfFloatPicturesAreClipped) {
    const ScratchFolder folder;
    Image bright = test::random_picture(20, 10, 9, 7), dim = test::random_picture(20, 10, 0.5, 8);
    int over = 0;
    for (float& v : bright.pixels) {
        over += v >= 4.0f;
        v = std::min(v, 4.0f);
    }
    ASSERT_GT(over, 20);
    write_image(folder / "b.exr", bright, {});
    write_image(folder / "d.exr", dim, {});
    const ImageStack stack = stack_of(test::rig_of(folder, {"b.exr", "d.exr"}), folder);
    const std::vector<float> samples = test::all_samples(stack);
    for (std::size_t i = 0; i < bright.pixels.size(); ++i) {
        const float b = samples[i / 3 * 6 + i % 3], d = samples[i / 3 * 6 + 3 + i % 3];
        EXPECT_EQ(b == kClipped, bright.pixels[i] == 4.0f) << i;
        EXPECT_TRUE(std::isfinite(d)) << i;
    }
    EXPECT_NEAR(stack.census().clipped_share, over / 1200.0, 1e-9);
}

TEST(ImageStack, MasksAreReadAndCounted) {
    const ScratchFolder folder;
    Image picture = test::random_picture(10, 10, 1, 9), mask(10, 10, 1);
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 10; ++x) {
            mask.at(x, y)[0] = x < 5 ? 1.0f : 0.0f;
            if (x == 0) std::fill_n(picture.at(x, y), 3, 0.0f);  // black, inside the mask
            if (x >= 8) std::fill_n(picture.at(x, y), 3, 2.0f);  // a plateau, outside the mask
            if (x == 7) std::fill_n(picture.at(x, y), 3, 0.0f);  // black, outside the mask
        }
    }
    write_image(folder / "p.exr", picture, {});
    write_image(folder / "m.png", mask, {});
    Rig rig = test::rig_of(folder, {"p.exr"});
    rig.mask = folder / "m.png";
    const ImageStack stack = stack_of(rig, folder);
    for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(stack.mask()[i], i % 10 < 5 ? 1 : 0) << i;
    EXPECT_NEAR(stack.census().black_share, 0.2, 1e-12);
    EXPECT_NEAR(stack.census().clipped_share, 0, 1e-12);

    write_image(folder / "m.png", Image(10, 10, 1, 0.0f), {});
    const std::string none = test::error_line([&] { stack_of(rig, folder); });
    EXPECT_NE(none.find("m.png"), none.npos) << none;
    write_image(folder / "m.png", Image(10, 9, 1, 1.0f), {});
    const std::string size = test::error_line([&] { stack_of(rig, folder); });
    EXPECT_NE(size.find("m.png"), size.npos) << size;
}

// Black or clipped pictures are no reading error; the census counts them.
TEST(ImageStack, BlackAndWhiteStacksAreCounted) {
    const ScratchFolder folder;
    write_image(folder / "b.exr", Image(6, 4, 3, 0.0f), {});
    write_image(folder / "w.png", Image(6, 4, 3, 1.0f), {});
    {
        const ImageStack stack = stack_of(test::rig_of(folder, {"b.exr", "b.exr"}), folder);
        EXPECT_EQ(stack.census().black_share, 1);
        EXPECT_EQ(stack.census().clipped_share, 0);
        for (const float v : test::all_samples(stack)) EXPECT_EQ(v, 0.0f);
    }
    const ImageStack stack = stack_of(test::rig_of(folder, {"w.png", "w.png"}), folder);
    EXPECT_EQ(stack.census().clipped_share, 1);
    for (const float v : test::all_samples(stack)) EXPECT_EQ(v, kClipped);
}

// The stack exceeds one band: every sample is at its position in whatever order the bands are read.
TEST(ImageStack, BandsFitTogether) {
    const ScratchFolder folder;
    const Image a = test::random_picture(128, 128, 1, 1), b = test::random_picture(128, 128, 7, 2);
    write_image(folder / "a.exr", a, {});
    write_image(folder / "b.exr", b, {});
    std::vector<std::string> names;
    for (int i = 0; i < 600; ++i) names.push_back(i % 3 == 1 ? "b.exr" : "a.exr");
    const ImageStack stack = stack_of(test::rig_of(folder, names), folder);
    ASSERT_GT(stack.bands(), 1u) << "600 lights of 128 x 128 pixels are 59 MB of codes";
    std::size_t covered = 0;
    std::vector<float> samples;
    for (std::size_t k = stack.bands(); k-- > 0;) {
        const StackBand band = stack.load(k);
        EXPECT_EQ(band.first, k * stack.band_pixels());
        covered += band.pixels;
        const std::size_t from = band.pixels / 3,
                          count = std::min<std::size_t>(50, band.pixels - from);
        samples.resize(count * stack.lights() * 3);
        stack.decode(band, from, count, samples.data());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const std::size_t pixel = band.first + from + i / (3 * stack.lights());
            const bool second = i / 3 % stack.lights() % 3 == 1;
            const auto value = static_cast<double>((second ? b : a).pixels[3 * pixel + i % 3]);
            ASSERT_NEAR(static_cast<double>(samples[i]), value,
                        test::coding_error(value, second ? 7 : 1));
        }
    }
    EXPECT_EQ(covered, stack.pixels());
}

}  // namespace
}  // namespace burnish
