// burnish info of folders of maps, of their descriptions, and of pictures that are not read.
#include <gtest/gtest.h>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "jobs/info/info.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using namespace test;

void map(const std::filesystem::path& path) {
    write_image(path, Image(4, 4, 3, 0.5f), {});
}

TEST(InfoFolder, SaysWhatMapsIsTakenForWhat) {
    const ScratchFolder folder;
    map(folder / "x_Color.png");
    map(folder / "x_NormalDX.png");
    const std::string text = describe_file((folder / "").string());
    EXPECT_NE(text.find("--maps takes x_Color.png for the base color map"), text.npos) << text;
    EXPECT_NE(text.find("x_NormalDX.png for the DirectX normal map"), text.npos) << text;
}

TEST(InfoFolder, DescribesAMaterialByFolderAndByFile) {
    const ScratchFolder folder;
    map(folder / "base_color.png");
    const auto json = folder.write(
        "material.json",
        R"({"format": "burnish-material", "version": 1, "name": "worn gold", "size": [64, 32],
            "tile_mm": [20, 10], "made": {"command": ""},
            "maps": {"base_color": {"file": "base_color.png"}, "orm": {"file": "orm.png"}}})");
    for (const std::string& path : {(folder / "").string(), json.string()}) {
        const std::string text = describe_file(path);
        for (const char* part : {"worn gold", "64x32", "20 x 10 mm", "base_color.png for the base",
                                 "orm.png: material.json names this map"})
            EXPECT_NE(text.find(part), text.npos) << part << " in " << text;
    }
    folder.write("material.json", R"({"format": "burnish-material", "size": "large"})");
    EXPECT_NE(error_line([&] { describe_file(json.string()); }).find("size"), std::string::npos);
}

TEST(InfoFolder, NamesFoldersOfMapsInAFolderAndRefusesOthers) {
    const ScratchFolder folder;
    EXPECT_NE(error_line([&] { describe_file((folder / "").string()); }).find("none of these"),
              std::string::npos);
    std::filesystem::create_directory(folder / "rust");
    map(folder / "rust/rust_color.png");
    EXPECT_NE(describe_file((folder / "").string()).find("folders of maps: rust"),
              std::string::npos);
}

TEST(InfoFolder, PicturesThatAreNotReadSayWhatConvertsThem) {
    const ScratchFolder folder;
    const auto file = folder.write("x.ktx2", "\xabKTX 20\xbb\r\n\x1a\n............");
    EXPECT_NE(error_line([&] { describe_file(file.string()); }).find("ktx extract"),
              std::string::npos);
}

}  // namespace
}  // namespace burnish
