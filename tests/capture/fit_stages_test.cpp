// Stages of a fit: interrupted anywhere and taken up again, it gives what an uninterrupted one
// gives; and the number of threads does not matter.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include "burnish/error.hpp"
#include "capture/solve/capture_fit.hpp"
#include "support/program.hpp"
#include "truth_metrics.hpp"

namespace burnish::test {
namespace {

constexpr int kSize = 12;

Rig small_stack(const std::filesystem::path& folder) {
    VirtualSettings settings;
    settings.width = settings.height = kSize;
    const VirtualSample sample = make_virtual_sample("satin", settings);
    return write_stack(sample, make_bar_rig(sample, 10, 10, {}), {.noise = 0.01}, folder);
}

CaptureFitSettings quick() {
    CaptureFitSettings settings;
    settings.eta = 1.5;
    settings.exemplars = 4;
    return settings;
}

TabulatedMaterial whole_fit(const Rig& rig, const std::filesystem::path& stages,
                            const Progress& progress) {
    CaptureFit fit(rig, quick(), stages, progress);
    fit.find_exemplars();
    fit.fit_texels();
    return fit.material();
}

void expect_same(const TabulatedMaterial& a, const TabulatedMaterial& b) {
    EXPECT_EQ(a.D, b.D);
    EXPECT_EQ(a.exemplar, b.exemplar);
    EXPECT_EQ(a.angle, b.angle);
    EXPECT_EQ(a.diffuse.pixels, b.diffuse.pixels);
    EXPECT_EQ(a.specular.pixels, b.specular.pixels);
    EXPECT_EQ(a.maps, b.maps);
}

TEST(CaptureFitStages, InterruptedAnywhereItGoesOn) {
    const Folder folder;
    const Rig rig = small_stack(folder.path("stack"));
    int steps = 0;
    const TabulatedMaterial whole =
        whole_fit(rig, folder.path("whole"), Progress([&](std::string_view, double) { ++steps; }));
    ASSERT_GT(steps, 20);
    // Each run goes on from what the one before left, and is stopped a little later.
    int runs = 0;
    for (int stop = 3; stop < 10 * steps; stop += 1 + steps / 7) {
        ++runs;
        int seen = 0;
        const Progress progress([&](std::string_view, double) {
            if (++seen == stop) throw Interrupted();
        });
        try {
            expect_same(whole, whole_fit(rig, folder.path("parts"), progress));
            break;
        } catch (const Interrupted&) {
        }
    }
    EXPECT_GT(runs, 3);
}

TEST(CaptureFitStages, AnyNumberOfThreadsGivesTheSame) {
    const Folder folder;
    const Rig rig = small_stack(folder.path("stack"));
    const TabulatedMaterial many = whole_fit(rig, folder.path("many"), {});
    const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
    expect_same(many, whole_fit(rig, folder.path("one"), {}));
}

TEST(CaptureFitStages, StagesOfOtherSettingsAreNotTaken) {
    const Folder folder;
    const Rig rig = small_stack(folder.path("stack"));
    whole_fit(rig, folder.path("stages"), {});
    CaptureFitSettings other = quick();
    other.eta = 2.0;
    CaptureFit fit(rig, other, folder.path("stages"), {});
    fit.find_exemplars();
    EXPECT_EQ(fit.report().eta, 2.0);
}

}  // namespace
}  // namespace burnish::test
