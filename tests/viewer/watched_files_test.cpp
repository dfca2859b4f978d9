// Files that a document names, and what happens to them on disk.
#include "viewer/document/watched_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "burnish/image_io.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/viewer_support.hpp"

namespace burnish::viewer {
namespace {

namespace fs = std::filesystem;
using test::ScratchFolder;
using test::two_materials;

TEST(WatchedFiles, AFileIsMissingUntilItIsBack) {
    const ScratchFolder folder;
    const std::string a = folder.write("a.glb", "a").string();
    const std::string b = folder.write("b.png", "b").string();
    WatchedFiles files;
    EXPECT_TRUE(files.look({a, b}).gone.empty());
    EXPECT_TRUE(files.missing().empty());
    fs::remove(a);
    WatchedFiles::Changes changes = files.look({a, b});
    EXPECT_EQ(changes.gone, std::vector<std::string>{a});
    EXPECT_FALSE(changes.changed);
    EXPECT_NE(line_of_missing(files.missing()).find("a.glb is gone from disk"), std::string::npos);
    EXPECT_TRUE(files.look({a, b}).gone.empty()) << "said once";
    EXPECT_EQ(files.missing(), std::vector<std::string>{a});
    folder.write("a.glb", "a");
    EXPECT_EQ(files.look({a, b}).back, std::vector<std::string>{a});
    EXPECT_TRUE(files.missing().empty());
    EXPECT_EQ(line_of_missing({}), "");
    // Another document is open.
    fs::remove(a);
    EXPECT_TRUE(files.look({b}).gone.empty());
    EXPECT_TRUE(files.missing().empty());
}

TEST(WatchedFiles, AnotherTimeIsAChangeAndANewNameIsNone) {
    const ScratchFolder folder;
    const std::string a = folder.write("a.glb", "a").string();
    const std::string b = folder.write("b.png", "b").string();
    WatchedFiles files;
    files.look({a});
    EXPECT_FALSE(files.look({a, b}).changed);
    fs::last_write_time(a, fs::last_write_time(a) + std::chrono::seconds(5));
    EXPECT_TRUE(files.look({a, b}).changed);
    EXPECT_FALSE(files.look({a, b}).changed);
}

TEST(WatchedFiles, AreThoseOfTheDocumentAndOfItsSceneFile) {
    const ScratchFolder folder;
    const std::string model = two_materials(folder, "two.glb").string();
    write_image(folder / "bumps.png", Image(4, 4, 3, 0.5f), {});
    write_image(folder / "color.png", Image(4, 4, 3, 0.5f), {});
    const std::string scene =
        folder
            .write("s.json", R"({"format": "burnish-scene", "version": 1, "environment": "none",
            "objects": [{"model": "two.glb"}], "parameters": {"normal_map": "bumps.png"}})")
            .string();
    Document document{.input = scene};
    set_parameter_text(document, "tabulated", "none");
    set_parameter_text(document, "base_color_map", (folder / "color.png").string(), 1);
    const std::vector<std::string> files = files_of(document, load_stage(document));
    std::vector<std::string> names;
    for (const std::string& file : files) {
        EXPECT_TRUE(fs::exists(file)) << file;
        names.push_back(fs::path(file).filename().string());
    }
    std::ranges::sort(names);
    EXPECT_EQ(names, (std::vector<std::string>{"bumps.png", "color.png", "s.json", "two.glb"}));
    EXPECT_TRUE(files_of({}, {}).empty());
}

}  // namespace
}  // namespace burnish::viewer
