// Files found by names of other machines.
#include "core/find_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "support/test_folder.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> kSubfolders = {"textures", "tex"};

class FindFile : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* name : {"model", "model/Tex", "model/scans", "beside"})
            fs::create_directory(folder_ / name);
        for (const char* name :
             {"secret.png", "beside/wood.png", "model/plain.png", "model/Wall.PNG",
              "model/Tex/Brick.tif", "model/scans/stone.jpg", "model/scans/stone.png"})
            folder_.write(name, "x");
    }

    FileFinder finder(bool may_leave = false) const {
        return FileFinder(folder_ / "model", {picture_endings(), kSubfolders, may_leave});
    }

    // "path below the model: difference", or "nothing".
    std::string found(std::string_view name, bool may_leave = false) const {
        const FoundFile file = finder(may_leave).find(name);
        if (!file) return "nothing";
        const std::string below =
            file.path.lexically_normal().lexically_relative(folder_ / "model").string();
        return file.is_exact() ? below : below + ": " + difference_of(file);
    }

    test::ScratchFolder folder_;
};

TEST_F(FindFile, AFileThatIsThereIsFoundWithoutADifference) {
    EXPECT_EQ(found("plain.png"), "plain.png");
    EXPECT_EQ(found("./plain.png"), "plain.png");
    EXPECT_EQ(found("Tex/Brick.tif"), "Tex/Brick.tif");
    EXPECT_EQ(found("scans/../plain.png"), "plain.png");
    EXPECT_EQ(found("\"plain.png\""), "plain.png");
    EXPECT_TRUE(finder().find("plain.png").is_exact());
}

TEST_F(FindFile, BackslashesSeparateFolders) {
    EXPECT_EQ(found("Tex\\Brick.tif"), "Tex/Brick.tif");
}

TEST_F(FindFile, OtherLetterCaseIsFoundInNamesAndFolders) {
    EXPECT_EQ(found("wall.png"), "Wall.PNG: other letter case");
    EXPECT_EQ(found("TEX/brick.TIF"), "Tex/Brick.tif: other letter case");
}

TEST_F(FindFile, TheSpellingThatIsWrittenGoesBeforeOthers) {
    folder_.write("model/plain.PNG", "y");
    EXPECT_EQ(found("plain.png"), "plain.png");
    EXPECT_EQ(found("plain.PNG"), "plain.PNG");
    // 'P' goes before 'p' in the order of bytes.
    EXPECT_EQ(found("Plain.Png"), "plain.PNG: other letter case");
}

TEST_F(FindFile, PathsOfAnotherMachineEndInTheFolder) {
    EXPECT_EQ(found("C:\\Users\\me\\model\\plain.png"), "plain.png: another folder");
    EXPECT_EQ(found("/home/me/scans/stone.jpg"), "scans/stone.jpg: another folder");
    EXPECT_EQ(found("../model/Tex/Brick.tif"), "Tex/Brick.tif: another folder");
    EXPECT_EQ(found("D:/x/WALL.png"), "Wall.PNG: another folder and other letter case");
}

TEST_F(FindFile, BareNamesAreFoundInTheUsualSubfolders) {
    EXPECT_EQ(found("Brick.tif"), "Tex/Brick.tif: another folder");
    EXPECT_EQ(found("stone.jpg"), "nothing") << "scans is no usual subfolder";
}

TEST_F(FindFile, AnotherEndingComesLastAndInTheGivenOrder) {
    EXPECT_EQ(found("plain.jpg"), "plain.png: another ending");
    EXPECT_EQ(found("plain"), "plain.png: another ending");
    EXPECT_EQ(found("wall.tga"), "Wall.PNG: other letter case and another ending");
    EXPECT_EQ(found("C:\\a\\brick.psd"),
              "Tex/Brick.tif: another folder, other letter case and another ending");
    EXPECT_EQ(found("scans/stone.psd"), "scans/stone.png: another ending");
    EXPECT_EQ(found("scans/stone.jpg"), "scans/stone.jpg");
}

TEST_F(FindFile, NothingOutsideTheFolderIsFoundUnlessAllowed) {
    EXPECT_EQ(found("../secret.png"), "nothing");
    EXPECT_EQ(found("../beside/wood.png"), "nothing");
    EXPECT_EQ(found((folder_ / "secret.png").string()), "nothing");
    EXPECT_EQ(found("Tex/../../secret.png"), "nothing");
    EXPECT_EQ(found("../secret.png", true), "../secret.png");
    EXPECT_EQ(found((folder_ / "beside/wood.png").string(), true), "../beside/wood.png");
}

TEST_F(FindFile, NamesThatAreNoPathsFindNothing) {
    for (const std::string& name :
         {std::string(), std::string("."), std::string(".."), std::string("/"), std::string("Tex"),
          std::string("Tex/"), std::string("plain.png/"), std::string("a\0b", 3),
          std::string(300, 'a'), std::string(100000, 'a'), std::string(4000, '/') + "x.png"})
        EXPECT_EQ(found(name), "nothing") << name.substr(0, 20);
    std::string deep;
    for (int i = 0; i < 1300; ++i) deep += "aa/";  // 3900 bytes, below the longest path
    EXPECT_EQ(found(deep + "plain.png"), "plain.png: another folder");
}

TEST_F(FindFile, NamesOfOldEncodingsAreComparedAsText) {
    folder_.write("model/K\xF6per.png", "x");        // Windows-1252
    folder_.write("model/Gew\xC3\xB6lbe.png", "x");  // UTF-8
    EXPECT_NE(found("K\xC3\xB6per.png"), "nothing");
    EXPECT_NE(found("Gew\xF6lbe.png"), "nothing");
    EXPECT_EQ(found("Gew\xC3\xB6lbe.png"), "Gew\xC3\xB6lbe.png");
}

TEST_F(FindFile, AFolderThatIsNotThereFindsNothing) {
    FileFinder finder(folder_ / "no such folder", {picture_endings(), kSubfolders});
    EXPECT_FALSE(finder.find("plain.png"));
}

TEST_F(FindFile, EndingsAreKeptWithoutAList) {
    FileFinder plain(folder_ / "model");
    EXPECT_TRUE(plain.find("wall.png"));
    EXPECT_FALSE(plain.find("plain.jpg"));
}

}  // namespace
}  // namespace burnish
