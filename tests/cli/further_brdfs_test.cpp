// `burnish brdf eval` in double against the oracle (tests/oracle/further_brdfs.hpp): the models
// beyond the microfacet ones and ggx-separable, on random and edge cases.
#include "further_brdfs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "make_cases.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

using oracle::BrdfCase;

// How many of the five parameters a model has; the others stay empty in the table.
std::size_t parameter_count(const std::string& brdf) {
    if (brdf == "phong" || brdf == "ashikhmin-shirley-diffuse") return 2;
    return brdf == "lafortune" ? 5 : 3;
}

std::string digits(long double v) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", static_cast<double>(v));  // every double, exactly
    return text;
}

std::string row_of(const BrdfCase& c) {
    std::string row = c.brdf;
    for (std::size_t k = 0; k < c.p.size(); ++k) {
        row += "," + (k < parameter_count(c.brdf) ? digits(c.p[k]) : std::string());
    }
    for (const oracle::Vec3 v : {c.i, c.o}) {
        row += "," + digits(v.x) + "," + digits(v.y) + "," + digits(v.z);
    }
    return row;
}

// The last field of every row of the table that `burnish brdf eval` makes of the cases.
std::vector<double> evaluated(const std::vector<BrdfCase>& cases) {
    std::string table = "brdf,p0,p1,p2,p3,p4,ix,iy,iz,ox,oy,oz\n";
    for (const BrdfCase& c : cases) table += row_of(c) + "\n";
    const Folder folder;
    const std::string in = folder.write("cases.csv", table);
    const std::string out = folder.path("values.csv");
    const Outcome outcome =
        run_burnish({"brdf", "eval", "--in", in, "--out", out, "--precision", "f64"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    if (outcome.exit_code != 0) return {};
    std::istringstream lines(contents_of(out));
    std::string line;
    std::getline(lines, line);
    std::vector<double> values;
    while (std::getline(lines, line)) {
        values.push_back(std::strtod(line.substr(line.rfind(',') + 1).c_str(), nullptr));
    }
    return values;
}

// The table of the shadowing integral is promised to 1e-5; everything else to nine digits.
double promised(const std::string& brdf) {
    return brdf == "ashikhmin-premoze-shirley" ? 1e-5 : 1e-9;
}

bool has_fresnel(const std::string& brdf) {
    return brdf == "cook-torrance" || brdf == "ggx-separable" || brdf == "he";
}

// With F0 = 0 nothing but (1 - i.h)^5 is left. i.h near 1 is known to an ulp or two, so that
// Schlick's term is known to 5 (1 - i.h)^4 times that.
double fresnel_slack(BrdfCase c) {
    constexpr long double kTwoUlps = 4.5e-16L;
    const oracle::Vec3 i = oracle::normalize(c.i);
    const long double cosine = oracle::dot(i, oracle::normalize(i + oracle::normalize(c.o)));
    c.p[2] = 1;
    const long double white = oracle::brdf_eval(c.brdf, c.p, c.i, c.o);
    return static_cast<double>(white * 5 * powl(1 - cosine, 4) * kTwoUlps);
}

// What rounding the inputs alone does to the value: large where a power or an exponential is far
// down its flank, and at the edges where a clamp sets in. Not for ashikhmin-premoze-shirley: at
// 1e-5 no rounding of inputs counts, and every step would cost two integrals.
double slack_of(const BrdfCase& c) {
    constexpr long double kEpsilon = 1.2e-16L;
    if (c.brdf == "ashikhmin-premoze-shirley") return 0;
    const long double wobble = 4 * oracle::brdf_wobble(c.brdf, c.p, c.i, c.o, kEpsilon);
    return static_cast<double>(wobble) + (has_fresnel(c.brdf) ? fresnel_slack(c) : 0);
}

void compare(const std::string& brdf, unsigned seed, std::size_t count) {
    const std::vector<BrdfCase> cases = oracle::further_cases(brdf, seed, count);
    const std::vector<double> got = evaluated(cases);
    ASSERT_EQ(got.size(), cases.size());
    int failures = 0;
    for (std::size_t k = 0; k < cases.size() && failures < 5; ++k) {
        const BrdfCase& c = cases[k];
        const double want = static_cast<double>(oracle::brdf_eval(c.brdf, c.p, c.i, c.o));
        // 1e-60: a light that nobody sees, above a double's own floor and above the fifth power of
        // the rounding error of 1 - i.h, which is what F0 = 0 and i = o leave.
        const double allowed = promised(brdf) * want + slack_of(c) + 1e-60;
        EXPECT_NEAR(got[k], want, allowed) << c.kind << ' ' << row_of(c);
        failures += std::fabs(got[k] - want) <= allowed ? 0 : 1;
    }
}

TEST(FurtherBrdfs, Phong) {
    compare("phong", 41, 1500);
}
TEST(FurtherBrdfs, Ward) {
    compare("ward", 42, 1500);
}
TEST(FurtherBrdfs, WardDuer) {
    compare("ward-duer", 43, 1500);
}
TEST(FurtherBrdfs, Lafortune) {
    compare("lafortune", 44, 1500);
}
TEST(FurtherBrdfs, CookTorrance) {
    compare("cook-torrance", 45, 1500);
}
TEST(FurtherBrdfs, AshikhminPremozeShirley) {
    compare("ashikhmin-premoze-shirley", 46, 300);
}
TEST(FurtherBrdfs, AshikhminShirleyDiffuse) {
    compare("ashikhmin-shirley-diffuse", 49, 1500);
}
TEST(FurtherBrdfs, GgxSeparable) {
    compare("ggx-separable", 47, 1500);
}
TEST(FurtherBrdfs, He) {
    compare("he", 48, 1500);
}

// The pairs that users meet in tables and papers, at angles up to the horizon.
TEST(FurtherBrdfs, AshikhminPremozeShirleyOnAGrid) {
    const std::vector<std::array<long double, 2>> exponents{
        {0, 0}, {1, 1}, {10, 10}, {200, 10}, {10000, 10000}, {0, 10000}, {1, 40}};
    std::vector<BrdfCase> cases;
    for (const auto& e : exponents) {
        for (const long double tilt : {0.0L, 45.0L, 80.0L, 89.9L}) {
            for (const long double azimuth : {0.0L, 35.0L, 90.0L}) {
                BrdfCase c;
                c.brdf = "ashikhmin-premoze-shirley";
                c.p = {e[0], e[1], 1, 0, 0};
                const auto rounded = [](oracle::Vec3 v) {
                    const auto round = [](long double a) {
                        return static_cast<long double>(static_cast<double>(a));
                    };
                    return oracle::Vec3{round(v.x), round(v.y), round(v.z)};
                };
                c.i = rounded(oracle::tilted(tilt, azimuth));
                c.o = {-c.i.x, -c.i.y, c.i.z};  // h = n
                cases.push_back(c);
            }
        }
    }
    const std::vector<double> got = evaluated(cases);
    ASSERT_EQ(got.size(), cases.size());
    for (std::size_t k = 0; k < cases.size(); ++k) {
        const BrdfCase& c = cases[k];
        const double want = static_cast<double>(oracle::brdf_eval(c.brdf, c.p, c.i, c.o));
        EXPECT_NEAR(got[k] / want, 1, 1e-5) << row_of(c);
    }
}

}  // namespace
}  // namespace burnish::test
