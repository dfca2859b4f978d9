// burnish trace as a person meets it: stops, shards, layers, and what it refuses.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/trace.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

std::vector<std::string> traced(const std::vector<std::string>& more, const std::string& out) {
    std::vector<std::string> arguments = {"trace", "builtin:sphere", "--size", "40x30", "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

Outcome trace_with(const std::vector<std::string>& more, const std::string& out,
                   const Surroundings& around = {}) {
    return run_burnish(traced(more, out), around);
}

TEST(TraceCommand, WritesEveryFormatAndNothingElse) {
    const Folder folder;
    for (const std::string name : {"a.exr", "a.png", "a.jpg", "a.tif"}) {
        const Outcome outcome = trace_with({"--samples", "2"}, folder.path(name));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
        EXPECT_EQ(outcome.output, folder.path(name) + "\n");
        EXPECT_EQ(read_image(folder.path(name)).width, 40);
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "a.jpg", "a.png", "a.tif"}));
}

TEST(TraceCommand, OfShardsMergedIsThePictureOfOne) {
    const Folder folder;
    ASSERT_EQ(trace_with({"--samples", "7"}, folder.path("one.exr")).exit_code, 0);
    std::vector<std::string> merge = {"trace", "-o", folder.path("all.exr"), "--merge"};
    for (const std::string shard : {"2/3", "0/3", "1/3"}) {
        const Outcome outcome =
            trace_with({"--samples", "7", "--shard", shard}, folder.path("all.exr"));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
        merge.push_back(folder.path("all.exr." + shard.substr(0, 1) + "of3.sums"));
    }
    EXPECT_FALSE(std::filesystem::exists(folder.path("all.exr")));
    const Outcome outcome = run_burnish(merge);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_EQ(read_image(folder.path("all.exr")).pixels, read_image(folder.path("one.exr")).pixels);
    merge.pop_back();
    EXPECT_NE(run_burnish(merge).complaint.find("1 of 3 shards are missing"), std::string::npos);
    merge.push_back(merge.back());
    expect_complaint(run_burnish(merge), 1, {"each shard once"});
}

TEST(TraceCommand, GoesOnAfterCtrlCToTheSamePicture) {
    const Folder folder;
    const std::vector<std::string> flags = {"--samples", "600"};
    {
        RunningProgram program(traced(flags, folder.path("a.exr")));
        usleep(700'000);
        program.send_signal(SIGINT);
        const int code = program.wait().exit_code;
        // 0: the machine was so fast that it was done.
        ASSERT_TRUE(code == 130 || code == 0) << code;
        if (code == 130) {
            EXPECT_TRUE(std::filesystem::exists(folder.path("a.exr.sums")));
            EXPECT_EQ(read_image(folder.path("a.exr")).width, 40);
        }
    }
    const Outcome on = trace_with({"--samples", "600", "--resume"}, folder.path("a.exr"));
    ASSERT_EQ(on.exit_code, 0) << on.complaint;
    ASSERT_EQ(trace_with(flags, folder.path("b.exr")).exit_code, 0);
    EXPECT_EQ(read_image(folder.path("a.exr")).pixels, read_image(folder.path("b.exr")).pixels);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "b.exr"}));
}

TEST(TraceCommand, RefusesTheSumsOfAnotherScene) {
    const Folder folder;
    ASSERT_EQ(trace_with({"--samples", "2", "--keep-sums"}, folder.path("a.exr")).exit_code, 0);
    expect_complaint(
        trace_with({"--samples", "2", "--resume", "--alpha-x", "0.3"}, folder.path("a.exr")), 1,
        {"a.exr.sums", "sums of this scene"});
    const Outcome more = trace_with({"--samples", "4", "--resume"}, folder.path("a.exr"));
    ASSERT_EQ(more.exit_code, 0) << more.complaint;
    ASSERT_EQ(trace_with({"--samples", "4"}, folder.path("b.exr")).exit_code, 0);
    EXPECT_EQ(read_image(folder.path("a.exr")).pixels, read_image(folder.path("b.exr")).pixels);
}

