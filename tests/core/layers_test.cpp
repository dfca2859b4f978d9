// Includes go downwards only (docs/develop/architecture.md): the includes of our own headers in every file of
// src/, papers/, bench/frame/ and include/ are checked against what the layer of the file may include.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>

#include "support/paths.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

// From top to bottom: a layer may include itself and what its line names, which is what
// src/<layer>/CMakeLists.txt links.
using Layers = std::map<std::string, std::set<std::string>>;

Layers layers() {
    const Layers below = {
        {"core", {}},
        {"image", {"core"}},
        {"models", {"core"}},
        {"maps", {"image", "models"}},
        {"scene", {"maps"}},
        {"formats", {"scene"}},
        {"stage", {"formats"}},
        {"fit", {"scene"}},
        {"gpu", {"scene"}},
        {"capture", {"formats", "fit"}},
        {"plot", {"scene"}},
        {"export", {"formats", "fit"}},
        {"jobs", {"stage", "gpu", "capture", "plot", "export"}},
        {"frame", {"jobs"}},
        {"papers", {"frame"}},
        {"cli", {"papers"}},
    };
    Layers all;
    const std::function<void(const std::string&, std::set<std::string>&)> add =
        [&](const std::string& layer, std::set<std::string>& to) {
            to.insert(layer);
            for (const std::string& lower : below.at(layer)) add(lower, to);
        };
    for (const auto& [layer, lower] : below) add(layer, all[layer]);
    return all;
}

// The layer of each public header: it may include what that layer may, and only that layer and
// those above it may include it.
const std::map<std::string, std::string> kPublic = {
    {"api", "core"},    {"error", "core"},       {"progress", "core"},
    {"image", "image"}, {"f32", "core"},  // nothing but the text of shading/, which is below every layer
    {"f64", "core"},    {"conductor", "models"}, {"shading_names", "models"},
    {"mesh", "scene"},  {"parameters", "scene"}, {"render_settings", "scene"},
    {"scene", "scene"}, {"stage", "stage"},      {"render", "jobs"},
};

std::string layer_of_include(const std::string& folder, const std::string& name) {
    if (folder != "burnish") return folder == "bench" ? "frame" : folder;
    const auto found = kPublic.find(name.substr(0, name.find('.')));
    return found == kPublic.end() ? "" : found->second;
}

void check_includes(const fs::path& file, const std::string& layer) {
    static const std::regex include(R"(^\s*#include\s+\"([a-z]+)/([^\"]*)\")");
    static const Layers may_include = layers();
    ASSERT_TRUE(may_include.contains(layer)) << file;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, include) || match[1] == "shading") continue;
        const std::string of = layer_of_include(match[1], match[2]);
        EXPECT_TRUE(may_include.at(layer).contains(of))
            << file << " includes " << match[1] << "/" << match[2];
    }
}

bool is_source(const fs::path& path) {
    return path.extension() == ".cpp" || path.extension() == ".hpp";
}

TEST(Layers, IncludesGoDownwardsOnly) {
    const fs::path root = test::source_folder();
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(root / "src")) {
        if (!is_source(entry.path())) continue;
        ++files;
        check_includes(entry.path(), fs::relative(entry.path(), root / "src").begin()->string());
    }
    EXPECT_GT(files, 300);
    for (const char* folder : {"bench/frame", "papers"})
        for (const auto& entry : fs::directory_iterator(root / folder))
            if (is_source(entry.path()))
                check_includes(entry.path(), fs::path(folder).filename().string());
}

TEST(Layers, PublicHeadersGoDownwardsOnly) {
    for (const auto& entry : fs::directory_iterator(test::source_folder() / "include/burnish")) {
        const std::string name = entry.path().stem().string();
        ASSERT_TRUE(kPublic.contains(name)) << name << " has no layer";
        check_includes(entry.path(), kPublic.at(name));
    }
}

// A folder that a person can survey, a file that can be read at one sitting.
TEST(Layers, FoldersAndFilesStaySmall) {
    constexpr int kMostSources = 20, kMostLines = 550;
    const fs::path root = test::source_folder();
    std::map<fs::path, int> sources;
    for (const char* top : {"src", "papers", "bench", "include", "shading", "shaders", "tests"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
            const std::string extension = entry.path().extension().string();
            if (!is_source(entry.path()) && extension != ".glsl" && extension != ".frag") continue;
            std::ifstream in(entry.path());
            int lines = 0;
            for (std::string line; std::getline(in, line);) ++lines;
            EXPECT_LE(lines, kMostLines) << entry.path();
            if (extension == ".cpp" && std::string_view(top) != "tests")
                ++sources[entry.path().parent_path()];
        }
    }
    for (const auto& [folder, count] : sources) EXPECT_LE(count, kMostSources) << folder;
}

// shading/ includes nothing but itself, and its texts include nothing at all.
TEST(Layers, TheTextOfTheMathsIncludesNothing) {
    for (const auto& entry : fs::recursive_directory_iterator(test::source_folder() / "shading")) {
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
    for (const auto& entry : fs::recursive_directory_iterator(test::source_folder() / "shading")) {
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
