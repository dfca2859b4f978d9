// Scripts of the viewer: words, commands, and errors that name the line.
#include "viewer/script/script.hpp"

#include <gtest/gtest.h>

#include <random>

#include "burnish/error.hpp"
#include "burnish/stage.hpp"
#include "support/test_folder.hpp"

namespace burnish::viewer {
namespace {

using test::error_line;

template <typename Kind>
Kind only(const std::string& line) {
    const std::vector<Command> commands = parse_script(line, "s.txt");
    EXPECT_EQ(commands.size(), 1u) << line;
    return std::get<Kind>(commands.at(0).action);
}

TEST(ViewerScript, WordsQuotesAndComments) {
    const std::vector<Command> commands = parse_script(
        "\xef\xbb\xbf# a comment\r\n\r\n  open \"a \\\"b\\\" \\\\c.glb\"  'd' # and "
        "another\n\tquit\n#quit",
        "s.txt");
    ASSERT_EQ(commands.size(), 2u);
    EXPECT_EQ(commands[0].line, 3);
    EXPECT_EQ(commands[0].text, "open \"a \\\"b\\\" \\\\c.glb\"  'd'");
    EXPECT_EQ(std::get<OpenCommand>(commands[0].action).files,
              (std::vector<std::string>{"a \"b\" \\c.glb", "'d'"}));
    EXPECT_EQ(commands[1].line, 4);
    EXPECT_TRUE(parse_script("", "s.txt").empty());
    EXPECT_TRUE(parse_script("#\n # \n", "s.txt").empty());
}

TEST(ViewerScript, EveryCommandIsRead) {
    EXPECT_EQ(only<SetCommand>("set base_color #ff8000 \"brushed steel\"").value, "#ff8000");
    EXPECT_EQ(only<SetCommand>("set alpha_x 0.2 #1").material, "#1");
    EXPECT_EQ(only<SetCommand>("set alpha_x 0.2 # tight").material, std::nullopt);
    EXPECT_EQ(only<UnsetCommand>("unset alpha_x oak").material, "oak");
    EXPECT_TRUE(only<LightCommand>("light 30,40,2").light == parse_light("30,40,2"));
    EXPECT_EQ(only<LightCommand>("light none").light, std::nullopt);
    EXPECT_EQ(only<EnvironmentCommand>("environment builtin:white").name, "builtin:white");
    const auto drag = only<DragCommand>("drag environment -12.5 3 20");
    EXPECT_EQ(drag.kind, DragKind::environment);
    EXPECT_EQ(drag.dx, -12.5);
    EXPECT_EQ(drag.dy, 3.0);
    EXPECT_EQ(drag.frames, 20);
    EXPECT_EQ(only<DragCommand>("drag orbit 1 2").frames, 1);
    EXPECT_EQ(only<MoveCommand>("move 3 4").y, 4.0);
    EXPECT_TRUE(only<ClickCommand>("click 3 4 shift").shift);
    EXPECT_FALSE(only<ClickCommand>("click 3 4").shift);
    EXPECT_EQ(only<MouseCommand>("mouse left 3 4").frames, 3);
    EXPECT_EQ(only<MouseCommand>("mouse left 3 4 60").frames, 60);
    const auto mouse = only<MouseCommand>("mouse right 3 -4 shift 5");
    EXPECT_EQ(mouse.button, 1);
    EXPECT_EQ(mouse.dy, -4.0);
    EXPECT_EQ(mouse.modifier, "shift");
    EXPECT_EQ(mouse.frames, 5);
    EXPECT_EQ(only<TypeCommand>("type \"two words\"").text, "two words");
    EXPECT_FALSE(only<TypeCommand>("type 0.3").enter);
    EXPECT_TRUE(only<TypeCommand>("type 0.3 enter").enter);
    EXPECT_EQ(only<KeyCommand>("key ctrl+z").keys, "ctrl+z");
    EXPECT_EQ(only<WaitCommand>("wait 12").amount, 12.0);
    EXPECT_EQ(only<WaitCommand>("wait rest").kind, WaitKind::rest);
    EXPECT_EQ(only<WaitCommand>("wait seconds 0.5").amount, 0.5);
    const auto generate = only<GenerateCommand>(
        "generate scratch preset swirl-marks amount 2.5 strength 0.5 seed 7 size 1024 tile 20 "
        "angle "
        "-30 range 4 length 9 width 0.2 depth 0.01");
    EXPECT_EQ(generate.preset, "swirl-marks");
    EXPECT_EQ(generate.amount, 2.5);
    EXPECT_EQ(generate.strength, 0.5);
    EXPECT_EQ(generate.seed, 7);
    EXPECT_EQ(generate.size, 1024);
    EXPECT_EQ(generate.tile_mm, 20.0);
    EXPECT_EQ(generate.angle_deg, -30.0);
    EXPECT_EQ(generate.range_deg, 4.0);
    EXPECT_EQ(generate.length_mm, 9.0);
    EXPECT_EQ(generate.width_mm, 0.2);
    EXPECT_EQ(generate.depth_mm, 0.01);
    EXPECT_FALSE(only<GenerateCommand>("generate scratch").amount);
    EXPECT_EQ(only<PickCommand>("pick 3 4").x, 3.0);
    const auto compare = only<CompareCommand>("compare split normal-map follow-grain");
    EXPECT_EQ(compare.mode, CompareMode::split);
    EXPECT_EQ(compare.methods, (std::vector<Method>{Method::normal_map, Method::follow_grain}));
    EXPECT_TRUE(only<CompareCommand>("compare off").methods.empty());
    EXPECT_EQ(only<ViewCommand>("view tangent").name, "tangent");
    EXPECT_TRUE(only<PanelCommand>("panel materials on").open);
    EXPECT_EQ(only<UndoCommand>("undo").steps, 1);
    EXPECT_EQ(only<RedoCommand>("redo 3").steps, 3);
    const auto save = only<SaveCommand>("save picture p.png 640x480");
    EXPECT_EQ(save.kind, SaveKind::picture);
    EXPECT_EQ(save.size, (Size{640, 480}));
    EXPECT_EQ(only<SaveCommand>("save scene s.json").size, std::nullopt);
    EXPECT_EQ(only<TurntableCommand>("turntable 24 t.png").frames, 24);
    EXPECT_EQ(only<TurntableCommand>("turntable 24 t.png").turn, Turn::object);
    EXPECT_EQ(only<TurntableCommand>("turntable 24 t.mp4 camera").turn, Turn::camera);
    EXPECT_EQ(only<ScreenshotCommand>("screenshot w.png").file, "w.png");
    EXPECT_EQ(only<ResizeCommand>("resize 1280x720").size, (Size{1280, 720}));
    only<QuitCommand>("quit");
}

TEST(ViewerScript, CommandsOfTheSceneAreRead) {
    using Does = SceneCommand::Does;
    const auto scene = [](const std::string& line) { return only<SceneCommand>(line); };
    EXPECT_EQ(scene("material oak").name, "oak");
    EXPECT_EQ(scene("material all").name, "");
    EXPECT_EQ(scene("object \"left door\" off").does, Does::hide_object);
    EXPECT_EQ(scene("object #3 on").does, Does::show_object);
    EXPECT_EQ(scene("object #3 solo").does, Does::solo_object);
    EXPECT_EQ(scene("object #3 frame").name, "#3");
    EXPECT_EQ(scene("object all on").does, Does::show_all_objects);
    EXPECT_EQ(scene("lights add point").type, LightType::point);
    EXPECT_EQ(scene("lights 2 off").index, 1);
    EXPECT_EQ(scene("lights 2 on").does, Does::switch_light_on);
    EXPECT_EQ(scene("lights 1 remove").does, Does::remove_light);
    const auto moved = scene("lights 1 to 30,40");
    EXPECT_TRUE(*moved.light == parse_light("30,40"));
    EXPECT_FALSE(moved.has_intensity);
    EXPECT_TRUE(scene("lights 1 to 30,40,2").has_intensity);
    EXPECT_FALSE(scene("lights 1 to point:1,2,3").has_intensity);
    EXPECT_TRUE(scene("lights 1 to point:1,2,3,4").has_intensity);
    EXPECT_EQ(scene("lights 1 color #ff0000").color, glm::vec3(1, 0, 0));
    EXPECT_EQ(scene("background off").does, Does::hide_background);
    const auto renamed = scene("bookmark rename front \"the front\"");
    EXPECT_EQ(renamed.name, "front");
    EXPECT_EQ(renamed.to, "the front");
    EXPECT_EQ(scene("bookmark go front").does, Does::go_to_bookmark);
    EXPECT_EQ(scene("recover later").does, Does::leave_recovered);
    EXPECT_EQ(scene("simulate device-reset").does, Does::reset_device);
    const auto pair = only<CompareCommand>("compare blink material oak /a/b.exr");
    EXPECT_EQ(pair.mode, CompareMode::blink);
    EXPECT_EQ(pair.materials->first, "oak");
    EXPECT_EQ(pair.materials->second, "/a/b.exr");
    const auto mouse = only<MouseCommand>("mouse middle 3 -4 shift");
    EXPECT_EQ(mouse.button, 2);
    EXPECT_EQ(mouse.dy, -4.0);
    EXPECT_EQ(mouse.modifier, "shift");
    EXPECT_EQ(only<MouseCommand>("scroll 0 2").button, -1);
    EXPECT_EQ(only<NavigationCommand>("navigation blender").navigation, Navigation::blender);
    EXPECT_EQ(only<NavigationCommand>("touchpad off").touchpad, false);
    for (const char* line :
         {"object oak", "object all off", "lights 0 on", "lights add spot", "lights 1 to 30",
          "lights 1 color", "bookmark", "bookmark rename a", "recover", "simulate",
          "compare split material a", "mouse up 1 2", "navigation maya", "background maybe"})
        EXPECT_THROW(parse_script(line, "s.txt"), Error) << line;
}

TEST(ViewerScript, ErrorsNameTheLineAndTheNearestWord) {
    const auto refused = [](const std::string& line, const std::vector<std::string>& parts) {
        const std::string text = error_line([&] { parse_script("\n" + line, "s.txt"); });
        EXPECT_EQ(text.find("s.txt: line 2: expected "), 0u) << text;
        EXPECT_NE(text.find(", found "), std::string::npos) << text;
        for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    refused("opne a.glb", {"did you mean 'open'?"});
    refused("open", {"a file, found the end of the line"});
    refused("open \"\"", {"an empty word"});
    refused("open \"a", {"a closing quotation mark"});
    refused("open \"a\"b", {"a blank"});
    refused("open a\x01", {"control character"});
    refused("set alphax 1", {"did you mean 'alpha_x'?"});
    refused("set alpha_x", {"a value of alpha_x"});
    refused("set alpha_x 7", {"a number from 0.001 to 1.5", "\"7\""});
    refused("set method follow-grian", {"did you mean 'follow-grain'?"});
    refused("set alpha_x 0.2 oak more", {"the end of the line", "\"more\""});
    refused("light 10", {"2 or 3 numbers"});
    refused("light 10,95", {"-90 to 90", "95"});
    refused("drag turn 1 2", {"orbit pan zoom light environment"});
    refused("drag orbit 1", {"DY in pixels"});
    refused("drag orbit 1 nan", {"a number"});
    refused("drag orbit 1 2 0", {"a whole number from 1 to 100000"});
    refused("click 1 2 ctrl", {"shift"});
    refused("wait", {"frames, rest"});
    refused("wait 1.5", {"a whole number"});
    refused("wait seconds -1", {"0 to 86400"});
    refused("compare splt", {"did you mean 'split'?"});
    refused("compare split none", {"2 to 4 methods"});
    refused("compare split none none", {"each method once"});
    refused("panel lights open", {"on off"});
    refused("undo 0", {"1 to 1000"});
    refused("save scene a.json 640x480", {"the end of the line"});
    refused("save picture a.png 640", {"WIDTHxHEIGHT"});
    refused("save picture a.png 0x5", {"1 to 16384"});
    refused("turntable 0 a.png", {"1 to 9999"});
    refused("turntable 9 a.png lights", {"what turns", "light"});
    refused("resize 99999x9", {"1 to 16384"});
    refused("expect fps", {"a comparison"});
    refused("expect fps > fast", {"a number behind"});
    refused("expect fps > 3 0.1", {"no tolerance"});
    refused("expect fps = 3 -0.1", {"a tolerance"});
    refused("quit now", {"seconds"});
    refused("quit 5 now", {"the end of the line"});
}

TEST(ViewerScript, ExpectationsHoldOrNot) {
    const auto meets_line = [](const std::string& rest, auto found) {
        return meets(only<ExpectCommand>("expect x " + rest), found);
    };
    EXPECT_TRUE(meets_line("= 3", 3.0));
    EXPECT_FALSE(meets_line("= 3", 3.1));
    EXPECT_TRUE(meets_line("= 3 0.2", 3.1));
    EXPECT_TRUE(meets_line("!= 3", 3.1));
    EXPECT_FALSE(meets_line("!= 3 0.2", 3.1));
    EXPECT_TRUE(meets_line(">= 30", 30.0));
    EXPECT_FALSE(meets_line("> 30", 30.0));
    EXPECT_TRUE(meets_line("<= 30", 30.0));
    EXPECT_FALSE(meets_line("< 30", 30.0));
    const double nan = std::nan("");
    for (const char* rest : {"= 3", "< 3", "> 3", "<= 3", ">= 3"})
        EXPECT_FALSE(meets_line(rest, nan));
    EXPECT_TRUE(meets_line("!= 3", nan));
    EXPECT_TRUE(meets_line("= steel", std::string_view("steel")));
    EXPECT_FALSE(meets_line("!= steel", std::string_view("steel")));
    EXPECT_TRUE(meets_line("= 0.20", std::string_view("0.2"))) << "numbers are compared as numbers";
    EXPECT_FALSE(meets_line("< 3", std::string_view("none")));
}

TEST(ViewerScript, SurvivesAnyBytes) {
    const std::string sound =
        "open a.glb\nset alpha_x 0.2 #1\nlight 30,40,2\ndrag orbit 10 20 5\nwait rest\n"
        "compare split none follow-grain\nexpect fps > 30\nsave picture \"a b.png\" 64x48\nquit\n";
    std::mt19937 random(18);
    int read = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = sound;
        if (i % 4 == 0) text.resize(random() % text.size());
        for (auto j = random() % 6; j > 0 && !text.empty(); --j)
            text[random() % text.size()] = static_cast<char>(random());
        if (i % 5 == 0) text.insert(random() % (text.size() + 1), sound.substr(random() % 40));
        try {
            parse_script(text, "s.txt");
            ++read;
        } catch (const Error& error) {
            const std::string line = error.what();
            EXPECT_EQ(line.find("s.txt: line "), 0u) << line;
            EXPECT_EQ(line.find('\n'), line.npos);
        }
    }
    EXPECT_GT(read, 100) << "some of the damage is harmless";
}

TEST(ViewerScript, IsLoadedFromAFile) {
    const test::ScratchFolder folder;
    EXPECT_EQ(load_script(folder.write("s.txt", "quit")).size(), 1u);
    error_line([&] { load_script(folder / "missing.txt"); });
}

}  // namespace
}  // namespace burnish::viewer
