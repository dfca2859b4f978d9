// The editor's stage is, after any way to a document, what loading that document gives.
#include "viewer/document/editor.hpp"

#include <gtest/gtest.h>

#include "burnish/image_io.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/random_documents.hpp"

namespace burnish::viewer {
namespace {

using test::error_line;
using test::expect_same_stage;
using test::RandomDocuments;
using test::ScratchFolder;
using test::two_materials;

TEST(Editor, RandomEditsGiveWhatLoadingGives) {
    RandomDocuments documents(182);
    Editor editor;
    editor.open(documents.next());
    for (int i = 0; i < 60; ++i) {
        Document document = documents.next();
        if (i % 3 != 0) {  // the same input, and every part either as before or new
            const Document& old = editor.document();
            document.input = old.input;
            if (i % 2 == 0) document.values = old.values;
            if (i % 5 == 0) document.material_values = old.material_values;
        }
        SCOPED_TRACE(i);
        try {
            editor.set(document);
        } catch (const Error&) {
            error_line([&] { load_stage(document); });
            continue;
        }
        const Stage fresh = load_stage(editor.document());
        expect_same_stage(editor.stage(), fresh);
        EXPECT_EQ(editor.stage().scene.warnings, fresh.scene.warnings);
        if (i % 7 == 0 && editor.undo()) {
            expect_same_stage(editor.stage(), load_stage(editor.document()));
            editor.redo();
        }
        if (testing::Test::HasFailure()) return;
    }
    while (editor.undo()) {
    }
    expect_same_stage(editor.stage(), load_stage(editor.document()));
}

class EditorOfTwo : public testing::Test {
  protected:
    void SetUp() override {
        Document document;
        document.input = two_materials(folder_, "two.glb", true, true).string();
        document.environment = "none";
        editor_.open(document);
    }

    // The counters that an edit moves, as letters.
    template <typename Edit>
    std::string moved_by(const Edit& edit) {
        const Revisions before = editor_.revisions();
        Document document = editor_.document();
        edit(document);
        editor_.set(document);
        const Revisions& after = editor_.revisions();
        std::string moved;
        if (after.scene != before.scene) moved += "S";
        if (after.geometry != before.geometry) moved += "g";
        if (after.materials != before.materials) moved += "m";
        if (after.textures != before.textures) moved += "t";
        if (after.lights != before.lights) moved += "l";
        if (after.environment != before.environment) moved += "e";
        if (after.camera != before.camera) moved += "c";
        if (after.settings != before.settings) moved += "s";
        if (after.display != before.display) moved += "d";
        return moved;
    }

