// `burnish verify`, as a person runs it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.hpp"
#include "verify/stock_formulas.hpp"

namespace burnish::test {
namespace {

TEST(VerifyCommand, PrintsARowForEachDistributionAndMethod) {
    const Outcome outcome =
        run_burnish({"verify", "--mdf", "ggx,ward", "--method", "follow-grain,normal-map"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    const auto lines_with = [&](const std::string& word) {
        std::size_t count = 0;
        for (std::size_t at = 0; (at = outcome.output.find(word, at)) != std::string::npos; ++at)
            ++count;
        return count;
    };
    EXPECT_EQ(lines_with("follow-grain"), 2U) << outcome.output;
    EXPECT_EQ(lines_with("holds"), 2U) << outcome.output;
    EXPECT_EQ(lines_with("not judged"), 2U) << outcome.output;
    EXPECT_NE(outcome.output.find("4 rows, 2 judged, 0 broken"), std::string::npos);
}

TEST(VerifyCommand, WritesJson) {
    const Outcome outcome = run_burnish({"verify", "--json", "--mdf", "beckmann", "--method",
                                         "slope-shift,deform-linear", "--alpha-x", "0.2"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    const nlohmann::json out = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(out.at("broken"), 0);
    ASSERT_EQ(out.at("rows").size(), 2U);
    const nlohmann::json& row = out.at("rows")[0];
    EXPECT_EQ(row.at("method"), "slope-shift");
    EXPECT_EQ(row.at("mdf"), "beckmann");
    EXPECT_EQ(row.at("p1"), 0.2) << "alpha_x alone sets both";
    EXPECT_TRUE(row.at("judged").get<bool>());
    EXPECT_LT(row.at("highlight_deg").get<double>(), 1);
    EXPECT_LE(row.at("furnace")[1].get<double>(), 1.001);
    EXPECT_FALSE(out.at("rows")[1].at("judged").get<bool>());
}

// Phong has no distribution: no figure, and no rows under methods that move half vectors.
TEST(VerifyCommand, LeavesOutWhatHasNoMeaning) {
    const Outcome outcome =
        run_burnish({"verify", "--json", "--brdf", "phong", "--method", "rotate-arc,stretch"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    const nlohmann::json out = nlohmann::json::parse(outcome.output);
    ASSERT_EQ(out.at("rows").size(), 1U);
    EXPECT_TRUE(out.at("rows")[0].at("energy")[0].is_null());
    expect_complaint(run_burnish({"verify", "--brdf", "phong", "--method", "stretch"}), 2,
                     {"--method", "phong"});
}

TEST(VerifyCommand, RefusesWhatItCannotMeasure) {
    expect_complaint(run_burnish({"verify", "--mdf", "gxx"}), 2, {"--mdf", "did you mean 'ggx'"});
    expect_complaint(run_burnish({"verify", "--method", "bend"}), 2, {"--method", "follow-grain"});
    expect_complaint(run_burnish({"verify", "--alpha-x", "0.01"}), 2, {"0.05", "0.01"});
    expect_complaint(run_burnish({"verify", "--normal", "0,0,1"}), 2, {"--normal", "--csv"});
    expect_complaint(run_burnish({"verify", "--f0", "1"}), 2, {"--f0", "--csv"});
    expect_complaint(run_burnish({"verify", "--csv", "x.csv", "--normal", "0,1"}), 2,
                     {"--normal", "X,Y,Z"});
    expect_complaint(run_burnish({"verify", "--csv", "x.csv", "--mdf", "ggx,ward"}), 2, {"--mdf"});
}

TEST(VerifyCommand, HoldsATableOfAnEngineAgainstOurs) {
    const Vector n = polar3(30, 35);
    const std::string table = value_table([&](const Vector& l, const Vector& v) {
        return three_brdf({{1, 0, 0}, {0, 1, 0}, n}, std::sqrt(0.1), 2.0 / 3, 1.0, l, v);
    });
    const Folder folder;
    const std::string file = folder.write("three.csv", table);
    const std::string normal = fmt::format("{:.9g},{:.9g},{:.9g}", n[0], n[1], n[2]);
    const std::vector<std::string> command{"verify",    "--csv", file,       "--alpha-x", "0.5",
                                           "--alpha-y", "0.1",   "--normal", normal};
    const Outcome outcome = run_burnish(command);
    EXPECT_EQ(outcome.exit_code, 1);
    for (const char* words :
         {"relative RMS error", "verdict", "matches normal-map", "unperturbed frame"})
        EXPECT_NE(outcome.output.find(words), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.complaint.find("0.01 is asked for"), std::string::npos) << outcome.complaint;

    std::vector<std::string> as_normal_map = command;
    as_normal_map.insert(as_normal_map.end(), {"--method", "normal-map", "--json"});
    const Outcome agreed = run_burnish(as_normal_map);
    EXPECT_EQ(agreed.exit_code, 0) << agreed.complaint;
    const nlohmann::json out = nlohmann::json::parse(agreed.output);
    EXPECT_LT(out.at("relative_rms").get<double>(), 1e-4);
    EXPECT_EQ(out.at("fit").at("method"), "normal-map");
    EXPECT_TRUE(out.at("alike").empty());
    EXPECT_NEAR(out.at("brightest_apart_deg").get<double>(), 0, 1e-9);
}

}  // namespace
}  // namespace burnish::test
