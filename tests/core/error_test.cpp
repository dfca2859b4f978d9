#include "burnish/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "burnish/progress.hpp"

namespace burnish {
namespace {

TEST(Error, PutsItsPartsIntoOneLine) {
    EXPECT_STREQ(Error("a.glb", "meshes[0]", "a POSITION", "none").what(),
                 "a.glb: meshes[0]: expected a POSITION, found none");
    EXPECT_STREQ(Error("a.png", "", "a file", "a folder").what(),
                 "a.png: expected a file, found a folder");
    EXPECT_STREQ(Error("", "--alpha", "a number", "").what(), "--alpha: expected a number");
    EXPECT_STREQ(Error("a.png", "", "", "nothing").what(), "a.png: found nothing");
}

TEST(Error, IsOneLineWhateverGoesIn) {
    const std::string line = Error("a\nb", "k\tx", "\x1b[31mred", "c\r\nd").what();
    for (const char c : line) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << line;
    const std::string plain = Error("first\nsecond").what();
    EXPECT_EQ(plain, "first second");
}

TEST(Error, UsageErrorsAndInterruptsAreErrors) {
    EXPECT_THROW(throw UsageError("--x", "", "y", "z"), Error);
    EXPECT_THROW(throw Interrupted(), Error);
}

TEST(Shown, QuotesAndHidesControlCharacters) {
    EXPECT_EQ(shown("ward"), "\"ward\"");
    EXPECT_EQ(shown(""), "\"\"");
    EXPECT_EQ(shown(std::string_view("a\0b\nc", 5)), "\"a?b?c\"");
}

TEST(Shown, CutsLongTextOutsideCharacters) {
    EXPECT_EQ(shown(std::string(60, 'x')), "\"" + std::string(60, 'x') + "\"");
    EXPECT_EQ(shown(std::string(61, 'x')), "\"" + std::string(60, 'x') + "...\"");
    // The two bytes of the last character straddle the limit: both must go.
    const std::string umlaut = std::string(59, 'x') + "\xc3\xa4" + "yyy";
    EXPECT_EQ(shown(umlaut), "\"" + std::string(59, 'x') + "...\"");
}

TEST(OneLine, CollapsesSpaceAndTrims) {
    EXPECT_EQ(one_line("  a \n\n b\tc \r\n"), "a b c");
    EXPECT_EQ(one_line("\n"), "");
}

TEST(Progress, ReportsStageAndClampedShare) {
    std::vector<double> shares;
    const Progress progress([&](std::string_view stage, double done) {
        EXPECT_EQ(stage, "render");
        shares.push_back(done);
    });
    for (const double done : {-1.0, 0.0, 0.25, 1.0, 7.0}) progress.step("render", done);
    progress.step("render", std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(shares, (std::vector<double>{0.0, 0.0, 0.25, 1.0, 1.0, 0.0}));
    EXPECT_NO_THROW(Progress().step("anything", 0.5));
}

TEST(Progress, StopsWhenItsTokenIsCancelled) {
    int reports = 0;
    const CancelToken token;
    const Progress progress([&](std::string_view, double) { ++reports; }, token);
    EXPECT_NO_THROW(progress.throw_if_cancelled());
    token.cancel();
    EXPECT_TRUE(progress.cancelled());
    EXPECT_THROW(progress.step("render", 0.5), Interrupted);
    EXPECT_THROW(progress.throw_if_cancelled(), Interrupted);
    EXPECT_EQ(reports, 0);
    token.reset();
    EXPECT_NO_THROW(progress.step("render", 0.5));
    EXPECT_EQ(reports, 1);
}

TEST(Progress, CancelsNothingBesideIt) {
    const CancelToken token, other;
    const Progress progress(token), beside(other);
    token.cancel();
    EXPECT_TRUE(progress.cancelled());
    EXPECT_FALSE(beside.cancelled());
    EXPECT_FALSE(Progress().cancelled());
}

TEST(Progress, APartHasTheTokenOfTheWhole) {
    const CancelToken token;
    const Progress whole(token);
    double reported = 0;
    const Progress part =
        whole.with_report([&](std::string_view, double done) { reported = done; });
    part.step("part", 0.25);
    EXPECT_EQ(reported, 0.25);
    token.cancel();
    EXPECT_TRUE(part.cancelled());
    EXPECT_THROW(part.step("part", 0.5), Interrupted);
    EXPECT_EQ(reported, 0.25);
}

}  // namespace
}  // namespace burnish
