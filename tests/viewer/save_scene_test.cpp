// What is saved is read back as the same scene, by the viewer and by `burnish render`.
#include "viewer/document/save_scene.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "burnish/image_io.hpp"
#include "viewer/document/editor.hpp"
#include "viewer/document/viewer_section.hpp"
#include "viewer/random_documents.hpp"

namespace burnish::viewer {
namespace {

using test::error_line;
using test::expect_same_stage;
using test::RandomDocuments;
using test::ScratchFolder;
using test::two_materials;

Stage rendered(const std::filesystem::path& scene) {
    StageRequest request;
    request.input = scene.string();
    return set_stage(request);
}

TEST(SavedScene, RandomDocumentsAreReadBackAsTheyWere) {
    RandomDocuments documents(181);
    int with_lights = 0, with_own = 0, with_hidden = 0;
    for (int i = 0; i < 200; ++i) {
        const Document document = documents.next();
        const Stage stage = load_stage(document);
        const std::filesystem::path file = documents.folder() / "saved.json";
        save_scene(document, stage, file);
        SCOPED_TRACE(scene_text(document, stage, file));
        expect_same_stage(rendered(file), stage);
        // The viewer itself, and what it saves of that.
        Editor editor;
        editor.open({.input = file.string()});
        expect_same_stage(editor.stage(), stage);
        EXPECT_EQ(editor.document().hidden, document.hidden);
        EXPECT_EQ(editor.document().bookmarks, document.bookmarks);
        EXPECT_EQ(editor.document().compare, document.compare);
        EXPECT_EQ(editor.document().dark, document.dark);
        const std::filesystem::path again = documents.folder() / "again.json";
        save_scene(editor.document(), editor.stage(), again);
        expect_same_stage(rendered(again), stage);
        if (testing::Test::HasFailure()) return;
        with_lights += document.lights ? 1 : 0;
        with_own += document.material_values.empty() ? 0 : 1;
        with_hidden += document.hidden.empty() ? 0 : 1;
    }
    EXPECT_GT(with_lights, 50);
    EXPECT_GT(with_own, 20);
    EXPECT_GT(with_hidden, 20);
}

TEST(SavedScene, FilesAreNamedFromItsFolderAndPresetsByTheirNames) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "in/maps");
    std::filesystem::create_directories(folder / "out");
    write_image(folder / "in/maps/bumps.png", Image(4, 4, 3, 0.5f), {});
    Document document;
    document.input = two_materials(folder, "in/two.glb").string();
    document.environment = "none";
    set_parameter_text(document, "normal_map", (folder / "in/maps/bumps.png").string());
    set_parameter_text(document, "weave", "plain", 1);
    const Stage stage = load_stage(document);
    const auto json = nlohmann::json::parse(scene_text(document, stage, folder / "out/scene.json"));
    EXPECT_EQ(json["objects"][0]["model"], "../in/two.glb");
    EXPECT_EQ(json["materials"]["brass"]["normal_map"], "../in/maps/bumps.png");
    EXPECT_EQ(json["materials"]["oak"]["weave"], "plain");
    EXPECT_EQ(json["environment"], "none");
    // The folder moves as a whole.
    save_scene(document, stage, folder / "out/scene.json");
    std::filesystem::create_directories(folder / "elsewhere");
    for (const char* part : {"in", "out"})
        std::filesystem::rename(folder / part, folder / ("elsewhere/" + std::string(part)));
    expect_same_stage(rendered(folder / "elsewhere/out/scene.json"), stage);
}

TEST(SavedScene, AFileThatIsCalledLikeAPresetStaysAFile) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "brushed");
    for (const char* map : {"/normal.png", "/anisotropy.png"})
        write_image(folder / ("brushed" + std::string(map)), Image(4, 4, 3, 0.5f), {});
    Document document{.input = "builtin:plane", .environment = "none"};
    set_parameter_text(document, "scratch", (folder / "brushed").string());
    const Stage stage = load_stage(document);
    save_scene(document, stage, folder / "scene.json");
    expect_same_stage(rendered(folder / "scene.json"), stage);
}

TEST(SavedScene, LinksOfFoldersDoNotLeadAstray) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "real/deep");
    std::filesystem::create_directory_symlink(folder / "real/deep", folder / "link");
    Document document;
    document.input = two_materials(folder, "two.glb").string();
    document.environment = "none";
    const Stage stage = load_stage(document);
    save_scene(document, stage, folder / "link/scene.json");
    expect_same_stage(rendered(folder / "link/scene.json"), stage);
    expect_same_stage(rendered(folder / "real/deep/scene.json"), stage);
}

