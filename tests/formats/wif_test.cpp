// WIF files against drafts computed by hand, round trips, and errors.
#include "burnish/wif.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "core/files.hpp"
#include "support/paths.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using test::error_line;
using test::ScratchFolder;

// Sections by name, so that a test can change one of them.
using Sections = std::map<std::string, std::string>;

// Three ends on three shafts, three picks, by treadles.
Sections small() {
    return {
        {"WIF", "Version=1.1\n"},         {"WEAVING", "Shafts=3\nTreadles=3\nRising Shed=yes\n"},
        {"WARP", "Threads=3\n"},          {"WEFT", "Threads=3\n"},
        {"THREADING", "1=1\n2=2\n3=3\n"}, {"TIEUP", "1=1,2\n2=3\n3=1,3\n"},
        {"TREADLING", "1=1\n2=2\n3=3\n"}};
}

std::string text_of(const Sections& sections) {
    std::string text = "[WIF]\n" + sections.at("WIF");
    for (const auto& [name, lines] : sections)
        if (name != "WIF") text += "\n[" + name + "]\n" + lines;
    return text;
}

WifFile read(const std::string& text) {
    const ScratchFolder folder;
    return read_wif(folder.write("cloth.wif", text));
}

std::string complaint(const std::string& text) {
    const ScratchFolder folder;
    const auto path = folder.write("cloth.wif", text);
    std::string line = error_line([&] { read_wif(path); });
    EXPECT_EQ(line.find(path.string()), 0u) << line;  // starts with the file's name
    return line.substr(std::min(line.size(), path.string().size()));
}

// Rows from the bottom, in the order of picks: "#.." is one end up and two down.
std::string drawn(const Draft& draft) {
    std::string text;
    for (int pick = 0; pick < draft.picks; ++pick) {
        for (int end = 0; end < draft.ends; ++end) text += draft.is_warp_up(end, pick) ? '#' : '.';
        text += ' ';
    }
    return text;
}

bool has(const std::vector<std::string>& warnings, const std::string& part) {
    return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& warning) {
        return warning.find(part) != std::string::npos;
    });
}

TEST(Wif, TreadlesMoveTheShaftsTheyAreTiedTo) {
    // By hand: pick 1 lifts shafts 1 and 2, pick 2 shaft 3, pick 3 shafts 1 and 3; end n is on
    // shaft n.
    const WifFile file = read(text_of(small()));
    EXPECT_EQ(drawn(file.draft), "##. ..# #.# ");
    EXPECT_EQ(file.draft.name, "cloth");
    EXPECT_EQ(file.shafts, 3);
    EXPECT_EQ(file.treadles, 3);
    EXPECT_FALSE(file.has_liftplan);
    EXPECT_TRUE(file.draft.warp_colors.empty());
    EXPECT_TRUE(file.warnings.empty()) << file.warnings.front();
}

TEST(Wif, ASinkingShedShowsTheOtherFace) {
    Sections sections = small();
    sections["WEAVING"] = "Shafts=3\nTreadles=3\nRising Shed=off\n";
    EXPECT_EQ(drawn(read(text_of(sections)).draft), "..# ##. .#. ");
    sections["WEAVING"] = "Shafts=3\nTreadles=3\n";
    const WifFile silent = read(text_of(sections));
    EXPECT_EQ(drawn(silent.draft), "##. ..# #.# ");
    EXPECT_TRUE(has(silent.warnings, "Rising Shed"));
}

TEST(Wif, SeveralTreadlesSeveralShaftsAndNone) {
    Sections sections = small();
    sections["THREADING"] = "3=3\n1=1,2\n";      // end 2 on no shaft, end 1 on two; in any order
    sections["TREADLING"] = "1=2,1\n2=0\n3=\n";  // both; none; none
    const WifFile file = read(text_of(sections));
    EXPECT_EQ(drawn(file.draft), "#.# ");  // the picks without a shaft are the last ones
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_EQ(file.warnings[0],
              "2 picks at the start or the end move no shaft and are not drawn; nothing holds 3 of "
              "the ends and 0 of the picks: they never change sides");
    sections["TREADLING"] = "1=2,1\n2=0\n3=1\n";
    const WifFile between = read(text_of(sections));
    EXPECT_EQ(drawn(between.draft), "#.# ... #.. ");
    EXPECT_TRUE(has(between.warnings, "nothing holds 1 of the ends and 1 of the picks"));
}

