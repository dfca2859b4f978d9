// WIF files against drafts computed by hand, round trips, and errors.
#include "burnish/wif.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "burnish/image_io.hpp"
#include "core/files.hpp"
#include "support/paths.hpp"
#include "support/test_folder.hpp"
#include "wif_support.hpp"

namespace burnish {
namespace {

using test::complaint;
using test::drawn;
using test::error_line;
using test::has;
using test::read;
using test::ScratchFolder;
using test::Sections;
using test::small;
using test::text_of;

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
    EXPECT_EQ(file.warnings[0],
              "[CONTENTS] announces [WEFT COLORS], which is not there; the file may be cut short");
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
    // The least of the usual ranges that holds the highest value.
    const std::pair<int, int> ranges[] = {{255, 255}, {256, 999}, {999, 999}, {1000, 65535}};
    for (const auto& [highest, white] : ranges) {
        sections["COLOR TABLE"] = fmt::format("1=0,{},0\n", highest);
        const WifFile file = read(text_of(sections));
        EXPECT_TRUE(has(file.warnings,
                        fmt::format("does not say Range: taken as 0,{0}, as the highest value of "
                                    "[COLOR TABLE] is {1} (a line Range=0,{0}",
                                    white, highest)));
        EXPECT_NEAR(file.draft.weft_colors.at(0).y,
                    linear_from_srgb(static_cast<float>(highest) / static_cast<float>(white)),
                    1e-6f);
    }
    sections["COLOR TABLE"] = "1=0,0,0\n";
    sections["COLOR PALETTE"] = "Entries=2\nRange=255,0\n";
    EXPECT_NE(complaint(text_of(sections)).find("\"255,0\""), std::string::npos);
    sections["COLOR PALETTE"] = "Entries=2\nRange=0,255\n";
    sections["WEFT"] = "Threads=3\n";
    const WifFile some = read(text_of(sections));
    EXPECT_EQ(some.warnings,
              std::vector<std::string>{"[WEFT]: 2 of the threads have no color, and there is no "
                                       "Color= for all of them: they are gray"});
    ASSERT_EQ(some.draft.weft_colors.size(), 3u);
    EXPECT_EQ(some.draft.weft_colors[0], glm::vec3(0.0f));
    EXPECT_NEAR(static_cast<double>(some.draft.weft_colors[1].y), std::pow(0.555 / 1.055, 2.4),
                1e-6);
    sections["WEFT"] = "Threads=3\nColor=2\n";
    EXPECT_TRUE(has(read(text_of(sections)).warnings,
                    "2 of the threads have a color that [COLOR TABLE] lacks, such as 2: they are"));
    sections["WEFT COLORS"] = "1=7\n";
    const WifFile none = read(text_of(sections));
    EXPECT_TRUE(has(none.warnings, "such as 7: they have the color of the material"));
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

// A count of the palette that its table does not keep to changes no color.
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
    EXPECT_TRUE(has(file.warnings, "Entries=1, but color 2 is used: it is drawn"));
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

TEST(Wif, BrokenFilesAreRefusedByFileSectionKeyAndLine) {
    const struct {
        std::string section, lines, says;
    } cases[] = {
        {"WEAVING", "Shafts=3\nTreadles=3\nRising Shed=maybe\n", "expected true, on, yes"},
        {"WARP", "Threads=0\n", "from 1 to 65536, found \"0\""},
        {"WARP", "Threads=2000000000\n", "from 1 to 65536"},
        {"WARP", "Threads= ; none\n", "from 1 to 65536, found no value"},
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
// A cut within a line, or before a section that is announced, is named as one.
TEST(Wif, ACutFileIsCalledOne) {
    Sections sections = small();
    sections["CONTENTS"] = "TREADLING=true\n";
    const std::string text = text_of(sections);
    const auto cut_at = [&](std::string_view part, std::size_t more) {
        return complaint(text.substr(0, text.find(part) + more));
    };
    EXPECT_NE(cut_at("Shafts=3", 3).find("may be cut short"), std::string::npos);
    EXPECT_NE(cut_at("[TREADLING]", 5).find("may be cut short"), std::string::npos);
    EXPECT_NE(cut_at("[TREADLING]", 0).find("may be cut short"), std::string::npos);
    sections["WARP"] = "Threads=none\n";
    EXPECT_EQ(complaint(text_of(sections)).find("cut short"), std::string::npos)
        << "another fault of a whole file";
}

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
