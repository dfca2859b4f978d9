// burnish capture report as a person runs it: a page whose pictures are all there, what it says of
// lights that judge and of what is missing, refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>

#include "burnish/image_io.hpp"
#include "burnish/tabulated_file.hpp"
#include "burnish/tabulated_material.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

Outcome capture(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "capture");
    return run_burnish(arguments);
}

// A small capture of four classes and what a fit made of it, once for all tests.
class CaptureReport : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<Folder>();
        ASSERT_EQ(capture({"simulate", "classes", "-o", folder_->path("sample"), "--size", "12",
                           "--lights", "10x10"})
                      .exit_code,
                  0);
        const Outcome fit = capture({"fit", rig(), "-o", material(), "--eta", "1.5", "--hold-out",
                                     "10", "--exemplars", "6"});
        ASSERT_EQ(fit.exit_code, 0) << fit.complaint;
    }
    static void TearDownTestSuite() { folder_.reset(); }

    static std::string path(const std::string& name) { return folder_->path(name); }
    static std::string rig() { return path("sample/rig.json"); }
    static std::string material() { return path("material.exr"); }

  private:
    static std::unique_ptr<Folder> folder_;
};
std::unique_ptr<Folder> CaptureReport::folder_;

std::set<std::string> values_of(const std::string& page, const std::string& attribute) {
    std::set<std::string> values;
    const std::string key = " " + attribute + "=\"";
    for (std::size_t at = page.find(key); at != page.npos; at = page.find(key, at)) {
        at += key.size();
        values.insert(page.substr(at, page.find('"', at) - at));
    }
    return values;
}

// Every element that is opened is closed, in order.
void expect_well_formed(const std::string& page) {
    const std::set<std::string> kVoid = {"meta", "img", "br", "!doctype"};
    std::vector<std::string> open;
    for (std::size_t at = page.find('<'); at != page.npos; at = page.find('<', at)) {
        const std::size_t end = page.find('>', at);
        ASSERT_NE(end, page.npos);
        const std::string tag = page.substr(at + 1, end - at - 1);
        const std::string name = tag.substr(0, tag.find_first_of(" \n"));
        at = end;
        if (kVoid.count(name)) continue;
        if (name[0] != '/') {
            open.push_back(name);
            continue;
        }
        ASSERT_FALSE(open.empty()) << tag;
        EXPECT_EQ("/" + open.back(), name);
        open.pop_back();
    }
    EXPECT_TRUE(open.empty());
}

// The page's pictures are the folder's.
void expect_whole(const std::string& out, const std::string& page) {
    const std::set<std::string> sources = values_of(page, "src");
    EXPECT_EQ(sources, values_of(page, "href"));
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(out))
        files.insert(entry.path().filename().string());
    std::set<std::string> expected = sources;
    expected.insert("index.html");
    EXPECT_EQ(files, expected);
    for (const std::string& name : sources)
        EXPECT_GT(read_image(out + "/" + name).width, 64) << name;
}

bool holds(const std::string& page, const std::string& words) {
    return page.find(words) != page.npos;
}

TEST_F(CaptureReport, IsAPageWhoseFilesAreAllThere) {
    const std::string out = path("report");
    const Outcome outcome = capture({"report", material(), "--stack", rig(), "-o", out});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_EQ(outcome.complaint, "");
    EXPECT_EQ(outcome.output, out + "/index.html\n");
    const std::string page = contents_of(out + "/index.html");
    expect_well_formed(page);
    expect_whole(out, page);
    EXPECT_FALSE(holds(page, "<script"));
    EXPECT_FALSE(holds(page, "://"));
    EXPECT_TRUE(holds(page, "Judged on 10 of 100 lights, which took no part in the fit"));
    for (const char* word : {"brightest light", "median light", "dimmest light", "12 x 12 pixels",
                             "Ward, isotropic", "narrowest lobe", "taken as flat"})
        EXPECT_TRUE(holds(page, word)) << word;
}

// Largest difference of two pictures of the same size, in codes of 8 bits.
double codes_apart(const std::string& a, const std::string& b) {
    const Image x = read_image(a, {.as_data = true}), y = read_image(b, {.as_data = true});
    EXPECT_EQ(x.pixels.size(), y.pixels.size());
    double most = 0.0;
    for (std::size_t i = 0; i < std::min(x.pixels.size(), y.pixels.size()); ++i)
        most = std::max(most, 255.0 * std::abs(static_cast<double>(x.pixels[i] - y.pixels[i])));
    return most;
}

// A stack that is the material's own pictures is foretold by it, and not by Ward's model.
TEST_F(CaptureReport, ShowsThePicturesOfAStackAsTheyAre) {
    ASSERT_EQ(capture({"relight", material(), "--rig", rig(), "-o", path("relit")}).exit_code, 0);
    const std::string out = path("relit report");
    const Outcome outcome = capture({"report", material(), "--stack", path("relit/rig.json"), "-o",
                                     out, "--render", "builtin:plane"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    for (const char* rank : {"brightest", "median", "dimmest"}) {
        const std::string light = out + "/light_" + rank;
        // Samples of the stack are kept in steps that are finer than half a code.
        EXPECT_LE(codes_apart(light + "_real.png", light + "_tabulated.png"), 1.01) << rank;
        EXPECT_GT(codes_apart(light + "_real.png", light + "_ward-isotropic.png"), 20.0) << rank;
    }
}

TEST_F(CaptureReport, SaysWhatIsMissing) {
    TabulatedMaterial m = read_tabulated_material(material());
    m.maps.clear();
    m.metadata.clear();
    m.exemplar[0] = TabulatedMaterial::kNoExemplar;
    write_tabulated_material(path("bare.exr"), m);
    const std::string out = path("bare report");
    const Outcome outcome = capture(
        {"report", path("bare.exr"), "--stack", rig(), "-o", out, "--render", "builtin:plane"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    const std::string page = contents_of(out + "/index.html");
    expect_well_formed(page);
    expect_whole(out, page);
    EXPECT_TRUE(holds(page, "has no maps of ward-isotropic, ward, ggx, ashikhmin-shirley"));
    EXPECT_TRUE(holds(page, "no map of what the fit left unexplained"));
    EXPECT_TRUE(holds(page, "10 of 100 lights, which took part in the fit"));
    EXPECT_FALSE(holds(page, "Ward, isotropic</th>"));
    const Outcome asked = capture({"report", path("bare.exr"), "--stack", rig(), "-o", out,
                                   "--render", "builtin:plane", "--hold-out", "20"});
    ASSERT_EQ(asked.exit_code, 0) << asked.complaint;
    EXPECT_TRUE(holds(contents_of(out + "/index.html"),
                      "Judged on 5 of 100 lights, every 20th, as was asked for; the material"));
}

TEST_F(CaptureReport, RefusesInOneLineAndLeavesNothing) {
    const std::string out = path("refused");
    ASSERT_EQ(
        capture({"simulate", "classes", "-o", path("other"), "--size", "8", "--lights", "10x10"})
            .exit_code,
        0);
    expect_complaint(capture({"report", material(), "--stack", path("other/rig.json"), "-o", out}),
                     1, {"12 x 12 pixels", "8 x 8"});
    expect_complaint(
        capture({"report", material(), "--stack", rig(), "-o", out, "--hold-out", "900"}), 1,
        {"lights", "more than 450", "100"});
    expect_complaint(
        capture({"report", material(), "--stack", rig(), "-o", out, "--render", path("none.glb")}),
        1, {"none.glb"});
    EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace burnish::test
