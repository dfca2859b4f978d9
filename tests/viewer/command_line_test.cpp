// The copied command draws what the viewer shows: it is parsed as `burnish render` parses it.
#include "viewer/document/command_line.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/text.hpp"
#include "support/program.hpp"
#include "viewer/document/editor.hpp"
#include "viewer/document/save_scene.hpp"
#include "viewer/random_documents.hpp"

namespace burnish::viewer {
namespace {

using test::expect_same_stage;
using test::RandomDocuments;

// The request of the words, by the rules of the flags: "--name value", "--name=value", "--switch".
StageRequest request_of(const std::vector<std::string>& words, std::vector<std::string>& methods) {
    StageRequest request;
    EXPECT_EQ(words.at(0), "render");
    request.input = words.at(1);
    for (std::size_t i = 2; i < words.size(); ++i) {
        const std::string word = words[i];
        if (word == "-o") {
            ++i;
            continue;
        }
        EXPECT_TRUE(word.starts_with("--")) << word;
        const std::size_t equals = word.find('=');
        std::string name = word.substr(2, equals == word.npos ? word.npos : equals - 2);
        std::replace(name.begin(), name.end(), '-', '_');
        const Parameter* parameter = find_parameter(name);
        const bool is_switch = parameter != nullptr && parameter->kind == ParameterKind::boolean;
        const std::string value = equals != word.npos ? word.substr(equals + 1)
                                  : is_switch         ? "true"
                                                      : words.at(++i);
        if (name == "env") {
            request.environment = value;
        } else if (name == "light") {
            request.lights.push_back(value);
        } else if (name == "compare") {
            methods.push_back(value);
        } else {
            request.values.set(name, value, word);
        }
    }
    return request;
}

TEST(CommandLineOfTheViewer, GivesTheStageOrSaysThatASceneIsNeeded) {
    RandomDocuments documents(183);
    int with_flags = 0, with_scene = 0;
    for (int i = 0; i < 100; ++i) {
        Document document = documents.next();
        if (i % 2 == 0) {
            document.material_values.clear();
            document.hidden.clear();
            if (document.lights)
                for (Light& light : *document.lights) {
                    light.color = glm::vec3(1.0f);
                    light.range = 0.0f;
                }
        }
        Stage stage;
        try {
            stage = load_stage(document);
        } catch (const Error&) {
            continue;
        }
        const std::string file = (documents.folder() / "saved.json").string();
        const CommandLine command = render_command(document, stage, file, "picture.png");
        if (command.needs_scene) save_scene(document, stage, file);
        EXPECT_EQ(command.needs_scene, !command.reason.empty());
        (command.needs_scene ? with_scene : with_flags) += 1;
        SCOPED_TRACE(command.text());
        std::vector<std::string> methods;
        Stage drawn = set_stage(request_of(command.words, methods));
        EXPECT_EQ(methods.empty(), document.compare.mode == CompareMode::off);
        // --compare takes the place of the method; directions of lights go through angles.
        for (std::size_t j = 0; j < drawn.scene.materials.size(); ++j)
            if (!methods.empty())
                drawn.scene.materials[j].method = stage.scene.materials.at(j).method;
        ASSERT_EQ(drawn.scene.lights.size(), stage.scene.lights.size());
        for (std::size_t j = 0; j < drawn.scene.lights.size(); ++j) {
            Light& light = drawn.scene.lights[j];
            EXPECT_LT(glm::length(light.direction - stage.scene.lights[j].direction), 1.001e-6f);
            light.direction = stage.scene.lights[j].direction;
        }
        expect_same_stage(drawn, stage);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(with_flags, 15);
    EXPECT_GT(with_scene, 15);
}

TEST(CommandLineOfTheViewer, LightsAreSaidByTheFewestDigitsThatGiveThemAgain) {
    std::mt19937 random(184);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const std::string said = fmt::format("{:.4g},{:.4g},{:.3g}", 360.0 * part(random) - 180.0,
                                             180.0 * part(random) - 90.0, 1e3 * part(random));
        const Light light = parse_light(said);
        const std::string word = light_word(light);
        EXPECT_TRUE(parse_light(word) == light) << said << " " << word;
        EXPECT_LE(word.size(), said.size() + 14) << said << " " << word;
    }
    for (const char* said : {"0,90,1", "0,-90,1", "90,0", "point:1,2.5,-3,7"})
        EXPECT_TRUE(parse_light(light_word(parse_light(said))) == parse_light(said)) << said;
    const auto word_of = [](auto change) {
        Light light;
        change(light);
        return light_word(light);
    };
    EXPECT_EQ(word_of([](Light& l) { l.color = {1, 1, 0.5f}; }), "");
    EXPECT_EQ(word_of([](Light& l) { l.type = LightType::spot; }), "");
    EXPECT_EQ(word_of([](Light& l) { l.intensity = 2e6f; }), "");
    EXPECT_EQ(word_of([](Light& l) {
                  l.type = LightType::point;
                  l.range = 3.0f;
              }),
              "");
}

TEST(CommandLineOfTheViewer, NamesTheReasonForAScene) {
    Document document{.input = "builtin:plane", .environment = "none"};
    const auto reason = [&] {
        return render_command(document, load_stage(document), "s.json", "p.png").reason;
    };
    EXPECT_EQ(reason(), "");
    document.lights.emplace(1).front().color = {1, 0, 0};
    EXPECT_NE(reason().find("lights"), std::string::npos);
    document.hidden = {0};
    EXPECT_EQ(reason(), "hidden parts");
    document.material_values[0].set_value("alpha_x", 0.2);
    EXPECT_EQ(reason(), "materials of their own");
    EXPECT_EQ(render_command(document, load_stage(document), "a b.json", "-p.png").text(),
              "burnish render 'a b.json' -o ./-p.png");
}

TEST(CommandLineOfTheViewer, WhatTheOpenSceneFileSaysNeedsNoFlagAndNoOtherScene) {
    const test::ScratchFolder folder;
    Document document{.input = "builtin:plane", .environment = "none"};
    document.lights = {Light{}, parse_light("30,40,2")};
    document.lights->front().color = {1, 0, 0};
    document.dark = {1};
    document.hidden = {0};
    document.material_values[0].set_value("alpha_x", 0.2);
    document.compare.mode = CompareMode::split;
    const std::string file = (folder / "saved.json").string();
    save_scene(document, load_stage(document), file);
    Editor editor;
    editor.open({.input = file});
    ASSERT_TRUE(editor.document().dark.contains(1));
    const auto text = [&](const Document& d) {
        const CommandLine command = render_command(d, editor.stage(), "other.json", "picture.png");
        EXPECT_EQ(command.needs_scene, !command.reason.empty());
        return command.text();
    };
    EXPECT_EQ(text(editor.document()),
              "burnish render " + file + " --compare normal-map,follow-grain -o picture.png");
    Document changed = editor.document();
    changed.compare = {};
    changed.bookmarks.push_back({.name = "a view"});
    set_parameter(changed, "alpha_x", 0.3);
    EXPECT_EQ(text(changed), "burnish render " + file + " --alpha-x 0.3 -o picture.png");
    changed.dark.clear();
    EXPECT_EQ(text(changed), "burnish render other.json -o picture.png");
    changed.dark = editor.document().dark;
    changed.hidden.clear();
    EXPECT_EQ(text(changed), "burnish render other.json -o picture.png");
}

TEST(CommandLineOfTheViewer, TheProgramTakesIt) {
    const test::Folder folder;
    Document document{.input = "builtin:plane", .environment = "none"};
    set_parameter(document, "shadows", false);
    set_parameter(document, "samples", 1);
    set_parameter(document, "width", 16);
    set_parameter(document, "height", 9);
    set_camera(document, {-1.5f, -0.25f, 2}, {-0.5f, 0, 0}, 30.0);
    document.lights = {parse_light("-30,40,2"), parse_light("point:-1,0,2,3")};
    const CommandLine command =
        render_command(document, load_stage(document), "", folder.path("picture.png"));
    ASSERT_FALSE(command.needs_scene);
    EXPECT_NE(command.text().find("--shadows=false"), std::string::npos);
    const test::Outcome outcome = test::run_burnish(command.words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint << command.text();
    EXPECT_EQ(folder.names(), std::vector<std::string>{"picture.png"});
    const auto metadata = read_image_info(folder.path("picture.png")).metadata;
    EXPECT_NE(metadata.at("burnish:parameters").find("shadows=false"), std::string::npos);
}

TEST(ShellQuoted, WordsSurviveAShell) {
    EXPECT_EQ(shell_quoted("a/b-c.png"), "a/b-c.png");
    EXPECT_EQ(shell_quoted(""), "''");
    EXPECT_EQ(shell_quoted("it's $HOME"), "'it'\\''s $HOME'");
    EXPECT_EQ(shell_quoted("#ff0000"), "'#ff0000'");
}

}  // namespace
}  // namespace burnish::viewer
