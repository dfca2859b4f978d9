// Baked cloth: it tiles without a seam, all maps show one surface, and yarns follow the draft.
#include "burnish/weave_maps.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <functional>
#include <limits>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "maps/weave/weave_cells.hpp"

namespace burnish {
namespace {

constexpr auto kNoLimit = std::numeric_limits<std::uint64_t>::max();

f32::WeaveShape shape(float gap, float twist_deg) {
    const float twist = twist_deg * 3.14159265f / 180.0f;
    f32::WeaveShape s;
    s.crimp = 0.2f;
    s.bulge = 0.8f;
    s.gap = gap;
    s.twist = {std::cos(twist), std::sin(twist)};
    return s;
}

// Settings with 32 texels per yarn.
WeaveMapSettings cloth(const char* weave, float gap = 0.2f, float twist_deg = 25.0f) {
    WeaveMapSettings settings;
    settings.draft = builtin_draft(weave);
    settings.shape = shape(gap, twist_deg);
    settings.width = 32 * settings.draft.ends;
    settings.height = 32 * settings.draft.picks;
    settings.yarn_mm = 0.5;
    return settings;
}

WeaveMaps baked(const WeaveMapSettings& settings) {
    return bake_weave(settings, kNoLimit);
}

std::uint16_t yarn_at(const WeaveMaps& maps, int x, int y) {
    return maps.yarns[static_cast<std::size_t>(y) * static_cast<std::size_t>(maps.width) +
                      static_cast<std::size_t>(x)];
}

template <typename Visit>
void at_every_texel(const WeaveMaps& maps, const Visit& visit) {
    for (int y = 0; y < maps.height; ++y)
        for (int x = 0; x < maps.width; ++x) visit(x, y);
}

std::string complaint(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no complaint";
}

TEST(WeaveMaps, SeveralRepeatsAreCopiesOfOne) {
    for (const char* name : {"plain", "herringbone", "satin-5"}) {
        WeaveMapSettings settings = cloth(name);
        const WeaveMaps one = baked(settings);
        settings.width *= 2;
        settings.height *= 3;
        settings.repeats_u = 2;
        settings.repeats_v = 3;
        const WeaveMaps many = baked(settings);
        at_every_texel(many, [&](int x, int y) {
            const int x1 = x % one.width, y1 = y % one.height;
            ASSERT_NEAR(*many.heights.at(x, y), *one.heights.at(x1, y1), 1e-6f);
            for (int c = 0; c < 2; ++c) {
                ASSERT_NEAR(many.normals.at(x, y)[c], one.normals.at(x1, y1)[c], 2e-5f);
                ASSERT_NEAR(many.direction.at(x, y)[c], one.direction.at(x1, y1)[c], 1e-6f);
            }
        });
    }
}

// Along a yarn the surface continues across the edge of the tile as it does inside.
TEST(WeaveMaps, TheSeamIsNoSteeperThanTheYarns) {
    for (const char* name : {"plain", "twill-2-1", "satin-8"}) {
        const WeaveMapSettings settings = cloth(name, 0.0f);
        const WeaveMaps maps = baked(settings);
        // Steepest slope along the middle line, crimp times pi in spacings, and across,
        // tan(asin(bulge)); in mm per texel.
        const double steepest = std::max(0.2 * 3.1416, 0.8 / 0.6) * 0.5 / 32.0;
        int met = 0;
        for (int x = 0; x < maps.width; ++x) {
            // The same warp yarn on both sides: row 0 is the top; the last row repeats above it.
            const int above = yarn_at(maps, x, 0), below = yarn_at(maps, x, maps.height - 1);
            if (above != below) continue;
            ++met;
            EXPECT_LE(std::abs(*maps.heights.at(x, 0) - *maps.heights.at(x, maps.height - 1)),
                      steepest * 1.01)
                << name << x;
        }
        EXPECT_GE(met, name == std::string("plain") ? 0 : maps.width / 4);
        for (int y = 0; y < maps.height; ++y)
            if (yarn_at(maps, 0, y) == yarn_at(maps, maps.width - 1, y)) {
                EXPECT_LE(std::abs(*maps.heights.at(0, y) - *maps.heights.at(maps.width - 1, y)),
                          steepest * 1.01);
            }
    }
}

TEST(WeaveMaps, NormalsAreThoseOfTheHeights) {
    WeaveMapSettings settings = cloth("twill-2-2");
    settings.width = settings.height = 4 * 128;
    const WeaveMaps maps = baked(settings);
    const double texel_mm = 0.5 / 128.0;
    int compared = 0;
    double worst = 0.0;
    at_every_texel(maps, [&](int x, int y) {
        if (x == 0 || y == 0 || x == maps.width - 1 || y == maps.height - 1) return;
        const int yarn = yarn_at(maps, x, y);
        for (int d = -1; d <= 1; d += 2)
            if (yarn_at(maps, x + d, y) != yarn || yarn_at(maps, x, y + d) != yarn) return;
        if (yarn == 0) return;
        const double sx =
            static_cast<double>(*maps.heights.at(x + 1, y) - *maps.heights.at(x - 1, y)) /
            (2.0 * texel_mm);
        const double sy =
            static_cast<double>(*maps.heights.at(x, y - 1) - *maps.heights.at(x, y + 1)) /
            (2.0 * texel_mm);
        const double length = std::sqrt(1.0 + sx * sx + sy * sy);
        worst =
            std::max({worst, std::abs(static_cast<double>(maps.normals.at(x, y)[0]) + sx / length),
                      std::abs(static_cast<double>(maps.normals.at(x, y)[1]) + sy / length)});
        ++compared;
    });
    // Central differences have the error h^2 / 6 times the third derivative, here at most pi^3
    // crimp along (6e-5) and 3 k^3 bulge... across (5e-4). Heights are floats with a rounding error
    // of 1e-7 over 4e-3 mm.
    EXPECT_LT(worst, 1e-3);
    EXPECT_GT(compared, maps.width * maps.height * 8 / 10);
}

TEST(WeaveMaps, EveryTexelIsThePointOfTheShadingText) {
    const WeaveMapSettings settings = cloth("satin-5", 0.3f, -35.0f);
    const WeaveMaps maps = baked(settings);
    at_every_texel(maps, [&](int x, int y) {
        const float u = (static_cast<float>(x) + 0.5f) / 32.0f;
        const float v = (static_cast<float>(maps.height - 1 - y) + 0.5f) / 32.0f;
        const int end = static_cast<int>(u), pick = static_cast<int>(v);
        const f32::WeavePoint p = f32::weave_point(
            weave_cell(settings.draft, end, pick), settings.shape,
            u - static_cast<float>(end) - 0.5f, v - static_cast<float>(pick) - 0.5f);
        const int yarn = yarn_at(maps, x, y);
        ASSERT_EQ(yarn != 0, p.cover > 0.0f);
        if (yarn == 0) return;
        ASSERT_EQ(yarn, p.warp > 0.5f ? 1 + end : 1 + maps.ends + pick);
        ASSERT_NEAR(*maps.heights.at(x, y), 0.5f * p.height, 1e-6f);
        const float angle = 2.0f * std::atan2(p.fiber.y, p.fiber.x);
        ASSERT_NEAR(maps.direction.at(x, y)[0], std::cos(angle), 1e-5f);
        ASSERT_NEAR(maps.direction.at(x, y)[1], std::sin(angle), 1e-5f);
        ASSERT_NEAR(maps.normals.at(x, y)[0], p.n.x, 1e-6f);
        ASSERT_NEAR(maps.normals.at(x, y)[1], p.n.y, 1e-6f);
    });
}

TEST(WeaveMaps, WithoutTwistWarpRunsUpAndWeftAcross) {
    const WeaveMaps maps = baked(cloth("plain", 0.2f, 0.0f));
    at_every_texel(maps, [&](int x, int y) {
        const int yarn = yarn_at(maps, x, y);
        const float expected = yarn == 0 ? 0.0f : yarn <= maps.ends ? -1.0f : 1.0f;
        ASSERT_NEAR(maps.direction.at(x, y)[0], expected, 1e-6f);
        ASSERT_NEAR(maps.direction.at(x, y)[1], 0.0f, 1e-6f);
    });
}

TEST(WeaveMaps, YarnsCoverTheAreasTheyShould) {
    // A gap of 1/4 of 32 texels leaves 24 texels of yarn: the upper yarn shows 24 x 32 texels, the
    // lower one beside it 8 x 24, the hole 8 x 8.
    const WeaveMapSettings settings = cloth("twill-3-1", 0.25f);
    const WeaveMaps maps = baked(settings);
    std::vector<float> ids(maps.yarns.size() * 3);
    weave_id_rows(maps, settings, 0, maps.height, ids.data());
    int holes = 0, warp = 0, upper = 0;
    for (std::size_t i = 0; i < ids.size(); i += 3) {
        holes += ids[i] == 0.0f;
        warp += ids[i] == 1.0f;
        upper += ids[i + 2] == 1.0f;
    }
    const int cells = 16;
    EXPECT_EQ(holes, cells * 8 * 8);
    EXPECT_EQ(upper, cells * 24 * 32);
    EXPECT_EQ(warp, 12 * 24 * 32 + 4 * 8 * 24);  // the warp is on top at 12 of 16
}

TEST(WeaveMaps, ColorsAndNumbersAreThoseOfTheYarnOnTop) {
    WeaveMapSettings settings = cloth("twill-2-1");
    settings.draft.weft_colors = {{0.1f, 0.2f, 0.3f}, {0.4f, 0.5f, 0.6f}, {0.7f, 0.8f, 0.9f}};
    settings.warp_color = {1.0f, 0.0f, 0.5f};
    settings.repeats_u = 2;
    settings.width *= 2;
    const WeaveMaps maps = baked(settings);
    const std::size_t row = static_cast<std::size_t>(maps.width) * 3;
    std::vector<float> colors(row * static_cast<std::size_t>(maps.height)), ids(colors.size());
    weave_color_rows(maps, settings, 0, maps.height, colors.data());
    weave_id_rows(maps, settings, 0, maps.height, ids.data());
    for (int pick = 0; pick < 3; ++pick)
        for (int end = 0; end < 6; ++end) {
            const int x = 32 * end + 16, y = maps.height - 1 - (32 * pick + 16);
            const std::size_t at =
                static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x) * 3;
            const bool up = settings.draft.is_warp_up(end % 3, pick);
            const glm::vec3 c = up ? settings.warp_color
                                   : settings.draft.weft_colors[static_cast<std::size_t>(pick)];
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(linear_from_srgb(colors[at + static_cast<std::size_t>(i)]), c[i],
                            1e-5f);
            EXPECT_EQ(ids[at], up ? 1.0f : 0.5f);
            // As documented: the number is the integer part of G times the count, also after
            // storage in 16 bits.
            const double code = std::round(static_cast<double>(ids[at + 1]) * 65535.0) / 65535.0;
            EXPECT_EQ(static_cast<int>(code * (up ? 6 : 3)), up ? end : pick);
            EXPECT_EQ(ids[at + 2], 1.0f);
        }
}

TEST(WeaveMaps, ThreadsChangeNothing) {
    const WeaveMapSettings settings = cloth("basket");
    const WeaveMaps many = baked(settings);
    const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
    const WeaveMaps single = baked(settings);
    EXPECT_EQ(many.heights.pixels, single.heights.pixels);
    EXPECT_EQ(many.normals.pixels, single.normals.pixels);
    EXPECT_EQ(many.yarns, single.yarns);
}

TEST(WeaveMaps, WhatCannotBeIsNamed) {
    const auto says = [](const std::function<void(WeaveMapSettings&)>& change) {
        WeaveMapSettings settings = cloth("plain");
        change(settings);
        return complaint([&] { baked(settings); });
    };
    EXPECT_NE(says([](auto& s) { s.width = 8; }).find("width: expected 16 to 16384"),
              std::string::npos);
    EXPECT_NE(says([](auto& s) { s.repeats_v = 0; }).find("repeats: expected 1 or more"),
              std::string::npos);
    EXPECT_NE(says([](auto& s) { s.repeats_u = 2000000000; }).find("at least 4 texels"),
              std::string::npos);
    EXPECT_NE(says([](auto& s) { s.yarn_mm = 0; }).find("yarn_mm"), std::string::npos);
    WeaveMapSettings large = cloth("plain");
    large.width = large.height = 16384;
    const std::uint64_t needed = weave_map_memory(large);
    EXPECT_GE(needed, std::uint64_t{16384} * 16384 * 22);
    EXPECT_NE(complaint([&] { bake_weave(large, needed - 1); }).find("size 16384x16384: expected"),
              std::string::npos);
}

}  // namespace
}  // namespace burnish
