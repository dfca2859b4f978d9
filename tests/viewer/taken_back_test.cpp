// What a file that is put onto a material takes back is said, with the reason.
#include "viewer/document/taken_back.hpp"

#include <gtest/gtest.h>

#include "burnish/image_io.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/document/open_files.hpp"
#include "viewer/viewer_support.hpp"

namespace burnish::viewer {
namespace {

using test::ScratchFolder;
using test::two_materials;

class TakenBack : public testing::Test {
  protected:
    TakenBack() {
        std::filesystem::create_directories(folder_ / "rust");
        write_image(folder_ / "rust/rust_Color.png", Image(4, 4, 3, 0.5f), {});
        write_image(folder_ / "rust_normal.png", Image(4, 4, 3, 0.5f), {});
    }
    std::string line(const Document& before, const std::string& file,
                     std::optional<int> material = std::nullopt) {
        const Document after = opened(before, (folder_ / file).string(), material);
        return line_of_taken_back(load_stage(before).materials.values(),
                                  load_stage(after).materials.values());
    }
    ScratchFolder folder_;
};

TEST_F(TakenBack, AFolderOfMapsTakesMetalAndScratchesBackInEveryLayer) {
    Document document{.input = two_materials(folder_, "two.glb").string(), .environment = "none"};
    EXPECT_EQ(line(document, "rust"), "") << "nothing was set";
    set_parameter_text(document, "metal", "copper");
    set_parameter_text(document, "scratch", "fine-random");
    set_parameter_text(document, "scratch_direction", "follow");
    const std::string expected =
        "metal and scratch were taken back: a folder of maps is a whole material (Ctrl+Z brings "
        "them back)";
    EXPECT_EQ(line(document, "rust"), expected);
    EXPECT_EQ(line(document, "rust", 1), expected) << "from the layer below";
    Document own{.input = document.input, .environment = "none"};
    set_parameter_text(own, "metal", "copper", 1);
    EXPECT_EQ(line(own, "rust", 1),
              "metal was taken back: a folder of maps is a whole material (Ctrl+Z brings it back)");
    EXPECT_EQ(line(own, "rust", 0), "") << "the other material keeps its metal";
}

TEST_F(TakenBack, ANormalMapTakesScratchesBackAndNothingElse) {
    Document document{.input = "builtin:plane", .environment = "none"};
    set_parameter_text(document, "metal", "copper");
    set_parameter_text(document, "scratch", "fine-random");
    EXPECT_TRUE(line(document, "rust_normal.png").starts_with("scratch was taken back: a normal"));
    unset_parameter(document, "scratch");
    EXPECT_EQ(line(document, "rust_normal.png"), "");
}

}  // namespace
}  // namespace burnish::viewer
