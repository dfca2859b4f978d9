// The pictures that capture relight writes: their names and their level.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "burnish/image_io.hpp"
#include "burnish/tabulated_file.hpp"
#include "jobs/capture/capture_fit.hpp"
#include "jobs/capture/capture_relight.hpp"
#include "support/program.hpp"
#include "tabulate_sample.hpp"

namespace burnish::test {
namespace {

VirtualSample tiny_sample() {
    VirtualSettings settings;
    settings.width = settings.height = 6;
    return make_virtual_sample("isotropic", settings);
}

struct RelitFolder {
    Folder folder;
    CaptureRelightRequest request;

    RelitFolder() {
        request.material = folder.path("m.exr");
        request.output = folder.path("out");
        write_tabulated_material(request.material, tabulated(tiny_sample(), {16, 48}));
    }
    CaptureRelightResult relight(const std::string& lights) {
        request.rig = folder.write("rig.lp", lights);
        return capture_relight(request, {});
    }
    std::vector<std::string> written() const {
        std::vector<std::string> names;
        for (const RigLight& light : read_rig(request.output / "rig.json", true).lights)
            names.push_back(light.images.at(0).image.filename().string());
        return names;
    }
};

using Names = std::vector<std::string>;

TEST(RelightNames, AreThoseOfTheRig) {
    RelitFolder f;
    f.relight("3\nC:\\photos\\P 1.jpg 0 0 1\n/home/p2.tif 0.6 0 0.8\nl\xf6we 0 0.6 0.8\n");
    EXPECT_EQ(f.written(), (Names{"P 1.exr", "p2.exr", "l\xc3\xb6we.exr"}));
}

TEST(RelightNames, AreNumbersWhereTwoAreAlike) {
    for (const char* second : {"b/p1.tif", "P1.jpg"}) {
        RelitFolder f;
        const auto result = f.relight("2\na/p1.jpg 0 0 1\n" + std::string(second) + " 0.6 0 0.8\n");
        EXPECT_EQ(f.written(), (Names{"0000.exr", "0001.exr"}));
        ASSERT_FALSE(result.warnings.empty());
        EXPECT_NE(result.warnings.back().find("numbered"), std::string::npos)
            << result.warnings.back();
    }
}

TEST(RelightNames, NeverWriteOverThePicturesOfTheRig) {
    RelitFolder f;
    const std::string picture = f.folder.path("p1.exr");
    write_image(picture, Image(6, 6, 3, 0.5f), {});
    f.request.output = f.folder.path(".");
    const std::string before = contents_of(picture);
    expect_parts(refusal_of([&] { f.relight("2\np1.exr 0 0 1\np2.exr 0.6 0 0.8\n"); }),
                 {"without the pictures of the rig", "p1.exr"});
    EXPECT_EQ(contents_of(picture), before);
}

// Lamps at positions in mm whose intensity nobody states: pictures of a card, fitted and relit.
TEST(RelightLevel, IsThatOfThePicturesOfTheFit) {
    const Folder folder;
    const VirtualSample sample = make_virtual_sample("diffuse", [] {
        VirtualSettings settings;
        settings.width = settings.height = 6;
        return settings;
    }());
    Rig rig = make_bar_rig(sample, 3, 3, {20.0, 500.0});
    for (std::size_t k = 0; k < rig.lights.size(); ++k) {
        const std::string name = folder.path("p" + std::to_string(k) + ".exr");
        write_image(name, virtual_picture(sample, rig, k, {}), {});
        rig.lights[k].images = {{name, 1.0}};
        rig.lights[k].intensity = {1.0, 1.0, 1.0};
    }
    rig.intensity_stated = false;
    write_rig(folder.path("rig.json"), rig);
    CaptureFitRequest fit;
    fit.stack = folder.path("rig.json");
    fit.output = folder.path("m.exr");
    fit.settings.hold_out = 3;
    const CaptureFitResult fitted = capture_fit(fit, {});
    EXPECT_TRUE(fitted.fit.level.chosen());
    EXPECT_EQ(std::count_if(fitted.warnings.begin(), fitted.warnings.end(),
                            [](const auto& w) { return w.find("no intensity") != w.npos; }),
              1);
    // Held-out pictures are predicted at their own level: PSNR falls below 20 dB at a tenth off.
    ASSERT_FALSE(fitted.held_out.empty());
    EXPECT_GT(fitted.held_out.front().psnr, 30.0);

    CaptureRelightRequest request;
    request.material = fit.output;
    request.rig = fit.stack;
    request.compare = fit.stack;
    request.output = folder.path("relit");
    const CaptureRelightResult relit = capture_relight(request, {});
    ASSERT_TRUE(relit.error.has_value());
    EXPECT_GT(relit.error->psnr_worst, 30.0);
    // The relit stack states its intensities: it is fitted to the same material.
    EXPECT_TRUE(read_rig(request.output / "rig.json", true).intensity_stated);
    fit.stack = request.output / "rig.json";
    fit.output = folder.path("again.exr");
    EXPECT_FALSE(capture_fit(fit, {}).fit.level.chosen());
    const auto a = read_tabulated_material(request.material).diffuse.pixels;
    const auto b = read_tabulated_material(fit.output).diffuse.pixels;
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 0.02f);
}

}  // namespace
}  // namespace burnish::test