TEST(Wif, ALiftPlanNamesTheShaftsItself) {
    Sections sections = small();
    sections.erase("TIEUP");
    sections.erase("TREADLING");
    sections["LIFTPLAN"] = "1=1\n2=2,3\n3=1,2,3\n";
    const WifFile file = read(text_of(sections));
    EXPECT_EQ(drawn(file.draft), "#.. .## ### ");
    EXPECT_TRUE(file.has_liftplan);
    // A lift plan beside a treadling must agree with it.
    sections = small();
    sections["LIFTPLAN"] = "1=1,2\n2=3\n3=1,3\n";
    EXPECT_EQ(drawn(read(text_of(sections)).draft), "##. ..# #.# ");
    sections["LIFTPLAN"] = "1=1,2\n2=2\n3=1,3\n";
    EXPECT_EQ(
        complaint(text_of(sections)),
        ": pick 2: expected [LIFTPLAN] and [TREADLING] to move the same shafts, found others");
    // Only a shaft with an end on it makes a difference.
    sections["THREADING"] = "1=1\n2=1\n3=1\n";
    EXPECT_EQ(drawn(read(text_of(sections)).draft), "### ... ### ");
}

// Programs keep the section that is not in use, without a shaft in it.
TEST(Wif, OfALiftPlanAndATreadlingTheOneThatMovesShaftsIsDrawn) {
    Sections sections = small();
    sections["LIFTPLAN"] = "1=\n2=0\n3=\n";
    const WifFile treadled = read(text_of(sections));
    EXPECT_EQ(drawn(treadled.draft), "##. ..# #.# ");
    EXPECT_FALSE(treadled.has_liftplan);
    sections["LIFTPLAN"] = "1=1\n2=2\n3=3\n";
    sections["TREADLING"] = "1=0\n2=\n3=\n";
    const WifFile lifted = read(text_of(sections));
    EXPECT_EQ(drawn(lifted.draft), "#.. .#. ..# ");
    EXPECT_TRUE(lifted.has_liftplan);
    // A treadling that cannot be read does not matter beside a lift plan.
    sections["TREADLING"] = "1=1\n2=7\n3=x\n";
    const WifFile broken = read(text_of(sections));
    EXPECT_EQ(drawn(broken.draft), "#.. .#. ..# ");
    EXPECT_TRUE(has(broken.warnings, "[LIFTPLAN] is drawn in place of [TREADLING]"));
}

TEST(Wif, LettersLineEndsCommentsAndOtherSectionsDoNotMatter) {
    const std::string text =
        "\xEF\xBB\xBF; made by hand\r\n  [ wif ] ; first\r\nversion=1.1\r\n"
        "[Private Loom Stuff]\r\nno key here\r\n1=1\r\n"
        "[weaving]\rshafts = 3 ; on the loom\rTREADLES=3\rrising shed=TRUE;\r"
        "[warp]\nthreads=3\n\n[weft]\nThreads=\t3\n[Threading]\n;1=3\n1=1\n2=2\n3=3 ; last\n"
        "[TieUp]\n1= 1 , 2\n2=3\n3=1,3\n[treadling]\n1=1\n2=2\n3=3\n[text]\n"
        "Title=A cloth; mine\n\x1A";
    const WifFile file = read(text);
    EXPECT_EQ(drawn(file.draft), "##. ..# #.# ");
    EXPECT_EQ(file.draft.name, "A cloth; mine");  // free text keeps its semicolons
}

// Values ignore case, like keys, and may be followed by a comment.
TEST(Wif, WordsMayBeInAnyCaseAndCommented) {
    Sections sections = small();
    sections["WIF"] = "Version=1.1 ; of 1997\n";
    sections["CONTENTS"] = "WEFT COLORS=Yes ; announced, not there\n";
    sections["COLOR PALETTE"] = "Entries=1\nForm=rgb ; screen\nRange=0,255\n";
    sections["COLOR TABLE"] = "1=255,0,0\n";
    sections["WARP"] = "Threads=3\nColor=1\nUnits=INCHES ; the same spacing\nSpacing=0.1\n";
    sections["WEFT"] = "Threads=3\nUnits=centimeters;\nSpacing=0.254\n";
    const WifFile file = read(text_of(sections));
    ASSERT_EQ(file.warnings.size(), 1u) << file.warnings.back();
    EXPECT_EQ(file.warnings[0], "[CONTENTS] announces [WEFT COLORS], which is not there");
    ASSERT_EQ(file.draft.warp_colors.size(), 3u);
    EXPECT_EQ(file.draft.warp_colors[0], glm::vec3(1.0f, 0.0f, 0.0f));
    sections["COLOR PALETTE"] = "Entries=1\nForm=hsv\nRange=0,255\n";
    EXPECT_NE(complaint(text_of(sections)).find("Form, line"), std::string::npos);
}

