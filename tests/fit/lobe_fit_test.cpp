// Lobes fitted to tables of known ones.
#include "burnish/lobe_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "burnish/virtual_ndf.hpp"
#include "core/constants.hpp"

namespace burnish::test {
namespace {

std::vector<float> table_of(const NdfGrid& grid, const VirtualNdf& ndf, double turn) {
    std::vector<float> table;
    for (int ring = 0; ring < grid.rings; ++ring)
        for (int column = 0; column < grid.azimuths; ++column) {
            const double u = (ring + 0.5) / grid.rings, theta = u * u * kPi / 2;
            const double phi = 2 * kPi * column / grid.azimuths - turn;
            table.push_back(
                static_cast<float>(ndf.D({std::sin(theta) * std::cos(phi),
                                          std::sin(theta) * std::sin(phi), std::cos(theta)})));
        }
    return table;
}

double apart(double a, double b) {  // of lines
    const double d = a - b;
    return std::abs(d - kPi * std::round(d / kPi));
}

constexpr Mdf kMdfs[] = {Mdf::ashikhmin_shirley, Mdf::ward, Mdf::beckmann, Mdf::ggx};

TEST(LobeFit, FindsWidthsAndGrooveOfEveryLobeTurnedByAnyAngle) {
    const NdfGrid grid;
    int k = 0;
    for (const Mdf mdf : kMdfs)
        for (const double along : {0.04, 0.1, 0.3})
            for (const double ratio : {1.3, 3.0}) {
                const double turn = std::fmod(0.37 + 0.61 * k++, kPi);
                const VirtualNdf ndf{"", {{1.0, mdf, along, along * ratio, 0.0, 0.0, 0.0}}};
                const LobeFit fit = fit_lobe(grid, table_of(grid, ndf, turn).data(), mdf);
                SCOPED_TRACE(testing::Message() << "mdf " << static_cast<int>(mdf) << " alpha "
                                                << along << " x " << ratio << " turn " << turn);
                // The table is the lobe at its cells, in single precision: what is left of the
                // residual is rounding, 6e-8 of each value.
                EXPECT_LT(fit.residual, 1e-5);
                EXPECT_NEAR(fit.alpha_along, along, 1e-4 * along);
                EXPECT_NEAR(fit.alpha_across, along * ratio, 1e-4 * along * ratio);
                EXPECT_LT(apart(fit.groove, turn), 1e-4);
                EXPECT_GE(fit.groove, 0.0);
                EXPECT_LT(fit.groove, kPi);
            }
}

TEST(LobeFit, TheGrooveIsTheAxisOfTheSmallerAlphaWhicheverThatIs) {
    const NdfGrid grid;
    const VirtualNdf across{"", {{1.0, Mdf::ggx, 0.4, 0.1, 0.0, 0.0, 0.0}}};
    const LobeFit fit = fit_lobe(grid, table_of(grid, across, 0.2).data(), Mdf::ggx);
    EXPECT_NEAR(fit.alpha_along, 0.1, 1e-5);
    EXPECT_NEAR(fit.alpha_across, 0.4, 4e-5);
    EXPECT_LT(apart(fit.groove, 0.2 + kPi / 2), 1e-4);
}

TEST(LobeFit, ARoundLobeHasTwoEqualAlphas) {
    const NdfGrid grid;
    for (const Mdf mdf : kMdfs) {
        const VirtualNdf round{"", {{1.0, mdf, 0.2, 0.2, 0.0, 0.0, 0.0}}};
        const LobeFit fit = fit_lobe(grid, table_of(grid, round, 0.0).data(), mdf);
        EXPECT_NEAR(fit.alpha_along, 0.2, 2e-5) << static_cast<int>(mdf);
        EXPECT_NEAR(fit.alpha_across, 0.2, 2e-5) << static_cast<int>(mdf);
    }
}

TEST(LobeFit, AnotherLobeThanTheTablesIsAFitWithAResidual) {
    const NdfGrid grid;
    const VirtualNdf ggx{"", {{1.0, Mdf::ggx, 0.1, 0.3, 0.0, 0.0, 0.0}}};
    const std::vector<float> table = table_of(grid, ggx, 1.0);
    for (const Mdf mdf : {Mdf::ashikhmin_shirley, Mdf::ward, Mdf::beckmann}) {
        const LobeFit fit = fit_lobe(grid, table.data(), mdf);
        // Tails of another kind: wider, the same way round, and not the same.
        EXPECT_GT(fit.residual, 0.05);
        EXPECT_LT(fit.residual, 0.3);
        EXPECT_GT(fit.alpha_along, 0.1);
        EXPECT_LT(fit.alpha_across, 0.6);
        EXPECT_LT(apart(fit.groove, 1.0), 0.01);
    }
}

TEST(LobeFit, TheScaleOfATableDoesNotMatter) {
    const NdfGrid grid{24, 72};
    const VirtualNdf ndf{"", {{1.0, Mdf::ggx, 0.1, 0.3, 0.0, 0.0, 0.0}}};
    std::vector<float> table = table_of(grid, ndf, 2.5);
    for (float& d : table) d *= 8.0f;
    const LobeFit fit = fit_lobe(grid, table.data(), Mdf::ggx);
    EXPECT_NEAR(fit.alpha_along, 0.1, 1e-5);
    EXPECT_NEAR(fit.alpha_across, 0.3, 3e-5);
}

TEST(LobeFit, SharpAndFlatTablesEndAtTheBounds) {
    const NdfGrid grid;
    std::vector<float> spike(static_cast<std::size_t>(grid.cells()), 0.0f);
    for (int a = 0; a < grid.azimuths; ++a) spike[static_cast<std::size_t>(a)] = 1e6f;
    const std::vector<float> flat(static_cast<std::size_t>(grid.cells()), 1.0f);
    for (const Mdf mdf : kMdfs) {
        const LobeFit sharp = fit_lobe(grid, spike.data(), mdf);
        EXPECT_GE(sharp.alpha_along, 0.00199);
        EXPECT_LT(sharp.alpha_across, 0.02);
        const LobeFit wide = fit_lobe(grid, flat.data(), mdf);
        EXPECT_GT(wide.alpha_along, 0.5);
        EXPECT_LT(wide.alpha_across, 1.51);
    }
}

}  // namespace
}  // namespace burnish::test
