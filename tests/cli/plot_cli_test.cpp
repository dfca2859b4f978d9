// burnish mdf plot and burnish brdf plot as a person runs them: what is drawn, what is refused.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "burnish/image_io.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

// The pixel ratio scales the picture and nothing else.
TEST(PlotCommand, PicturesHaveTheSizeAskedFor) {
    const Folder folder;
    int width[2], height[2];
    for (const int ratio : {1, 2}) {
        const std::string path = folder.path(std::to_string(ratio) + ".png");
        const Outcome outcome =
            run_burnish({"mdf", "plot", "--method", "none,deform-smooth", "--panel", "120",
                         "--pixel-ratio", std::to_string(ratio), "-o", path});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
        const Image image = read_image(path);
        width[ratio - 1] = image.width;
        height[ratio - 1] = image.height;
    }
    EXPECT_GT(width[0], 2 * 120);
    EXPECT_NEAR(width[1], 2 * width[0], 1);
    EXPECT_NEAR(height[1], 2 * height[0], 1);
}

TEST(PlotCommand, EveryKindIsWrittenWithItsCommand) {
    const Folder folder;
    for (const auto& [group, kind] :
         std::vector<std::pair<std::string, std::string>>{{"mdf", "disk"},
                                                          {"mdf", "grid"},
                                                          {"mdf", "profile"},
                                                          {"brdf", "polar"},
                                                          {"brdf", "surface"},
                                                          {"brdf", "albedo"}}) {
        const std::string path = folder.path(kind + ".svg");
        std::vector<std::string> arguments = {group, "plot", "--kind", kind, "-o", path};
        if (group == "mdf") arguments.insert(arguments.end(), {"--method", "follow-grain"});
        if (group == "brdf") arguments.insert(arguments.end(), {"--brdf", "ward,ggx"});
        const Outcome outcome = run_burnish(arguments);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
        const std::string svg = text_of(path);
        EXPECT_NE(svg.find("</svg>"), std::string::npos) << kind;
        EXPECT_NE(svg.find("--kind " + kind), std::string::npos) << kind;
    }
}

TEST(PlotCommand, RefusesWhatCannotBeDrawn) {
    const Folder folder;
    const std::string out = folder.path("x.png");
    const auto refused = [&](std::vector<std::string> arguments, int code,
                             const std::vector<std::string>& parts) {
        arguments.insert(arguments.begin() + 1, "plot");
        arguments.insert(arguments.end(), {"-o", out});
        expect_complaint(run_burnish(arguments), code, parts);
        EXPECT_FALSE(std::filesystem::exists(out));
    };
    refused({"mdf", "--tilt", "95"}, 2, {"--tilt", "95"});
    refused({"mdf", "--normal", "0,0,0"}, 2, {"--normal"});
    refused({"mdf", "--normal", "nan,0,1"}, 2, {"--normal", "nan"});
    refused({"mdf", "--mdf", "ggx", "--alpha-x", "0"}, 2, {"--alpha-x"});
    refused({"mdf", "--kind", "grid", "--method", "normal-map"}, 2, {"normal-map", "moves"});
    refused({"mdf", "--panel", "1e9"}, 2, {"--panel"});
    refused({"brdf", "--brdf", "gxx"}, 2, {"ggx"});
    refused({"brdf", "--brdf", "ggx", "--incidence", "90"}, 2, {"--incidence", "90"});
    expect_complaint(run_burnish({"mdf", "plot", "-o", folder.path("x.jpg")}), 2, {".png or .svg"});
}

}  // namespace
}  // namespace burnish::test
