// burnish capture directions as a person runs it: pictures of balls in, a rig out.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>

#include "burnish/image_io.hpp"
#include "burnish/rig.hpp"
#include "capture/ball_support.hpp"
#include "jobs/capture/capture_directions.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

constexpr ProbeCircle kBall{163.3, 127.8, 110.0};
const std::string kBallFlag = "--ball=163.3,127.8,110";

// Clipped lamps of 8-bit pictures are found to 0.25 deg (light_probe_test.cpp).
constexpr double kNear = 0.3;

const std::vector<Vec3d> kLights = {direction(15, 40), direction(40, 160), direction(65, 290)};

// .png and .jpg hold display values.
std::string write_picture(const Folder& folder, const std::string& name, Image image) {
    if (!holds_linear(name))
        for (float& value : image.pixels) value = srgb_from_linear(value);
    write_image(folder.path(name), image, {});
    return folder.path(name);
}

std::string ball_picture(const Folder& folder, const std::string& name, const Vec3d& towards,
                         double radiance = 5.0) {
    return write_picture(folder, name, picture_of_balls({{kBall, {{towards, 4.0, radiance}}}}));
}

std::vector<std::string> ball_pictures(const Folder& folder) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < kLights.size(); ++k)
        names.push_back(ball_picture(folder, fmt::format("ball {}.png", k), kLights[k]));
    return names;
}

Outcome directions(std::vector<std::string> pictures, const std::vector<std::string>& more,
                   const Surroundings& around = {}) {
    pictures.insert(pictures.begin(), {"capture", "directions"});
    pictures.insert(pictures.end(), more.begin(), more.end());
    return run_burnish(pictures, around);
}

void expect_lights(const Rig& rig, const std::vector<std::string>& pictures) {
    ASSERT_EQ(rig.lights.size(), kLights.size());
    for (std::size_t k = 0; k < kLights.size(); ++k) {
        EXPECT_FALSE(rig.lights[k].place.near);
        EXPECT_LT(angle_deg(rig.lights[k].place.at, kLights[k]), kNear) << k;
        EXPECT_TRUE(std::filesystem::equivalent(rig.lights[k].images.at(0).image, pictures[k]));
    }
}

TEST(CaptureDirections, MakesARigOfTheBallsPictures) {
    const Folder folder;
    const auto pictures = ball_pictures(folder);
    std::filesystem::create_directory(folder.path("rigs"));
    for (const char* name : {"rigs/rig.json", "rigs/rig.lp"}) {
        const std::string out = folder.path(name);
        const Outcome outcome = directions(pictures, {kBallFlag, "-o", out});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
        const Rig rig = read_rig(out, true);
        expect_lights(rig, pictures);
        EXPECT_EQ(rig.response, RigResponse::srgb);
        EXPECT_EQ(rig.camera.at, (Vec3d{0, 0, 1}));
        EXPECT_NE(contents_of(out).find("../ball 0.png"), std::string::npos);
    }
    // JSON wants a size, which nobody said.
    EXPECT_EQ(read_rig(folder.path("rigs/rig.json"), true).width_mm, 320.0);
}

TEST(CaptureDirections, PrintsALineForEachLight) {
    const Folder folder;
    const auto pictures = ball_pictures(folder);
    const std::string out = folder.path("rig.json");
    const Outcome outcome = directions(pictures, {kBallFlag, "-o", out, "--width-mm", "64"});
    EXPECT_EQ(outcome.complaint, "");
    const std::regex lines(
        R"(ball 0\.png: 0\.1\d+ 0\.1\d+ 0\.96\d+, theta 1[45]\.\d, phi (39|40)\.\d, spread [23]\.\d deg\n)"
        R"(ball 1\.png: -0\.6\d+ 0\.2\d+ 0\.76\d+, theta (39|40)\.\d, phi 1(59|60)\.\d, spread [23]\.\d deg\n)"
        R"(ball 2\.png: 0\.3\d+ -0\.8\d+ 0\.42\d+, theta 6[45]\.\d, phi 2(89|90)\.\d, spread [23]\.\d deg\n)"
        R"([^\n]*rig\.json\n)");
    EXPECT_TRUE(std::regex_match(outcome.output, lines)) << outcome.output;
    const Rig rig = read_rig(out, true);
    EXPECT_EQ(rig.width_mm, 64.0);
    EXPECT_EQ(rig.height_mm, 52.0);  // 320 x 260 pixels
}

