// burnish render and info as a person meets them: outputs, their metadata, bad input in one line.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "burnish/image_io.hpp"
#include "support/paths.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

// Small and quick, on whatever runs the GL.
std::vector<std::string> render(const std::vector<std::string>& more, const std::string& out) {
    std::vector<std::string> arguments = {"render", "--size", "48x40", "--samples", "2", "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

double mean_of(const Image& image) {
    double sum = 0;
    for (const float value : image.pixels) {
        EXPECT_TRUE(std::isfinite(value));
        sum += value;
    }
    return sum / static_cast<double>(image.pixels.size());
}

TEST(RenderCommand, WritesEveryFormatAtTheSizeAskedFor) {
    const Folder folder;
    for (const std::string name : {"a.png", "a.jpg", "a.tif", "a.exr"}) {
        const Outcome outcome = run_burnish(render({"builtin:sphere"}, folder.path(name)));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
        EXPECT_EQ(outcome.output, folder.path(name) + "\n");
        const Image image = read_image(folder.path(name));
        EXPECT_EQ(image.width, 48);
        EXPECT_EQ(image.height, 40);
        EXPECT_GT(mean_of(image), 0.01) << name;
    }
}

TEST(RenderCommand, KeepsItsCommandInThePicture) {
    const Folder folder;
    ASSERT_EQ(
        run_burnish(render({"builtin:torus", "--metal", "gold"}, folder.path("a.png"))).exit_code,
        0);
    const Outcome info = run_burnish({"info", folder.path("a.png")});
    EXPECT_NE(info.output.find("--metal gold"), std::string::npos) << info.output;
}

TEST(RenderCommand, TheSameSeedIsTheSamePicture) {
    const Folder folder;
    for (const std::string name : {"a.exr", "b.exr"})
        ASSERT_EQ(
            run_burnish(render({"builtin:drape", "--seed", "7"}, folder.path(name))).exit_code, 0);
    EXPECT_EQ(read_image(folder.path("a.exr")).pixels, read_image(folder.path("b.exr")).pixels);
}

TEST(RenderCommand, ComparesMethodsOnOneSheet) {
    const Folder folder;
    const Outcome outcome = run_burnish(
        render({"builtin:sphere", "--normal-map", "builtin:bumps", "--alpha-x", "0.1", "--alpha-y",
                "0.4", "--compare", "none,normal-map,deform-smooth,follow-grain"},
               folder.path("sheet.png")));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    const Image sheet = read_image(folder.path("sheet.png"));
    EXPECT_GT(sheet.width, 4 * 48);
    EXPECT_GT(sheet.height, 2 * 40);
}

TEST(RenderCommand, TurnsTheTable) {
    const Folder folder;
    const Outcome outcome =
        run_burnish(render({"builtin:drape", "--turntable", "3"}, folder.path("t.png")));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"t_0000.png", "t_0001.png", "t_0002.png"}));
    EXPECT_NE(read_image(folder.path("t_0000.png")).pixels,
              read_image(folder.path("t_0001.png")).pixels);
}

TEST(RenderCommand, TurnsAPartOfTheTable) {
    const Folder folder;
    const std::string out = folder.path("t.png");
    const auto turned = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"builtin:plane", "--turntable", "4"});
        return run_burnish(render(more, out));
    };
    ASSERT_EQ(turned({"--turn", "light", "--frames", "2-3"}).exit_code, 0);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"t_0002.png", "t_0003.png"}));
    const Outcome resumed = turned({"--turn", "light", "--frames", "1-3", "--resume"});
    EXPECT_EQ(resumed.output, folder.path("t_0001.png") + "\n");
    EXPECT_NE(resumed.complaint.find("note: --resume: kept 2 of 3 pictures"), std::string::npos)
        << resumed.complaint;
    expect_complaint(turned({"--turn", "lights"}), 2, {"--turn", "lights", "light"});
    expect_complaint(turned({"--frames", "1-x"}), 2, {"--frames", "whole number", "\"x\""});
    expect_complaint(turned({"--frames", "4"}), 2, {"--frames", "from 0 to 3", "found 4"});
    expect_complaint(turned({"--fps", "24"}), 2, {"--fps: expected -o FILE of a film"});
}

TEST(RenderCommand, RendersTheExampleScenes) {
    const Folder folder;
    for (const auto& entry : fs::directory_iterator(test::source_folder() / "examples/scenes")) {
        const std::string out = folder.path(entry.path().stem().string() + ".png");
        const Outcome outcome = run_burnish(render({entry.path().string()}, out));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
        EXPECT_GT(mean_of(read_image(out)), 0.01);
    }
}

