// The match of all rotations at once, compared with sums over each rotation by the definition.
#include "capture/solve/rotation_match.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <limits>

#include "match_support.hpp"

namespace burnish {
namespace {

using namespace test;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

class Match : public testing::TestWithParam<NdfGrid> {};
INSTANTIATE_TEST_SUITE_P(Grids, Match, testing::ValuesIn(test::kGrids), test::name_of_grid);

// Is there a rotation within half a column of the result that is as good as the best within
// rounding and has the result's scale and overlap? Small masks have several equally good rotations.
bool is_answer(const NdfGrid& grid, const Table& point, const Table& exemplar, double residual,
               const RotationMatch& found) {
    for (int s = 0; s < grid.azimuths; ++s) {
        if (columns_between(static_cast<double>(found.shift), s, grid.azimuths) > 0.501) continue;
        const AtRotation there = by_definition(grid, point, exemplar, s, 0);
        if (std::abs(there.residual - residual) < kResidualRounding &&
            std::abs(static_cast<double>(found.scale) - there.scale) < 1e-3 * there.scale &&
            std::abs(static_cast<double>(found.overlap) - there.overlap) < 1e-3)
            return true;
    }
    return false;
}

// The spectral match finds the rotation of the definition (or one as good within rounding), with
// the definition's values there. 33 points and 9 exemplars are no multiples of a tile.
TEST_P(Match, SpectralMatchIsBruteForce) {
    const NdfGrid grid = GetParam();
    const float least = 0.4f;
    Random random(7);
    std::vector<Table> points, exemplars;
    for (std::size_t i = 0; i < 33; ++i)
        points.push_back(patterned(grid, kMasks[i % std::size(kMasks)], random));
    for (std::size_t i = 0; i < 9; ++i)
        exemplars.push_back(patterned(grid, kMasks[i % std::size(kMasks)], random));
    RotationMatcher matcher(grid, least);
    const Pile e = pile_of(exemplars), p = pile_of(points);
    matcher.set_exemplars(e.tables());
    EXPECT_EQ(matcher.exemplars(), 9u);
    const Matches all = all_matches(matcher, p.tables());
    int answered = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_EQ(all[i].size(), exemplars.size());
        for (std::size_t k = 0; k < exemplars.size(); ++k) {
            const RotationMatch& found = all[i][k];
            const std::string where = std::to_string(i) + " with " + std::to_string(k);
            // Rounding decides whether overlaps equal to the least one are valid.
            const double low =
                best_by_definition(grid, points[i], exemplars[k], static_cast<double>(least) - 1e-4)
                    .at.residual;
            const Best best = best_by_definition(grid, points[i], exemplars[k],
                                                 static_cast<double>(least) + 1e-4);
            const auto residual = static_cast<double>(found.residual);
            EXPECT_LE(residual, best.at.residual + kResidualRounding) << where;
            if (best.at.residual == 1) continue;
            ++answered;
            EXPECT_GE(residual, low - kResidualRounding) << where;
            EXPECT_TRUE(is_answer(grid, points[i], exemplars[k], best.at.residual, found))
                << where << ": rotation " << found.shift << ", scale " << found.scale
                << ", overlap " << found.overlap;
        }
    }
    EXPECT_GT(answered, 33 * 9 / 4);
}

// A value with weight 0 has no influence.
TEST_P(Match, ValuesWithoutWeightDoNoHarm) {
    const NdfGrid grid = GetParam();
    Random random(21);
    const Table p = patterned(grid, Mask::half, random), e = patterned(grid, Mask::holes, random);
    const RotationMatch plain = one_match(grid, p, e);
    ASSERT_LT(plain.residual, 1.0f);
    for (const float odd : {kNone, std::numeric_limits<float>::infinity(), 1e30f, -3.0f}) {
        Table p2 = p, e2 = e;
        for (Table* t : {&p2, &e2})
            for (std::size_t i = 0; i < t->value.size(); ++i)
                if (t->weight[i] == 0) t->value[i] = odd;
        const RotationMatch found = one_match(grid, p2, e2);
        EXPECT_EQ(found.residual, plain.residual) << odd;
        EXPECT_EQ(found.shift, plain.shift) << odd;
        EXPECT_EQ(found.scale, plain.scale) << odd;
    }
}

// Are both results equally good? The rounding of a point depends on the other points of its call.
// 1e-3: masks of few cells keep few digits of sums over whole tables.
bool alike(const Matches& a, const Matches& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].size() != b[i].size()) return false;
        for (std::size_t k = 0; k < a[i].size(); ++k)
            // Rounding decides whether a rotation with the least overlap is valid.
            if (std::min(a[i][k].overlap, b[i][k].overlap) > 0.401f &&
                !(std::abs(a[i][k].residual - b[i][k].residual) < 1e-3f))
                return false;
    }
    return true;
}

bool same(const Matches& a, const Matches& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].size() != b[i].size()) return false;
        for (std::size_t k = 0; k < a[i].size(); ++k)
            if (a[i][k].residual != b[i][k].residual || a[i][k].shift != b[i][k].shift ||
                a[i][k].scale != b[i][k].scale || a[i][k].overlap != b[i][k].overlap)
                return false;
    }
    return true;
}

