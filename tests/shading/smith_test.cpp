// Smith's masking against its definition by quadrature (tests/oracle).
#include <gtest/gtest.h>

#include "lobes_under_test.hpp"
#include "oracle/oracle.hpp"

namespace burnish::test {
namespace {

double worst_G1_error(int mdf, const std::string& name, double largest_alpha) {
    double worst = 0;
    for (double wide : {0.05, 0.1, 0.3, 0.6, 1.0}) {
        if (wide > largest_alpha) {
            continue;
        }
        for (double ratio : {1.0, 0.3}) {
            const double alpha_x = wide * ratio, alpha_y = wide;
            const f64::Lobe lobe = f64::lobe_from_alpha(mdf, alpha_x, alpha_y);
            for (double theta : {40.0, 67.0, 76.0, 88.0}) {
                for (double phi : {0.0, 45.0, 90.0}) {
                    const vec3 w = direction(theta * kPi / 180, phi * kPi / 180);
                    const double exact = static_cast<double>(
                        oracle::smith_G1_exact(name, lobe.p0, lobe.p1, {w.x, w.y, w.z}));
                    worst = std::max(worst, std::abs(f64::smith_G1(lobe, w) - exact));
                }
            }
        }
    }
    return worst;
}

TEST(Smith, ClosedFormsAreExact) {
    EXPECT_LT(worst_G1_error(f64::kMdfGgx, "ggx", 1.0), 1e-8);
    EXPECT_LT(worst_G1_error(f64::kMdfBeckmann, "beckmann", 1.0), 1e-8);
}

TEST(Smith, FittedFormsKeepTheirStatedError) {
    EXPECT_LT(worst_G1_error(f64::kMdfAshikhminShirley, "ashikhmin-shirley", 1.0), 0.0115);
    EXPECT_LT(worst_G1_error(f64::kMdfAshikhminShirley, "ashikhmin-shirley", 0.3), 0.0015);
    EXPECT_LT(worst_G1_error(f64::kMdfWard, "ward", 1.0), 0.0115);
    EXPECT_LT(worst_G1_error(f64::kMdfWard, "ward", 0.3), 0.0011);
}

TEST(Smith, IsOneAtTheNormalAndNeverAboveIt) {
    for (const LobeCase& c : lobe_cases()) {
        const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
        EXPECT_NEAR(f64::smith_G1(lobe, {0, 0, 1}), 1.0, 1e-12);
        double before = 1;
        for (int i = 0; i <= 900; ++i) {
            const double g = f64::smith_G1(lobe, direction(i * 0.1 * kPi / 180, 0.4));
            EXPECT_LE(g, before + 1e-12) << label(c, 0) << " at " << i * 0.1;
            before = g;
        }
        EXPECT_EQ(f64::smith_G1(lobe, {0.6, 0, -0.8}), 0.0);
    }
}

}  // namespace
}  // namespace burnish::test