TEST(CaptureDirections, TheSamplesPicturesTakeThePlaceOfTheBalls) {
    const Folder folder;
    const auto balls = ball_pictures(folder);
    std::vector<std::string> pictures;
    for (const char* name : {"c.exr", "a.exr", "b.exr"})  // in the order given, not of names
        pictures.push_back(write_picture(folder, name, Image(30, 20, 3, 0.5f)));
    const std::string out = folder.path("rig.json");
    std::vector<std::string> more = {kBallFlag, "-o", out, "--width-mm", "60", "--pictures"};
    more.insert(more.end(), pictures.begin(), pictures.end());
    ASSERT_EQ(directions(balls, more).exit_code, 0);
    const Rig rig = read_rig(out, true);
    expect_lights(rig, pictures);
    EXPECT_EQ(rig.response, RigResponse::linear);
    EXPECT_EQ(rig.height_mm, 40.0);
}

// A lamp that is not clipped is right to 0.04 deg only where the curve is taken out: the rim's
// pixels would count too much.
TEST(CaptureDirections, ResponsesAreTakenOut) {
    const Folder folder;
    const Vec3d light = direction(50, 100);
    const std::string linear = ball_picture(folder, "ball.exr", light, 0.9);
    const std::string coded = ball_picture(folder, "ball.png", light, 0.9);
    for (const std::string& picture : {linear, coded}) {
        const std::string out = folder.path("rig.lp");
        ASSERT_EQ(directions({picture}, {kBallFlag, "-o", out}).exit_code, 0);
        EXPECT_LT(angle_deg(read_rig(out, true).lights[0].place.at, light), 0.06) << picture;
    }
    const std::string out = folder.path("rig.json");
    ASSERT_EQ(directions({coded}, {kBallFlag, "-o", out, "--response", "linear"}).exit_code, 0);
    EXPECT_EQ(read_rig(out, true).response, RigResponse::linear);
}

TEST(CaptureDirections, ATiltedCameraTurnsTheDirections) {
    const Folder folder;
    const std::string picture = ball_picture(folder, "ball.png", direction(45, 90));
    const std::string out = folder.path("rig.json");
    ASSERT_EQ(directions({picture}, {kBallFlag, "-o", out, "--camera", "0,-1,1"}).exit_code, 0);
    const Rig rig = read_rig(out, true);
    EXPECT_LT(angle_deg(rig.camera.at, direction(45, 270)), 1e-6);
    EXPECT_LT(angle_deg(rig.lights[0].place.at, {0, 0, 1}), kNear);
    // The same lamp on the other side is under the sample.
    const std::string under = ball_picture(folder, "under.png", direction(60, 270));
    expect_complaint(directions({under}, {kBallFlag, "-o", out, "--camera", "0,-1,1"}), 1,
                     {"under.png", "above the sample", "z = -0.2"});
}

constexpr ProbeCircle kLeft{85.0, 130.0, 70.0}, kRight{240.0, 120.0, 65.0};
const std::vector<std::string> kBothFlags = {"--ball", "85,130,70", "--ball", "240,120,65"};