TEST(RenderCommand, WrongWordsAreUsageErrorsThatSuggest) {
    const Folder folder;
    const std::string out = folder.path("a.png");
    expect_complaint(run_burnish(render({"builtin:spere"}, out)), 2, {"spere", "sphere"});
    expect_complaint(run_burnish(render({"builtin:sphere", "--mdf", "gggx"}, out)), 2,
                     {"--mdf", "ggx"});
    expect_complaint(run_burnish(render({"builtin:sphere", "--compare", "none,folow-grain"}, out)),
                     2, {"--compare", "follow-grain"});
    expect_complaint(run_burnish(render({"builtin:sphere", "--alpha-x", "9"}, out)), 2,
                     {"--alpha-x", "0.001 to 1.5", "9"});
    expect_complaint(run_burnish(render({"builtin:sphere", "--alpha-x", ".1", "--e-x", "9"}, out)),
                     2, {"--alpha-x and --e-x say the same thing"});
    expect_complaint(run_burnish(render({"builtin:sphere", "--light", "up"}, out)), 2,
                     {"--light", "up"});
    expect_complaint(run_burnish({"render", "builtin:sphere", "--size", "0x10", "-o", out}), 2,
                     {"--size", "1 to 16384"});
    expect_complaint(run_burnish(render({"builtin:sphere"}, folder.path("a.bmp"))), 2, {".png"});
    expect_complaint(run_burnish(render({"builtin:sphere", "--camera-index", "3"}, out)), 2,
                     {"--camera-index: the file has no cameras"});
    expect_complaint(run_burnish(render({"builtin:sphere", "--light", "10,95"}, out)), 2,
                     {"--light", "-90 to 90", "95"});
    expect_complaint(run_burnish({"render", "builtin:sphere", "--turntable", "0", "-o", out}), 2,
                     {"--turntable: expected a whole number from 1 to 9999, found \"0\""});
    expect_complaint(run_burnish({"render", out, "-o", out}), 1, {"no such file or folder"});
    expect_complaint(run_burnish({"render", folder.write("in.png", "x"), "-o", out}), 1,
                     {"in.png", "scene .json"});
    fs::remove(folder.path("in.png"));
    EXPECT_TRUE(folder.names().empty());
}

TEST(RenderCommand, DrawsPhongAndLafortune) {
    const Folder folder;
    std::vector<Image> pictures;
    for (const std::string brdf : {"microfacet", "phong", "lafortune"}) {
        const std::string out = folder.path(brdf + ".exr");
        const Outcome outcome =
            run_burnish(render({"builtin:sphere", "--brdf", brdf, "--cosine-exponent", "30",
                                "--lafortune-c", "-1,-0.6,0.9", "--normal-map", "builtin:bumps"},
                               out));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
        pictures.push_back(read_image(out));
        EXPECT_GT(mean_of(pictures.back()), 0.01) << brdf;
    }
    EXPECT_NE(pictures[0].pixels, pictures[1].pixels);
    EXPECT_NE(pictures[1].pixels, pictures[2].pixels);
}

TEST(RenderCommand, DeformsNoLobeWithoutHalfVectors) {
    const Folder folder;
    const std::string out = folder.path("a.png");
    const char* why = "for brdf phong, which has no half vectors to deform, found deform-smooth";
    expect_complaint(run_burnish(render(
                         {"builtin:sphere", "--brdf", "phong", "--method", "deform-smooth"}, out)),
                     2, {why});
    expect_complaint(
        run_burnish(render(
            {"builtin:sphere", "--brdf", "phong", "--compare", "follow-grain,deform-smooth"}, out)),
        2, {why});
    const std::string scene = R"({"format": "burnish-scene", "version": 1,
        "objects": [{"model": "builtin:plane", "material": "m"}],
        "materials": {"m": {"brdf": "phong", "method": "deform-smooth"}}})";
    const std::string file = folder.write("s.json", scene);
    expect_complaint(run_burnish(render({file}, out)), 1, {"s.json: objects[0]", why});
    expect_complaint(run_burnish(render({"builtin:sphere", "--brdf", "he"}, out)), 2,
                     {"--brdf", "cook-torrance is nearest"});
    EXPECT_EQ(folder.names(), std::vector<std::string>{"s.json"});
}

