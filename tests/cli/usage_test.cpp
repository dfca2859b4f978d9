// The command line itself: help, version, what is unknown, what is missing.
#include <gtest/gtest.h>

#include <regex>

#include "support/program.hpp"

namespace burnish::test {
namespace {

TEST(Usage, VersionIsOneLine) {
    const Outcome outcome = run_burnish({"--version"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(std::regex_match(outcome.output, std::regex(R"(burnish \d+\.\d+\.\d+\n)")))
        << outcome.output;
}

TEST(Usage, HelpNamesTheCommands) {
    const Outcome outcome = run_burnish({"--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    for (const char* word : {"mdf", "brdf", "--progress", "--version"}) {
        EXPECT_NE(outcome.output.find(word), std::string::npos) << word;
    }
}

TEST(Usage, HelpOfEvalExplainsItsColumns) {
    const std::string mdf = run_burnish({"mdf", "eval", "--help"}).output;
    for (const char* word : {"ashikhmin-shirley", "alpha_x", "follow-grain", "hx, hy, hz",
                             "D_conserving", "--precision"}) {
        EXPECT_NE(mdf.find(word), std::string::npos) << word;
    }
    const std::string brdf = run_burnish({"brdf", "eval", "--help"}).output;
    for (const char* word : {"ward-gmd", "microfacet", "p0 .. p4", "smith", "F0"}) {
        EXPECT_NE(brdf.find(word), std::string::npos) << word;
    }
}

TEST(Usage, HelpThatCannotBePrintedFails) {
    expect_complaint(run_burnish({"--help"}, {.output_file = "/dev/full"}), 1, {"standard output"});
}

TEST(Usage, NoCommandAsksForOne) {
    expect_complaint(run_burnish({}), 2, {"expected a command", "mdf", "brdf", "burnish --help"});
    expect_complaint(run_burnish({"mdf"}), 2, {"mdf: expected a command", "eval"});
}

TEST(Usage, UnknownWordsSuggestTheNearest) {
    expect_complaint(run_burnish({"bdrf"}), 2,
                     {"unknown command \"bdrf\"", "did you mean 'brdf'?"});
    expect_complaint(run_burnish({"mdf", "evla"}), 2, {"\"evla\"", "did you mean 'eval'?"});
    expect_complaint(run_burnish({"mdf", "eval", "--inn", "a", "--out", "b"}), 2,
                     {"mdf eval: unknown option \"--inn\"", "did you mean '--in'?"});
    expect_complaint(run_burnish({"--progess=json", "mdf", "eval", "--in", "a", "--out", "b"}), 2,
                     {"unknown option \"--progess\"", "did you mean '--progress'?"});
    expect_complaint(run_burnish({"zzzzzzz"}), 2, {"unknown command", "mdf, brdf"});
}

TEST(Usage, UnexpectedWordsAreRefused) {
    expect_complaint(run_burnish({"mdf", "eval", "--in", "a", "--out", "b", "more"}), 2,
                     {"unexpected argument \"more\""});
    // A command of the program is no argument of another.
    expect_complaint(run_burnish({"mdf", "eval", "--in", "a", "--out", "b", "brdf"}), 2,
                     {"unexpected argument \"brdf\""});
    expect_complaint(run_burnish({"line\nbreak"}), 2, {"unknown command"});
}

TEST(Usage, MissingValuesAreNamed) {
    expect_complaint(run_burnish({"mdf", "eval", "--in", "a"}), 2,
                     {"mdf eval: --out: expected a value, found none"});
    expect_complaint(run_burnish({"mdf", "eval", "--out", "b", "--in"}), 2,
                     {"mdf eval: --in: expected a value, found none"});
    expect_complaint(run_burnish({"render", "builtin:plane", "-o", "a.png", "--conserve=maybe"}), 2,
                     {"--conserve: expected", "maybe"});
    expect_complaint(run_burnish({"render", "-o", "a.png"}), 2, {"render: input: expected"});
    // Not the value "-o" of --metal, and "-30" is no flag.
    for (const char* next : {"-o", "--output", "--gl-device=0", "--progress"})
        expect_complaint(run_burnish({"render", "builtin:plane", "--metal", next, "a.png"}), 2,
                         {"render: --metal: expected a value, found none", "--metal NAME"});
    expect_complaint(run_burnish({"mdf", "eval", "--in", "--out", "b"}), 2,
                     {"mdf eval: --in: expected a value, found none"});
    expect_complaint(run_burnish({"render", "builtin:plane", "--camera-azimuth", "-30", "-o"}), 2,
                     {"render: --output: expected a value, found none"});
    expect_complaint(run_burnish({"mdf", "eval", "--in", "no.csv", "--out", "b"}), 1,
                     {"no.csv: expected a readable file, found no such file or folder"});
}

TEST(Usage, UnknownChoicesSuggestTheNearest) {
    expect_complaint(run_burnish({"mdf", "eval", "--in", "a", "--out", "b", "--precision", "f46"}),
                     2, {"--precision", "\"f46\"", "did you mean 'f64'?"});
    expect_complaint(run_burnish({"mdf", "eval", "--in", "a", "--out", "b", "--progress", "jsn"}),
                     2, {"--progress", "\"jsn\"", "did you mean 'json'?"});
}

}  // namespace
}  // namespace burnish::test