TEST(Wif, IsToldByItsNameOrByItsFirstSection) {
    const ScratchFolder folder;
    EXPECT_TRUE(is_wif_file(folder.write("a.txt", "; cloth\n [ wif ] ; first\nVersion=1.1\n")));
    EXPECT_FALSE(is_wif_file(folder.write("b.txt", "[WEAVING]\nShafts=2\n[WIF]\n")));
    EXPECT_FALSE(is_wif_file(folder.write("c.txt", "[WIF\n")));
    // A broken file is recognized by its name.
    EXPECT_TRUE(is_wif_file(folder.write("d.WIF", "")));
    EXPECT_TRUE(is_wif_file(folder.write("e.wif", std::string(1, '\0'))));
}

TEST(Wif, ColorsAreThoseOfAScreenInAnyRange) {
    // The sRGB curve by definition (IEC 61966-2-1).
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    Sections sections = small();
    sections["COLOR PALETTE"] = "Entries=3\nForm=RGB\nRange=-100,900\n";
    sections["COLOR TABLE"] = "1=-100,400,900\n3=-80,0,150\n";
    sections["WARP"] = "Threads=3\nColor=3\n";
    sections["WARP COLORS"] = "2=1,255,0,0\n";  // older files write the color after its number
    const WifFile file = read(text_of(sections));
    EXPECT_EQ(file.colors, 3);
    ASSERT_EQ(file.draft.warp_colors.size(), 3u);
    EXPECT_TRUE(file.draft.weft_colors.empty());
    const double expected[3][3] = {{0.02, 0.1, 0.25}, {0.0, 0.5, 1.0}, {0.02, 0.1, 0.25}};
    for (std::size_t end = 0; end < 3; ++end)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(static_cast<double>(file.draft.warp_colors[end][c]),
                        linear(expected[end][c]), 1e-6)
                << end << c;
}

TEST(Wif, ColorsThatLackSomethingAreNamed) {
    Sections sections = small();
    sections["WEFT COLORS"] = "1=1\n";
    EXPECT_TRUE(has(read(text_of(sections)).warnings, "no [COLOR TABLE]"));
    sections["COLOR TABLE"] = "1=0,0,0\n";
    sections["WEFT"] = "Threads=3\nColor=1\n";
    EXPECT_TRUE(has(read(text_of(sections)).warnings, "does not say Range: taken as 0,255"));
    sections["COLOR PALETTE"] = "Entries=2\nRange=255,0\n";
    EXPECT_NE(complaint(text_of(sections)).find("\"255,0\""), std::string::npos);
    sections["COLOR PALETTE"] = "Entries=2\nRange=0,255\n";
    sections["WEFT"] = "Threads=3\n";
    const WifFile some = read(text_of(sections));
    EXPECT_EQ(some.warnings,
              std::vector<std::string>{"[WEFT]: 2 of the threads have no colour, and there is no "
                                       "Color= for all of them: they are gray"});
    ASSERT_EQ(some.draft.weft_colors.size(), 3u);
    EXPECT_EQ(some.draft.weft_colors[0], glm::vec3(0.0f));
    EXPECT_NEAR(static_cast<double>(some.draft.weft_colors[1].y), std::pow(0.555 / 1.055, 2.4),
                1e-6);
    sections["WEFT"] = "Threads=3\nColor=2\n";
    EXPECT_TRUE(
        has(read(text_of(sections)).warnings,
            "2 of the threads have a colour that [COLOR TABLE] lacks, such as 2: they are"));
    sections["WEFT COLORS"] = "1=7\n";
    const WifFile none = read(text_of(sections));
    EXPECT_TRUE(has(none.warnings, "such as 7: they have the colour of the material"));
    EXPECT_TRUE(none.draft.weft_colors.empty());
    sections["WEFT"] = "Threads=3\nColor=1\n";
    EXPECT_TRUE(has(read(text_of(sections)).warnings, "such as 7: they have the one of Color="));
    sections["WEFT COLORS"] = "1=1\n";
    sections["WEFT"] = "Threads=3\nColor=2\n";
    sections["COLOR TABLE"] = "1=0,0\n2=0,0,0\n";
    EXPECT_NE(complaint(text_of(sections)).find("[COLOR TABLE] 1, line"), std::string::npos);
    sections["COLOR TABLE"] = "1=0,0,256\n2=0,0,0\n";
    EXPECT_NE(complaint(text_of(sections)).find("Range of [COLOR PALETTE], found \"256\""),
              std::string::npos);
    sections["WEFT COLORS"] = "1=two\n";
    EXPECT_NE(complaint(text_of(sections)).find("found no number from 0 to 65536"),
              std::string::npos);
}

