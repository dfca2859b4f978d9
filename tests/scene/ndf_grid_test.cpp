// Tables of distributions against the analytic lobes that they sample, and a separate quadrature.
#include "burnish/ndf_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "burnish/f64.hpp"
#include "core/constants.hpp"

namespace burnish {
namespace {

double lobe_value(const f64::Lobe& lobe, double theta, double phi) {
    const f64::Perturbation p = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
    return f64::lobe_D(
        lobe, p,
        {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
}

std::vector<float> table_of(const NdfGrid& grid, const f64::Lobe& lobe, double turn = 0) {
    std::vector<float> table;
    for (int r = 0; r < grid.rings; ++r) {
        for (int a = 0; a < grid.azimuths; ++a) {
            table.push_back(static_cast<float>(lobe_value(lobe, static_cast<double>(grid.theta(r)),
                                                          2 * kPi * a / grid.azimuths - turn)));
        }
    }
    return table;
}

struct Case {
    int mdf;
    double alpha_x, alpha_y;
};

const Case kCases[] = {{f64::kMdfGgx, 0.1, 0.4},       {f64::kMdfGgx, 0.5, 0.5},
                       {f64::kMdfBeckmann, 0.15, 0.6}, {f64::kMdfBeckmann, 0.08, 0.08},
                       {f64::kMdfWard, 0.1, 0.3},      {f64::kMdfAshikhminShirley, 0.2, 0.1}};

f64::Lobe lobe_of(const Case& c) {
    return f64::lobe_from_alpha(c.mdf, c.alpha_x, c.alpha_y);
}

TEST(NdfGrid, CellsTileTheHemisphere) {
    for (const NdfGrid grid : {NdfGrid{32, 96}, NdfGrid{1, 4}, NdfGrid{7, 13}}) {
        double sum = 0;
        for (int r = 0; r < grid.rings; ++r) sum += grid.solid_angle(r) * grid.azimuths;
        EXPECT_NEAR(sum, 2 * kPi, 1e-12);
    }
}

TEST(NdfGrid, RingsAreEqualStepsOfU) {
    const NdfGrid grid{32, 96};
    for (int r = 0; r < grid.rings; ++r) {
        const double u = (r + 0.5) / grid.rings;
        EXPECT_NEAR(static_cast<double>(grid.theta(r)), kPi / 2 * u * u, 1e-6);
        // 4e-4: the error of theta near the normal, as u, from a rounded cosine.
        EXPECT_NEAR(static_cast<double>(ndf_u(std::cos(grid.theta(r)))), u, r < 2 ? 1e-2 : 4e-4);
    }
    EXPECT_EQ(ndf_u(0.0F), 1.0F);
    EXPECT_EQ(ndf_u(-0.5F), 1.0F);
    EXPECT_EQ(ndf_u(1.0F), 0.0F);
}

// Linear interpolation has the error h^2/8 times the second derivative. With 32 rings a lobe of
// alpha 0.08 has 5 rings within its width, and the error of the mean over the lobe is about one
// percent.
TEST(NdfGrid, MassOfAnalyticLobesIsOne) {
    for (const Case& c : kCases) {
        const NdfGrid coarse{32, 96}, fine{128, 384};
        EXPECT_NEAR(ndf_mass(coarse, table_of(coarse, lobe_of(c)).data()), 1, 0.02)
            << c.mdf << " " << c.alpha_x;
        EXPECT_NEAR(ndf_mass(fine, table_of(fine, lobe_of(c)).data()), 1, 0.002)
            << c.mdf << " " << c.alpha_x;
    }
}

TEST(NdfGrid, CellCentersAreReadExactly) {
    const NdfGrid grid{9, 14};
    std::vector<float> table;
    for (int i = 0; i < grid.cells(); ++i) table.push_back(static_cast<float>((i * 37) % 101));
    for (int r = 0; r < grid.rings; ++r) {
        for (int a = 0; a < grid.azimuths; ++a) {
            const float u = (static_cast<float>(r) + 0.5F) / 9.0F;
            for (const int turns : {-1, 0, 2}) {
                const double phi = 2 * kPi * a / grid.azimuths + 2 * kPi * turns;
                // 0.01: rounding of phi over a few turns in float, times slopes of up to 100 per
                // column.
                EXPECT_NEAR(ndf_lookup(grid, table.data(), u, static_cast<float>(phi)),
                            table[static_cast<std::size_t>(r * 14 + a)], 0.01F);
            }
        }
    }
    // Constant beyond the outermost centers.
    EXPECT_EQ(ndf_lookup(grid, table.data(), 0, 0), table[0]);
    EXPECT_EQ(ndf_lookup(grid, table.data(), 1, 0), table[8 * 14]);
}

// Halfway between columns and across the wrap: the mean of the two.
TEST(NdfGrid, ColumnsAreInterpolatedAcrossTheWrap) {
    const NdfGrid grid{2, 4};
    const std::vector<float> table = {1, 2, 3, 8, 1, 2, 3, 8};
    const auto at = [&](double column) {
        return ndf_lookup(grid, table.data(), 0.25F, static_cast<float>(kPi / 2 * column));
    };
    EXPECT_NEAR(at(0.5), 1.5, 1e-5);
    EXPECT_NEAR(at(3.5), 4.5, 1e-5);
    EXPECT_NEAR(at(-0.5), 4.5, 1e-5);
    EXPECT_NEAR(at(3.75), 2.75, 1e-5);
}

TEST(NdfGrid, BilinearErrorFallsWithTheSquareOfTheStep) {
    const f64::Lobe lobe = lobe_of(kCases[0]);
    double worst[2] = {0, 0};
    const NdfGrid grids[2] = {{32, 96}, {64, 192}};
    for (int g = 0; g < 2; ++g) {
        const std::vector<float> table = table_of(grids[g], lobe);
        for (int i = 0; i < 400; ++i) {
            const double u = 0.05 + 0.9 * i / 400, phi = i * 0.7;
            const double exact = lobe_value(lobe, kPi / 2 * u * u, phi);
            const double read = static_cast<double>(
                ndf_lookup(grids[g], table.data(), static_cast<float>(u), static_cast<float>(phi)));
            worst[g] = std::max(worst[g], std::fabs(read - exact));
        }
    }
    const double peak = lobe_value(lobe, 0, 0);
    EXPECT_LT(worst[0], 0.03 * peak);
    EXPECT_LT(worst[1], 0.4 * worst[0]);  // a quarter, except for the positions of the samples
}

TEST(NdfGrid, TurningShiftsColumns) {
    const NdfGrid grid{24, 96};
    const f64::Lobe lobe = lobe_of(kCases[0]);
    const int columns = 11;
    const std::vector<float> table = table_of(grid, lobe);
    const std::vector<float> turned = table_of(grid, lobe, 2 * kPi * columns / grid.azimuths);
    for (int r = 0; r < grid.rings; ++r) {
        for (int a = 0; a < grid.azimuths; ++a) {
            const float from = table[static_cast<std::size_t>(r * 96 + a)];
            const float to = turned[static_cast<std::size_t>(r * 96 + (a + columns) % 96)];
            EXPECT_NEAR(from, to, 1e-5F * from + 1e-9F);
        }
    }
    const std::vector<float> areas = ndf_areas(grid, table.data());
    const std::vector<float> areas_turned = ndf_areas(grid, turned.data());
    const float c = std::cos(2 * std::numbers::pi_v<float> * columns / 96),
                s = std::sin(2 * std::numbers::pi_v<float> * columns / 96);
    for (int i = 0; i < 40; ++i) {
        const float theta = 0.038F * static_cast<float>(i), phi = 0.9F * static_cast<float>(i);
        const float x = std::sin(theta) * std::cos(phi), y = std::sin(theta) * std::sin(phi);
        // 2e-3: the 32 nodes of the areas lie elsewhere in the rotated lobe.
        EXPECT_NEAR(
            ndf_area_lookup(areas.data(), x, y, std::cos(theta)),
            ndf_area_lookup(areas_turned.data(), c * x - s * y, s * x + c * y, std::cos(theta)),
            2e-3F);
    }
}

// g = cos / G1 in the separable Smith model: a second derivation, in closed form for Beckmann and
// GGX (the fits of the other lobes are not a reference).
TEST(NdfGrid, AreasAreThoseOfSmith) {
    const NdfGrid grid{96, 192};
    const Case cases[] = {{f64::kMdfGgx, 0.1, 0.4},
                          {f64::kMdfGgx, 0.6, 0.6},
                          {f64::kMdfBeckmann, 0.05, 0.05},
                          {f64::kMdfBeckmann, 0.15, 0.5}};
    for (const Case& c : cases) {
        const f64::Lobe lobe = lobe_of(c);
        const std::vector<float> table = table_of(grid, lobe);
        const std::vector<float> areas = ndf_areas(grid, table.data());
        double worst = 0, at = 0;
        for (int i = 0; i < 900; ++i) {
            const double theta = kPi / 2 * (i % 30 + 0.25) / 30, phi = 0.21 * (i / 30.0);
            const f64::vec3 w(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                              std::cos(theta));
            const double smith = w.z / f64::smith_G1(lobe, w);
            const double read = static_cast<double>(
                ndf_area_lookup(areas.data(), static_cast<float>(w.x), static_cast<float>(w.y),
                                static_cast<float>(w.z)));
            if (std::fabs(read - smith) > worst) at = theta;
            worst = std::max(worst, std::fabs(read - smith));
        }
        // Errors of the nodes (below), and of the bilinear table against the lobe: 96 rings, alpha
        // 0.05.
        EXPECT_LT(worst, 5e-3) << c.mdf << " " << c.alpha_x << " at " << at * 180 / kPi;
    }
}

// The error of the nodes: 16 x 32 against four times as many a side. 3e-3: alpha 0.1 with 0.4,
// where the horizon changes within two columns.
TEST(NdfGrid, AreaNodesAreCloseEnough) {
    const NdfGrid grid{48, 96}, many{61, 128};
    for (const Case& c : kCases) {
        const std::vector<float> table = table_of(grid, lobe_of(c));
        const std::vector<float> areas = ndf_areas(grid, table.data());
        const std::vector<float> fine = ndf_areas(grid, table.data(), many);
        float worst = 0;
        for (int i = 0; i < 2000; ++i) {
            const float theta = 1.5707F * static_cast<float>(i) / 2000,
                        phi = 0.37F * static_cast<float>(i);
            const float x = std::sin(theta) * std::cos(phi), y = std::sin(theta) * std::sin(phi);
            worst = std::max(worst,
                             std::fabs(ndf_area_lookup(areas.data(), x, y, std::cos(theta)) -
                                       ndf_area_lookup(fine.data(), x, y, std::cos(theta), many)));
        }
        EXPECT_LT(worst, 3e-3F) << c.mdf << " " << c.alpha_x << " " << c.alpha_y;
    }
}

}  // namespace
}  // namespace burnish
