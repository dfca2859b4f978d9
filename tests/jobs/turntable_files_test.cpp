// Turntables as files: ranges, resumed turns, what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "jobs/turntable_request.hpp"
#include "support/program.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

std::string fault_of(const RenderRequest& request) {
    return error_line([&] { render(request); });
}

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

TEST(TurntableFiles, RangesAreTheWholeTurn) {
    const ScratchFolder folder;
    const RenderRequest whole = turntable_request("builtin:torus", folder / "whole.png", 4);
    render(whole);
    RenderRequest part = turntable_request("builtin:torus", folder / "part.png", 4);
    part.frames = FrameRange{1, 3};
    const RenderReport report = render(part);
    ASSERT_EQ(report.written.size(), 3u);
    EXPECT_EQ(report.written[0].filename(), "part_0001.png");
    EXPECT_FALSE(fs::exists(folder / "part_0000.png"));
    part.frames = FrameRange{0, 0};
    EXPECT_EQ(render(part).written.size(), 1u);
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(frame_picture(part, i).pixels, frame_picture(whole, i).pixels) << i;
}

TEST(TurntableFiles, ResumeDrawsOnlyWhatIsMissing) {
    const ScratchFolder folder;
    RenderRequest request = turntable_request("builtin:torus", folder / "t.png", 4);
    render(request);
    const Image second = frame_picture(request, 2);
    fs::remove(folder / "t_0002.png");
    std::vector<fs::file_time_type> times;
    for (const int i : {0, 1, 3}) times.push_back(fs::last_write_time(numbered(request.output, i)));
    request.resume = true;
    request.command = "another command";  // its range may be another: it is not compared
    const RenderReport report = render(request);
    ASSERT_EQ(report.written.size(), 1u);
    EXPECT_EQ(report.written[0].filename(), "t_0002.png");
    ASSERT_FALSE(report.notes.empty());
    EXPECT_EQ(report.notes.back(), "--resume: kept 3 of 4 pictures");
    EXPECT_EQ(frame_picture(request, 2).pixels, second.pixels);
    std::size_t k = 0;
    for (const int i : {0, 1, 3})
        EXPECT_EQ(fs::last_write_time(numbered(request.output, i)), times[k++]) << i;
    EXPECT_TRUE(render(request).written.empty());
}

// All formats keep what is compared.
TEST(TurntableFiles, ResumeRefusesPicturesOfAnotherTurn) {
    const ScratchFolder folder;
    for (const std::string extension : {".png", ".jpg", ".tif", ".exr"}) {
        RenderRequest request =
            turntable_request("builtin:torus", folder / ("t" + extension), 2,
                              {{"normal_map", "builtin:bumps"}, {"exposure", "0.5"}});
        request.stage.lights = {"45,30"};
        render(request);
        request.resume = true;
        EXPECT_TRUE(render(request).written.empty()) << extension;
        fs::remove(numbered(request.output, 0));  // nothing is drawn before all were looked at

        RenderRequest other = request;
        other.stage.values.set("samples", "5", "");
        expect_parts(fault_of(other), {"t_0001" + extension, "burnish:parameters",
                                       "expected samples=5", "found samples=4", "--resume"});
        other = request;
        other.turn = Turn::camera;
        expect_parts(fault_of(other), {"burnish:turntable", "expected camera, frame 1 of 2",
                                       "found object, frame 1 of 2"});
        other = request;
        other.stage.lights = {"50,30"};
        expect_parts(fault_of(other), {"burnish:turntable", "light 50,30"});
        other = request;
        other.stage.environment = "builtin:white";
        expect_parts(fault_of(other), {"burnish:environment", "builtin:white"});
        EXPECT_FALSE(fs::exists(numbered(request.output, 0)));
    }
}

TEST(TurntableFiles, ResumeRefusesAPictureOfSomethingElse) {
    const ScratchFolder folder;
    RenderRequest request = turntable_request("builtin:torus", folder / "t.png", 1);
    request.resume = true;
    write_image(folder / "t_0000.png", Image(64, 48, 3, 0.5f), {});
    expect_parts(fault_of(request), {"t_0000.png", "burnish:version", "nothing there"});
    folder.write("t_0000.png", "no picture");
    expect_parts(fault_of(request), {"t_0000.png"});
}

TEST(TurntableFiles, FlagsThatMakeNoSenseAreOneLine) {
    const ScratchFolder folder;
    const auto refused = [&](const char* output, int count, const auto& change,
                             std::initializer_list<std::string> parts) {
        RenderRequest request = turntable_request("builtin:torus", folder / output, count);
        change(request);
        expect_parts(error_line<UsageError>([&] { render(request); }), parts);
    };
    using R = RenderRequest;
    refused("a.png", 0, [](R& r) { r.turn = Turn::light; }, {"--turn: expected --turntable"});
    refused("a.png", 0, [](R& r) { r.frames = FrameRange{}; }, {"--frames: expected --turntable"});
    refused("a.png", 0, [](R& r) { r.resume = true; }, {"--resume: expected --turntable"});
    refused("a.png", 0, [](R& r) { r.fps = 25; }, {"--fps: expected -o FILE of a film"});
    refused("a.png", 3, [](R& r) { r.fps = 25; }, {"--fps: expected -o FILE of a film"});
    refused("a.png", 3, [](R& r) { r.keep_frames = true; }, {"--keep-frames: expected -o FILE"});
    refused("a.mp4", 0, [](R&) {}, {"a.mp4: expected --turntable COUNT for a film"});
    refused("a.mp4", 3, [](R& r) { r.fps = 121; }, {"--fps", "1 to 120", "121"});
    refused("a.png", 3, [](R& r) { r.frames = FrameRange{2, 1}; }, {"--frames", "A-B", "2-1"});
    refused("a.png", 3,
            [](R& r) {
                r.frames = FrameRange{0, 3};
            },
            {"--frames", "from 0 to 2", "found 3"});
    refused("a.gif", 3, [](R&) {}, {"a.gif"});
    EXPECT_TRUE(names_in(folder / "").empty());
}

TEST(TurntableFiles, LightThatIsNotThereIsWarnedOf) {
    const ScratchFolder folder;
    RenderRequest request = turntable_request("builtin:torus", folder / "t.png", 1);
    request.turn = Turn::light;
    request.stage.environment = "none";
    request.stage.lights = {"none"};
    const std::vector<std::string> warnings = render(request).warnings;
    EXPECT_TRUE(std::ranges::any_of(warnings, [](const std::string& line) {
        return line.starts_with("--turn light: there are no lights");
    }));
}

}  // namespace
}  // namespace burnish::test