TEST(CaptureDirections, SeveralBallsGiveTheirMean) {
    const Folder folder;
    const auto picture = [&](const std::string& name, double apart) {
        // Not clipped: found to 0.07 deg on balls of this size.
        const Lamp left{direction(30 - apart / 2, 70), 4, 0.9};
        const Lamp right{direction(30 + apart / 2, 70), 4, 0.9};
        return write_picture(folder, name, picture_of_balls({{kLeft, {left}}, {kRight, {right}}}));
    };
    std::vector<std::string> more = kBothFlags;
    more.insert(more.end(), {"-o", folder.path("rig.lp")});
    const Outcome outcome = directions({picture("far.png", 1.0), picture("near.png", 8.0)}, more);
    ASSERT_EQ(outcome.exit_code, 0);
    const Rig rig = read_rig(folder.path("rig.lp"), true);
    for (const RigLight& light : rig.lights)
        EXPECT_LT(angle_deg(light.place.at, direction(30, 70)), kNear);
    // Of the lamp that is near alone.
    EXPECT_EQ(std::count(outcome.complaint.begin(), outcome.complaint.end(), '\n'), 1);
    expect_parts(outcome.complaint, {"warning", "near.png", "degrees apart"});
    const std::regex lines(
        "far.*balls (0\\.9|1\\.[01]) deg apart\n"
        "near.*balls (7\\.9|8\\.[01]) deg apart\n.*\n");
    EXPECT_TRUE(std::regex_match(outcome.output, lines)) << outcome.output;
}

TEST(CaptureDirections, WarnsOfTwoLamps) {
    const Folder folder;
    const Lamp one{direction(30, 70), 4, 5}, other{direction(40, 200), 4, 5};
    const std::string two =
        write_picture(folder, "two.png", picture_of_balls({{kBall, {one, other}}}));
    const Outcome outcome = directions({ball_picture(folder, "one.png", kLights[0]), two},
                                       {kBallFlag, "-o", folder.path("rig.lp")});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(std::count(outcome.complaint.begin(), outcome.complaint.end(), '\n'), 1);
    expect_parts(outcome.complaint, {"warning", "two.png", "two lamps"});
}

TEST(CaptureDirections, WarnsOfADiameterGivenForARadius) {
    const Folder folder;
    const std::string doubled = fmt::format("{},{},{}", kBall.x, kBall.y, 2 * kBall.radius);
    const Outcome outcome = directions({ball_picture(folder, "one.png", kLights[0])},
                                       {"--ball", doubled, "-o", folder.path("rig.lp")});
    EXPECT_EQ(outcome.exit_code, 0);
    expect_parts(outcome.complaint, {"warning", "one.png", "leaves the picture of 320 x 260"});
}

TEST(CaptureDirections, RefusesInOneLineAndLeavesNothing) {
    const Folder folder;
    const auto pictures = ball_pictures(folder);
    const std::string out = folder.write("rig.json", "old");
    const auto refused = [&](const std::vector<std::string>& balls,
                             const std::vector<std::string>& more, int code,
                             const std::vector<std::string>& parts) {
        const auto before = folder.names();
        expect_complaint(directions(balls, more), code, parts);
        EXPECT_EQ(folder.names(), before);
        EXPECT_EQ(contents_of(out), "old");
    };
    for (const char* bad : {"1,2", "1,2,3,4", "nan,2,30"})
        refused(pictures, {"--ball", bad, "-o", out}, 2, {"--ball", "X,Y,R", bad});
    for (const char* bad : {"100,100,3", "100,100,inf"})
        refused(pictures, {"--ball", bad, "-o", out}, 2, {"--ball", "at least 4 pixels", bad});
    refused(pictures, {"-o", out}, 2, {"--ball"});
    refused({}, {kBallFlag, "-o", out}, 2, {"balls"});
    refused(pictures, {kBallFlag, "-o", folder.path("rig.dome")}, 2, {".json or .lp", "rig.dome"});
    refused(pictures, {kBallFlag, "-o", folder.path("rig.lp"), "--camera", "0,0,1"}, 2,
            {"--camera", ".lp"});
    refused(pictures, {kBallFlag, "-o", out, "--pictures", pictures[0]}, 2,
            {"--pictures", "3", "found 1"});
    refused({pictures[0], folder.path("none.png")}, {kBallFlag, "-o", out}, 1,
            {"none.png", "no such file"});
    refused(pictures, {kBallFlag, "--ball", "1000,1000,50", "-o", out}, 1,
            {"ball 0.png: ball 2", "inside the picture", "320 x 260"});
    refused(pictures, {kBallFlag, "-o", folder.path("no/rig.json")}, 1, {"no/rig.json", "folder"});
}

