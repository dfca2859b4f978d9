// The map of the tree. build/<preset>/layers.txt holds the layers that CMake links, a line each:
// "<layer>: <layers that it may include>". The includes of our own headers and the picture in the
// page on architecture are held against that list.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/paths.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

using Graph = std::map<std::string, std::set<std::string>>;  // from each node to those below it

Graph linked_layers() {
    std::ifstream in(test::build_folder() / "layers.txt");
    Graph graph;
    for (std::string line; std::getline(in, line);) {
        const std::size_t colon = line.find(':');
        if (colon == line.npos) continue;
        std::istringstream names(line.substr(colon + 1));
        std::set<std::string>& below = graph[line.substr(0, colon)];
        for (std::string name; names >> name;) below.insert(name);
    }
    return graph;
}

// The nodes of `graph` from top to bottom, each before all that lie below it; nodes of one height
// by name. Empty when the graph has a circle.
std::vector<std::string> from_top_to_bottom(Graph graph) {
    std::vector<std::string> order;
    while (!graph.empty()) {
        std::set<std::string> tops;
        for (const auto& [node, below] : graph) tops.insert(node);
        for (const auto& [node, below] : graph)
            for (const std::string& name : below) tops.erase(name);
        if (tops.empty()) return {};
        for (const std::string& node : tops) {
            order.push_back(node);
            graph.erase(node);
        }
    }
    return order;
}

// What each layer may include: itself and all that lie below it.
Graph may_include() {
    Graph all;
    const Graph linked = linked_layers();
    std::vector<std::string> order = from_top_to_bottom(linked);
    std::reverse(order.begin(), order.end());
    for (const std::string& layer : order) {
        all[layer] = {layer};
        for (const std::string& below : linked.at(layer))
            all[layer].insert(all[below].begin(), all[below].end());
    }
    return all;
}

// The picture of the page: a line a layer, from top to bottom, with the layers that it links.
std::string drawn(const Graph& graph) {
    std::string text;
    for (const std::string& layer : from_top_to_bottom(graph)) {
        std::string line = layer;
        if (!graph.at(layer).empty()) {
            line.resize(std::max<std::size_t>(line.size(), 8), ' ');
            line += " ->";
            for (const std::string& below : graph.at(layer)) line += " " + below;
        }
        text += line + "\n";
    }
    return text;
}

bool is_source(const fs::path& path) {
    return path.extension() == ".cpp" || path.extension() == ".hpp";
}

fs::path architecture_page() {
    const fs::path docs = test::source_folder() / "docs";
    const fs::path page = docs / "develop/architecture.md";
    return fs::exists(page) ? page : docs / "architecture.md";
}

// The block of a page that starts with a line of ``` and `kind`.
std::string block_of(const fs::path& page, const std::string& kind) {
    std::ifstream in(page);
    std::string text;
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        if (inside && line.starts_with("```")) break;
        if (inside) text += line + "\n";
        inside = inside || line == "```" + kind;
    }
    return text;
}