TEST(SavedScene, LightsOfTheModelGoWhenOthersTakeTheirPlace) {
    const ScratchFolder folder;
    Document document;
    document.input = two_materials(folder, "lit.glb", true).string();
    document.environment = "none";
    const Stage lit = load_stage(document);
    ASSERT_EQ(lit.scene.lights.size(), 1u);
    save_scene(document, lit, folder / "own.json");
    EXPECT_TRUE(rendered(folder / "own.json").scene.lights == lit.scene.lights);
    document.lights.emplace();
    save_scene(document, load_stage(document), folder / "dark.json");
    EXPECT_TRUE(rendered(folder / "dark.json").scene.lights.empty());
    // A dark scene that is opened and saved again stays dark.
    Editor editor;
    editor.open({.input = (folder / "dark.json").string()});
    save_scene(editor.document(), editor.stage(), folder / "dark again.json");
    EXPECT_TRUE(rendered(folder / "dark again.json").scene.lights.empty());
}

TEST(SavedScene, TheTextureOfALightIsFoundAgain) {
    const ScratchFolder folder;
    write_image(folder / "box.exr", Image(4, 4, 3, 0.5f), {});
    const std::string lit = folder
                                .write("lit.json", R"({"format": "burnish-scene", "version": 1,
        "objects": [{"model": "builtin:plane"}], "lights": [{"type": "rectangle", "position": [0, 0, 1],
        "direction": [0, 0, -1], "size": 1, "radiance": 3, "texture": "box.exr"}]})")
                                .string();
    Document document{.input = lit, .environment = "none"};
    const Stage stage = load_stage(document);
    ASSERT_NE(stage.scene.lights.at(0).texture.image, nullptr);
    save_scene(document, stage, folder / "saved.json");
    const Light read = rendered(folder / "saved.json").scene.lights.at(0);
    EXPECT_EQ(read, stage.scene.lights[0]);
    EXPECT_EQ(read.texture.image->pixels, stage.scene.lights[0].texture.image->pixels);
}

TEST(SavedScene, RenderPassesOverTheViewersSection) {
    const ScratchFolder folder;
    Document document{.input = "builtin:plane", .environment = "none"};
    document.bookmarks.push_back({"front", {0, 0, 3}, {0, 0, 0}, 20.0});
    const Stage stage = load_stage(document);
    save_scene(document, stage, folder / "scene.json");
    EXPECT_TRUE(rendered(folder / "scene.json").scene.warnings.empty());
    document.bookmarks.clear();
    EXPECT_EQ(scene_text(document, stage, folder / "x.json").find("viewer"), std::string::npos);
}

TEST(SavedScene, ABrokenSectionOfTheViewerIsNamed) {
    const auto refused = [](const std::string& text, const std::string& part) {
        const std::string line = error_line([&] { read_viewer_section(text, "s.json"); });
        EXPECT_EQ(line.find("s.json: viewer"), 0u) << line;
        EXPECT_NE(line.find(part), std::string::npos) << line;
    };
    refused(R"({"bookmark": []})", "did you mean 'bookmarks'?");
    refused(R"({"bookmarks": [{"name": "a", "position": [1, 2], "target": [0, 0, 0]}]})",
            "three numbers");
    refused(
        R"({"bookmarks": [{"name": "a", "position": [0,0,0], "target": [0,0,0], "fov_deg": 9}]})",
        "a place other than the target");
    refused(R"({"compare": {"mode": "splits"}})", "did you mean 'split'?");
    refused(R"({"compare": {"methods": ["none"]}})", "2 to 4 methods");
    refused(R"({"compare": {"gain": 1e9}})", "0.01 to 1000");
    EXPECT_TRUE(read_viewer_section("", "s.json").bookmarks.empty());
}

TEST(SavedScene, IsWrittenWholeOrNotAtAll) {
    const ScratchFolder folder;
    Document document{.input = "builtin:plane", .environment = "none"};
    const Stage stage = load_stage(document);
    folder.write("scene.json", "before");
    document.lights.emplace(1).front().color = glm::vec3(7.0f);
    error_line<UsageError>([&] { save_scene(document, stage, folder / "scene.json"); });
    std::ifstream file(folder / "scene.json");
    std::string text;
    std::getline(file, text);
    EXPECT_EQ(text, "before");
    document.lights.reset();
    error_line([&] { save_scene(document, stage, folder / "no folder/scene.json"); });
}

}  // namespace
}  // namespace burnish::viewer