// Results are equal bit for bit for any number of threads. With other points or parts of the
// exemplars in a call they are equal within rounding, as the rounding of matrix products depends on
// the position.
TEST_P(Match, AnswersDoNotDependOnThreadsOrCompany) {
    const NdfGrid grid = GetParam();
    Random random(33);
    Pile p, e;
    for (std::size_t i = 0; i < 150; ++i)
        p.add(patterned(grid, kMasks[i % std::size(kMasks)], random));
    for (std::size_t i = 0; i < 37; ++i)
        e.add(patterned(grid, kMasks[i % std::size(kMasks)], random));
    RotationMatcher matcher(grid);
    using Control = oneapi::tbb::global_control;
    Matches one_thread, two_threads;
    {
        const Control limit(Control::max_allowed_parallelism, 1);
        matcher.set_exemplars(e.tables());
        one_thread = all_matches(matcher, p.tables());
    }
    {
        const Control limit(Control::max_allowed_parallelism, 2);
        matcher.set_exemplars(e.tables());
        two_threads = all_matches(matcher, p.tables());
    }
    EXPECT_TRUE(same(one_thread, two_threads));
    for (const std::size_t group : {1u, 7u, 64u}) {
        Matches parts;
        for (std::size_t first = 0; first < p.count; first += group) {
            const std::size_t count = std::min(group, p.count - first);
            for (auto& m : all_matches(matcher, p.tables(first, count, grid)))
                parts.push_back(std::move(m));
        }
        EXPECT_TRUE(alike(one_thread, parts)) << group;
    }
    Matches some(p.count);
    std::mutex mutex;
    matcher.match_range(p.tables(), 11, 9, [&](std::size_t point, auto matches) {
        const std::lock_guard lock(mutex);
        some.at(point).assign(matches.begin(), matches.end());
    });
    for (auto& row : one_thread) row = {row.begin() + 11, row.begin() + 20};
    EXPECT_TRUE(alike(one_thread, some));
}

TEST_P(Match, TooLittleOverlapIsNoMatch) {
    const NdfGrid grid = GetParam();
    Random random(2);
    Table p = random_table(grid, Mask::full, random), e = p;
    for (int r = 0; r < grid.rings;
         ++r)  // the point is known near the normal, the exemplar elsewhere
        for (int a = 0; a < grid.azimuths; ++a)
            (r < grid.rings / 2 ? e : p).weight[cell(grid, r, a)] = 0;
    EXPECT_EQ(one_match(grid, p, e).residual, 1.0f);
    EXPECT_EQ(one_match(grid, e, p).residual, 1.0f);
    EXPECT_NEAR(one_match(grid, p, p).overlap, 1.0f, 1e-5f);
    EXPECT_LT(one_match(grid, p, p).residual, 1e-4f);
    const Table nothing = random_table(grid, Mask::empty, random);
    EXPECT_EQ(one_match(grid, nothing, p).residual, 1.0f);
    EXPECT_EQ(one_match(grid, p, nothing).residual, 1.0f);
}

// Realistic lobes, with peaks of hundreds and tails of thousandths, under half masks.
TEST_P(Match, PeaksDoNotDrownTails) {
    const NdfGrid grid = GetParam();
    Random random(17);
    const Table e{test::sampled(grid, test::ggx(0.04, 0.2, 0.05, 0.1)),
                  std::vector<float>(static_cast<std::size_t>(grid.cells()), 1.0f)};
    for (int i = 0; i < 10; ++i) {
        Table p{test::sampled(grid, test::ggx(0.05, 0.25, 0.05, 0.1), random.uniform(0, 96)), {}};
        for (int k = 0; k < grid.cells(); ++k) {
            const bool tail = k / grid.azimuths > grid.rings / 3;
            p.weight.push_back(tail && k % grid.azimuths > grid.azimuths / 3 ? 1.0f : 0.0f);
        }
        const Best best = best_by_definition(grid, p, e, 0.4);
        const RotationMatch found = one_match(grid, p, e);
        EXPECT_NEAR(static_cast<double>(found.residual), best.at.residual, 1e-3) << i;
        EXPECT_LT(columns_between(static_cast<double>(found.shift), best.shift, grid.azimuths),
                  0.501)
            << i;
    }
}

TEST(MatchOf, NoPointsAndTablesOfZeros) {
    const NdfGrid grid{8, 24};
    RotationMatcher matcher(grid);
    const Pile none;
    Random random(1);
    Table zero = random_table(grid, Mask::full, random);
    const Table some = zero;
    for (float& v : zero.value) v = 0;
    const Pile e = pile_of({some, zero});
    matcher.set_exemplars(e.tables());
    EXPECT_TRUE(all_matches(matcher, none.tables()).empty());
    const Matches all = all_matches(matcher, e.tables());
    EXPECT_EQ(all[0][1].residual, 1.0f);  // no scale of a zero table fits
    for (const auto& row : all)
        for (const RotationMatch& m : row)
            EXPECT_TRUE(std::isfinite(m.residual) && std::isfinite(m.shift) &&
                        std::isfinite(m.scale));
}

}  // namespace
}  // namespace burnish
