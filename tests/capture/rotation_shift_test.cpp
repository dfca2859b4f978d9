// Rotations of tables: by whole columns, between columns, and with too little overlap.
#include <gtest/gtest.h>

#include "capture/solve/rotation_match.hpp"
#include "match_support.hpp"

namespace burnish {
namespace {

using namespace test;

class MatchShifts : public testing::TestWithParam<NdfGrid> {};
INSTANTIATE_TEST_SUITE_P(Grids, MatchShifts, testing::ValuesIn(test::kGrids), test::name_of_grid);

// A rotation of the point's table is added to the result, a rotation of the exemplar's is
// subtracted.
TEST_P(MatchShifts, ShiftsGoWithTheTables) {
    const NdfGrid grid = GetParam();
    Random random(5);
    const Table p = patterned(grid, Mask::half, random), e = patterned(grid, Mask::holes, random);
    const RotationMatch plain = one_match(grid, p, e);
    ASSERT_LT(plain.residual, 1.0f);
    for (const int columns : {1, 5, grid.azimuths / 2, grid.azimuths - 1}) {
        const RotationMatch of_exemplar = one_match(grid, p, rotated(grid, e, columns));
        const RotationMatch of_point = one_match(grid, rotated(grid, p, columns), e);
        // 0.02: the effect of rounding on the position between columns.
        EXPECT_LT(columns_between(static_cast<double>(of_exemplar.shift),
                                  static_cast<double>(plain.shift) - columns, grid.azimuths),
                  0.02)
            << columns;
        EXPECT_LT(columns_between(static_cast<double>(of_point.shift),
                                  static_cast<double>(plain.shift) + columns, grid.azimuths),
                  0.02)
            << columns;
        for (const RotationMatch& m : {of_exemplar, of_point}) {
            EXPECT_NEAR(m.residual, plain.residual, kResidualRounding) << columns;
            EXPECT_NEAR(m.scale, plain.scale, 1e-3f * plain.scale) << columns;
            EXPECT_NEAR(m.overlap, plain.overlap, 1e-3f) << columns;
            EXPECT_GE(m.shift, -0.5f);
            EXPECT_LE(m.shift, static_cast<float>(grid.azimuths) - 0.5f);
        }
    }
}

TEST_P(MatchShifts, SelfMatchesAndScalesAreFound) {
    const NdfGrid grid = GetParam();
    Random random(9);
    for (const Mask mask : {Mask::full, Mask::holes, Mask::half, Mask::soft}) {
        const Table e = patterned(grid, mask, random);
        Table p = rotated(grid, e, 7);
        for (float& v : p.value) v *= 3.75f;
        const RotationMatch found = one_match(grid, p, e);
        EXPECT_LT(found.residual, 1e-4f) << static_cast<int>(mask);
        EXPECT_GE(found.residual, 0.0f) << static_cast<int>(mask);
        EXPECT_NEAR(found.shift, 7, 0.5) << static_cast<int>(mask);
        EXPECT_NEAR(found.scale, 3.75f, 4e-3f) << static_cast<int>(mask);
    }
}

// A leaning lobe, which fits at one rotation only, at positions between columns. The point has its
// own mask. 0.1 column is 0.4 degrees on the usual grid.
TEST_P(MatchShifts, RotationsBetweenColumnsAreFound) {
    const NdfGrid grid = GetParam();
    // Wider lobes for wider columns: the parabola through three columns needs a smooth residual.
    const double wide = grid.azimuths == 96 ? 1 : 1.8;
    const auto lobe = test::beckmann(0.25 * wide, 0.5 * wide, 0.15, 0.2);
    const Table e{test::sampled(grid, lobe),
                  std::vector<float>(static_cast<std::size_t>(grid.cells()), 1.0f)};
    for (const bool masked : {false, true}) {
        double worst = 0;
        for (int i = 0; i < 25; ++i) {
            const double columns = i * (grid.azimuths / 25.0) + 0.137 * i;
            Table p{test::sampled(grid, lobe, columns), e.weight};
            if (masked)
                for (int r = 0; r < grid.rings; ++r)
                    for (int a = 0; a < grid.azimuths / 3; ++a) p.weight[cell(grid, r, a)] = 0;
            const RotationMatch found = one_match(grid, p, e);
            EXPECT_LT(found.residual, 0.04f) << columns;  // that of the nearest whole column
            worst = std::max(
                worst, columns_between(static_cast<double>(found.shift), columns, grid.azimuths));
        }
        // Wide columns with the mask's edge across the lobe distort the parabola.
        EXPECT_LT(worst, masked && grid.azimuths < 96 ? 0.2 : 0.1) << (masked ? "masked" : "whole");
    }
}

// Next to an invalid rotation no parabola is defined: the result is a whole column. Two masks of
// half a circle have enough overlap only within a quarter circle, and the best rotation lies
// beyond.
TEST_P(MatchShifts, AnswersAtTheRimOfOverlapAreWhole) {
    const NdfGrid grid = GetParam();
    const auto lobe = test::beckmann(0.3, 0.6, 0.3, 0);
    Table p{test::sampled(grid, lobe, 0.4 * grid.azimuths), {}}, e{test::sampled(grid, lobe), {}};
    for (int i = 0; i < grid.cells(); ++i) {
        const float w = i % grid.azimuths < grid.azimuths / 2 ? 1.0f : 0.0f;
        p.weight.push_back(w);
        e.weight.push_back(w);
    }
    const Best best = best_by_definition(grid, p, e, 0.4);
    const auto before = by_definition(grid, p, e, best.shift - 1, 0).overlap;
    const auto after = by_definition(grid, p, e, best.shift + 1, 0).overlap;
    ASSERT_LT(std::min(before, after), 0.399) << "the case is not at the rim";
    const RotationMatch found = one_match(grid, p, e);
    EXPECT_EQ(found.shift, static_cast<float>(best.shift));
    EXPECT_NEAR(static_cast<double>(found.residual), best.at.residual, kResidualRounding);
}

}  // namespace
}  // namespace burnish