TEST(TraceCommand, RefusesASecondTraceIntoTheSameFile) {
    const Folder folder;
    RunningProgram program(traced({"--max-time", "20"}, folder.path("a.exr")));
    usleep(500'000);
    expect_complaint(trace_with({"--samples", "1"}, folder.path("a.exr")), 1,
                     {"a.exr.sums", "no other process that writes it"});
    program.send_signal(SIGTERM);
    program.wait();
}

TEST(TraceCommand, LeavesTheEarlierPictureOnAFullDisk) {
    const Folder folder;
    ASSERT_EQ(trace_with({"--samples", "2"}, folder.path("a.exr")).exit_code, 0);
    const std::string before = contents_of(folder.path("a.exr"));
    expect_complaint(
        trace_with({"--samples", "4"}, folder.path("a.exr"), {.file_size_limit = 20000}), 1,
        {"a.exr.sums: expected a file that can be written, found the file size limit is reached"});
    EXPECT_EQ(contents_of(folder.path("a.exr")), before);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.exr"});
}

TEST(TraceCommand, WritesLayers) {
    const Folder folder;
    ASSERT_EQ(trace_with({"--samples", "4", "--layers"}, folder.path("a.exr")).exit_code, 0);
    std::vector<std::string> warnings;
    ReadOptions options;
    options.warnings = &warnings;
    const Image color = read_image(folder.path("a.exr"), options);
    ASSERT_EQ(trace_with({"--samples", "4"}, folder.path("b.exr")).exit_code, 0);
    EXPECT_EQ(color.pixels, read_image(folder.path("b.exr")).pixels);
    expect_complaint(trace_with({"--layers"}, folder.path("a.png")), 2, {"a .exr for --layers"});
}

TEST(TraceCommand, SaysWhatIsWrongInOneLine) {
    const Folder folder;
    const std::string out = folder.path("a.exr");
    expect_complaint(trace_with({"--shard", "3/2"}, out), 2, {"--shard", "3/2"});
    expect_complaint(trace_with({"--shard", "one"}, out), 2, {"--shard", "INDEX/COUNT"});
    expect_complaint(trace_with({"--error", "-1"}, out), 2, {"--error"});
    expect_complaint(trace_with({"--depth", "-2"}, out), 2, {"--depth"});
    expect_complaint(run_burnish({"trace", "-o", out}), 2, {"MODEL or SCENE"});
    expect_complaint(run_burnish({"trace", "--merge", folder.write("no.sums", "P6"), "-o", out}), 1,
                     {"no.sums", "sums of `burnish trace`"});
    EXPECT_EQ(folder.names(), std::vector<std::string>{"no.sums"});
}

// mpirun, Slurm and PMI by what they set.
TEST(TraceShard, IsTakenFromTheEnvironmentOfATask) {
    const auto with = [](const std::vector<std::pair<std::string, std::string>>& variables) {
        for (const auto& [name, value] : variables) setenv(name.c_str(), value.c_str(), 1);
        const TraceShard shard = parse_shard("env");
        for (const auto& [name, value] : variables) unsetenv(name.c_str());
        return std::pair(shard.index, shard.count);
    };
    for (const char* name :
         {"OMPI_COMM_WORLD_RANK", "SLURM_PROCID", "SLURM_ARRAY_TASK_ID", "PMI_RANK"})
        unsetenv(name);
    EXPECT_EQ(with({{"OMPI_COMM_WORLD_RANK", "1"}, {"OMPI_COMM_WORLD_SIZE", "2"}}),
              std::pair(1, 2));
    EXPECT_EQ(with({{"SLURM_PROCID", "3"}, {"SLURM_NTASKS", "5"}}), std::pair(3, 5));
    EXPECT_EQ(with({{"PMI_RANK", "0"}, {"PMI_SIZE", "4"}}), std::pair(0, 4));
    // Elements 10, 12, 14 of an array, each of two tasks.
    EXPECT_EQ(with({{"SLURM_ARRAY_TASK_ID", "12"},
                    {"SLURM_ARRAY_TASK_COUNT", "3"},
                    {"SLURM_ARRAY_TASK_MIN", "10"},
                    {"SLURM_ARRAY_TASK_STEP", "2"},
                    {"SLURM_PROCID", "1"},
                    {"SLURM_NTASKS", "2"}}),
              std::pair(3, 6));
    EXPECT_THROW(parse_shard("env"), UsageError);
}

}  // namespace
}  // namespace burnish::test
