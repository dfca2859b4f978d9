// The generated cases of the further reflectance models.
#include "further_brdfs.hpp"
#include "selfcheck.hpp"

namespace burnish::oracle {
namespace {

bool is_double(long double a) {
    return static_cast<long double>(static_cast<double>(a)) == a;
}

TEST(OracleFurtherCases, AreDoublesReproducibleFiniteAndMeetTheLobes) {
    std::vector<std::string> brdfs = further_brdf_names();
    brdfs.emplace_back("ggx-separable");
    for (const std::string& brdf : brdfs) {
        const std::vector<BrdfCase> cases = further_cases(brdf, 8, 200);
        const std::vector<BrdfCase> again = further_cases(brdf, 8, 200);
        ASSERT_EQ(cases.size(), 200u);
        int bright = 0;
        std::set<std::string> kinds;
        for (std::size_t k = 0; k < cases.size(); ++k) {
            const BrdfCase& c = cases[k];
            for (const Vec3 v : {c.i, c.o}) {
                EXPECT_TRUE(is_double(v.x) && is_double(v.y) && is_double(v.z));
            }
            for (const long double p : c.p) EXPECT_TRUE(is_double(p));
            EXPECT_EQ(length(c.i - again[k].i) + length(c.o - again[k].o), 0);
            const long double f = brdf_eval(c.brdf, c.p, c.i, c.o);
            EXPECT_TRUE(f >= 0 && f < 1e300L) << brdf << ' ' << c.kind << ' ' << k;
            if (c.kind == "below") {
                EXPECT_EQ(f, 0);
            }
            bright += f > 1e-3L ? 1 : 0;
            kinds.insert(c.kind);
        }
        EXPECT_GT(bright, 80) << brdf;  // off the lobe, below, or share 0: the rest
        EXPECT_EQ(kinds.size(), 7u) << brdf;
    }
}

// The roughness of the surface in waves: g from 1e-4 to hundreds.
TEST(OracleFurtherCases, SpanTheSeries) {
    long double low = 1e30L;
    long double high = 0;
    for (const BrdfCase& c : further_cases("he", 8, 200)) {
        if (c.kind == "below") continue;
        const Vec3 i = normalize(c.i);
        const Vec3 o = normalize(c.o);
        const long double s = he_effective_sigma(c.p[0], c.p[1], i, o);
        const long double g = powl(2 * kPi * s * (i.z + o.z), 2);
        low = std::min(low, g);
        high = std::max(high, g);
    }
    EXPECT_LT(low, 1e-4L);
    EXPECT_GT(high, 500);
}

}  // namespace
}  // namespace burnish::oracle
