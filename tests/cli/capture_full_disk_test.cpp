// Disks that fill up under capture simulate and capture fit: one line, nothing half-written, and a
// fit that goes on where it was. A limit of the size of files stands for a disk of that size, and
// /dev/full for one without any room.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "burnish/tabulated_file.hpp"
#include "burnish/tabulated_material.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

Outcome simulate(const std::string& output, const std::string& size = "8",
                 const std::string& format = "exr", const Surroundings& around = {}) {
    return run_burnish({"capture", "simulate", "satin", "-o", output, "--lights", "6x6", "--size",
                        size, "--format", format},
                       around);
}

std::vector<std::string> all_below(const std::string& folder) {
    std::vector<std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        out.push_back(entry.path().string());
    std::sort(out.begin(), out.end());
    return out;
}

// As expect_complaint, and in the words of files that cannot be written.
void expect_full(const Outcome& outcome, const std::string& file, const std::string& reason) {
    expect_complaint(outcome, 1, {file, ": expected a file that can be written, found " + reason});
}
const std::string kLimit = "the file size limit is reached";

TEST(CaptureFullDisk, SimulateLeavesNothing) {
    const Folder folder;
    const std::string stack = folder.path("stack");
    // The rig, a map of the truth, and a picture: each larger than the ones before.
    expect_full(simulate(stack, "8", "exr", {.file_size_limit = 200}), "stack/rig.json", kLimit);
    expect_full(simulate(stack, "60", "png16", {.file_size_limit = 8000}),
                "stack/truth/grain_angle_deg.exr", kLimit);
    expect_full(simulate(stack, "60", "exr", {.file_size_limit = 40000}), "stack/images/000",
                kLimit);
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

TEST(CaptureFullDisk, AnOlderStackStaysWhole) {
    const Folder folder;
    const std::string stack = folder.path("stack");
    ASSERT_EQ(simulate(stack).exit_code, 0);
    const auto before = all_below(stack);
    const std::string rig = contents_of(stack + "/rig.json");
    const std::string picture = contents_of(stack + "/images/0000.exr");
    // Larger pictures than the file may be; rig and truth are not.
    expect_full(simulate(stack, "60", "exr", {.file_size_limit = 40000}), "stack/images/000",
                kLimit);
    EXPECT_EQ(all_below(stack), before);
    EXPECT_EQ(contents_of(stack + "/rig.json"), rig);
    EXPECT_EQ(contents_of(stack + "/images/0000.exr"), picture);
}

Outcome fit(const std::string& rig, const std::string& output, std::vector<std::string> more = {},
            const Surroundings& around = {}) {
    more.insert(more.begin(), {"capture", "fit", rig, "-o", output, "--eta", "1.5"});
    return run_burnish(more, around);
}

// 36 lights of 8 x 8 pixels: pictures.bin has 14 kB, exemplars.bin 28 kB an exemplar.
TEST(CaptureFullDisk, AFitGoesOnWhereTheDiskWasFull) {
    const Folder folder;
    const std::string rig = folder.path("stack/rig.json"), out = folder.path("out");
    ASSERT_EQ(simulate(folder.path("stack")).exit_code, 0);
    ASSERT_EQ(fit(rig, folder.path("whole.exr")).exit_code, 0);
    fs::create_directory(out);
    const std::string material = out + "/m.exr", stages = material + ".stages";
    const auto expect_left = [&](const std::vector<std::string>& paths) {
        EXPECT_EQ(all_below(out), paths);
    };

    expect_full(fit(rig, material, {}, {.file_size_limit = 4000}), stages + "/pictures.bin",
                kLimit);
    expect_left({});
    expect_full(fit(rig, material, {}, {.file_size_limit = 20000}), stages + "/exemplars.bin",
                kLimit);
    expect_left({stages, stages + "/pictures.bin"});

    ASSERT_EQ(fit(rig, material, {"--until", "texels"}).exit_code, 0);
    const std::vector<std::string> done = {stages, stages + "/exemplars.bin",
                                           stages + "/pictures.bin", stages + "/texels.bin"};
    expect_left(done);
    expect_full(fit(rig, material, {}, {.file_size_limit = 10000}), "out/m.exr", kLimit);
    expect_left(done);

    // No work is done twice, and what comes out is what an undisturbed fit gives.
    const Outcome last = fit(rig, material, {"--progress", "json"});
    ASSERT_EQ(last.exit_code, 0) << last.complaint;
    for (const char* stage : {"reading pictures", "solving exemplars", "\"texels\""})
        EXPECT_EQ(last.complaint.find(stage), std::string::npos) << last.complaint;
    expect_left({material});
    const TabulatedMaterial a = read_tabulated_material(folder.path("whole.exr"));
    const TabulatedMaterial b = read_tabulated_material(material);
    EXPECT_EQ(a.D, b.D);
    EXPECT_EQ(a.angle, b.angle);
    EXPECT_EQ(a.specular.pixels, b.specular.pixels);
}

TEST(CaptureFullDisk, ADeviceWithoutRoomKeepsTheStages) {
    const Folder folder;
    ASSERT_EQ(simulate(folder.path("stack")).exit_code, 0);
    const std::string material = folder.path("m.exr");
    fs::create_symlink("/dev/full", material);
    expect_full(fit(folder.path("stack/rig.json"), material), "m.exr",
                "no space left on the device");
    EXPECT_TRUE(fs::is_symlink(material));
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"m.exr", "m.exr.stages", "stack"}));
    fs::remove(material);
    const Outcome again = fit(folder.path("stack/rig.json"), material, {"--progress", "json"});
    EXPECT_EQ(again.exit_code, 0);
    EXPECT_EQ(again.complaint.find("reading pictures"), std::string::npos) << again.complaint;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"m.exr", "stack"}));
}

}  // namespace
}  // namespace burnish::test
