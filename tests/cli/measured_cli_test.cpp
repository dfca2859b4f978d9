// `brdf fit` and `info` on measured materials, as a person runs them.
#include <gtest/gtest.h>

#include <string>

#include "support/bsdf_writer.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

std::string material() {
    KnownMaterial made;
    made.normals = 48;
    return made.text();
}

TEST(BrdfFit, PrintsATableAndWritesOne) {
    const Folder folder;
    const std::string file = folder.write("made.bsdf", material());
    const Outcome outcome = run_burnish({"brdf", "fit", file, "--model", "ward,ggx", "--samples",
                                         "800", "-o", folder.path("fits.csv")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    for (const char* word : {"made by a test", "isotropic", "ggx", "ward", "alpha_x", "%"})
        EXPECT_NE(outcome.output.find(word), std::string::npos) << word;
    // Best first.
    EXPECT_LT(outcome.output.find("\n  ggx"), outcome.output.find("\n  ward"));
    const std::string csv = contents_of(folder.path("fits.csv"));
    EXPECT_NE(csv.find("brdf fit"), std::string::npos) << "the command";
    EXPECT_NE(csv.find("rms,1,ggx,"), std::string::npos) << csv;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"fits.csv", "made.bsdf"}));
}

// The columns p0..p4 go back into `brdf eval`.
TEST(BrdfFit, TheTableCanBeEvaluated) {
    const Folder folder;
    const std::string file = folder.write("made.bsdf", material());
    ASSERT_EQ(run_burnish({"brdf", "fit", file, "--model", "ggx,lafortune", "--samples", "400",
                           "-o", folder.path("fits.csv")})
                  .exit_code,
              0);
    std::string text = contents_of(folder.path("fits.csv"));
    std::string with_directions;
    bool header = true;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = text.find('\n', start);
        std::string line = text.substr(start, end - start);
        if (line[0] != '#') line += header ? ",ix,iy,iz,ox,oy,oz" : ",.1,0,1,-.2,.1,1";
        if (line[0] != '#') header = false;
        with_directions += line + '\n';
        start = end + 1;
    }
    const Outcome outcome =
        run_burnish({"brdf", "eval", "--in", "-", "--out", "-"}, {.input = with_directions});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
}

TEST(BrdfFit, MistakesAreOneLine) {
    const Folder folder;
    const std::string file = folder.write("made.bsdf", material());
    expect_complaint(run_burnish({"brdf", "fit", file, "--model", "gxg"}), 2, {"gxg", "ggx"});
    expect_complaint(run_burnish({"brdf", "fit", file, "--metric", "max"}), 2, {"max", "rms"});
    expect_complaint(run_burnish({"brdf", "fit", file, "-o", folder.path("a.txt")}), 2, {".csv"});
    expect_complaint(run_burnish({"brdf", "fit"}), 2, {"input"});
    const std::string text = folder.write("text.bsdf", "not a material");
    expect_complaint(run_burnish({"brdf", "fit", text}), 1, {"text.bsdf", "tensor_file"});
    const std::string cut = folder.write("cut.bsdf", material().substr(0, 5000));
    expect_complaint(run_burnish({"brdf", "fit", cut}), 1, {"cut.bsdf", "end of the file"});
}

TEST(Info, SaysWhatAMeasuredMaterialHolds) {
    const Folder folder;
    const Outcome outcome = run_burnish({"info", folder.write("made.bsdf", material())});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    for (const char* word : {"measured material", "made by a test", "isotropic", "0.0, 12.9",
                             "field vndf: float32, 1 x 8 x 48 x 48", "of the light at 45 degrees"})
        EXPECT_NE(outcome.output.find(word), std::string::npos) << word << outcome.output;
    const std::string other = folder.write("other", tensor_text({bytes_part("note", "hello")}));
    EXPECT_NE(run_burnish({"info", other}).output.find("field note: uint8, 5"), std::string::npos);
}

}  // namespace
}  // namespace burnish::test