TEST(RenderCommand, WhatSaysTheSameTwiceIsRefused) {
    const Folder folder;
    const std::string out = folder.path("a.png");
    for (const std::string side : {"--width", "--height"}) {
        expect_complaint(run_burnish(render({"builtin:sphere", side, "100"}, out)), 2,
                         {"--size", "--width"});
        expect_complaint(
            run_burnish({"render", "builtin:sphere", side, "100", "--size", "32x32", "-o", out}), 2,
            {"--size", "--width"});
    }
    expect_complaint(
        run_burnish(
            render({"builtin:sphere", "--compare", "none,follow-grain", "--method", "none"}, out)),
        2, {"--compare: expected no --method"});
    expect_complaint(run_burnish(render({"builtin:sphere", "--compare", "none,none"}, out)), 2,
                     {"--compare: expected each method once, found none again"});
    EXPECT_TRUE(folder.names().empty());
}

TEST(RenderCommand, TheLastOfTwoFlagsHoldsAndIsNamed) {
    const Folder folder;
    const Outcome outcome = run_burnish(
        render({"builtin:plane", "--size", "24x20", "--size", "16x12"}, folder.path("a.png")));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_NE(outcome.complaint.find("--size: given 3 times: the last one, \"16x12\", holds"),
              std::string::npos)
        << outcome.complaint;
    EXPECT_EQ(read_image(folder.path("a.png")).width, 16);
}

TEST(RenderCommand, SaysWhichFlagsChangeNothing) {
    const Folder folder;
    const auto complaint = [&](std::vector<std::string> flags) {
        flags.insert(flags.begin(), "builtin:plane");
        const Outcome outcome = run_burnish(render(flags, folder.path("a.png")));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
        return outcome.complaint;
    };
    EXPECT_NE(complaint({"--normal-scale", "2"}).find("normal_scale: there is no normal map"),
              std::string::npos);
    EXPECT_NE(complaint({"--normal-filter", "mips"}).find("normal_filter: there is no normal map"),
              std::string::npos);
    EXPECT_NE(complaint({"--metal", "gold", "--metallic", "0"}).find("metallic: a measured metal"),
              std::string::npos);
    EXPECT_NE(complaint({"--camera-zoom", "2", "--camera-distance", "3"}).find("camera_zoom:"),
              std::string::npos);
    const struct {
        std::vector<std::string> flags;
        const char* line;
    } cases[] = {
        {{"--uv-scale", "3"}, "uv_scale: there are no maps"},
        {{"--weave", "plain", "--uv-scale", "3"}, "uv_scale: there are no maps"},
        {{"--weave-fuzz", "0.2"}, "weave_fuzz: there is no weave"},
        {{"--conserve", "--normal-map", "builtin:bumps"}, "conserve: only the deform methods"},
        {{"--method", "none"}, "method: there is no normal map"},
        {{"--mdf", "ggx", "--brdf", "ward"}, "mdf: the reflection model has a distribution"},
        {{"--anisotropy-rotation", "30"}, "anisotropy_rotation: the lobe is isotropic"},
        {{"--metal", "gold", "--base-color", "1,0,0"}, "base_color: a measured metal"},
        {{"--metal", "gold", "--f0", "0.1"}, "f0: a metal has its reflectance"},
        {{"--background", "transparent", "--background-color", "1,0,0"},
         "background_color: a transparent background"},
        {{"--background", "color", "--background-blur", "1"}, "background_blur: the environment"},
        {{"--env", "none", "--environment-rotation", "30"}, "environment_rotation: there is no"},
        {{"--image-light", "prefiltered", "--image-light-samples", "4"},
         "image_light_samples: only image_light importance"},
        {{"--light", "none", "--shadows"}, "shadows: there are no lights"},
        {{"--light", "none", "--light", "45,30"}, "--light: none beside 45,30"},
        {{"--camera-position", "1,1,1", "--camera-azimuth", "3"},
         "camera_azimuth: camera_position holds"}};
    for (const auto& c : cases)
        EXPECT_NE(complaint(c.flags).find(c.line), std::string::npos) << c.line;
    const std::vector<std::string> none[] = {
        {"--alpha-x", "0.1", "--alpha-y", "0.3", "--anisotropy-rotation", "30"},
        {"--normal-map", "builtin:bumps", "--uv-scale", "3", "--method", "none"},
        {"--normal-map", "builtin:bumps", "--conserve", "--compare", "none,deform-smooth"},
        {"--light", "none", "--ground"},
        {"--light", "45,30", "--shadows=false"}};
    for (const auto& flags : none) EXPECT_EQ(complaint(flags), "") << flags.front();
    EXPECT_EQ(complaint({"--metal", "gold", "--metallic", "1"}), "");
    EXPECT_EQ(complaint({"--normal-scale", "2", "--normal-map", "builtin:bumps"}), "");
}

