// `brdf fit` and `info` on measured materials, as a person runs them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "core/constants.hpp"
#include "formats/bsdf/rgl_brdf.hpp"
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

TEST(BrdfFit, DrawsTheMeasurementBesideItsFits) {
    const Folder folder;
    const std::string file = folder.write("made.bsdf", material());
    const Outcome outcome = run_burnish({"brdf", "fit", file, "--model", "ward,ggx", "--samples",
                                         "400", "--plot", folder.path("fits.svg")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    const std::string svg = contents_of(folder.path("fits.svg"));
    for (const char* word : {"measured", "ggx", "ward", "light at", "brdf fit"})
        EXPECT_NE(svg.find(word), std::string::npos) << word;
    expect_complaint(run_burnish({"brdf", "fit", file, "--plot", folder.path("fits.jpg")}), 2,
                     {".png or .svg"});
}

// The material is f cos(theta_o) = color D(h) / (4 sigma(wi)), wi being the direction that the file
// calls incident. Evaluated from the formula here, at directions of the file's own grid.
TEST(BrdfEval, AMeasuredMaterialIsEvaluatedAsAModelIs) {
    const Folder folder;
    KnownMaterial made;
    made.normals = 128;
    const std::string file = folder.write("made.bsdf", made.text());
    std::string table = "brdf,p0,p1,p2,ix,iy,iz,ox,oy,oz\n";
    std::vector<std::array<double, 3>> expected;
    for (const std::size_t t : {1U, 3U, 5U}) {
        const double theta = made.theta(t);
        const Vector wi{-std::sin(theta), 0, std::cos(theta)};
        for (const double degrees : {5.0, 30.0, 50.0}) {
            const double to = degrees * kPi / 180;
            const Vector wo{std::sin(to) * 0.8, std::sin(to) * 0.6, std::cos(to)};
            Vector h{wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]};
            const double length = std::sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
            for (double& c : h) c /= length;
            const double f = made.surface.D(h) / (4 * made.surface.sigma(wi) * wo[2]);
            expected.push_back({0.8 * f, 0.5 * f, 0.2 * f});
            table += file;
            table += ",,,";
            for (const double c : wi) table += "," + std::to_string(c);
            for (const double c : wo) table += "," + std::to_string(c);
            table += '\n';
        }
    }
    table += "ggx,.3,.3,1,0,0,1,0,0,1\n";
    const Outcome outcome =
        run_burnish({"brdf", "eval", "--in", "-", "--out", "-", "--rgb"}, {.input = table});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    std::istringstream lines(outcome.output);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line.substr(line.size() - 14), ",f,f_r,f_g,f_b") << line;
    const auto added = [&] {
        std::getline(lines, line);
        std::array<double, 4> values{};
        std::size_t end = line.size();
        for (std::size_t k = 4; k-- > 0;) {
            const std::size_t comma = line.rfind(',', end - 1);
            values[k] = std::stod(line.substr(comma + 1, end - comma - 1));
            end = comma;
        }
        return values;
    };
    for (const std::array<double, 3>& rgb : expected) {
        const auto f = added();
        // 2 %: tables of 128 x 128 normals, between whose nodes the file is bilinear.
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(f[c + 1], rgb[c], 0.02 * rgb[c]) << line;
        EXPECT_NEAR(f[0], 0.2126 * f[1] + 0.7152 * f[2] + 0.0722 * f[3], 1e-3 * f[0]) << line;
    }
    const auto model = added();
    EXPECT_EQ(model[0], model[1]);
    EXPECT_EQ(model[0], model[3]);
    EXPECT_NEAR(model[0], 1 / (4 * kPi * 0.09), 1e-12);
}

// The same numbers as of the library: the light is the direction that the file calls incident.
TEST(BrdfEval, AMeasuredMaterialHasTheValuesOfTheLibrary) {
    const Folder folder;
    KnownMaterial made;
    made.normals = 48;
    made.color = [](double x, double y) { return std::array{0.2 + x, 0.9 * y, 0.1}; };
    const std::string file = folder.write("made.bsdf", made.text());
    const RglBrdf brdf = RglBrdf::load(file);
    const Direction<double> wi{0.48, 0.0, std::sqrt(1 - 0.48 * 0.48)};
    const Direction<double> wo{-0.28, 0.0, 0.96};
    const std::string row =
        fmt::format("{},{},{},{},{},{},{}\n", file, wi.x, wi.y, wi.z, wo.x, wo.y, wo.z);
    const auto last = [&](const char* precision) {
        const Outcome outcome = run_burnish(
            {"brdf", "eval", "--in", "-", "--out", "-", "--rgb", "--precision", precision},
            {.input = "brdf,ix,iy,iz,ox,oy,oz\n" + row + row});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
        std::string text = outcome.output.substr(0, outcome.output.size() - 1);
        return text.substr(text.rfind(row.substr(0, row.size() - 1)) + row.size());
    };
    const RglBrdf::Rgb f = brdf.eval(wo, wi);
    const double y = 0.2126 * f[0] + 0.7152 * f[1] + 0.0722 * f[2];
    const std::string found = last("f64");
    EXPECT_EQ(found.substr(found.find(',')), fmt::format(",{},{},{}", f[0], f[1], f[2]));
    EXPECT_NEAR(std::stod(found), y, 1e-4 * y);
    EXPECT_LE(last("f32").size(), 4 * 12U) << "digits of a float";
    EXPECT_GT(std::abs(f[0] - brdf.eval(wi, wo)[0]), 1e-3) << "the order of directions matters";
}

TEST(BrdfEval, AMeasuredMaterialThatCannotBeReadNamesItsRow) {
    const Folder folder;
    const std::string text = folder.write("text.bsdf", "not a material");
    const std::string header = "brdf,ix,iy,iz,ox,oy,oz\n";
    const auto run = [&](const std::string& name) {
        return run_burnish({"brdf", "eval", "--in", "-", "--out", "-"},
                           {.input = header + name + ",0,0,1,0,0,1\n"});
    };
    expect_complaint(run(text), 1, {"line 2", "column brdf", "tensor_file"});
    expect_complaint(run(folder.path("none.bsdf")), 1, {"line 2", "none.bsdf"});
}

TEST(BrdfPlot, DrawsMeasuredMaterialsOfEveryKind) {
    const Folder folder;
    const std::string file = folder.write("made.bsdf", material());
    for (const char* kind : {"polar", "surface", "albedo"}) {
        const std::string path = folder.path(std::string(kind) + ".svg");
        const Outcome outcome =
            run_burnish({"brdf", "plot", "--kind", kind, "--brdf", file + ",ggx", "-o", path});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
        const std::string svg = contents_of(path);
        EXPECT_NE(svg.find("made: measured"), std::string::npos) << kind;
        // Close to the horizon the tables hold f cos, not 0: f of them would set the scale.
        EXPECT_EQ(svg.find("leaves the plot"), std::string::npos) << kind;
    }
    expect_complaint(run_burnish({"brdf", "plot", "--brdf", folder.path("none.bsdf"), "-o",
                                  folder.path("x.svg")}),
                     1, {"none.bsdf"});
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