// The further ways in which pictures can be wrong, without a program for each.
TEST(CaptureDirections, NamesThePictureAtFault) {
    const Folder folder;
    const std::string good = ball_picture(folder, "good.png", kLights[0]);
    const auto wrong = [&](std::vector<std::filesystem::path> balls,
                           const std::vector<std::string>& parts, const ProbeCircle& circle) {
        CaptureDirectionsRequest request;
        request.balls = std::move(balls);
        request.circles = {circle};
        request.output = folder.path("rig.lp");
        expect_parts(refusal_of([&] { capture_directions(request, {}); }), parts);
        EXPECT_FALSE(std::filesystem::exists(request.output));
    };
    wrong({good, good}, {"good.png", "twice"}, kBall);
    wrong({folder.write("text.png", "text")}, {"text.png"}, kBall);
    wrong({good}, {"good.png: circle", "inside the picture"}, {1000, 1000, 50});
    wrong({write_picture(folder, "dark.png", picture_of_balls({{kBall, {}}}))},
          {"dark.png", "highlight"}, kBall);
    wrong({good, write_picture(folder, "small.png", Image(20, 20, 3, 0.5f))},
          {"small.png", "320 x 260", "20 x 20"}, kBall);
    std::filesystem::copy_file(good, folder.path(" blank.png"));
    wrong({folder.path(" blank.png")}, {"rig.lp", "blanks"}, kBall);
}

// Puts an Exif block with the orientation behind the start of a JPEG file.
void set_orientation(const std::string& path, char orientation) {
    std::string bytes = contents_of(path);
    // APP1 of 34 bytes: "Exif", a big-endian TIFF header, one entry (0x0112, a short), no next.
    std::string block = std::string("\xff\xe1\x00\x22", 4) + std::string("Exif\0\0", 6) +
                        std::string("MM\0\x2a\0\0\0\x08", 8) +
                        std::string("\0\x01\x01\x12\0\x03\0\0\0\x01", 10);
    block += '\0';  // the value, then two bytes of padding and the place of the next directory
    block += orientation;
    bytes.insert(2, block + std::string(6, '\0'));
    std::ofstream(path, std::ios::binary) << bytes;
}

// The ball at (163.3, 127.8) of 320 x 260 stored pixels; where a viewer shows it follows from what
// the orientations mean: 6 is shown turned clockwise, 8 counter-clockwise, 3 by half a turn.
TEST(CaptureDirections, SaysHowAnExifOrientationMovesTheBall) {
    const struct {
        char orientation;
        const char* shown;
    } kCases[] = {{6, "132.2,163.3,110"}, {8, "127.8,156.7,110"}, {3, "156.7,132.2,110"}};
    for (const auto& [orientation, shown] : kCases) {
        const Folder folder;
        const std::string picture = ball_picture(folder, "a.jpg", kLights[0]);
        set_orientation(picture, orientation);
        const Outcome outcome =
            directions({picture}, {"--ball", shown, "-o", folder.path("rig.lp")});
        expect_parts(outcome.complaint, {"Exif orientation", "taken as stored, 320 x 260",
                                         std::string("--ball ") + shown +
                                             " of a viewer is --ball 163.3,127.8,110 here"});
        EXPECT_EQ(directions({picture}, {kBallFlag, "-o", folder.path("rig.lp")}).exit_code, 0);
        EXPECT_LT(angle_deg(read_rig(folder.path("rig.lp"), true).lights[0].place.at, kLights[0]),
                  kNear);
    }
    // No highlight where the flag says: the message names the orientation.
    const Folder folder;
    const std::string dark = write_picture(folder, "dark.jpg", picture_of_balls({{kBall, {}}}));
    set_orientation(dark, 6);
    expect_parts(refusal_of([&] {
                     CaptureDirectionsRequest request;
                     request.balls = {dark};
                     request.circles = {kBall};
                     request.output = folder.path("rig.lp");
                     capture_directions(request, {});
                 }),
                 {"dark.jpg", "highlight", "Exif orientation 6", "clockwise"});
}

