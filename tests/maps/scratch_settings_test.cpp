// The valid settings of the scratch generator, and the errors for invalid ones.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "burnish/error.hpp"
#include "scratch_support.hpp"

namespace burnish {
namespace {

std::string complaint(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no complaint";
}

TEST(ScratchSpread, ReadsBackWhatItWrites) {
    for (const char* text : {"5", "0.25", "uniform:2:8", "normal:5:1.5", "lognormal:5:0.6"})
        EXPECT_EQ(to_text(parse_spread(text, "")), text);
    for (const char* text : {"", "x", "uniform", "uniform:1", "uniform:3:2", "normal:1:-1", "5mm",
                             "lognormal:nan:1", "gauss:1:2", "normal:1:2:3", "inf"})
        EXPECT_THROW(parse_spread(text, "--width"), UsageError) << text;
}

TEST(ScratchSpread, HasItsMeanAndStaysInItsBounds) {
    const struct {
        const char* text;
        double mean;  // closed forms; the cut at 3 sigma changes the last by under 1 %
    } cases[] = {{"5", 5.0},
                 {"uniform:2:8", 5.0},
                 {"normal:5:1", 5.0},
                 {"lognormal:5:0.5", 5.0 * std::exp(0.125)}};
    for (const auto& c : cases) {
        const Spread spread = parse_spread(c.text, "");
        double sum = 0.0;
        constexpr int kSide = 200;
        for (int i = 0; i < kSide * kSide; ++i) {
            const double value =
                spread.sample((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
            EXPECT_GE(value, spread.lowest() * (1 - 1e-12));
            EXPECT_LE(value, spread.highest() * (1 + 1e-12));
            sum += value / (kSide * kSide);
        }
        EXPECT_NEAR(sum, c.mean, 0.01 * c.mean) << c.text;
    }
}

TEST(ScratchSettings, ContradictionsAreNamed) {
    const struct {
        std::function<void(ScratchSettings&)> change;
        const char* says;
    } cases[] = {
        {[](auto& s) { s.layers[0].density_per_cm2 = 3; }, "a count or a density"},
        {[](auto& s) { s.layers[0].depth_mm = constant_spread(0.3); }, "half the width"},
        {[](auto& s) { s.layers[0].length_mm = constant_spread(0.1); }, "no more than the length"},
        {[](auto& s) { s.layers[0].range_deg = 5; }, "layers[0].range_deg"},
        {[](auto& s) { s.layers[0].angle_deg = 5; }, "layers[0].angle_deg"},
        {[](auto& s) { s.layers[0].placement = ScratchPlacement::even; }, "placement"},
        {[](auto& s) { s.layers[0].passes = 2; }, "passes"},
        {[](auto& s) { s.layers[0].taper = 0; }, "taper"},
        {[](auto& s) { s.layers[0].taper = std::nan(""); }, "taper"},
        {[](auto& s) { s.layers[0].length_mm = constant_spread(500); }, "length_mm"},
        {[](auto& s) { s.layers[0].count = 1e12; }, "count"},
        {[](auto& s) { s.layers.clear(); }, "layers"},
        {[](auto& s) { s.layers.resize(17, s.layers[0]); }, "16 layers"},
        {[](auto& s) { s.size = 8; }, "size"},
        {[](auto& s) { s.size = 20000; }, "16384"},
        {[](auto& s) { s.tile_mm = -1; }, "tile_mm"},
        {[](auto& s) { s.layers[0].field = ScratchField::image; }, "direction image"},
    };
    for (const auto& c : cases) {
        ScratchSettings settings = one_layer(64, 5, 5, 0.4, 0.02);
        c.change(settings);
        const std::string said = complaint([&] { made(settings); });
        EXPECT_NE(said.find(c.says), std::string::npos) << said;
    }
}

TEST(ScratchSettings, InputsAreChecked) {
    const ScratchSettings settings = one_layer(64, 5, 5, 0.4, 0.02);
    ScratchInputs wide;
    wide.wear_mask = Image(64, 32, 1);
    EXPECT_NE(complaint([&] { made(settings, wide); }).find("square"), std::string::npos);
    ScratchSettings steered = settings;
    steered.layers[0].field = ScratchField::image;
    ScratchInputs gray;
    gray.direction = Image(64, 64, 1);
    EXPECT_NE(complaint([&] { made(steered, gray); }).find("channels"), std::string::npos);
    ScratchInputs unused;
    unused.direction = Image(64, 64, 3);
    EXPECT_NE(complaint([&] { made(settings, unused); }).find("direction"), std::string::npos);
    ScratchInputs broken;
    broken.wear_mask = Image(64, 64, 1, std::numeric_limits<float>::quiet_NaN());
    EXPECT_NE(complaint([&] { made(settings, broken); }).find("NaN"), std::string::npos);
}

TEST(ScratchSettings, TooMuchMemoryIsRefusedWithTheFigure) {
    ScratchSettings settings = one_layer(16384, 1e6, 5, 0.4, 0.02);
    const std::uint64_t needed = scratch_memory(settings);
    // 12 bytes of height and direction, and 20/3 of moments.
    EXPECT_GT(needed, std::uint64_t{16384} * 16384 * 56 / 3);
    EXPECT_LT(needed, std::uint64_t{16384} * 16384 * 25);
    const std::string said = complaint([&] { engrave(settings, {}, needed - 1); });
    EXPECT_NE(said.find("size 16384"), std::string::npos) << said;
    EXPECT_NE(said.find("MB of free memory"), std::string::npos) << said;
}

TEST(ScratchSettings, ExtremesGiveNumbers) {
    // Tight rings, strokes over several tiles, pits of one texel, no strokes.
    const auto sound = [](const ScratchSettings& settings) {
        const ScratchMaps maps = made(settings);
        for (const float h : maps.height.pixels) ASSERT_TRUE(std::isfinite(h));
        for (const float d : maps.direction.pixels) ASSERT_TRUE(std::isfinite(d));
    };
    ScratchSettings settings = one_layer(100, 20, 40, 0.5, 0.25);
    settings.layers[0].curvature_per_mm = constant_spread(100);
    sound(settings);
    settings.layers[0].curvature_per_mm = constant_spread(4);
    sound(settings);
    settings = one_layer(100, 3, 190, 24, 12);
    sound(settings);
    settings = one_layer(17, 500, 0.001, 0.0005, 0.0001);
    sound(settings);
    settings = one_layer(64, 0, 5, 0.4, 0.02);
    sound(settings);
    settings = one_layer(64, 5, 5, 0.4, 0.0);
    sound(settings);
}

TEST(ScratchPresets, AreAllSound) {
    for (const std::string_view name : scratch_preset_names())
        EXPECT_NO_THROW(check_scratch_settings(scratch_preset(name, ""), name)) << name;
    EXPECT_NE(complaint([] { scratch_preset("brushd", "--preset"); }).find("brushed"),
              std::string::npos);
}

}  // namespace
}  // namespace burnish
