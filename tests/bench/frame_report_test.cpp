// What the reports of `burnish bench frame` say of a measurement that is made up, device time and
// all: every figure known beforehand.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "bench/frame/frame_cost.hpp"
#include "burnish/plot/figure.hpp"

namespace burnish {
namespace {

using nlohmann::json;

constexpr double kMilli = 1e-3;

// One frame a sample; by the device half the wall's time, by the processors twice.
std::vector<FrameSample> rounds_of(const std::vector<double>& wall_ms) {
    std::vector<FrameSample> rounds;
    for (const double ms : wall_ms)
        rounds.push_back({1, 0, {kMilli * ms, 2 * kMilli * ms, 0.5 * kMilli * ms}});
    return rounds;
}

TechniqueCost cost_of(const std::vector<std::string_view>& names,
                      const std::vector<std::vector<double>>& wall_ms) {
    TechniqueCost cost{technique_named(names.back(), ""), {}, {}};
    for (const auto name : names) cost.subjects.push_back(technique_named(name, ""));
    for (const auto& rounds : wall_ms) cost.samples.push_back(rounds_of(rounds));
    return cost;
}

// A machine that is twice as slow in the second round, thrice in the third; rotate-approx takes
// 2.5, 2.3, 2.62 times what Gouraud shading takes.
FrameCost made_up() {
    FrameCaseCost one;
    one.asked = {4096, 100, 50};
    one.triangles = 4200;
    one.covered_pixels = 1000;
    one.costs.push_back({technique_named("gouraud", ""), {}, {}});
    one.costs.push_back(cost_of({"gouraud", "normal-map"}, {{4, 8, 12}, {8, 16, 24}}));
    one.costs.push_back(cost_of({"gouraud", "normal-map", "rotate-approx"},
                                {{4, 8, 12}, {8, 16, 24}, {10, 18.4, 31.44}}));
    one.rotation = cost_of({"normal-map", "rotate-approx", "rotate-exact"},
                           {{8, 8, 8}, {8.2, 8.2, 8.2}, {9, 9, 9}});
    FrameCost cost;
    cost.device = "A device | of <somebody>";
    cost.driver = "1.0";
    cost.timer = {true, "", {{1, 0.004, 0.002}}};
    cost.processor = "A processor";
    cost.threads = 2;
    cost.load_before = -1;
    cost.date = "2026-11-25T00:00:00Z";
    cost.rounds = 3;
    cost.sample_s = 0.06;
    cost.cases.push_back(one);
    return cost;
}

TEST(FrameReport, RatiosAreMediansOverTheRoundsNotOfTheRounds) {
    const FrameCost cost = made_up();
    const FrameCaseCost& one = cost.cases[0];
    EXPECT_DOUBLE_EQ(one.against_gouraud(one.costs[0], Clock::wall)->median, 1.0);
    EXPECT_DOUBLE_EQ(one.against_gouraud(one.costs[1], Clock::cpu)->median, 2.0);
    const Estimate approximate = *one.against_gouraud(one.costs[2], Clock::device);
    EXPECT_NEAR(approximate.median, 2.5, 1e-12);
    EXPECT_NEAR(approximate.spread, 0.08, 1e-12);  // quartiles 2.4 and 2.56
    EXPECT_NEAR(one.costs[2].against("normal-map", Clock::wall)->median, 1.25, 1e-12);
    EXPECT_FALSE(one.costs[1].against("rotate-approx", Clock::wall));
    // Gouraud shading's own time is the one beside normal-map.
    EXPECT_NEAR(one.frame_s(one.costs[0], Clock::wall)->median, 8 * kMilli, 1e-12);
    EXPECT_NEAR(one.frame_s(one.costs[0], Clock::device)->median, 4 * kMilli, 1e-12);
}

TEST(FrameReport, JsonHoldsFiguresAndSamplesOfAllClocks) {
    const json result = json::parse(frame_cost_json(made_up()));
    EXPECT_EQ(result.at("clock"), "device");
    EXPECT_TRUE(result.at("machine").at("load_average_before").is_null());
    EXPECT_TRUE(result.at("timer_queries").at("usable"));
    const json& one = result.at("cases").at(0);
    const json& approximate = one.at("techniques").at(2);
    EXPECT_EQ(approximate.at("name"), "rotate-approx");
    EXPECT_NEAR(approximate.at("k12_table1").get<double>(), 1004.0 / 642.0, 1e-12);
    const json& frame = approximate.at("frame_ms");
    EXPECT_NEAR(frame.at("wall").at("median").get<double>(), 18.4, 1e-9);
    EXPECT_NEAR(frame.at("cpu").at("median").get<double>(), 36.8, 1e-9);
    EXPECT_NEAR(frame.at("device").at("median").get<double>(), 9.2, 1e-9);
    EXPECT_EQ(approximate.at("samples").size(), 9u);
    const json& rotation = one.at("rotation");
    EXPECT_NEAR(rotation.at("approximate_minus_normal_map").at("wall").at("median").get<double>(),
                200.0, 1e-6);  // microseconds
    EXPECT_NEAR(rotation.at("exact_minus_approximate").at("device").at("median").get<double>(),
                400.0, 1e-6);
}

TEST(FrameReport, TheTableIsByTheDevicesClock) {
    const std::string text = frame_cost_markdown(made_up());
    const auto holds = [&](const char* row) {
        EXPECT_NE(text.find(row), std::string::npos) << row << " in:\n" << text;
    };
    holds("Times are the device's own");
    holds("1000 pixels (20 %) are covered");
    // of Gouraud, CPU, of normal-map, CPU, ms, ns a covered pixel, K12
    holds("| gouraud | 1.00 | 1.00 | - | - | 4.00 | 4000.0 | 1.00 |");
    holds("| normal-map | 2.00 ± 0.00 | 2.00 | 1.00 | 1.00 | 8.00 | 8000.0 | 1.55 |");
    holds("| rotate-approx | 2.50 ± 0.08 | 2.50 | 1.25 ± 0.04 | 1.25 | 9.20 | 9200.0 | 1.56 |");
    holds("| rotate-exact - normal-map | 500 ± 0 | 500.00 ± 0.00 | yes | 54 |");
}

TEST(FrameReport, TheChartHasABarAndTheFigureForEach) {
    const std::string svg = frame_cost_svg(made_up());
    for (const char* words : {">100 x 50, 4200 triangles<", ">2.00 ± 0.00<", ">2.50 ± 0.08<",
                              "A device | of &lt;somebody"})
        EXPECT_NE(svg.find(words), std::string::npos) << words;
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

// On the scale of the methods these would leave no bars to see.
TEST(FrameReport, TablesHaveBarsOfTheirOwnScale) {
    FrameCost cost = made_up();
    const auto width_of = [&](const std::string& name) {
        for (const plot::DataArea& area : plot::draw_figure(frame_cost_figure(cost)).areas)
            if (area.name == "bar " + name) return area.box.width;
        return 0.0;
    };
    const double before = width_of("rotate-approx");
    cost.cases[0].costs.push_back(
        cost_of({"gouraud", "normal-map", "tabulated"}, {{4, 8, 12}, {8, 16, 24}, {80, 160, 240}}));
    EXPECT_GT(before, 100.0);
    EXPECT_EQ(width_of("rotate-approx"), before);
    EXPECT_GT(width_of("tabulated"), before);
    EXPECT_NE(frame_cost_markdown(cost).find("| tabulated | 20.00 ± 0.00 | 20.00 | 10.00 ± 0.00 |"),
              std::string::npos);
}

// One technique by the device's clock and another by the wall's would not be comparable.
TEST(FrameReport, ATimerThatFallsSilentIsNotUsedForAny) {
    FrameCost sound = made_up();
    sound.distrust_silent_timer();
    EXPECT_EQ(sound.clock(), Clock::device);
    for (const std::optional<double> nothing : {std::optional<double>{}, std::optional(0.0)}) {
        FrameCost cost = made_up();
        cost.cases[0].costs[2].samples[1][2].times.device_s = nothing;
        cost.distrust_silent_timer();
        EXPECT_EQ(cost.clock(), Clock::wall);
        EXPECT_NE(cost.timer.reason.find("no time for some frames of 100x50"), std::string::npos);
        const std::string text = frame_cost_markdown(cost);
        EXPECT_NE(text.find(cost.timer.reason), std::string::npos);
        EXPECT_NE(text.find("| 18.40 |"), std::string::npos);  // the wall's milliseconds
    }
}

}  // namespace
}  // namespace burnish
