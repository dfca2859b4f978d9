// Includes go downwards only (docs/architecture.md): every file of src/ is read and its includes of
// our own headers are checked against what its layer may include.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace burnish {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"core", {"core"}},
    {"shading", {"shading", "core"}},
    {"maps", {"maps", "core", "shading"}},
    {"scene", {"scene", "maps", "core", "shading"}},
    {"gpu", {"gpu", "scene", "maps", "core", "shading"}},
    {"capture", {"capture", "scene", "maps", "core", "shading"}},
    {"plot", {"plot", "scene", "maps", "core", "shading"}},
    {"app", {"app", "plot", "gpu", "capture", "scene", "maps", "core", "shading"}},
    {"cli", {"cli", "app", "plot", "gpu", "capture", "scene", "maps", "core", "shading"}},
};

TEST(Layers, IncludesGoDownwardsOnly) {
    const fs::path source = fs::path(BURNISH_SOURCE_DIR) / "src";
    const std::regex include(R"(^\s*#include\s+\"([a-z]+)/[^\"]*\")");
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(source)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".cpp" && extension != ".hpp") continue;
        ++files;
        const std::string layer = fs::relative(entry.path(), source).begin()->string();
        ASSERT_TRUE(kMayInclude.contains(layer)) << entry.path();
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);) {
            std::smatch match;
            if (!std::regex_search(line, match, include) || match[1] == "burnish") continue;
            EXPECT_TRUE(kMayInclude.at(layer).contains(match[1]))
                << entry.path() << " includes " << match[1] << "/";
        }
    }
    EXPECT_GT(files, 40);
}

// shading/ includes nothing but itself, and its texts include nothing at all.
TEST(Layers, TheTextOfTheMathsIncludesNothing) {
    for (const auto& entry : fs::directory_iterator(fs::path(BURNISH_SOURCE_DIR) / "shading")) {
        if (entry.path().extension() != ".glsl") continue;
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);)
            EXPECT_EQ(line.find("#include"), std::string::npos) << entry.path();
    }
}

// The dialect has no bare floating-point literals, but in CONSTANT, and no swizzles in the shared
// texts.
TEST(Layers, TheTextOfTheMathsKeepsToItsDialect) {
    const std::regex bare(R"((^|[^A-Za-z0-9_.(])[0-9]+\.[0-9]*)");
    const std::regex swizzle(R"(\.(xy|xz|yz|xyz|zyx|yx|rgb)\b)");
    const std::regex in_out(R"(\binout\b)");
    const std::regex constant(R"(^CONSTANT\(\w+, [0-9.e-]+\))");
    for (const auto& entry : fs::directory_iterator(fs::path(BURNISH_SOURCE_DIR) / "shading")) {
        if (entry.path().extension() != ".glsl" || entry.path().stem() == "prelude") continue;
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);) {
            const std::string code =
                std::regex_replace(line.substr(0, line.find("//")), constant, "");
            EXPECT_FALSE(std::regex_search(code, bare)) << entry.path() << ": " << line;
            EXPECT_FALSE(std::regex_search(code, swizzle)) << entry.path() << ": " << line;
            EXPECT_FALSE(std::regex_search(code, in_out)) << entry.path() << ": " << line;
        }
    }
}

}  // namespace
}  // namespace burnish
