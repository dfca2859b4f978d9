// Other programs: their words, what they print, and their end.
#include "core/run_program.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <stdexcept>
#include <string>

namespace burnish {
namespace {

TEST(RunProgram, GivesOutputMessagesAndExitCode) {
    const std::array<std::string, 3> words = {"sh", "-c", "echo shown; echo said >&2; exit 3"};
    std::string printed;
    const auto result = run_program(words, [&](std::string_view more) { printed += more; });
    ASSERT_TRUE(result);
    EXPECT_EQ(result->exit_code, 3);
    EXPECT_EQ(result->messages, "said\n");
    EXPECT_EQ(printed, "shown\n");
}

TEST(RunProgram, NoShellReadsTheWords) {
    const std::string word = "$HOME; `echo x` 'y' \"z\" *";
    const std::array<std::string, 3> words = {"printf", "%s", word};
    std::string printed;
    ASSERT_TRUE(run_program(words, [&](std::string_view more) { printed += more; }));
    EXPECT_EQ(printed, word);
}

TEST(RunProgram, IsNoneWhereThereIsNoSuchProgram) {
    const std::array<std::string, 1> words = {"no-such-program-of-burnish"};
    EXPECT_FALSE(run_program(words));
}

TEST(RunProgram, SaysWhichSignalEndedTheProgram) {
    const std::array<std::string, 3> words = {"sh", "-c", "kill -9 $$"};
    EXPECT_EQ(run_program(words)->exit_code, 128 + 9);
}

// The input is empty, not that of the caller: `cat` ends at once.
TEST(RunProgram, GivesAnEmptyInput) {
    const std::array<std::string, 1> words = {"cat"};
    EXPECT_EQ(run_program(words)->exit_code, 0);
}

// More than a pipe holds (64 KB on Linux): a program that waited for its reader would never end.
TEST(RunProgram, KeepsTheFirstOfManyMessages) {
    const std::array<std::string, 3> words = {
        "sh", "-c", "i=0; while [ $i -lt 9000 ]; do echo 0123456789abcdef >&2; i=$((i+1)); done"};
    const auto result = run_program(words);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->exit_code, 0);
    EXPECT_EQ(result->messages.size(), std::size_t{64} << 10);
}

TEST(RunProgram, EndsTheProgramWhereTheCallerThrows) {
    const std::array<std::string, 2> words = {"sleep", "60"};
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THROW(run_program(words, [](std::string_view) { throw std::runtime_error("enough"); }),
                 std::runtime_error);
    // The caller is asked every 0.1 s; a program that was waited for would take a minute.
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

}  // namespace
}  // namespace burnish