TEST(RenderCommand, NotesAreNotCalledWarnings) {
    const Folder folder;
    write_image(folder.path("x_color.png"), Image(4, 4, 3, 0.5f), {});
    const Outcome outcome =
        run_burnish(render({"builtin:plane", "--maps", folder.path("")}, folder.path("out.exr")));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_NE(outcome.complaint.find("note: maps of"), std::string::npos) << outcome.complaint;
    EXPECT_EQ(outcome.complaint.find("warning"), std::string::npos) << outcome.complaint;
}

TEST(RenderCommand, WarnsOfTransparencyThatTheOutputCannotKeep) {
    const Folder folder;
    const std::vector<std::string> transparent = {"builtin:plane", "--background", "transparent"};
    const Outcome jpeg = run_burnish(render(transparent, folder.path("a.jpg")));
    EXPECT_EQ(jpeg.exit_code, 0);
    EXPECT_NE(jpeg.complaint.find("warning: --background transparent: .jpg"), std::string::npos)
        << jpeg.complaint;
    EXPECT_EQ(run_burnish(render(transparent, folder.path("a.png"))).complaint, "");
}

TEST(RenderCommand, WritesSixteenBitsWhereTheFormatHasThem) {
    const Folder folder;
    const std::vector<std::string> deep = {"builtin:sphere", "--bit-depth", "16"};
    const Outcome png = run_burnish(render(deep, folder.path("a.png")));
    EXPECT_EQ(png.complaint, "");
    EXPECT_EQ(read_image_info(folder.path("a.png")).pixel_type, "uint16");
    const Outcome jpeg = run_burnish(render(deep, folder.path("a.jpg")));
    EXPECT_EQ(jpeg.exit_code, 0);
    EXPECT_NE(jpeg.complaint.find("warning: bit_depth: .jpg holds 8 bits a channel"),
              std::string::npos)
        << jpeg.complaint;
}

// The lamp of the studio on polished metal is far brighter than white: the robust mean of a picture is
// darker than the plain one. An .exr is the plain mean, whatever is asked for.
TEST(RenderCommand, TakesTheRobustMeanForDisplayedPicturesAlone) {
    const Folder folder;
    const auto mean = [&](const std::string& robust, const std::string& name) {
        const Outcome outcome = run_burnish(
            render({"builtin:sphere", "--metal", "steel", "--alpha-x", "0.05", "--normal-map",
                    "builtin:bumps", "--samples", "16", "--robust-mean=" + robust},
                   folder.path(name)));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
        return mean_of(read_image(folder.path(name), {.as_data = true}));
    };
    EXPECT_LT(mean("true", "a.png"), mean("false", "b.png") - 0.0004);
    EXPECT_EQ(mean("true", "a.exr"), mean("false", "b.exr"));
}

TEST(RenderCommand, WarnsOfANormalMapThatIsNone) {
    const Folder folder;
    write_image(folder.path("grey.png"), Image(4, 4, 3, 0.6f), {});
    const Outcome outcome = run_burnish(
        render({"builtin:plane", "--normal-map", folder.path("grey.png")}, folder.path("a.png")));
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.complaint.find("does not look like a tangent-space normal map"),
              std::string::npos)
        << outcome.complaint;
}

TEST(RenderCommand, FaultsOfASceneFileNameItAndTheKey) {
    const Folder folder;
    const std::string scene = R"({"format": "burnish-scene", "version": 1,
        "objects": [{"model": "builtin:plane"}], "environment": "no.hdr"})";
    expect_complaint(run_burnish(render({folder.write("s.json", scene)}, folder.path("a.png"))), 1,
                     {"s.json: environment: ", "no.hdr", "no such file or folder"});
}

TEST(RenderCommand, HelpHasNamesRangesAndDefaults) {
    const std::string help = run_burnish({"render", "--help"}).output;
    for (const char* part : {"--alpha-x NUMBER", "(0.001 to 1.5)", "--samples INTEGER",
                             "(1 to 65536; default 64)", "--metal NAME", "--normal-map FILE",
                             "--lafortune-c X,Y,Z", "(each -10 to 10; default -1,-1,1)",
                             "--size WxH", "--turntable COUNT", "turn_0000.exr", "builtin:black"})
        EXPECT_NE(help.find(part), std::string::npos) << part;
}

