// shading/surface/weave.glsl and the cells of drafts: the surface of woven cloth.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "burnish/f64.hpp"
#include "maps/weave/weave_cells.hpp"

namespace burnish::test {
namespace {

f64::WeaveCell in_double(const f32::WeaveCell& c) {
    return {c.warp_up, c.warp_start, c.warp_end, c.weft_start, c.weft_end};
}

f64::WeaveShape shape_of(double crimp, double bulge, double gap, double twist = 0) {
    return {crimp, bulge, gap, {std::cos(twist), std::sin(twist)}};
}

f32::WeaveShape in_float(const f64::WeaveShape& s) {
    return {static_cast<float>(s.crimp),
            static_cast<float>(s.bulge),
            static_cast<float>(s.gap),
            {static_cast<float>(s.twist.x), static_cast<float>(s.twist.y)}};
}

// The cloth at a point in yarn spacings.
f64::WeavePoint cloth_at(const Draft& draft, const f64::WeaveShape& shape, double u, double v) {
    const double end = std::floor(u), pick = std::floor(v);
    const f32::WeaveCell cell = weave_cell(draft, static_cast<int>(end), static_cast<int>(pick));
    return f64::weave_point(in_double(cell), shape, u - end - 0.5, v - pick - 0.5);
}

class Weave : public testing::TestWithParam<std::string_view> {
  protected:
    Draft draft = builtin_draft(GetParam());
    std::mt19937 random{7};
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
};

// Central differences of the height over 1e-6 have an error of 1e-9. Points are at least two steps
// away from the borders of yarns and cells, where the surface has edges.
TEST_P(Weave, NormalIsThatOfTheHeight) {
    const f64::WeaveShape shape = shape_of(0.17, 0.8, 0.13);
    constexpr double kStep = 1e-6;
    int compared = 0;
    for (int i = 0; i < 20000; ++i) {
        const double u = uniform(random) * draft.ends, v = uniform(random) * draft.picks;
        const f64::WeavePoint p = cloth_at(draft, shape, u, v);
        bool smooth = p.cover > 0.5;
        for (const double du : {-3e-6, 3e-6})
            for (const double dv : {-3e-6, 3e-6}) {
                const f64::WeavePoint q = cloth_at(draft, shape, u + du, v + dv);
                smooth = smooth && q.warp == p.warp && q.cover > 0.5 &&
                         std::floor(u + du) == std::floor(u) && std::floor(v + dv) == std::floor(v);
            }
        if (!smooth) continue;
        const auto height = [&](double x, double y) { return cloth_at(draft, shape, x, y).height; };
        const double gu = (height(u + kStep, v) - height(u - kStep, v)) / (2 * kStep);
        const double gv = (height(u, v + kStep) - height(u, v - kStep)) / (2 * kStep);
        const double scale = 1 / std::sqrt(1 + gu * gu + gv * gv);
        ASSERT_NEAR(p.n.x, -gu * scale, 1e-8);
        ASSERT_NEAR(p.n.y, -gv * scale, 1e-8);
        ASSERT_NEAR(p.n.z, scale, 1e-8);
        ++compared;
    }
    EXPECT_GT(compared, 18000);
}

TEST_P(Weave, RepeatsWithTheDraft) {
    const f64::WeaveShape shape = shape_of(0.1, 0.6, 0.2, 0.4);
    for (int i = 0; i < 1000; ++i) {
        // Multiples of 1/1024, so that adding a repeat is exact.
        const double u = std::floor(uniform(random) * draft.ends * 1024) / 1024;
        const double v = std::floor(uniform(random) * draft.picks * 1024) / 1024;
        const f64::WeavePoint a = cloth_at(draft, shape, u, v);
        const f64::WeavePoint b = cloth_at(draft, shape, u - 3 * draft.ends, v + 5 * draft.picks);
        ASSERT_EQ(a.height, b.height);
        ASSERT_EQ(a.warp, b.warp);
        ASSERT_EQ(a.n.x, b.n.x);
    }
}

// Across cells along a yarn, height and slopes are continuous, above and below, and the yarn is on
// top where the draft says so.
TEST_P(Weave, YarnsAreContinuous) {
    const f64::WeaveShape shape = shape_of(0.2, 0.5, 0.1);
    const auto warp_in = [&](int end, int pick, double along) {
        const f32::WeaveCell c = weave_cell(draft, end, pick);
        const double side = c.warp_up ? 1 : -1;
        return f64::yarn_point(shape, 0.2, along, side, along < 0 ? c.warp_start : c.warp_end);
    };
    const auto weft_in = [&](int end, int pick, double along) {
        const f32::WeaveCell c = weave_cell(draft, end, pick);
        const double side = c.warp_up ? -1 : 1;
        return f64::yarn_point(shape, 0.2, along, side, along < 0 ? c.weft_start : c.weft_end);
    };
    const auto expect_same = [](const f64::YarnPoint& a, const f64::YarnPoint& b) {
        ASSERT_NEAR(a.height, b.height, 1e-12);
        ASSERT_NEAR(a.along, b.along, 1e-12);
        ASSERT_NEAR(a.across, b.across, 1e-12);
    };
    for (int end = 0; end < draft.ends; ++end) {
        for (int pick = 0; pick < draft.picks; ++pick) {
            expect_same(warp_in(end, pick, 0.5), warp_in(end, pick + 1, -0.5));
            expect_same(weft_in(end, pick, 0.5), weft_in(end + 1, pick, -0.5));
            expect_same(warp_in(end, pick, -1e-15), warp_in(end, pick, 1e-15));
            const double lift = warp_in(end, pick, 0).height - weft_in(end, pick, 0).height;
            ASSERT_NEAR(lift, draft.is_warp_up(end, pick) ? 0.4 : -0.4, 1e-12);
        }
    }
}

struct Counted {
    double area[2] = {0, 0};  // weft, warp
    double nx2[2] = {0, 0}, ny2[2] = {0, 0}, nz[2] = {0, 0};
    double hole = 0;
};

// Counts over a grid on the whole repeat.
Counted counted(const Draft& draft, const f64::WeaveShape& shape, int steps) {
    Counted c;
    const double weight = 1.0 / (static_cast<double>(steps * steps) * draft.ends * draft.picks);
    for (int i = 0; i < steps * draft.ends; ++i) {
        for (int j = 0; j < steps * draft.picks; ++j) {
            const f64::WeavePoint p = cloth_at(draft, shape, (i + 0.5) / steps, (j + 0.5) / steps);
            if (p.cover < 0.5) {
                c.hole += weight;
                continue;
            }
            const int k = p.warp > 0.5 ? 1 : 0;
            c.area[k] += weight;
            c.nx2[k] += weight * p.n.x * p.n.x;
            c.ny2[k] += weight * p.n.y * p.n.y;
            c.nz[k] += weight * p.n.z;
        }
    }
    return c;
}

// A grid of 40 points per cell and a gap of 0.2 = 8/40 count exactly. The moments differ by the
// errors of the grids, below 1e-3.
TEST_P(Weave, SharesAndSlopesOfFamiliesAreThoseCounted) {
    const f64::WeaveShape shape = shape_of(0.15, 0.7, 0.2);
    const Counted c = counted(draft, shape, 40);
    EXPECT_NEAR(c.hole, 0.04, 1e-12);
    const WeaveFamilies families = weave_families(draft);
    for (int k = 0; k < 2; ++k) {
        const WeaveFamily& family = k == 1 ? families.warp : families.weft;
        EXPECT_NEAR(weave_coverage(family, 0.2f), c.area[k], 1e-6);
        double sum = 0, across2 = 0, along2 = 0, nz = 0;
        for (const WeaveSlope& s : weave_slopes(family, in_float(shape), 40, 20)) {
            const f32::vec3 n = f32::normal_of_slopes(-s.along, -s.across);
            const auto w = static_cast<double>(s.weight);
            sum += w;
            along2 += w * static_cast<double>(n.x * n.x);
            across2 += w * static_cast<double>(n.y * n.y);
            nz += w * static_cast<double>(n.z);
        }
        EXPECT_NEAR(sum, 1.0, 1e-4);
        EXPECT_NEAR(along2, (k == 1 ? c.ny2 : c.nx2)[k] / c.area[k], 1e-3);
        EXPECT_NEAR(across2, (k == 1 ? c.nx2 : c.ny2)[k] / c.area[k], 1e-3);
        EXPECT_NEAR(nz, c.nz[k] / c.area[k], 1e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(Drafts, Weave, testing::ValuesIn(draft_names()), [](const auto& draft) {
    std::string name(draft.param);
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
});

// e_x and e_y are exchanged with the yarn: fibers run along +u on the weft and along +v on the
// warp, both rotated counter-clockwise by the twist.
TEST(WeavePoint, FibersFollowTheirYarn) {
    for (const double twist : {0.0, 0.3, -0.5}) {
        const f64::WeaveShape shape = shape_of(0.1, 0.6, 0.1, twist);
        for (const bool warp_up : {false, true}) {
            const f64::WeaveCell cell{warp_up, true, true, true, true};
            const f64::WeavePoint p = f64::weave_point(cell, shape, 0.1, 0.1);
            EXPECT_EQ(p.warp, warp_up ? 1.0 : 0.0);
            const double angle = twist + (warp_up ? 0.5 * f64::kPi : 0.0);
            EXPECT_NEAR(p.fiber.x, std::cos(angle), 1e-12);
            EXPECT_NEAR(p.fiber.y, std::sin(angle), 1e-12);
        }
    }
}

// The lower yarn is visible through the gap beside the upper one, and the hole between all yarns.
TEST(WeavePoint, GapsShowWhatLiesBelow) {
    const f64::WeaveShape shape = shape_of(0.1, 0.6, 0.2);
    const f64::WeaveCell cell{true, true, true, true, true};
    const f64::WeavePoint above = f64::weave_point(cell, shape, 0.39, 0.0);
    const f64::WeavePoint below = f64::weave_point(cell, shape, 0.41, 0.0);
    EXPECT_EQ(above.warp, 1.0);
    EXPECT_EQ(below.warp, 0.0);
    EXPECT_LT(below.height, above.height);
    EXPECT_EQ(f64::weave_point(cell, shape, 0.39, 0.45).warp, 1.0);
    EXPECT_EQ(f64::weave_point(cell, shape, 0.41, 0.45).cover, 0.0);
}

// The sine of the tilt across a yarn is linear and reaches `bulge` at the edge.
TEST(WeavePoint, BulgeIsTheSineAtTheEdge) {
    const f64::WeaveShape shape = shape_of(0.0, 0.8, 0.1);
    const f64::WeaveCell cell{true, true, true, true, true};
    EXPECT_NEAR(f64::weave_point(cell, shape, 0.45 - 1e-9, 0.2).n.x, 0.8, 1e-7);
    EXPECT_NEAR(f64::weave_point(cell, shape, 0.225, 0.2).n.x, 0.4, 1e-12);
    EXPECT_NEAR(f64::weave_point(cell, shape, 0.45 - 1e-12, 0.2).height, 0.0, 1e-11);
}

TEST(WeavePoint, ExtremeShapesAreFinite) {
    for (const float crimp : {0.0f, 0.5f})
        for (const float bulge : {0.0f, 0.95f})
            for (const float gap : {0.0f, 0.9f})
                for (int bits = 0; bits < 32; ++bits)
                    for (int i = 0; i <= 20; ++i)
                        for (int j = 0; j <= 20; ++j) {
                            const f32::WeaveCell cell{(bits & 1) != 0, (bits & 2) != 0,
                                                      (bits & 4) != 0, (bits & 8) != 0,
                                                      (bits & 16) != 0};
                            const f32::WeavePoint p =
                                f32::weave_point(cell, {crimp, bulge, gap, {0.0f, 1.0f}},
                                                 static_cast<float>(i) / 20 - 0.5f,
                                                 static_cast<float>(j) / 20 - 0.5f);
                            ASSERT_TRUE(std::isfinite(p.height));
                            ASSERT_NEAR(f32::length(p.n), 1.0f, 1e-6f);
                            ASSERT_GT(p.n.z, 0.04f);
                        }
}

TEST(WeaveMean, TableCoordinateIsInverted) {
    for (const double slope : {-40.0, -1.0, -0.01, 0.0, 0.3, 7.0})
        for (const double width : {0.001, 0.2, 2.0})
            EXPECT_NEAR(f64::weave_table_slope(f64::weave_table_coordinate(slope, width), width),
                        slope, 1e-9 * (1 + std::abs(slope) / width));
}

// The mean replaces the yarns as the pixel grows from a third of a cell to a cell.
TEST(WeaveMean, ShareGrowsWithThePixel) {
    EXPECT_EQ(f64::weave_mean_share(-1.6), 0.0);
    EXPECT_EQ(f64::weave_mean_share(0.0), 1.0);
    double last = 0;
    for (double size = -2; size < 1; size += 0.01) {
        EXPECT_GE(f64::weave_mean_share(size), last);
        last = f64::weave_mean_share(size);
    }
}

TEST(WeaveCells, BitsSayWhatTheDraftSays) {
    const Draft draft = builtin_draft("twill-2-1");
    const std::vector<std::uint8_t> bits = weave_bits(draft);
    ASSERT_EQ(bits.size(), draft.warp_up.size());
    for (std::size_t i = 0; i < bits.size(); ++i) EXPECT_EQ(bits[i] & 1, draft.warp_up[i]);
    const WeaveFamilies f = weave_families(draft);
    EXPECT_NEAR(f.warp.upper + f.weft.upper, 1.0, 1e-12);
    // Up two, down one: two passages in three cells.
    EXPECT_NEAR(f.warp.bends, 2.0 / 3.0, 1e-12);
    EXPECT_NEAR(f.weft.bends, 2.0 / 3.0, 1e-12);
}

}  // namespace
}  // namespace burnish::test
