// WIF files whose rows, counts and sizes say more than is drawn.
#include <gtest/gtest.h>

#include <string>

#include "burnish/wif.hpp"
#include "wif_support.hpp"

namespace burnish {
namespace {

using test::complaint;
using test::drawn;
using test::has;
using test::read;
using test::Sections;
using test::small;
using test::text_of;

// Rows of treadles and threads that the counts do not reach, as Fiberworks writes them.
TEST(WifSize, RowsThatNothingUsesChangeNothing) {
    const Draft plain = read(text_of(small())).draft;
    Sections sections = small();
    sections["TIEUP"] += "4=1,2\n5=9\n6=x\n7=\n5000=1\n";
    sections["TREADLING"] += "4=1\n5=y\n";
    sections["THREADING"] += "0=1\n4=3\n77777777777777777777777=1\n";
    const WifFile file = read(text_of(sections));
    EXPECT_EQ(drawn(file.draft), drawn(plain));
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_EQ(file.warnings[0],
              "passed over, because nothing uses them: 3 rows of [THREADING], 2 rows of "
              "[TREADLING], 5 rows of [TIEUP]");
    sections = small();
    sections.erase("TIEUP");
    sections.erase("TREADLING");
    sections["LIFTPLAN"] = "1=1,2,9\n2=3\n3=1,3,77\n4=1\n5=z\n";  // no end is on 9 and on 77
    const WifFile lifted = read(text_of(sections));
    EXPECT_EQ(drawn(lifted.draft), drawn(plain));
    EXPECT_EQ(lifted.warnings, std::vector<std::string>{
                                   "passed over, because nothing uses them: 2 rows of [LIFTPLAN]"});
}

// The counts of [WEAVING] say nothing of a crossing: where threading and tie-up agree, they are drawn.
TEST(WifSize, CountsOfShaftsAndTreadlesDecideNothing) {
    const std::string cloth = drawn(read(text_of(small())).draft);
    const struct {
        std::string weaving, says;
    } cases[] = {
        {"Shafts=2\nTreadles=3\n", "[WEAVING] Shafts=2, but 3 are used: they are drawn"},
        {"Shafts=3\nTreadles=1\n", "[WEAVING] Treadles=1, but 3 are used: they are drawn"},
        {"Shafts=0\nTreadles=3\n",
         "[WEAVING] Shafts: expected a whole number from 1 to 4096, "
         "found \"0\": the numbers that are used count"},
        {"Shafts=many\nTreadles=3\n", "found \"many\""},
        {"Shafts=3\nTreadles=-1\n", "found \"-1\""},
        {"Shafts=99999999999999999999\n", "found \"99999999999999999999\""},
        {"Shafts=3\nTreadles=\n", ""},
        {"", ""},
    };
    for (const auto& c : cases) {
        Sections sections = small();
        sections["WEAVING"] = c.weaving + "Rising Shed=yes\n";
        const WifFile file = read(text_of(sections));
        EXPECT_EQ(drawn(file.draft), cloth) << c.weaving;
        EXPECT_EQ(file.shafts, 3) << c.weaving;
        EXPECT_EQ(file.treadles, 3) << c.weaving;
        EXPECT_EQ(file.warnings.size(), c.says.empty() ? 0u : 1u) << c.weaving;
        EXPECT_TRUE(c.says.empty() || has(file.warnings, c.says)) << c.weaving;
    }
}

TEST(WifSize, ValuesThatAreNotDrawnAreNotParsed) {
    const std::string cloth = drawn(read(text_of(small())).draft);
    Sections sections = small();
    sections["WIF"] = "Version\nDevelopers=\n";
    sections["WEAVING"] = "Shafts=3\nTreadles=3\nRising Shed=yes\nProfile=perhaps\nProfile=2\n";
    sections["WARP"] =
        "Threads=3\nThreads=3 ; again\nUnits=ells\nSpacing=0,212\nSpacing=7\nThickness=\n"
        "Spacing Zoom=x\n";
    sections["WEFT"] = "Threads=3\nSpacing=-1\nThickness=1e999\n";
    sections["WARP SPACING"] = "1=0.212\n2=\n3=0,212\n3=x\nfour=4\nno key\n9=7\n";
    sections["WEFT THICKNESS"] = "1=\n1=\n";
    sections["TEXT"] = "a line\nTitle=\xC4rmel \xE9t\xE9\n";  // Latin-1
    sections["CONTENTS"] = "THREADING=maybe\nnothing\n";
    sections["NOTES"] = std::string(70000, 'n') + "\n\n=\n";
    const WifFile file = read(text_of(sections));
    EXPECT_EQ(drawn(file.draft), cloth);
    EXPECT_EQ(file.draft.name, "\xC3\x84rmel \xC3\xA9t\xC3\xA9") << "UTF-8";
    EXPECT_TRUE(file.warnings.empty()) << file.warnings.front();
}

TEST(WifSize, DecimalCommasCountAsPoints) {
    Sections sections = small();
    sections["WARP"] = "Threads=3\nSpacing=0,212\n";
    sections["WEFT"] = "Threads=3\nSpacing=0.212\n";
    EXPECT_TRUE(read(text_of(sections)).warnings.empty());
    sections["WARP SPACING"] = "2=0,25\n";
    EXPECT_TRUE(has(read(text_of(sections)).warnings, "Spacing differs"));
}

// Threads of small drafts in which every end and every pick differs, so that no repeat is there.
Sections lifted(int ends, int picks) {
    Sections sections = {{"WIF", ""}, {"WEAVING", "Rising Shed=1\n"}};
    sections["WARP"] = "Threads=" + std::to_string(ends) + "\n";
    sections["WEFT"] = "Threads=" + std::to_string(picks) + "\n";
    return sections;
}

TEST(WifSize, YarnsOnNoShaftAtTheSidesAreCutOff) {
    Sections sections = lifted(1200, 1200);
    sections["THREADING"] = "101=1\n102=2\n104=3\n";
    sections["LIFTPLAN"] = "11=1,2\n12=3\n13=1,3\n";
    const WifFile file = read(text_of(sections));
    EXPECT_EQ(drawn(file.draft), "##.. ...# #..# ");
    EXPECT_EQ(file.warp.threads, 1200);
    EXPECT_EQ(file.warp.first, 100);
    EXPECT_EQ(file.warp.used, 4);
    EXPECT_EQ(file.weft.first, 10);
    EXPECT_EQ(file.weft.drawn, 3);
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_EQ(
        file.warnings[0],
        "1196 ends at the sides are on no shaft and not drawn; 1197 picks at the start or the "
        "end move no shaft and are not drawn; nothing holds 1 of the ends and 0 of the picks: "
        "they never change sides");
    // Colors stay with their yarns; those of yarns that are not drawn need not be sound.
    sections["COLOR PALETTE"] = "Range=0,1\n";
    sections["COLOR TABLE"] = "1=1,0,0\n2=0,1,0\n";
    sections["WARP"] += "Color=1\n";
    sections["WARP COLORS"] = "1=55\n2=x\n102=2\n";
    const Draft colored = read(text_of(sections)).draft;
    ASSERT_EQ(colored.warp_colors.size(), 4u);
    EXPECT_EQ(colored.warp_colors[0], glm::vec3(1, 0, 0));
    EXPECT_EQ(colored.warp_colors[1], glm::vec3(0, 1, 0));
}

// A side of many whole repeats is the same cloth as one of them; the expected cells come from the
// text's own rule, not from the reader.
TEST(WifSize, LargeDraftsOfWholeRepeatsAreDrawnAsOne) {
    Sections sections = lifted(1200, 1300);
    std::string threading, plan, colors;
    for (int e = 0; e < 1200; ++e)  // 8 shafts, but shafts 1 to 4 move as 5 to 8 do
        threading += std::to_string(e + 1) + "=" + std::to_string(e % 8 + 1) + "\n";
    const auto lift = [](int p) {
        return std::to_string(p % 4 + 1) + "," + std::to_string(p % 4 + 5);
    };
    for (int p = 0; p < 1300; ++p) plan += std::to_string(p + 1) + "=" + lift(p) + "\n";
    sections["THREADING"] = threading;
    sections["LIFTPLAN"] = plan;
    const WifFile file = read(text_of(sections));
    EXPECT_EQ(drawn(file.draft), "#... .#.. ..#. ...# ");
    EXPECT_EQ(file.warp.threads, 1200);
    EXPECT_EQ(file.warp.used, 1200);
    EXPECT_EQ(file.weft.repeat, 4);
    EXPECT_TRUE(file.warnings.empty()) << "the cloth is the same";
    // Stripes of six ends: the repeat of weave and colors is their least common multiple, 12.
    sections["COLOR PALETTE"] = "Range=0,1\n";
    sections["COLOR TABLE"] = "1=1,0,0\n2=0,1,0\n";
    for (int e = 0; e < 1200; ++e)
        colors += std::to_string(e + 1) + "=" + std::to_string(e / 3 % 2 + 1) + "\n";
    sections["WARP COLORS"] = colors;
    const WifFile striped = read(text_of(sections));
    EXPECT_EQ(striped.draft.ends, 12);
    EXPECT_EQ(striped.draft.picks, 4);
    EXPECT_EQ(striped.draft.warp_colors[5], glm::vec3(0, 1, 0));
    // A rest that is no whole repeat: still drawn whole, as the draft is not too large.
    sections["WARP"] = "Threads=1199\n";
    EXPECT_EQ(read(text_of(sections)).draft.ends, 1199);
}

TEST(WifSize, DraftsOfAtMost256YarnsASideAreDrawnAsWritten) {
    Sections sections = lifted(256, 8);
    for (int e = 1; e <= 256; ++e)
        sections["THREADING"] += std::to_string(e) + "=" + std::to_string(e % 2 + 1) + "\n";
    for (int p = 1; p <= 8; ++p)
        sections["LIFTPLAN"] += std::to_string(p) + "=" + std::to_string(p % 2 + 1) + "\n";
    const WifFile file = read(text_of(sections));
    EXPECT_EQ(file.draft.ends, 256);
    EXPECT_EQ(file.draft.picks, 8);
    EXPECT_EQ(file.warp.repeat, 2);
    EXPECT_EQ(file.weft.repeat, 2);
}

TEST(WifSize, DraftsThatAreTooLargeAreCutAndSaySo) {
    // 5000 ends are 714 repeats of 7 and two more; the picks differ all (binary numbers).
    Sections sections = lifted(5000, 4200);
    std::string threading, plan;
    for (int e = 0; e < 5000; ++e)
        threading += std::to_string(e + 1) + "=" + std::to_string(e % 7 + 1) + "\n";
    for (int p = 0; p < 4200; ++p) {
        plan += std::to_string(p + 1) + "=1";
        for (int bit = 0; bit < 13; ++bit)
            if (((p * p + 1) >> bit & 1) != 0) plan += "," + std::to_string(bit % 7 + 1);
        plan += "\n";
    }
    sections["THREADING"] = threading;
    sections["LIFTPLAN"] = plan;
    const WifFile file = read(text_of(sections));
    EXPECT_EQ(file.draft.ends, 7);
    EXPECT_EQ(file.draft.picks, 4096);
    EXPECT_TRUE(has(file.warnings,
                    "too large to draw whole: of 5000 ends the repeat of 7 is drawn, without the 2 "
                    "after the last whole one; of 4200 picks the first 4096 are drawn, with a seam "
                    "where they start again"));
    EXPECT_EQ(file.weft.repeat, 4200);
}

// A tiny file can name any size: the time and the memory stay those of what is drawn.
TEST(WifSize, SizesWithoutRowsTakeLittle) {
    Sections sections = lifted(65536, 65536);
    sections["THREADING"] = "1=1\n65536=1\n";
    sections["LIFTPLAN"] = "1=1\n65536=1\n";
    const Draft draft = read(text_of(sections)).draft;
    EXPECT_LE(draft.warp_up.size(), static_cast<std::size_t>(kMostDraftCells));
    EXPECT_EQ(draft.ends, 2048);
    EXPECT_EQ(draft.picks, 2048);
    sections["WARP"] = "Threads=65537\n";
    EXPECT_NE(complaint(text_of(sections)).find("from 1 to 65536"), std::string::npos);
}

}  // namespace
}  // namespace burnish
