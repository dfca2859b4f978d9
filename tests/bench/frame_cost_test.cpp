// burnish bench frame: what it refuses, and that what it writes is whole and adds up.
#include "bench/frame/frame_cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "bench/frame/frame_papers.hpp"
#include "bench/frame/frame_tabulated.hpp"
#include "burnish/context.hpp"
#include "burnish/renderer.hpp"
#include "core/statistics.hpp"
#include "formats/tabulated/tabulated_check.hpp"
#include "gpu/gpu_fixture.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

using nlohmann::json;

class FrameCostTest : public GpuTest {};

FrameCostRequest tiny_request() {
    FrameCostRequest request;
    request.cases = {{500, 40, 24}};
    request.techniques = {technique_named("rotate-approx", ""),
                          technique_named("rotate-exact", "")};
    request.rounds = 3;
    request.sample_s = 1e-4;
    return request;
}

// The median of the samples' ratios, worked out from the file alone.
double median_ratio(const json& samples, const std::string& subject, const std::string& base) {
    std::map<int, double> a, b;
    for (const json& s : samples) {
        const double seconds = s.at("wall_s").get<double>() / s.at("frames").get<int>();
        if (s.at("technique") == subject) a[s.at("round")] = seconds;
        if (s.at("technique") == base) b[s.at("round")] = seconds;
    }
    std::vector<double> ratios;
    for (const auto& [round, seconds] : a) ratios.push_back(seconds / b.at(round));
    std::sort(ratios.begin(), ratios.end());
    EXPECT_EQ(ratios.size() % 2, 1u);
    return ratios[ratios.size() / 2];
}

void expect_plausible(const json& estimate) {
    for (const char* key : {"median", "spread", "error"})
        EXPECT_TRUE(std::isfinite(estimate.at(key).get<double>()));
    EXPECT_GT(estimate.at("median").get<double>(), 0.0);
    EXPECT_GE(estimate.at("spread").get<double>(), 0.0);
}

TEST_F(FrameCostTest, TheCommandWritesThreeFilesOrPrintsTheTables) {
    const Folder folder;
    std::vector<std::string> words = {"bench",         "frame",       "--quick", "--size",
                                      "48x27",         "--triangles", "500",     "--methods",
                                      "rotate-approx", "--pairs",     "3"};
    const Outcome printed = run_burnish(words);
    ASSERT_EQ(printed.exit_code, 0) << printed.complaint;
    EXPECT_NE(printed.output.find("## 48 x 27, "), std::string::npos) << printed.output;
    EXPECT_NE(printed.output.find("| rotate-approx |"), std::string::npos);
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
    words.insert(words.end(), {"-o", folder.path("f.json")});
    const Outcome written = run_burnish(words);
    ASSERT_EQ(written.exit_code, 0) << written.complaint;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"f.json", "f.md", "f.svg"}));
    for (const std::string& name : folder.names())
        EXPECT_NE(written.output.find(folder.path(name) + "\n"), std::string::npos) << name;
    const json result = json::parse(contents_of(folder.path("f.json")));
    EXPECT_EQ(result.at("format"), "burnish-frame-cost");
    EXPECT_EQ(result.at("gl").at("device"), context->renderer());
    EXPECT_NE(result.at("command").get<std::string>().find("bench frame --quick"),
              std::string::npos);
    EXPECT_EQ(result.at("cases").at(0).at("techniques").size(), 3u);  // with the two bases
}

TEST_F(FrameCostTest, EveryTechniqueIsMeasuredWithRatiosThatAddUp) {
    FrameCostRequest request = default_frame_request(true);
    request.cases = {{500, 48, 27}};
    request.rounds = 3;
    request.sample_s = 1e-4;
    const json result = json::parse(frame_cost_json(measure_frame_cost(request)));
    ASSERT_EQ(result.at("cases").size(), 1u);
    const json& one = result.at("cases").at(0);
    // The torus, seen whole: a quarter of the picture and a bit (26.6 % at 1280x720).
    EXPECT_NEAR(one.at("covered_pixels").get<double>() / (48 * 27), 0.266, 0.02);
    std::set<std::string> seen;
    for (const json& technique : one.at("techniques")) {
        const auto name = technique.at("name").get<std::string>();
        seen.insert(name);
        expect_plausible(technique.at("against_gouraud").at("wall"));
        expect_plausible(technique.at("frame_ms").at("wall"));
        if (name == "gouraud") continue;
        EXPECT_DOUBLE_EQ(technique.at("against_gouraud").at("wall").at("median").get<double>(),
                         median_ratio(technique.at("samples"), name, "gouraud"));
        EXPECT_EQ(technique.at("samples").size(), name == "normal-map" ? 6u : 9u);
    }
    EXPECT_EQ(seen.size(), techniques().size());
    for (const Technique& technique : techniques())
        EXPECT_TRUE(seen.contains(std::string(technique.name))) << technique.name;
    EXPECT_EQ(one.at("rotation").at("samples").size(), 3u * 6u);
}

