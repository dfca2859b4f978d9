// burnish render --tabulated and burnish info of a tabulated material as a person runs them.
#include <gtest/gtest.h>

#include "burnish/image_io.hpp"
#include "burnish/tabulated_file.hpp"
#include "burnish/tabulated_material.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

// One exemplar, D = 1/pi: white, and red below.
void write_material(const std::string& path) {
    TabulatedMaterial m;
    m.grid = {4, 8};
    m.exemplars = 1;
    m.D.assign(32, 0.31831F);
    m.origin.assign(32, NdfOrigin::completed);
    m.groove = {0.5F};
    m.width = 1;
    m.height = 2;
    m.width_mm = 3;
    m.height_mm = 6;
    m.exemplar = {0, 0};
    m.angle = {0.0F, 0.0F};
    m.diffuse = Image(1, 2, 3, 0.5F);
    m.diffuse.at(0, 1)[1] = m.diffuse.at(0, 1)[2] = 0.0F;
    m.specular = Image(1, 2, 3, 0.0F);
    m.normal = Image(1, 2, 3, 0.0F);
    m.normal.pixels[2] = m.normal.pixels[5] = 1.0F;
    m.metadata = {{"burnish:command", "a test"}};
    write_tabulated_material(path, m);
}

TEST(TabulatedCommand, InfoDescribesTheFile) {
    const Folder folder;
    write_material(folder.path("m.exr"));
    const Outcome outcome = run_burnish({"info", folder.path("m.exr")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    for (const char* words : {"1x2 texels of 3 x 6 mm", "1 exemplar of 4 rings x 8 azimuths",
                              "100 % completed", "groove at 29 degrees", "burnish:command: a test"})
        EXPECT_NE(outcome.output.find(words), std::string::npos) << words << outcome.output;
}

TEST(TabulatedCommand, RendersTexelsTheRightWayUp) {
    const Folder folder;
    write_material(folder.path("m.exr"));
    const Outcome outcome =
        run_burnish({"render", "builtin:plane", "--tabulated", folder.path("m.exr"), "--env",
                     "none", "--light", "0,0", "--camera-elevation", "0", "--camera-azimuth", "0",
                     "--size", "16x16", "--samples", "4", "-o", folder.path("p.exr")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    const Image picture = read_image(folder.path("p.exr"));
    // v runs down the picture: the first row, white, is above.
    const float* high = picture.at(8, 3);
    const float* low = picture.at(8, 12);
    // Nearly at the middles of the two texels, between which there is a mixture.
    EXPECT_GT(high[1], 0.9F * high[0]);
    EXPECT_LT(low[1], 0.3F * low[0]);
}

TEST(TabulatedCommand, WhatIsNotDrawnIsSaidInOneLine) {
    const Folder folder;
    write_material(folder.path("m.exr"));
    const Outcome outcome =
        run_burnish({"render", "builtin:plane", "--tabulated", folder.path("m.exr"),
                     "--image-light", "prefiltered", "--size", "8x8", "-o", folder.path("p.png")});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.complaint.find("importance"), std::string::npos) << outcome.complaint;
}

}  // namespace
}  // namespace burnish::test