    ScratchFolder folder_;
    Editor editor_;
};

TEST_F(EditorOfTwo, DoesAgainOnlyWhatDiffers) {
    EXPECT_EQ(moved_by([](Document& d) { set_parameter(d, "alpha_x", 0.2); }), "m");
    EXPECT_EQ(moved_by([](Document& d) { set_parameter(d, "alpha_x", 0.3, 1); }), "m");
    EXPECT_EQ(moved_by([](Document& d) { set_parameter_text(d, "normal_map", "builtin:bumps"); }),
              "mt");
    EXPECT_EQ(moved_by([](Document& d) { set_parameter(d, "exposure", 1.5); }), "d");
    EXPECT_EQ(moved_by([](Document& d) { set_parameter_text(d, "tone_map", "aces"); }), "d");
    EXPECT_EQ(moved_by([](Document& d) { set_parameter(d, "samples", 3); }), "s");
    EXPECT_EQ(moved_by([](Document& d) { set_parameter(d, "environment_rotation", 30.0); }), "s");
    EXPECT_EQ(moved_by([](Document& d) { set_camera(d, {1, 2, 3}, {0, 0, 0}, 30.0); }), "c");
    EXPECT_EQ(moved_by([](Document& d) { d.environment = "builtin:white"; }), "e");
    EXPECT_EQ(moved_by([](Document& d) { d.lights.emplace(); }), "l");
    EXPECT_EQ(moved_by([](Document& d) { d.hidden = {1}; }), "g");
    EXPECT_EQ(moved_by([](Document& d) { d.compare.gain = 2.0; }), "");
    EXPECT_EQ(moved_by([](Document& d) { d.bookmarks.push_back({"here"}); }), "");
    EXPECT_EQ(moved_by([](Document& d) { set_parameter(d, "triangles", 500); }), "Sgmtlecsd");
}

TEST_F(EditorOfTwo, AMaterialIsEditedAlone) {
    Document document = editor_.document();
    set_parameter(document, "alpha_x", 0.2);
    set_parameter(document, "alpha_y", 0.5, 1);
    editor_.set(document);
    const std::vector<Material>& materials = editor_.stage().scene.materials;
    EXPECT_EQ(stated_alpha(materials[0]), glm::vec2(0.2f, 0.2f));
    EXPECT_EQ(stated_alpha(materials[1]), glm::vec2(0.2f, 0.5f));
}

TEST_F(EditorOfTwo, HiddenPartsLeaveTheFramedCameraAndComeBack) {
    Document document = editor_.document();
    set_parameter(document, "camera_azimuth", 10.0);  // in place of the file's camera
    editor_.set(document);
    const Camera camera = editor_.stage().camera;
    const std::vector<Instance> shown = editor_.stage().scene.instances;
    document.hidden = {0, 2};
    editor_.set(document);
    EXPECT_EQ(editor_.stage().scene.instances[0].mesh, -1);
    EXPECT_EQ(editor_.stage().scene.instances[1].mesh, shown[1].mesh);
    EXPECT_TRUE(editor_.stage().camera == camera);
    editor_.undo();
    EXPECT_TRUE(editor_.stage().scene.instances == shown);
}

TEST_F(EditorOfTwo, AnEditThatThrowsLeavesEverythingAsItWas) {
    Document document = editor_.document();
    set_parameter_text(document, "normal_map", "builtin:bumps");
    document.hidden = {1};
    editor_.set(document);
    const Stage before = editor_.stage();
    const Revisions revisions = editor_.revisions();
    const auto refused = [&](auto edit) {
        Document other = document;
        // What could be done already must not be half done.
        set_parameter(other, "exposure", 3.0);
        set_parameter(other, "alpha_x", 0.7);
        other.hidden = {0};
        edit(other);
        error_line([&] { editor_.set(other); });
        expect_same_stage(editor_.stage(), before);
        EXPECT_EQ(editor_.stage().scene.textures.size(), before.scene.textures.size());
        EXPECT_EQ(editor_.stage().scene.warnings, before.scene.warnings);
        EXPECT_TRUE(editor_.revisions() == revisions);
        EXPECT_EQ(editor_.document(), document);
        EXPECT_EQ(editor_.history().undo_count(), 1u);
    };
    refused([&](Document& d) { d.environment = (folder_ / "missing.hdr").string(); });
    refused([&](Document& d) {
        set_parameter_text(d, "base_color_map", (folder_ / "missing.png").string());
    });
    refused([&](Document& d) { d.values.set_value("e_x", 3.0); });
    refused([&](Document& d) { set_parameter_text(d, "weave", "twil"); });
    refused([&](Document& d) {
        d.material_values[1].set_value("e_x", 3.0);
        d.material_values[1].set_value("alpha_x", 0.3);
    });
    refused([&](Document& d) { d.input = (folder_ / "missing.glb").string(); });
    refused([&](Document& d) { d.lights.emplace(1).front().intensity = -1.0f; });
    refused([&](Document& d) { d.values.set_value("camera_index", 7); });
    refused([&](Document& d) { d.compare.methods.clear(); });
    // One map is read before the other one fails.
    write_image(folder_ / "sound.png", Image(4, 4, 3, 0.5f), {});
    refused([&](Document& d) {
        set_parameter_text(d, "normal_map", (folder_ / "sound.png").string(), 0);
        set_parameter_text(d, "normal_map", (folder_ / "missing.png").string(), 1);
    });
}

TEST_F(EditorOfTwo, ADragIsOneStepAndUndoIsNamed) {
    for (int i = 1; i <= 30; ++i) {
        Document document = editor_.document();
        set_parameter(document, "alpha_x", 0.01 * i);
        editor_.set(document, "alpha_x", "alpha_x");
    }
    editor_.close_step();
    EXPECT_EQ(editor_.history().undo_count(), 1u);
    EXPECT_EQ(editor_.history().undo_name(), "alpha_x");
    EXPECT_TRUE(editor_.undo());
    EXPECT_FALSE(editor_.undo());
    EXPECT_TRUE(editor_.redo());
    EXPECT_EQ(editor_.document().values.real("alpha_x"), 0.3);
}

TEST_F(EditorOfTwo, WarningsOfTheLastChangeAreToldFromTheOthers) {
    Document document = editor_.document();
    set_parameter(document, "ks", 2.0);
    editor_.set(document);
    ASSERT_EQ(editor_.new_warnings().size(), 1u);
    EXPECT_EQ(editor_.new_warnings()[0].find("ks: "), 0u);
    set_parameter(document, "exposure", 2.0);
    editor_.set(document);
    EXPECT_TRUE(editor_.new_warnings().empty());
    EXPECT_FALSE(editor_.warnings().empty()) << "it is still true";
    unset_parameter(document, "ks");
    editor_.set(document);
    EXPECT_TRUE(editor_.warnings().empty());
}

TEST_F(EditorOfTwo, AnotherInputIsAStepToo) {
    const std::string two = editor_.document().input;
    const std::vector<Material> materials = editor_.stage().scene.materials;
    Document document;
    document.input = "builtin:plane";
    document.environment = "none";
    ASSERT_TRUE(needs_load(editor_.document(), document));
    editor_.set_loaded(document, load_stage(document), "open");
    EXPECT_EQ(editor_.stage().scene.materials.size(), 1u);
    EXPECT_TRUE(needs_load(editor_.document(), *editor_.history().undo_document()));
    EXPECT_TRUE(editor_.undo_loaded(load_stage(*editor_.history().undo_document())));
    EXPECT_EQ(editor_.document().input, two);
    EXPECT_TRUE(editor_.stage().scene.materials == materials);
    EXPECT_TRUE(editor_.redo());
    EXPECT_EQ(editor_.document().input, "builtin:plane");
}

TEST_F(EditorOfTwo, AFileThatChangedOnDiskIsReadAgain) {
    Document document = editor_.document();
    document.hidden = {2};
    set_parameter(document, "alpha_x", 0.4, 1);
    editor_.set(document);
    // Fewer parts than before: what belongs to a missing one is kept, and a line says so.
    std::filesystem::copy_file(two_materials(folder_, "other.glb"), document.input,
                               std::filesystem::copy_options::overwrite_existing);
    editor_.reload();
    EXPECT_TRUE(editor_.stage().scene.lights.empty());
    EXPECT_EQ(stated_alpha(editor_.stage().scene.materials[1]), glm::vec2(0.4f));
    document.hidden.insert(9);
    document.material_values[5].set_value("alpha_x", 0.1);
    editor_.set(document);
    ASSERT_EQ(editor_.new_warnings().size(), 2u);
    EXPECT_NE(editor_.new_warnings()[0].find("2 materials"), std::string::npos);
    EXPECT_NE(editor_.new_warnings()[1].find("#9"), std::string::npos);
    std::filesystem::remove(document.input);
    error_line([&] { editor_.reload(); });
    EXPECT_EQ(editor_.stage().scene.instances.size(), 3u) << "what was open stays";
}

TEST_F(EditorOfTwo, TwoHundredEditsAndUndosReadNoMapTwice) {
    write_image(folder_ / "a.png", Image(64, 64, 3, 0.5f), {});
    write_image(folder_ / "b.png", Image(64, 64, 3, 0.5f), {});
    const auto edit = [&](int i) {
        Document document = editor_.document();
        set_parameter_text(document, "normal_map",
                           (folder_ / (i % 2 == 0 ? "a.png" : "b.png")).string(), i % 2);
        set_parameter(document, "alpha_x", 0.01 + 0.001 * (i % 100));
        editor_.set(document);
    };
    edit(0);
    edit(1);
    const std::size_t textures = editor_.stage().scene.textures.size();
    const std::size_t meshes = editor_.stage().scene.meshes.size();
    for (int i = 0; i < 200; ++i) edit(i);
    while (editor_.undo()) {
    }
    while (editor_.redo()) {
    }
    EXPECT_EQ(editor_.stage().scene.textures.size(), textures);
    EXPECT_EQ(editor_.stage().scene.meshes.size(), meshes);
}

// A slider of heights names another map at every place of the slider.
TEST_F(EditorOfTwo, MapsThatAreLongUnusedAreFreedAndReadAgain) {
    write_image(folder_ / "h.png", Image(64, 64, 1, 0.5f), {});
    Document document = editor_.document();
    set_parameter_text(document, "height_map", (folder_ / "h.png").string());
    const auto used_bytes = [&] {
        std::size_t bytes = 0;
        for (const Texture& texture : editor_.stage().scene.textures)
            bytes += texture.texels.size();
        return bytes;
    };
    std::size_t most = 0, places = 0;
    for (int i = 0; i < 200; ++i) {
        set_parameter(document, "height_scale", 0.001 * (i + 1));
        editor_.set(document);
        const int texture = editor_.stage().scene.materials[0].normal_texture.texture;
        ASSERT_GE(texture, 0);
        EXPECT_FALSE(editor_.stage().scene.textures[static_cast<std::size_t>(texture)].empty());
        if (i == 2 * static_cast<int>(MaterialAssets::kMostUnused)) {
            most = used_bytes();
            places = editor_.stage().scene.textures.size();
        }
    }
    EXPECT_EQ(used_bytes(), most);
    EXPECT_EQ(editor_.stage().scene.textures.size(), places);
    EXPECT_FALSE(editor_.stage().materials.texture_changes().empty());
    for (int i = 0; i < 150; ++i) {
        editor_.undo();
        if (i % 30 == 0) expect_same_stage(editor_.stage(), load_stage(editor_.document()));
    }
    EXPECT_LE(used_bytes(), most);
    EXPECT_LE(editor_.stage().scene.textures.size(), places);
}

TEST(EditorAtFirst, IsEmptyAndTakesTheStateOfTheFile) {
    Editor editor;
    EXPECT_TRUE(editor.stage().scene.instances.empty());
    EXPECT_FALSE(editor.undo());
    editor.reload();
    error_line<UsageError>([&] { editor.open({}); });
    const ScratchFolder folder;
    two_materials(folder, "two.glb");
    Document document;
    document.environment = "none";
    document.input = folder
                         .write("scene.json", R"({"format": "burnish-scene", "version": 1,
        "objects": [{"model": "two.glb", "hidden": [2, 0]}],
        "viewer": {"compare": {"mode": "blink", "gain": 8}}})")
                         .string();
    editor.open(document);
    EXPECT_EQ(editor.document().hidden, (std::set<int>{0, 2}));
    EXPECT_EQ(editor.document().compare.mode, CompareMode::blink);
    EXPECT_EQ(editor.stage().scene.instances[1].mesh, editor.stage().shown_meshes[1]);
    EXPECT_EQ(editor.stage().scene.instances[2].mesh, -1);
    EXPECT_FALSE(editor.undo()) << "opening is where the history begins";
}

TEST(EditorAtFirst, LoadingReportsAndStops) {
    std::vector<std::string> stages;
    Document document;
    document.input = "builtin:plane";
    document.environment = "none";
    const CancelToken token;
    load_stage(document,
               Progress([&](std::string_view stage, double) { stages.emplace_back(stage); }));
    EXPECT_EQ(stages.front(), "model");
    token.cancel();
    Editor editor;
    EXPECT_THROW(editor.open(document, Progress(token)), Interrupted);
    EXPECT_TRUE(editor.document().input.empty());
}

}  // namespace
}  // namespace burnish::viewer
