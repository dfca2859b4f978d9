// The values that come out of `mdf eval` and `brdf eval`, against closed forms. The wide
// comparison, all methods and edge cases, is tests/shading/oracle_test.cpp.
#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "jobs/models/eval.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

// The last `count` fields of every row after the header.
std::vector<std::vector<std::string>> added_fields(const std::string& table, std::size_t count) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(table);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::vector<std::string> fields(1);
        for (const char c : line) {
            if (c == ',') {
                fields.emplace_back();
            } else {
                fields.back() += c;
            }
        }
        rows.emplace_back(fields.end() - static_cast<std::ptrdiff_t>(count), fields.end());
    }
    return rows;
}

std::vector<std::vector<std::string>> eval(const std::string& verb, const std::string& table,
                                           std::size_t count,
                                           const std::string& precision = "f64") {
    const Outcome outcome = run_burnish(
        {verb, "eval", "--in", "-", "--out", "-", "--precision", precision}, {.input = table});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    return added_fields(outcome.output, count);
}

void expect_close(const std::string& found, double expected) {
    EXPECT_NEAR(std::stod(found), expected, 1e-12 * std::fabs(expected)) << found;
}

TEST(MdfEval, PeaksAreThePrefactors) {
    const auto rows = eval("mdf",
                           "mdf,p0,p1,method,nx,ny,nz,hx,hy,hz\n"
                           "ashikhmin-shirley,200,10,none,0,0,1,0,0,3\n"
                           "beckmann,.1,.4,none,0,0,1,0,0,1\n"
                           "ggx,.1,.4,none,0,0,1,0,0,1\n"
                           "ward,.1,.4,none,0,0,1,0,0,1\n",
                           3);
    ASSERT_EQ(rows.size(), 4U);
    expect_close(rows[0][0], std::sqrt(201.0 * 11.0) / (2 * kPi));
    expect_close(rows[0][1], std::sqrt(202.0 * 12.0) / (2 * kPi));
    expect_close(rows[1][0], 1 / (kPi * 0.04));
    expect_close(rows[2][1], 1 / (kPi * 0.04));
    EXPECT_EQ(rows[3][0], "1");
}

TEST(MdfEval, OffThePeak) {
    // h = (3, 4, 12) / 13 unperturbed: cos^2 phi = 9/25, tan^2 = 25/144.
    const auto rows = eval("mdf",
                           "mdf,p0,p1,method,nx,ny,nz,hx,hy,hz\n"
                           "ashikhmin-shirley,20,10,none,0,0,1,3,4,12\n"
                           "beckmann,.5,.4,none,0,0,1,3,4,12\n"
                           "ggx,.5,.4,none,0,0,1,3,4,12\n"
                           "ward,.5,.4,none,0,0,1,3,4,12\n",
                           3);
    ASSERT_EQ(rows.size(), 4U);
    const double z = 12.0 / 13, x2 = 9.0 / 169, y2 = 16.0 / 169;
    expect_close(rows[0][0],
                 std::sqrt(21.0 * 11.0) / (2 * kPi) * std::pow(z, (20 * 9.0 + 10 * 16.0) / 25));
    const double slopes = x2 / 0.25 + y2 / 0.16;
    expect_close(rows[1][0], std::exp(-slopes / (z * z)) / (kPi * 0.2 * z * z * z * z));
    expect_close(rows[2][0], 1 / (kPi * 0.2 * (slopes + z * z) * (slopes + z * z)));
    expect_close(rows[3][0], std::exp(-2 * slopes / (1 + z)));
}

TEST(MdfEval, ConservingFactorIsOfDeformSmoothOnly) {
    const std::string numbers = ",3,0,4,.3,.2,.9\n";  // |d|^2 = 0.36
    std::string table = "mdf,p0,p1,method,nx,ny,nz,hx,hy,hz\n";
    for (const char* method : {"deform-smooth", "deform-linear", "rotate-arc", "normal-map"}) {
        table += std::string("ggx,.3,.5,") + method + numbers;
    }
    const auto rows = eval("mdf", table, 3);
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_GT(std::stod(rows[0][1]), 0.0);
    expect_close(rows[0][2], std::stod(rows[0][1]) * (4 - 0.36) / (4 - 2 * 0.36));
    for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_EQ(rows[i][2], rows[i][1]);
}

