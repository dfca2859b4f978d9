// The pages of docs/ and those at the top of the tree: links, anchors, names of files, line
// lengths, and that the site's contents (mkdocs.yml) name every page.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "markdown.hpp"
#include "support/paths.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = source_folder();

// Names of the pages of docs/, spelled so that this file names none itself.
const std::string kDocs = "docs" + std::string("/");

std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    if (!fs::is_directory(folder)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<Page> pages() {
    std::vector<Page> all;
    for (const char* name : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"})
        all.push_back(read_page(kRoot / name));
    for (const fs::path& file : files_below(kRoot / "docs"))
        if (file.extension() == ".md") all.push_back(read_page(file));
    return all;
}

// One line a fault.
void expect_none(const std::vector<std::string>& faults) {
    std::string list;
    for (const std::string& fault : faults) list += "\n  " + fault;
    EXPECT_TRUE(faults.empty()) << list;
}

std::string place(const Page& page, int line) {
    return fs::relative(page.file, kRoot).string() + ":" + std::to_string(line);
}

// "" when the link leads somewhere.
std::string fault_of_link(const fs::path& folder, const fs::path& self, const std::string& target) {
    const std::size_t hash = target.find('#');
    const std::string name = target.substr(0, hash);
    const fs::path file = name.empty() ? self : folder / name;
    if (!fs::exists(file)) return "no such file";
    if (hash == std::string::npos) return "";
    const std::string anchor = target.substr(hash + 1);
    for (const std::string& heading : headings_of(read_page(file))) {
        const bool github = github_anchor(heading) == anchor;
        const bool mkdocs = mkdocs_anchor(heading) == anchor;
        if (github && mkdocs) return "";
        if (github || mkdocs) return "an anchor that GitHub and mkdocs spell differently";
    }
    return "no such heading";
}

TEST(Pages, RelativeLinksAndAnchorsLeadSomewhere) {
    int links = 0;
    std::vector<std::string> faults;
    for (const Page& page : pages()) {
        for (const PageLine& line : page.prose) {
            for (const std::string& target : links_of(line.text)) {
                if (target.find("://") != std::string::npos) continue;
                ++links;
                const std::string fault = fault_of_link(page.file.parent_path(), page.file, target);
                if (!fault.empty())
                    faults.push_back(place(page, line.number) + ": " + target + ": " + fault);
            }
        }
    }
    expect_none(faults);
    EXPECT_GT(links, 100);
}

TEST(Pages, TheTestSeesABrokenLink) {
    const fs::path docs = kRoot / "docs";
    EXPECT_EQ(fault_of_link(docs, docs / "index.md", "guide/render.md#camera"), "");
    EXPECT_EQ(fault_of_link(docs, docs / "index.md", "guide/rendering.md"), "no such file");
    EXPECT_EQ(fault_of_link(docs, docs / "index.md", "guide/render.md#kamera"), "no such heading");
    EXPECT_EQ(links_of("see [a](b.md), `[c](d.md)` and ![e](f.png)"),
              (std::vector<std::string>{"b.md", "f.png"}));
}

// Comments, messages and help texts name pages from the root of the tree.
TEST(Pages, PagesNamedInTheTreeExist) {
    const std::regex named("\\b" + kDocs + R"([A-Za-z0-9_/-]+\.(md|jpg|png))");
    const std::set<std::string> text = {".cpp", ".hpp", ".inc",   ".glsl", ".vert", ".frag", ".sh",
                                        ".py",  ".txt", ".cmake", ".md",   ".json", ".in",   ""};
    std::vector<fs::path> files;
    for (const char* folder : {"src", "shading", "shaders", "include", "tests", "scripts",
                               "examples", "bench", "papers", "cmake", "docs"})
        for (const fs::path& file : files_below(kRoot / folder))
            if (text.contains(file.extension().string())) files.push_back(file);
    for (const char* name : {"CMakeLists.txt", "CMakePresets.json", "Makefile", "README.md",
                             "CONTRIBUTING.md", "CHANGELOG.md"})
        files.push_back(kRoot / name);
    int names = 0;
    std::vector<std::string> faults;
    for (const fs::path& file : files) {
        // Results are history: they name the pages of their time.
        if (file.string().find("bench/results") != std::string::npos) continue;
        std::ifstream in(file);
        std::string line;
        for (int number = 1; std::getline(in, line); ++number) {
            for (std::sregex_iterator at(line.begin(), line.end(), named), end; at != end; ++at) {
                ++names;
                if (!fs::exists(kRoot / at->str()))
                    faults.push_back(fs::relative(file, kRoot).string() + ":" +
                                     std::to_string(number) + ": " + at->str());
            }
        }
    }
    expect_none(faults);
    EXPECT_GT(names, 50);
}

// `src/core`, `bench/results/...` and the like in the pages.
TEST(Pages, FilesOfTheTreeNamedInThePagesExist) {
    const std::regex path(
        R"((src|shading|shaders|include|tests|scripts|examples|bench|papers|cmake)/[A-Za-z0-9_./-]*)");
    std::vector<std::string> faults;
    for (const Page& page : pages()) {
        if (page.file.filename() == "CHANGELOG.md") continue;  // history
        for (const PageLine& line : page.prose) {
            for (const std::string& span : code_spans_of(line.text)) {
                if (!std::regex_match(span, path)) continue;
                if (!fs::exists(kRoot / span))
                    faults.push_back(place(page, line.number) + ": " + span);
            }
        }
    }
    expect_none(faults);
}

TEST(Pages, LinesAreAtMost120ColumnsButForTablesAndUrls) {
    std::vector<std::string> faults;
    for (const Page& page : pages()) {
        for (const PageLine& line : page.prose) {
            const std::size_t start = line.text.find_first_not_of(' ');
            const bool table = start != std::string::npos && line.text[start] == '|';
            const bool picture = line.text.starts_with("![");
            const bool url = line.text.find("://") != std::string::npos;
            if (table || picture || url) continue;
            if (columns_of(line.text) > 120) faults.push_back(place(page, line.number));
        }
    }
    expect_none(faults);
}

// A formula that was wrapped before its minus sign would become a list.
TEST(Pages, NoLineInsideAParagraphStartsLikeAList) {
    const std::regex item(R"(\s*([-*+]|[0-9]+\.)\s.*)");
    std::vector<std::string> faults;
    for (const Page& page : pages()) {
        for (std::size_t i = 1; i < page.prose.size(); ++i) {
            const std::string& before = page.prose[i - 1].text;
            const bool adjacent = page.prose[i - 1].number + 1 == page.prose[i].number;
            const bool in_list = std::regex_match(before, item) || before.starts_with("  ");
            const bool blank = before.find_first_not_of(' ') == std::string::npos;
            if (adjacent && !in_list && !blank && std::regex_match(page.prose[i].text, item))
                faults.push_back(place(page, page.prose[i].number));
        }
    }
    expect_none(faults);
}

// A code span that goes on in the next line is set with the break in it.
TEST(Pages, CodeSpansEndOnTheirLine) {
    std::vector<std::string> faults;
    for (const Page& page : pages())
        for (const PageLine& line : page.prose)
            if (std::count(line.text.begin(), line.text.end(), '`') % 2 != 0 &&
                page.file.filename() != "CHANGELOG.md")
                faults.push_back(place(page, line.number));
    expect_none(faults);
}

// The segments of a JPEG file before its picture: names of tables, sizes, the file type, and Adobe's.
// Others hold texts about the machine and the command that made it.
TEST(Pages, PicturesCarryNoMetadata) {
    int pictures = 0;
    for (const fs::path& file : files_below(kRoot / "docs")) {
        if (file.extension() != ".jpg") continue;
        ++pictures;
        std::ifstream stream(file, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        const auto byte = [&](std::size_t i) {
            return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0xda;
        };
        for (std::size_t i = 2; byte(i + 1) != 0xda; i += 2 + 256u * byte(i + 2) + byte(i + 3)) {
            const int marker = byte(i + 1);
            const bool text = marker == 0xfe || (marker > 0xe0 && marker <= 0xef && marker != 0xee);
            EXPECT_FALSE(text) << file << " has the segment " << std::hex << marker;
        }
    }
    EXPECT_GT(pictures, 0);
}

TEST(Pages, TheContentsOfTheSiteNameEveryPage) {
    std::ifstream in(kRoot / "mkdocs.yml");
    const std::string contents(std::istreambuf_iterator<char>(in), {});
    std::set<std::string> named;
    const std::regex page(R"([a-z][a-z0-9_/-]*\.md)");
    for (std::sregex_iterator at(contents.begin(), contents.end(), page), end; at != end; ++at)
        named.insert(at->str());
    std::set<std::string> there;
    for (const fs::path& file : files_below(kRoot / "docs"))
        if (file.extension() == ".md")
            there.insert(fs::relative(file, kRoot / "docs").generic_string());
    EXPECT_EQ(named, there);
}

}  // namespace
}  // namespace burnish::test
