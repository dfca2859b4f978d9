// Each weave by the property that defines it in a weaver's textbook, not by its own formula.
#include "burnish/draft.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "burnish/error.hpp"

namespace burnish {
namespace {

// The value of the infinitely repeated pattern.
bool up(const Draft& draft, int end, int pick) {
    const auto wrap = [](int i, int n) { return ((i % n) + n) % n; };
    return draft.is_warp_up(wrap(end, draft.ends), wrap(pick, draft.picks));
}

template <typename Check>
void at_every_crossing(const Draft& draft, const Check& check) {
    for (int pick = 0; pick < draft.picks; ++pick)
        for (int end = 0; end < draft.ends; ++end) check(end, pick);
}

int ups_of_end(const Draft& draft, int end) {
    int count = 0;
    for (int pick = 0; pick < draft.picks; ++pick) count += up(draft, end, pick);
    return count;
}

int ups_of_pick(const Draft& draft, int pick) {
    int count = 0;
    for (int end = 0; end < draft.ends; ++end) count += up(draft, end, pick);
    return count;
}

std::string complaint(const Draft& draft) {
    try {
        check_draft(draft, "cloth");
    } catch (const Error& error) {
        return error.what();
    }
    return "no complaint";
}

TEST(Draft, PlainAlternatesBothWays) {
    const Draft plain = builtin_draft("plain");
    at_every_crossing(plain, [&](int end, int pick) {
        EXPECT_NE(up(plain, end, pick), up(plain, end + 1, pick));
        EXPECT_NE(up(plain, end, pick), up(plain, end, pick + 1));
    });
}

// Each pick is the previous one, shifted by one end to the right. Each yarn passes over and under
// the numbers of yarns in the twill's name.
void expect_twill(const Draft& draft, int over, int under) {
    at_every_crossing(draft, [&](int end, int pick) {
        EXPECT_EQ(up(draft, end, pick), up(draft, end + 1, pick + 1)) << draft.name;
    });
    for (int end = 0; end < draft.ends; ++end) EXPECT_EQ(ups_of_end(draft, end), over);
    for (int pick = 0; pick < draft.picks; ++pick) EXPECT_EQ(ups_of_pick(draft, pick), over);
    const DraftFigures figures = draft_figures(draft);
    EXPECT_EQ(figures.longest_warp_float, over) << draft.name;
    EXPECT_EQ(figures.longest_weft_float, under) << draft.name;
    EXPECT_DOUBLE_EQ(figures.warp_share, static_cast<double>(over) / (over + under));
}

TEST(Draft, TwillsShiftByOneAPick) {
    expect_twill(builtin_draft("twill-2-1"), 2, 1);
    expect_twill(builtin_draft("twill-2-2"), 2, 2);
    expect_twill(builtin_draft("twill-3-1"), 3, 1);
}

TEST(Draft, EveryFloatOfTwill22HasLengthTwo) {
    const Draft twill = builtin_draft("twill-2-2");
    // A crossing has exactly one equal neighbor along each yarn.
    at_every_crossing(twill, [&](int end, int pick) {
        const bool here = up(twill, end, pick);
        EXPECT_EQ((up(twill, end, pick - 1) == here) + (up(twill, end, pick + 1) == here), 1);
        EXPECT_EQ((up(twill, end - 1, pick) == here) + (up(twill, end + 1, pick) == here), 1);
    });
}

TEST(Draft, HerringboneReversesAtEnds8And16) {
    const Draft draft = builtin_draft("herringbone");
    ASSERT_EQ(draft.ends, 16);
    at_every_crossing(draft, [&](int end, int pick) {
        // The diagonal climbs to the right, then to the left.
        if (end % 8 != 7) {
            const int step = end < 8 ? 1 : -1;
            EXPECT_EQ(up(draft, end, pick), up(draft, end + 1, pick + step)) << end;
        } else {
            // Clean cut: opposite on the two sides of a reversal.
            EXPECT_NE(up(draft, end, pick), up(draft, end + 1, pick)) << end;
        }
    });
    // Every end is one of a 2/2 twill, and the cut lengthens no float.
    const DraftFigures figures = draft_figures(draft);
    EXPECT_EQ(figures.longest_warp_float, 2);
    EXPECT_EQ(figures.longest_weft_float, 2);
    EXPECT_DOUBLE_EQ(figures.warp_share, 0.5);
}

// One interlacing per end and pick, none adjacent, with steps coprime to the repeat.
void expect_satin(const Draft& draft, int repeat) {
    ASSERT_EQ(draft.ends, repeat);
    ASSERT_EQ(draft.picks, repeat);
    std::vector<int> place(static_cast<std::size_t>(repeat));
    for (int i = 0; i < repeat; ++i) {
        EXPECT_EQ(ups_of_end(draft, i), repeat - 1);
        EXPECT_EQ(ups_of_pick(draft, i), repeat - 1);
        int& at = place[static_cast<std::size_t>(i)];
        while (up(draft, at, i)) ++at;
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                if (dx != 0 || dy != 0) {
                    EXPECT_TRUE(up(draft, at + dx, i + dy)) << i;
                }
    }
    const int move = (place[1] - place[0] + repeat) % repeat;
    EXPECT_EQ(std::gcd(move, repeat), 1);
    for (std::size_t i = 0; i < place.size(); ++i)
        EXPECT_EQ((place[(i + 1) % place.size()] - place[i] + 2 * repeat) % repeat, move) << i;
}

TEST(Draft, SatinsHaveOneScatteredInterlacing) {
    expect_satin(builtin_draft("satin-5"), 5);
    expect_satin(builtin_draft("satin-8"), 8);
}

TEST(Draft, BasketIsPlainWeaveOfPairs) {
    const Draft basket = builtin_draft("basket"), plain = builtin_draft("plain");
    at_every_crossing(basket, [&](int end, int pick) {
        EXPECT_EQ(up(basket, end, pick), up(plain, end / 2, pick / 2));
    });
}

TEST(Draft, EveryBuiltinHolds) {
    for (const std::string_view name : draft_names()) {
        const Draft draft = builtin_draft(name);
        EXPECT_EQ(draft.name, name);
        EXPECT_EQ(complaint(draft), "no complaint");
        const DraftFigures figures = draft_figures(draft);
        EXPECT_EQ(figures.loose_ends + figures.loose_picks, 0) << name;
    }
    try {
        builtin_draft("twil-2-2", "--weave");
        FAIL() << "no complaint";
    } catch (const UsageError& error) {
        EXPECT_EQ(std::string(error.what())
                      .find("--weave: unknown weave \"twil-2-2\"; did you "
                            "mean 'twill-2-2'?"),
                  0u)
            << error.what();
    }
}

TEST(Draft, FloatsGoOnOverTheRepeatAndLooseYarnsAreCounted) {
    // By hand: end 0 is up at picks 3 and 0, which are adjacent across the edge; end 1 is never up.
    Draft draft{"hand", 2, 4, {1, 0, 0, 0, 0, 0, 1, 0}, {}, {}};
    const DraftFigures figures = draft_figures(draft);
    EXPECT_EQ(figures.longest_warp_float, 2);
    EXPECT_EQ(figures.longest_weft_float, 2);  // picks 1 and 2: over both ends, without end
    EXPECT_EQ(figures.loose_ends, 1);
    EXPECT_EQ(figures.loose_picks, 2);
    EXPECT_DOUBLE_EQ(figures.warp_share, 0.25);
}

TEST(Draft, BrokenOnesAreNamed) {
    const Draft good = builtin_draft("plain");
    const auto says = [&](auto change) {
        Draft draft = good;
        change(draft);
        return complaint(draft);
    };
    EXPECT_EQ(says([](Draft& d) { d.ends = 0; }), "cloth: ends: expected 1 to 4096, found 0");
    EXPECT_EQ(says([](Draft& d) { d.picks = 5000; }),
              "cloth: picks: expected 1 to 4096, found 5000");
    EXPECT_EQ(says([](Draft& d) { d.ends = d.picks = 4096; }),
              "cloth: size: expected at most 4194304 crossings, found 4096 ends x 4096 picks");
    EXPECT_EQ(says([](Draft& d) { d.warp_up.pop_back(); }),
              "cloth: warp_up: expected 4 cells, found 3");
    EXPECT_EQ(says([](Draft& d) { d.warp_up[1] = 2; }), "cloth: warp_up: expected 0 or 1, found 2");
    EXPECT_EQ(says([](Draft& d) { d.warp_colors.resize(3); }),
              "cloth: warp_colors: expected 2 or none, found 3");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(says([&](Draft& d) {
                  d.weft_colors.assign(2, glm::vec3(0, nan, 0));
              }).find("weft_colors: expected finite"),
              std::string::npos);
}

}  // namespace
}  // namespace burnish