TEST(MdfEval, SinglePrecisionPrintsFloats) {
    const std::string table =
        "mdf,p0,p1,method,nx,ny,nz,hx,hy,hz\n"
        "ggx,.3,.5,follow-grain,.2,.1,.9,.3,.2,.9\n"
        "ward,.3,.5,deform-smooth,.2,.1,.9,.3,.2,.9\n";
    const auto single = eval("mdf", table, 3, "f32"), full = eval("mdf", table, 3, "f64");
    ASSERT_EQ(single.size(), full.size());
    for (std::size_t row = 0; row < full.size(); ++row) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string& text = single[row][i];
            EXPECT_LE(text.size(), 11U) << text;  // 9 digits, a point, a leading zero
            float value = 0;
            std::from_chars(text.data(), text.data() + text.size(), value);
            std::array<char, 32> digits{};
            std::to_chars(digits.data(), digits.data() + digits.size(), value);
            EXPECT_EQ(text, digits.data()) << "not the shortest digits of a float";
            const double exact = std::stod(full[row][i]);
            EXPECT_NEAR(static_cast<double>(value), exact, 1e-5 * exact);
        }
    }
}

TEST(MdfEval, LengthsDoNotMatter) {
    const auto rows = eval("mdf",
                           "mdf,p0,p1,method,nx,ny,nz,hx,hy,hz\n"
                           "ggx,.3,.5,follow-grain,1,2,4,2,-1,8\n"
                           "ggx,.3,.5,follow-grain,1e300,2e300,4e300,2e-300,-1e-300,8e-300\n"
                           "ggx,.3,.5,follow-grain,1e-310,2e-310,4e-310,2,-1,8\n",
                           3);
    ASSERT_EQ(rows.size(), 3U);
    expect_close(rows[1][0], std::stod(rows[0][0]));
    expect_close(rows[2][0], std::stod(rows[0][0]));
}

TEST(BrdfEval, StraightDown) {
    // wi = wo = n: no shadowing, wi.h = 1, F = F0.
    const auto rows = eval("brdf",
                           "brdf,p0,p1,p2,p3,p4,ix,iy,iz,ox,oy,oz,mdf,smith\n"
                           "ashikhmin-shirley,200,10,.6,,,0,0,1,0,0,1,,\n"
                           "ward-gmd,.7,.1,.4,,,0,0,1,0,0,1,,\n"
                           "ggx,.1,.4,.6,,,0,0,1,0,0,1,,\n"
                           "ggx-separable,.1,.4,.6,,,0,0,1,0,0,1,,\n"
                           "beckmann,.1,.4,.6,,,0,0,1,0,0,1,,\n"
                           "microfacet,200,10,.6,,,0,0,1,0,0,1,ashikhmin-shirley,\n",
                           1);
    ASSERT_EQ(rows.size(), 6U);
    expect_close(rows[0][0], 0.6 * std::sqrt(201.0 * 11.0) / (8 * kPi));
    expect_close(rows[1][0], 0.7 / (4 * kPi * 0.04));
    for (std::size_t i = 2; i < 5; ++i) expect_close(rows[i][0], 0.6 / (4 * kPi * 0.04));
    expect_close(rows[5][0], 0.6 * std::sqrt(202.0 * 12.0) / (8 * kPi));
}