TEST(CaptureDirections, SaysWhatToGiveForAMissingBall) {
    const Folder folder;
    const std::string picture = ball_picture(folder, "a.png", kLights[0]);
    expect_complaint(directions({picture}, {"-o", folder.path("rig.lp")}), 2,
                     {"--ball X,Y,R", "outline of a mirror ball in pixels"});
}

// Linear PNG files, as a raw converter writes them: read as sRGB, the rim of the highlight would
// weigh too little.
TEST(CaptureDirections, HonoursTheResponseOfTheBalls) {
    const Folder folder;
    const Vec3d light = direction(50, 100);
    const std::string linear = folder.path("linear.png");
    write_image(linear, picture_of_balls({{kBall, {{light, 4.0, 0.9}}}}), {});
    const std::string sample = write_picture(folder, "s.png", Image(30, 20, 3, 0.5f));
    const auto found = [&](const std::vector<std::string>& more, const std::string& out) {
        std::vector<std::string> all = {kBallFlag, "-o", folder.path(out)};
        all.insert(all.end(), more.begin(), more.end());
        EXPECT_EQ(directions({linear}, all).exit_code, 0);
        return read_rig(folder.path(out), true).lights[0].place.at;
    };
    const Vec3d truth = found({"--response", "linear"}, "a.json");
    EXPECT_LT(angle_deg(truth, light), 0.06);
    EXPECT_EQ(found({"--response", "linear"}, "a.lp"),
              found({"--ball-response", "linear"}, "b.lp"));
    EXPECT_LT(angle_deg(found({"--response", "linear", "--pictures", sample}, "c.json"), truth),
              1e-6);
    EXPECT_LT(
        angle_deg(found({"--ball-response", "linear", "--response", "srgb", "--pictures", sample},
                        "d.json"),
                  truth),
        1e-6);
    EXPECT_EQ(read_rig(folder.path("d.json"), true).response, RigResponse::srgb);
    EXPECT_GT(angle_deg(found({}, "e.json"), truth), 1e-4);
}

TEST(CaptureDirections, FindsPicturesOfOtherCaseAndEnding) {
    const Folder folder;
    ball_picture(folder, "B0.PNG", kLights[0]);
    ball_picture(folder, "b1.png", kLights[1]);
    const Outcome outcome = directions({folder.path("b0.jpg"), folder.path("b1.jpg")},
                                       {kBallFlag, "-o", folder.path("rig.lp")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    expect_parts(outcome.complaint, {"b0.jpg", "\"B0.PNG\" is taken for it", "1 more"});
    EXPECT_NE(contents_of(folder.path("rig.lp")).find("B0.PNG"), std::string::npos);
}

TEST(CaptureDirections, WarnsOfListsInTwoOrders) {
    const Folder folder;
    std::vector<std::string> balls;
    std::vector<std::string> more = {kBallFlag, "-o", folder.path("rig.lp"), "--pictures"};
    for (const char* name : {"b1.png", "b10.png", "b2.png"})
        balls.push_back(ball_picture(folder, name, kLights[0]));
    for (const char* name : {"s01.png", "s02.png", "s10.png"})
        more.push_back(write_picture(folder, name, Image(30, 20, 3, 0.5f)));
    expect_parts(directions(balls, more).complaint, {"\"b10.png\" is given before \"b2.png\""});
}

TEST(CaptureDirections, AFullDiskLeavesTheOldRig) {
    const Folder folder;
    const auto pictures = ball_pictures(folder);
    const std::string out = folder.write("rig.json", "old");
    const auto before = folder.names();
    expect_complaint(
        directions(pictures, {kBallFlag, "-o", out, "--width-mm", "9"}, {.file_size_limit = 300}),
        1, {"rig.json", "size limit"});
    EXPECT_EQ(contents_of(out), "old");
    EXPECT_EQ(folder.names(), before);
}

}  // namespace
}  // namespace burnish::test