// A count of the palette that its table does not keep to changes no colour.
TEST(Wif, ColorsThatNothingUsesAreNotParsed) {
    Sections sections = small();
    sections["COLOR PALETTE"] = "Entries=1\nForm=RGB\nRange=0,255\n";
    sections["COLOR TABLE"] = "1=255,0,0\n2=0,255,0\n3=,\n4=0,0,256\n999999=1,1,1\n";
    sections["WARP"] = "Threads=3\nColor=2\n";
    sections["WARP COLORS"] = "1=1\n4=77\n5=x\n";
    const WifFile file = read(text_of(sections));
    ASSERT_EQ(file.draft.warp_colors.size(), 3u);
    EXPECT_EQ(file.draft.warp_colors[0], glm::vec3(1.0f, 0.0f, 0.0f));
    EXPECT_EQ(file.draft.warp_colors[2], glm::vec3(0.0f, 1.0f, 0.0f));
    EXPECT_TRUE(has(file.warnings, "2 rows of [WARP COLORS], 3 rows of [COLOR TABLE]"));
    EXPECT_TRUE(has(file.warnings, "Entries=1, but colour 2 is used: it is drawn"));
    EXPECT_EQ(file.warnings.size(), 2u);
}

TEST(Wif, WhatIsNotDrawnIsSaidOnce) {
    Sections sections = small();
    sections["WARP"] = "Threads=3\nUnits=Centimeters\nSpacing=0.254\nThickness=1\n";
    sections["WEFT"] = "Threads=3\nUnits=Inches\nSpacing=0.1\n";  // equal values
    EXPECT_TRUE(read(text_of(sections)).warnings.empty());
    sections["WEFT"] = "Threads=3\nUnits=Decipoints\nSpacing=100\n";
    EXPECT_TRUE(has(read(text_of(sections)).warnings, "Spacing differs"));
    sections["WEFT"] = "Threads=3\n";
    sections["WARP SPACING"] = "1=0.254\n";
    sections["WARP THICKNESS"] = "1=1\n2=2\n3=3\n";
    const WifFile file = read(text_of(sections));
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_EQ(file.warnings[0], "Thickness differs from yarn to yarn: all are drawn alike");
    sections["WEFT SPACING"] = "1=1\n2=2\n";
    EXPECT_EQ(read(text_of(sections)).warnings,
              std::vector<std::string>{
                  "Spacing and Thickness differ from yarn to yarn: all are drawn alike"});
    sections = small();
    sections["WIF"] = "Version=2.0\n";
    EXPECT_TRUE(has(read(text_of(sections)).warnings, "\"2.0\""));
    sections = small();
    sections["CONTENTS"] = "COLOR TABLE=yes\nWARP COLORS=0\n";
    const WifFile cut = read(text_of(sections));
    ASSERT_EQ(cut.warnings.size(), 1u);
    EXPECT_TRUE(has(cut.warnings, "announces [COLOR TABLE]"));
}