TEST(BrdfEval, MicrofacetTakesAnyDistribution) {
    const std::string head = "brdf,p0,p1,p2,ix,iy,iz,ox,oy,oz,mdf,smith\n";
    const std::string numbers = ",.2,.5,.1,.3,.1,.5,-.2,.2,.7,";
    const auto rows =
        eval("brdf",
             head + "ggx" + numbers + ",\n" + "microfacet" + numbers + "ggx,\n" + "microfacet" +
                 numbers + "ggx,correlated\n" + "ggx-separable" + numbers + ",\n" + "microfacet" +
                 numbers + "ggx,separable\n" + "beckmann" + numbers + ",\n" + "microfacet" +
                 numbers + "beckmann,\n",
             1);
    ASSERT_EQ(rows.size(), 7U);
    EXPECT_EQ(rows[0], rows[1]);
    EXPECT_EQ(rows[0], rows[2]);
    EXPECT_EQ(rows[3], rows[4]);
    EXPECT_EQ(rows[5], rows[6]);
    EXPECT_NE(rows[0], rows[3]);
    EXPECT_NE(rows[0], rows[5]);
}

TEST(BrdfEval, ReciprocalAndZeroBelow) {
    std::string table = "brdf,p0,p1,p2,ix,iy,iz,ox,oy,oz\n";
    const std::vector<std::string> models = {"ashikhmin-shirley,30,9,.2", "ward-gmd,.5,.2,.6",
                                             "ggx,.2,.6,.2", "ggx-separable,.2,.6,.2",
                                             "beckmann,.2,.6,.2"};
    for (const std::string& model : models) {
        table += model + ",.3,.1,.5,-.2,.2,.7\n" + model + ",-.2,.2,.7,.3,.1,.5\n" + model +
                 ",.3,.1,-.5,-.2,.2,.7\n" + model + ",.3,.1,.5,-.2,.2,-.1\n";
    }
    const auto rows = eval("brdf", table, 1);
    ASSERT_EQ(rows.size(), 4 * models.size());
    for (std::size_t i = 0; i < models.size(); ++i) {
        EXPECT_GT(std::stod(rows[4 * i][0]), 0.0) << models[i];
        expect_close(rows[4 * i + 1][0], std::stod(rows[4 * i][0]));
        EXPECT_EQ(rows[4 * i + 2][0], "0") << models[i];
        EXPECT_EQ(rows[4 * i + 3][0], "0") << models[i];
    }
}

TEST(BrdfEval, WhatIsMissingIsNamed) {
    const Folder folder;
    const auto complain = [&](const std::string& table, const std::vector<std::string>& parts) {
        const EvalRequest request{folder.write("in.csv", table), folder.path("out.csv")};
        expect_parts(refusal_of([&] { eval_brdf_table(request, Progress()); }), parts);
    };
    complain("brdf,p0,p1,ix,iy,iz,ox,oy,oz\nggx,.1,.2,0,0,1,0,0,1\n",
             {"in.csv: line 2, column p2", "F0 from 0 to 1", "found nothing"});
    complain("brdf,p0,p1,p2,ix,iy,iz,ox,oy,oz\nggx,.1,.2,,0,0,1,0,0,1\n", {"column p2"});
    complain("brdf,p0,p1,p2,ix,iy,iz,ox,oy,oz\nggx,.1,.2,1.1,0,0,1,0,0,1\n",
             {"column p2", "F0 from 0 to 1", "found \"1.1\""});
    complain("brdf,p0,p1,p2,ix,iy,iz,ox,oy,oz\nwardgmd,.1,.2,1,0,0,1,0,0,1\n",
             {"column brdf", "did you mean 'ward-gmd'?"});
    complain("brdf,p0,p1,p2,ix,iy,iz,ox,oy,oz\nmicrofacet,.1,.2,1,0,0,1,0,0,1\n",
             {"column mdf", "found nothing"});
    complain("brdf,p0,p1,p2,ix,iy,iz,ox,oy,oz,mdf,smith\nmicrofacet,.1,.2,1,0,0,1,0,0,1,ggx,x\n",
             {"column smith", "correlated separable"});
    complain("brdf,ix,iy,iz,ox,oy\n", {"a column named oz"});
}

}  // namespace
}  // namespace burnish::test