// The layer of each public header: it may include what that layer may, and only that layer and
// those above it may include it.
// f32 and f64 hold nothing but the text of shading/, which is below every layer.
const std::map<std::string, std::string> kPublic = {
    {"api", "core"},
    {"error", "core"},
    {"progress", "core"},
    {"trace_shard", "core"},
    {"version", "core"},
    {"f32", "core"},
    {"f64", "core"},
    {"image", "image"},
    {"image_io", "image"},
    {"display", "image"},
    {"compare", "image"},
    {"conductor", "models"},
    {"conductors", "models"},
    {"shading_names", "models"},
    {"mdf", "models"},
    {"brdf_models", "models"},
    {"scratch_settings", "maps"},
    {"scratch_maps", "maps"},
    {"draft", "maps"},
    {"weave_maps", "maps"},
    {"mesh", "scene"},
    {"parameters", "scene"},
    {"prepared_environment", "scene"},
    {"render_settings", "scene"},
    {"scene", "scene"},
    {"surface", "scene"},
    {"turntable", "scene"},
    {"ndf_grid", "scene"},
    {"tabulated_material", "scene"},
    {"builtin_meshes", "scene"},
    {"fit_tangents", "scene"},
    {"load_model", "formats"},
    {"environments", "formats"},
    {"scene_file", "formats"},
    {"tabulated_file", "formats"},
    {"rgl_material", "formats"},
    {"load_tabulated", "formats"},
    {"wif", "formats"},
    {"visibility", "scene"},
    {"stage", "stage"},
    {"layered_materials", "stage"},
    {"material_assets", "stage"},
    {"lobe_fit", "fit"},
    {"fit_models", "fit"},
    {"fit_brdf", "fit"},
    {"context", "gpu"},
    {"renderer", "gpu"},
    {"upload_counts", "gpu"},
    {"rig", "capture"},
    {"coverage", "capture"},
    {"relight", "capture"},
    {"virtual_ndf", "capture"},
    {"virtual_sample", "capture"},
    {"capture_fit", "capture"},
    {"plot/canvas", "plot"},
    {"plot/scale", "plot"},
    {"plot/color_map", "plot"},
    {"plot/panels", "plot"},
    {"plot/figure", "plot"},
    {"plot/mdf_plot", "plot"},
    {"plot/brdf_plot", "plot"},
    {"gltf_material", "export"},
    {"material_textures", "export"},
    {"render", "jobs"},
    {"trace", "jobs"},
};

std::string layer_of_include(const std::string& folder, const std::string& name) {
    if (folder != "burnish") return folder == "bench" ? "frame" : folder;
    const auto found = kPublic.find(name.substr(0, name.rfind('.')));
    return found == kPublic.end() ? "" : found->second;
}

void check_includes(const fs::path& file, const std::string& layer) {
    static const std::regex include(R"(^\s*#include\s+\"([a-z]+)/([^\"]*)\")");
    static const Graph allowed = may_include();
    ASSERT_TRUE(allowed.contains(layer)) << file;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, include) || match[1] == "shading") continue;
        const std::string of = layer_of_include(match[1], match[2]);
        EXPECT_TRUE(allowed.at(layer).contains(of))
            << file << " includes " << match[1] << "/" << match[2];
    }
}

TEST(Layers, HaveNoCircle) {
    const Graph linked = linked_layers();
    EXPECT_GE(linked.size(), 14u) << "layers.txt of the build folder";
    EXPECT_EQ(from_top_to_bottom(linked).size(), linked.size());
    EXPECT_TRUE(from_top_to_bottom({{"a", {"b"}}, {"b", {"a"}}}).empty());  // the test sees one
}

TEST(Layers, AreThoseOfThePage) {
    EXPECT_EQ(block_of(architecture_page(), "layers"), drawn(linked_layers()))
        << architecture_page() << ": the block that starts with ```layers";
}

// Sub-folders of a layer form no circle. Files that lie in the layer's own folder are the face of
// the whole layer and do not count.
TEST(Layers, FoldersOfALayerHaveNoCircle) {
    const std::regex include(R"(^\s*#include\s+\"([a-z]+)/([a-z]+)/[^\"]*\")");
    const fs::path root = test::source_folder() / "src";
    std::map<std::string, Graph> folders;  // by layer
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const fs::path path = fs::relative(entry.path(), root);
        if (!is_source(path) || std::distance(path.begin(), path.end()) < 3) continue;
        const std::string layer = path.begin()->string();
        const std::string folder = std::next(path.begin())->string();
        std::set<std::string>& below = folders[layer][folder];
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);) {
            std::smatch match;
            if (std::regex_search(line, match, include) && match[1] == layer && match[2] != folder)
                below.insert(match[2]);
        }
    }
    EXPECT_GE(folders.size(), 5u);
    for (const auto& [layer, graph] : folders) {
        std::string edges;
        for (const auto& [folder, below] : graph)
            for (const std::string& name : below) edges += folder + " -> " + name + "\n";
        EXPECT_EQ(from_top_to_bottom(graph).size(), graph.size()) << layer << ":\n" << edges;
    }
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
    const fs::path include = test::source_folder() / "include/burnish";
    for (const auto& entry : fs::recursive_directory_iterator(include)) {
        if (!entry.is_regular_file()) continue;
        const std::string name = fs::relative(entry.path(), include).replace_extension().string();
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