// Rows of treadles and threads that the counts do not reach, as Fiberworks writes them.
TEST(Wif, RowsThatNothingUsesChangeNothing) {
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
TEST(Wif, CountsOfShaftsAndTreadlesDecideNothing) {
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

TEST(Wif, ValuesThatAreNotDrawnAreNotParsed) {
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
    EXPECT_EQ(file.draft.name, "\xC4rmel \xE9t\xE9");
    EXPECT_TRUE(file.warnings.empty()) << file.warnings.front();
}

TEST(Wif, DecimalCommasCountAsPoints) {
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

TEST(Wif, YarnsOnNoShaftAtTheSidesAreCutOff) {
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
TEST(Wif, LargeDraftsOfWholeRepeatsAreDrawnAsOne) {
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

TEST(Wif, DraftsOfAtMost256YarnsASideAreDrawnAsWritten) {
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

TEST(Wif, DraftsThatAreTooLargeAreCutAndSaySo) {
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

TEST(Wif, BrokenFilesAreRefusedByFileSectionKeyAndLine) {
    const struct {
        std::string section, lines, says;
    } cases[] = {
        {"WEAVING", "Shafts=3\nTreadles=3\nRising Shed=maybe\n", "expected true, on, yes"},
        {"WARP", "Threads=0\n", "from 1 to 65536, found \"0\""},
        {"WARP", "Threads=2000000000\n", "from 1 to 65536"},
        {"WARP", "Threads=3\nThreads=4\n", "expected the value of line"},
        {"WEFT", "Color=1\n",
         "[WEFT] Threads: expected a whole number from 1 to 65536, found no such"},
        {"THREADING", "", "expected a section [THREADING]"},
        {"THREADING", "1=4\n", "Shafts of [WEAVING], found \"4\""},
        {"THREADING", "1=1\n1=2\n", "expected the value of line"},
        {"THREADING", "1=5000\n", "whole numbers from 0 to 4096"},
        {"THREADING", "1=1\n[TEXT]\n[THREADING]\n1=2\n", "expected the value of line"},
        {"THREADING", "one=1\n", "the number of a row, found \"one\""},
        {"THREADING", "1\n", "expected [SECTION] or key=value, found \"1\""},
        {"TIEUP", "", "expected [LIFTPLAN], or [TIEUP] and [TREADLING], found [TREADLING] alone"},
        {"TREADLING", "1=4\n", "Treadles of [WEAVING], found \"4\", which [TIEUP] does not"},
        {"TREADLING", "", "found [TIEUP] alone"},
        {"TREADLING", "1=1\n[BROKEN\n", "expected [SECTION], found \"[BROKEN\""},
    };
    for (const auto& c : cases) {
        Sections sections = small();
        sections[c.section] = c.lines;
        const std::string said = complaint(text_of(sections));
        EXPECT_NE(said.find(c.says), std::string::npos) << c.section << "\n" << c.lines << said;
    }
    Sections neither = small();
    neither.erase("TIEUP");
    neither.erase("TREADLING");
    EXPECT_NE(complaint(text_of(neither)).find("found none of them"), std::string::npos);
    for (const char* missing : {"WARP", "WEFT"}) {
        Sections sections = small();
        sections.erase(missing);
        EXPECT_NE(complaint(text_of(sections)).find("no such section"), std::string::npos);
    }
}

// A tiny file can name any size: the time and the memory stay those of what is drawn.
TEST(Wif, SizesWithoutRowsTakeLittle) {
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

TEST(Wif, WhatIsNoTextIsRefused) {
    const std::string good = text_of(small());
    EXPECT_NE(complaint("").find("an empty file"), std::string::npos);
    EXPECT_NE(complaint("hello\n").find("[WIF] before anything else"), std::string::npos);
    EXPECT_NE(complaint("[WEAVING]\nShafts=3\n").find("section [WIF], found none"),
              std::string::npos);
    EXPECT_NE(complaint("\xFF\xFE[\0W\0" + good).find("UTF-16"), std::string::npos);
    EXPECT_NE(complaint(good + std::string(1, '\0')).find("a NUL byte"), std::string::npos);
    EXPECT_NE(complaint(good + "\x01\x02").find("a byte 0x01"), std::string::npos);
    EXPECT_EQ(drawn(read(good + "\x1A\x01\x02").draft), drawn(read(good).draft))
        << "Ctrl-Z ends it";
    EXPECT_NE(complaint(good + std::string(70000, '1')).find("at most 65536 bytes, found 70000"),
              std::string::npos);
    EXPECT_NE(complaint(std::string(std::size_t{17} << 20, '\n')).find("expected"),
              std::string::npos);
    std::string many = "1=1";
    for (int i = 0; i < 4096; ++i) many += ",1";
    Sections sections = small();
    sections["THREADING"] = many + "\n";
    EXPECT_NE(complaint(text_of(sections)).find("at most 4096 numbers"), std::string::npos);
}

TEST(Wif, CutAnywhereItIsADraftOrOneLine) {
    const std::string whole =
        read_text_file(test::source_folder() / "examples" / "weaves" / "satin-stripe.wif");
    const ScratchFolder folder;
    int refused = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const auto path = folder.write("cut.wif", whole.substr(0, length));
        try {
            const WifFile file = read_wif(path);
            check_draft(file.draft, "cut");
            // One for the cut, one for Rising Shed.
            ASSERT_LE(file.warnings.size(), 2u) << length << ": " << file.warnings[2];
        } catch (const Error& error) {
            ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            ++refused;
        }
    }
    // Everything before the first line of the last section is required.
    EXPECT_GE(refused, static_cast<int>(whole.find("[TREADLING]")));
}

// Random drafts are written and read again: cells exactly, colors within half an 8-bit code.
TEST(Wif, WrittenDraftsReadBack) {
    std::mt19937 random(7);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    for (int round = 0; round < 40; ++round) {
        Draft draft;
        draft.name = "round " + std::to_string(round);
        draft.ends = 1 + below(30);
        draft.picks = 1 + below(30);
        for (int i = 0; i < draft.ends * draft.picks; ++i)
            draft.warp_up.push_back(static_cast<std::uint8_t>(below(2)));
        const auto color = [&] {
            return glm::vec3(below(1001), below(1001), below(1001)) / 1000.0f;
        };
        if (round % 3 != 0)
            for (int i = 0; i < draft.ends; ++i) draft.warp_colors.push_back(color());
        if (round % 3 == 2)
            for (int i = 0; i < draft.picks; ++i) draft.weft_colors.push_back(color());
        const Draft back = read(wif_text(draft)).draft;
        EXPECT_EQ(back.name, draft.name);
        EXPECT_EQ(drawn(back), drawn(draft));
        ASSERT_EQ(back.warp_colors.size(), draft.warp_colors.size());
        ASSERT_EQ(back.weft_colors.size(), draft.weft_colors.size());
        // The curve is steepest at white: d linear / d code = 2.4 / 1.055 / 255.
        for (std::size_t i = 0; i < draft.warp_colors.size(); ++i)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(back.warp_colors[i][c], draft.warp_colors[i][c],
                            0.5f * 2.4f / 1.055f / 255.0f + 1e-6f);
        // Colors are rounded once: a second round trip changes nothing.
        const Draft again = read(wif_text(back)).draft;
        EXPECT_EQ(again.warp_colors, back.warp_colors);
        EXPECT_EQ(again.weft_colors, back.weft_colors);
    }
}

TEST(Wif, TheExamplesAreTheClothsTheyClaimToBe) {
    const auto example = [](const char* name) {
        WifFile file = read_wif(test::source_folder() / "examples" / "weaves" / name);
        EXPECT_TRUE(file.warnings.empty()) << name << ": " << file.warnings.front();
        EXPECT_FALSE(file.draft.warp_colors.empty()) << name;
        EXPECT_FALSE(file.draft.weft_colors.empty()) << name;
        return file.draft;
    };
    const Draft twill = builtin_draft("twill-2-2"), broken = builtin_draft("herringbone");
    const Draft houndstooth = example("houndstooth.wif");
    for (int pick = 0; pick < 8; ++pick)
        for (int end = 0; end < 8; ++end)
            EXPECT_EQ(houndstooth.is_warp_up(end, pick), twill.is_warp_up(end % 4, pick % 4));
    EXPECT_EQ(houndstooth.warp_colors[0], houndstooth.weft_colors[0]);
    EXPECT_NE(houndstooth.warp_colors[3], houndstooth.warp_colors[4]);
    EXPECT_EQ(drawn(example("herringbone-tweed.wif")), drawn(broken));
    const Draft stripe = example("satin-stripe.wif"), dobby = example("dobby-diamonds.wif");
    EXPECT_EQ(draft_figures(stripe).longest_warp_float, 3);
    EXPECT_EQ(draft_figures(stripe).longest_weft_float, 3);
    EXPECT_EQ(draft_figures(dobby).longest_warp_float, 3);
    EXPECT_EQ(draft_figures(dobby).longest_weft_float, 3);
    for (int pick = 0; pick < 14; ++pick)
        for (int end = 0; end < 14; ++end) {
            // Diamonds: mirror symmetry about the first end and about the first pick.
            EXPECT_EQ(dobby.is_warp_up(end, pick), dobby.is_warp_up((14 - end) % 14, pick));
            EXPECT_EQ(dobby.is_warp_up(end, pick), dobby.is_warp_up(end, (14 - pick) % 14));
        }
}

}  // namespace
}  // namespace burnish