TEST_F(FrameCostTest, TablesAndChartNameTheDeviceAndEveryTechnique) {
    FrameCostRequest request = tiny_request();
    request.command = "burnish bench frame <&>";
    const FrameCost cost = measure_frame_cost(request);
    const std::string markdown = frame_cost_markdown(cost);
    const std::string svg = frame_cost_svg(cost);
    for (const std::string& text : {markdown, svg}) {
        EXPECT_NE(text.find(context->renderer()), std::string::npos);
        for (const char* name : {"gouraud", "normal-map", "rotate-approx", "rotate-exact"})
            EXPECT_NE(text.find(name), std::string::npos) << name;
        EXPECT_EQ(text.find("deform-smooth"), std::string::npos);
        EXPECT_EQ(text.find("nan"), std::string::npos);
    }
    EXPECT_NE(markdown.find("K12 Fig 7"), std::string::npos);
    EXPECT_NE(svg.find("&lt;&amp;"), std::string::npos);
    EXPECT_EQ(svg.find("<&"), std::string::npos);
}

TEST_F(FrameCostTest, FigureSevenNeedsBothRotations) {
    FrameCostRequest request = tiny_request();
    request.techniques.pop_back();
    const FrameCost cost = measure_frame_cost(request);
    EXPECT_TRUE(cost.cases[0].rotation.samples.empty());
    EXPECT_TRUE(json::parse(frame_cost_json(cost)).at("cases").at(0).at("rotation").is_null());
    EXPECT_EQ(frame_cost_markdown(cost).find("K12 Fig 7"), std::string::npos);
}

