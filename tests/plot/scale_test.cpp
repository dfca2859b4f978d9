#include "burnish/plot/scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace burnish::plot {
namespace {

TEST(Scale, PositionAndValueAreInverse) {
    for (const Scale& scale : {Scale{ScaleKind::linear, -2, 5}, Scale{ScaleKind::gamma, 0, 7.5},
                               Scale{ScaleKind::log, 1e-3, 40}}) {
        EXPECT_NEAR(scale.position(scale.low), 0, 1e-12);
        EXPECT_NEAR(scale.position(scale.high), 1, 1e-12);
        for (const double at : {0.1, 0.5, 0.93})
            EXPECT_NEAR(scale.position(scale.value(at)), at, 1e-12);
    }
    EXPECT_NEAR((Scale{ScaleKind::gamma, 0, 1}.position(0.5)), std::pow(0.5, 1 / 2.2), 1e-12);
    EXPECT_LT((Scale{ScaleKind::log, 1e-3, 1}.position(0)), -1e300);
}

// Every number beside an axis says where it stands.
TEST(Scale, TicksStandWhereTheySay) {
    for (const double high : {0.003, 0.9, 7.48, 120.0, 45000.0}) {
        for (const ScaleKind kind : {ScaleKind::linear, ScaleKind::gamma}) {
            const Scale scale = scale_to(kind, high);
            int labelled = 0;
            for (const Tick& tick : scale.ticks(5)) {
                EXPECT_GE(tick.position, -1e-9);
                EXPECT_LE(tick.position, 1 + 1e-9);
                if (tick.label.find("\u00d7") != std::string::npos) continue;
                ++labelled;
                EXPECT_NEAR(scale.value(tick.position), std::stod(tick.label), 1e-6 * high)
                    << tick.label;
            }
            EXPECT_GE(labelled, 3) << high;
        }
    }
}

TEST(Scale, LogTicksAreDecades) {
    const Scale scale{ScaleKind::log, 1e-3, 10};
    std::vector<std::string> labels;
    for (const Tick& tick : scale.ticks(5))
        if (!tick.label.empty()) labels.push_back(tick.label);
    EXPECT_EQ(labels, (std::vector<std::string>{"10^{-3}", "0.01", "0.1", "1", "10"}));
    EXPECT_LE((Scale{ScaleKind::log, 1e-30, 1e30}.ticks(5).size()), 12u);
}

TEST(Scale, NumbersAreShort) {
    EXPECT_EQ(number_text(0), "0");
    EXPECT_EQ(number_text(-0.25), "\u22120.25");
    EXPECT_EQ(number_text(1234.5), "1234");
    EXPECT_EQ(number_text(1e6), "10^{6}");
    EXPECT_EQ(number_text(1.6e5, 3), "1.6\u2009\u00d7\u200910^{5}");
    EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "\u221e");
}

TEST(Scale, TopsThatAreNoneCountAsOne) {
    for (const double high : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_EQ(scale_to(ScaleKind::linear, high).high, 1);
}

}  // namespace
}  // namespace burnish::plot