TEST(RenderCommand, BrokenFilesAreOneLine) {
    const Folder folder;
    const std::string out = folder.path("a.png");
    const std::string old = "an old picture";
    folder.write("a.png", old);
    const std::string truncated =
        folder.write("cut.glb", std::string("glTF\2\0\0\0\377\0\0\0", 12));
    expect_complaint(run_burnish(render({truncated}, out)), 1, {"cut.glb"});
    expect_complaint(run_burnish(render({folder.write("e.obj", "")}, out)), 1, {"e.obj"});
    expect_complaint(
        run_burnish(render({folder.write("s.json", "{\"format\":\"burnish-scene\"")}, out)), 1,
        {"s.json"});
    expect_complaint(run_burnish(render({folder.path("missing.glb")}, out)), 1, {"missing.glb"});
    expect_complaint(run_burnish(render(
                         {"builtin:sphere", "--env", folder.write("e.hdr", "#?RADIANCE\n")}, out)),
                     1, {"e.hdr"});
    expect_complaint(
        run_burnish(
            render({"builtin:sphere", "--normal-map", folder.write("n.png", "\x89PNG")}, out)),
        1, {"n.png"});
    EXPECT_EQ(contents_of(out), old);
}

TEST(RenderCommand, AFullDiskLeavesTheOldPicture) {
    const Folder folder;
    const std::string out = folder.write("a.exr", "an old picture");
    Surroundings small_disk;
    small_disk.file_size_limit = 4096;
    expect_complaint(
        run_burnish({"render", "builtin:sphere", "--size", "200x200", "--samples", "1", "-o", out},
                    small_disk),
        1, {"a.exr"});
    EXPECT_EQ(contents_of(out), "an old picture");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.exr"});
    expect_complaint(run_burnish(render({"builtin:sphere"}, folder.path("no/such/a.png"))), 1,
                     {"no/such"});
}

TEST(InfoCommand, SaysWhatThereIs) {
    const Outcome sphere = run_burnish({"info", "builtin:sphere"});
    EXPECT_EQ(sphere.exit_code, 0);
    EXPECT_NE(sphere.output.find("101760 triangles"), std::string::npos) << sphere.output;
    const Outcome studio = run_burnish({"info", "builtin:studio"});
    EXPECT_NE(studio.output.find("mean radiance"), std::string::npos) << studio.output;
    expect_complaint(run_burnish({"info"}), 2, {"--devices"});
}

TEST(InfoCommand, SaysWhatASceneFileSays) {
    const Outcome cup = run_burnish(
        {"info", (test::source_folder() / "examples/scenes/brushed_cup.json").string()});
    EXPECT_EQ(cup.exit_code, 0);
    for (const char* part : {"material turned copper: metal copper, alpha (0.08, 0.35)",
                             "environment: builtin:studio", "camera of the picture: at ("})
        EXPECT_NE(cup.output.find(part), std::string::npos) << part << "\n" << cup.output;
    EXPECT_EQ(cup.output.find("base color"), std::string::npos) << cup.output;
}

TEST(InfoCommand, GroupsMaterialsThatDifferInNumbersAlone) {
    const Folder folder;
    std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nmtllib m.mtl\n", mtl;
    for (int i = 0; i < 20; ++i) {
        const std::string name = "paint" + std::to_string(i);
        obj += "usemtl " + name + "\nf 1 2 3\n";
        mtl += "newmtl " + name + "\nKd 0.5 0." + std::to_string(100 + i) + " 0.5\n";
    }
    folder.write("m.mtl", mtl);
    const Outcome info = run_burnish({"info", folder.write("m.obj", obj)});
    EXPECT_EQ(info.exit_code, 0) << info.complaint;
    EXPECT_NE(info.output.find("paint0 .. paint19 (20 materials)"), std::string::npos)
        << info.output;
    EXPECT_NE(info.output.find(".."), std::string::npos);
    EXPECT_EQ(info.output.find("paint7"), std::string::npos) << info.output;
}

TEST(InfoCommand, KeepsToWhatTheFileSaysOfItself) {
    const Folder folder;
    write_image(folder.path("a.exr"), Image(4, 4, 3, 0.5f), {{"burnish:command", "x"}});
    const Outcome info = run_burnish({"info", folder.path("a.exr")});
    EXPECT_NE(info.output.find("burnish:command: x"), std::string::npos) << info.output;
    EXPECT_EQ(info.output.find("oiio:"), std::string::npos) << info.output;
    EXPECT_EQ(info.output.find("screenWindow"), std::string::npos) << info.output;
}

}  // namespace
}  // namespace burnish::test