TEST_F(FrameCostTest, StoppedItLeavesNothing) {
    const Folder folder;
    FrameCostRequest request = tiny_request();
    request.output = folder.path("f.json");
    int steps = 0;
    double last = 0;
    const Progress progress([&](std::string_view, double done) {
        EXPECT_GE(done, last);
        last = done;
        if (++steps == 8) throw Interrupted();
    });
    EXPECT_THROW(bench_frame(request, progress), Interrupted);
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

TEST_F(FrameCostTest, MoreThanTheDeviceHoldsIsRefused) {
    const int most = context->max_texture_size();
    EXPECT_NO_THROW(require_size(*context, {500, 64, 64}));
    expect_parts(refusal_of([&] {
                     require_size(*context, {500, most + 1, 16});
                 }),
                 {"picture size", std::to_string(most), context->renderer()});
}

TEST_F(FrameCostTest, ImageLightNeedsAnEnvironment) {
    FrameBench bench(*context, {500, 32, 32}, false);
    expect_parts(refusal_of([&] { bench.time(technique_named("image-importance", ""), 1); }),
                 {"image-importance", "image light"});
}

TEST_F(FrameCostTest, FramesAreTimedOnDesktopAndEs) {
    const auto time_on = [](gpu::GlApi api) {
        gpu::Context own(-1, api);
        FrameBench bench(own, {500, 64, 64}, false);
        return bench.time(technique_named("normal-map", ""), 4);
    };
    for (const gpu::GlApi api : {gpu::GlApi::desktop, gpu::GlApi::es}) {
        gpu::FrameTimes times;
        try {
            times = time_on(api);
        } catch (const Error& error) {
            if (std::string(error.what()).find("no OpenGL context") == std::string::npos) throw;
            continue;  // the machine has the other one only
        }
        EXPECT_GT(times.wall_s, 0.0);
        EXPECT_GE(times.cpu_s, 0.0);
        EXPECT_GE(times.device_s.value_or(0.0), 0.0);
    }
}

TEST(FrameCost, WrongWordsAreUsageErrorsThatSuggest) {
    const auto refused = [&](std::vector<std::string> flags,
                             const std::vector<std::string>& parts) {
        std::vector<std::string> words = {"bench", "frame"};
        words.insert(words.end(), flags.begin(), flags.end());
        expect_complaint(run_burnish(words), 2, parts);
    };
    refused({"--methods", "gouraud,rotate-exat"}, {"--methods", "rotate-exat", "rotate-exact"});
    refused({"--size", "1280"}, {"--size", "WIDTHxHEIGHT", "1280"});
    refused({"--triangles", "4k,4q"}, {"--triangles", "4q"});
    refused({"--pairs", "2"}, {"--pairs", "3 to 1000"});
    refused({"-o", ""}, {"--output", ".json"});
    expect_complaint(run_burnish({"bench", "fram"}), 2, {"fram", "frame"});
}

// Before there is a context: nothing is measured first.
TEST(FrameCost, RequestsThatMakeNoSenseAreUsageErrors) {
    const Folder folder;
    const auto refused = [](const std::function<void(FrameCostRequest&)>& spoil,
                            const std::vector<std::string>& parts) {
        FrameCostRequest request = tiny_request();
        spoil(request);
        try {
            measure_frame_cost(request);
            ADD_FAILURE() << "measured";
        } catch (const UsageError& error) {
            expect_parts(error.what(), parts);
        }
    };
    using Request = FrameCostRequest;
    refused([](Request& r) { r.cases.clear(); }, {"bench frame", "one case or more"});
    refused([](Request& r) { r.rounds = 2; }, {"--pairs", "3 to 1000", "2"});
    refused([](Request& r) { r.cases[0].width = 8; }, {"--size", "16 to 16384", "8"});
    refused([](Request& r) { r.cases[0].height = 99999; }, {"--size", "16 to 16384", "99999"});
    refused([](Request& r) { r.cases[0].triangles = 99; }, {"--triangles", "100 to 4000000"});
    refused([](Request& r) { r.cases[0].triangles = -1; }, {"--triangles", "-1"});
    refused([&](Request& r) { r.output = folder.path("f.txt"); }, {"f.txt", ".json"});
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

TEST(FrameCost, AFolderThatIsNotThereIsSaidFirst) {
    const Folder folder;
    FrameCostRequest request = tiny_request();
    request.output = folder.path("none/f.json");
    expect_parts(refusal_of([&] { measure_frame_cost(request); }), {"none", "no folder"});
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

TEST(FrameCost, AnOutputThatCannotBeWrittenIsSaidFirst) {
    const Folder folder;
    std::filesystem::create_directory(folder.path("f.md"));
    expect_complaint(run_burnish({"bench", "frame", "-o", folder.path("f.json")}), 1, {"f.md"});
}

// A material that a file could hold, and the dear case: neighbours that share nothing.
TEST(FrameCost, MeasuredMaterialsOfTheBenchAreSoundAndVaryFromTexelToTexel) {
    const TabulatedMaterial many = bench_material_of_texels();
    EXPECT_NO_THROW(check_tabulated_material("many", many));
    EXPECT_NO_THROW(check_tabulated_material("one", bench_material_of_one()));
    EXPECT_EQ(bench_material_of_one().texels(), 1u);
    EXPECT_EQ(std::set(many.exemplar.begin(), many.exemplar.end()).size(), 4u);
    std::size_t alike = 0;
    for (std::size_t i = 1; i < many.texels(); ++i) {
        const float turn = std::fabs(many.angle[i] - many.angle[i - 1]);
        // Of the field in the code 0.05 from one to the next, and 0.07 from row to row.
        EXPECT_LT(turn, 0.13F) << i;
        alike += many.exemplar[i] == many.exemplar[i - 1] && turn == 0.0F ? 1 : 0;
    }
    EXPECT_LT(alike, many.texels() / 50);  // the crests of the field
}

// Table I against itself: 1004 / 968, / 647, / 642.
TEST(FrameCost, ThePapersTableIsTheirs) {
    EXPECT_NEAR(*k12_cost("aniso"), 1.037, 5e-4);
    EXPECT_NEAR(*k12_cost("normal-map"), 1.552, 5e-4);
    EXPECT_NEAR(*k12_cost("rotate-approx"), 1.564, 5e-4);
    EXPECT_FALSE(k12_cost("rotate-exact"));
    // What Table I says of Fig 7: the approximate rotation's 11 microseconds, to one.
    EXPECT_NEAR(1.0 / 642.0 - 1.0 / 647.0, kK12ApproximateRotation, 1.1e-6);
}

TEST(FrameCost, DefaultsGoFromFourThousandToAMillionAndFrom720To4K) {
    const std::vector<FrameCase> cases = default_frame_cases(false);
    const auto holds = [&](int triangles, int width, int height) {
        return std::any_of(cases.begin(), cases.end(), [&](const FrameCase& c) {
            return c.triangles == triangles && c.width == width && c.height == height;
        });
    };
    EXPECT_TRUE(holds(4096, 1280, 720));
    EXPECT_TRUE(holds(1000000, 1280, 720));
    EXPECT_TRUE(holds(102400, 3840, 2160));
    EXPECT_EQ(default_frame_cases(true).size(), 2u);
    const FrameCostRequest quick = default_frame_request(true),
                           whole = default_frame_request(false);
    EXPECT_EQ(quick.cases.size(), 2u);
    EXPECT_EQ(whole.cases.size(), cases.size());
    EXPECT_EQ(quick.techniques.size(), techniques().size());
    EXPECT_LT(quick.rounds, whole.rounds);
}

}  // namespace
}  // namespace burnish::test
