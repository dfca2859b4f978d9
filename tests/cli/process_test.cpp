// What happens around a run: signals, pipes that go away, progress.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <regex>
#include <sstream>
#include <string>
#include <thread>

#include "support/program.hpp"

namespace burnish::test {
namespace {

constexpr const char* kHeader = "mdf,p0,p1,method,nx,ny,nz,hx,hy,hz\n";
constexpr const char* kRow = "ggx,.1,.2,none,0,0,1,0,0,1\n";

bool holds_temporary(const Folder& folder) {
    for (const std::string& name : folder.names()) {
        if (name.starts_with(".burnish-")) return true;
    }
    return false;
}

// Work has begun once its temporary output is there.
void wait_for_temporary(const Folder& folder) {
    for (int i = 0; i < 1000 && !holds_temporary(folder); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ASSERT_TRUE(holds_temporary(folder));
}

class InterruptedRun : public testing::TestWithParam<int> {};

TEST_P(InterruptedRun, LeavesTheOldOutputAndNothingElse) {
    const Folder folder;
    const std::string out = folder.write("out.csv", "old");
    RunningProgram program({"mdf", "eval", "--in", "-", "--out", out});
    program.give(std::string(kHeader) + kRow);
    wait_for_temporary(folder);
    program.send_signal(GetParam());
    expect_complaint(program.wait(), 130, {"interrupted"});
    EXPECT_EQ(contents_of(out), "old");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"out.csv"}));
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptedRun, testing::Values(SIGINT, SIGTERM));

TEST(Process, AReaderThatGoesAwayIsAnErrorNotADeath) {
    RunningProgram program({"mdf", "eval", "--in", "-", "--out", "-"});
    program.close_output();
    program.give(std::string(kHeader) + kRow);
    program.end_input();
    expect_complaint(program.wait(), 1, {"standard output", "pipe"});
}

std::string table_of(int rows) {
    std::string text = kHeader;
    for (int i = 0; i < rows; ++i) text += kRow;
    return text;
}

TEST(Progress, JsonIsOneObjectALine) {
    const Folder folder;
    const std::string in = folder.write("in.csv", table_of(1000));
    const Outcome outcome = run_burnish(
        {"mdf", "eval", "--in", in, "--out", folder.path("out.csv"), "--progress", "json"});
    EXPECT_EQ(outcome.exit_code, 0);
    const std::regex object(
        R"(\{"stage":"evaluate","done":[01]\.\d{4},"elapsed_s":\d+\.\d{3},"left_s":(null|\d+\.\d{3})\})");
    std::istringstream lines(outcome.complaint);
    std::string line, last;
    while (std::getline(lines, line)) {
        EXPECT_TRUE(std::regex_match(line, object)) << line;
        last = line;
    }
    EXPECT_NE(last.find("\"done\":1.0000"), std::string::npos) << last;
}

TEST(Progress, BarShowsStagePercentAndRate) {
    const Folder folder;
    const std::string in = folder.write("in.csv", table_of(1000));
    const Outcome outcome = run_burnish(
        {"--progress", "bar", "mdf", "eval", "--in", in, "--out", folder.path("out.csv")});
    EXPECT_EQ(outcome.exit_code, 0);
    for (const char* part : {"evaluate", "100 %", "%/s", "0:00 left"}) {
        EXPECT_NE(outcome.complaint.find(part), std::string::npos) << outcome.complaint;
    }
}

TEST(Progress, NothingIsShownWhereNobodyLooks) {
    const Folder folder;
    const std::string in = folder.write("in.csv", table_of(1000));
    for (const char* mode : {"auto", "off"}) {
        const Outcome outcome = run_burnish(
            {"mdf", "eval", "--in", in, "--out", folder.path("out.csv"), "--progress", mode});
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_EQ(outcome.complaint, "");
    }
}

}  // namespace
}  // namespace burnish::test
