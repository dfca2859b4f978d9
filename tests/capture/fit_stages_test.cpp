// Stages of a fit. A fit that is interrupted anywhere and continued equals an uninterrupted one; so
// does a fit in parts. Results do not depend on the number of threads. Stages of other settings are
// not used.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <functional>

#include "burnish/error.hpp"
#include "capture/solve/capture_fit.hpp"
#include "support/program.hpp"
#include "truth_metrics.hpp"

namespace burnish::test {
namespace {

Rig small_stack(const std::filesystem::path& folder, int size, double tilt_deg) {
    VirtualSettings settings;
    settings.width = settings.height = size;
    settings.tilt_deg = tilt_deg;
    const VirtualSample sample = make_virtual_sample("satin", settings);
    return write_stack(sample, make_bar_rig(sample, 10, 10, {}), {.noise = 0.01}, folder);
}

CaptureFitSettings quick(bool normals = false) {
    CaptureFitSettings settings;
    settings.eta = 1.5;
    settings.exemplars = 4;
    settings.normals = normals;
    return settings;
}

TabulatedMaterial whole_fit(const Rig& rig, const CaptureFitSettings& settings,
                            const std::filesystem::path& stages, const Progress& progress) {
    CaptureFit fit(rig, settings, stages, progress);
    fit.find_exemplars();
    fit.fit_texels();
    return fit.material();
}

void expect_same(const TabulatedMaterial& a, const TabulatedMaterial& b) {
    EXPECT_EQ(a.exemplars, b.exemplars);
    EXPECT_EQ(a.D, b.D);
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.groove, b.groove);
    EXPECT_EQ(a.eta, b.eta);
    EXPECT_EQ(a.exemplar, b.exemplar);
    EXPECT_EQ(a.angle, b.angle);
    EXPECT_EQ(a.diffuse.pixels, b.diffuse.pixels);
    EXPECT_EQ(a.specular.pixels, b.specular.pixels);
    EXPECT_EQ(a.normal.pixels, b.normal.pixels);
    EXPECT_EQ(a.maps, b.maps);
}

class CaptureFitStages : public testing::TestWithParam<bool> {
  protected:
    bool normals() const { return GetParam(); }
    // Twice as many rounds with normals: fewer points.
    Rig stack(const Folder& folder) const {
        return small_stack(folder.path("stack"), normals() ? 8 : 12, normals() ? 6.0 : 0.0);
    }
};
INSTANTIATE_TEST_SUITE_P(Normals, CaptureFitStages, testing::Bool(),
                         [](const auto& instance) { return instance.param ? "Tilt" : "Flat"; });

TEST_P(CaptureFitStages, InterruptedAnywhereItGoesOn) {
    const Folder folder;
    const Rig rig = stack(folder);
    int steps = 0;
    const TabulatedMaterial whole = whole_fit(rig, quick(normals()), folder.path("whole"),
                                              Progress([&](std::string_view, double) { ++steps; }));
    ASSERT_GT(steps, 20);
    // The test needs tilted normals.
    if (normals()) {
        EXPECT_NE(whole.normal.pixels, Image(whole.width, whole.height, 3, 0.0f).pixels);
        EXPECT_LT(*std::min_element(whole.normal.pixels.begin(), whole.normal.pixels.end()),
                  -0.01f);
    }
    // Each run continues from the previous one and is stopped a little later.
    int stopped = 0;
    bool completed = false;
    for (int stop = 3; stop < 10 * steps && !completed; stop += 1 + steps / 7) {
        int seen = 0;
        const Progress progress([&](std::string_view, double) {
            if (++seen == stop) throw Interrupted();
        });
        try {
            expect_same(whole, whole_fit(rig, quick(normals()), folder.path("parts"), progress));
            completed = true;
        } catch (const Interrupted&) {
            ++stopped;
        }
    }
    EXPECT_TRUE(completed) << "no run came to its end";
    EXPECT_GT(stopped, 2);
}

TEST_P(CaptureFitStages, AnyNumberOfThreadsGivesTheSame) {
    const Folder folder;
    const Rig rig = stack(folder);
    const TabulatedMaterial many = whole_fit(rig, quick(normals()), folder.path("many"), {});
    const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
    expect_same(many, whole_fit(rig, quick(normals()), folder.path("one"), {}));
}

// Fits bands separately, as cluster jobs do, with fits that each opened the same folder.
TEST_P(CaptureFitStages, BandsApartGiveTheWhole) {
    const Folder folder;
    const Rig rig = stack(folder);
    const TabulatedMaterial whole = whole_fit(rig, quick(normals()), folder.path("whole"), {});
    CaptureFitSettings settings = quick(normals());
    settings.band_bytes = 6 * rig.lights.size() * 20;  // 20 pixels
    CaptureFit fit(rig, settings, folder.path("bands"), {});
    fit.find_exemplars();
    const std::size_t bands = fit.stack().bands();
    ASSERT_GT(bands, 3u);
    Texels all(0, fit.stack().pixels(), settings.models);
    for (const auto& [first, last] :
         {std::pair{std::size_t{2}, bands}, {std::size_t{0}, std::size_t{2}}}) {
        CaptureFit job(rig, settings, folder.path("bands"), {});
        job.find_exemplars();
        const Texels part = job.fit_bands(first, last);
        EXPECT_EQ(part.first, first * 20);
        EXPECT_TRUE(part.whole(settings.models));
        all.merge(part);
    }
    fit.take_texels(all);
    expect_same(whole, fit.material());
    EXPECT_THROW(fit.take_texels(Texels(0, 3, settings.models)), Error);
}

// Does a fit with these settings use the exemplars stored in the folder?
bool takes_exemplars(const Rig& rig, const CaptureFitSettings& settings,
                     const std::filesystem::path& stages) {
    const Progress progress([](std::string_view stage, double) {
        if (stage == "partial distributions")
            throw Interrupted();  // the first step of finding them
    });
    CaptureFit fit(rig, settings, stages, progress);
    try {
        fit.find_exemplars();
        return true;
    } catch (const Interrupted&) {
        return false;
    }
}

TEST(CaptureFitSettingsOf, StagesOfOthersAreNotTaken) {
    const Folder folder;
    const Rig rig = small_stack(folder.path("stack"), 12, 0.0);
    whole_fit(rig, quick(), folder.path("stages"), {});
    ASSERT_TRUE(takes_exemplars(rig, quick(), folder.path("stages")));
    const std::pair<const char*, std::function<void(CaptureFitSettings&)>> changes[] = {
        {"rings", [](auto& s) { s.grid.rings = 24; }},
        {"azimuths", [](auto& s) { s.grid.azimuths = 72; }},
        {"exemplars", [](auto& s) { s.exemplars = 3; }},
        {"eta", [](auto& s) { s.eta = 2.0; }},
        {"eta estimated", [](auto& s) { s.eta.reset(); }},
        {"seed", [](auto& s) { s.seed = 2; }},
        {"hold_out", [](auto& s) { s.hold_out = 10; }},
        {"training_points", [](auto& s) { s.training_points = 100; }},
        {"normals", [](auto& s) { s.normals = true; }},
        {"models", [](auto& s) { s.models = false; }},
    };
    for (const auto& [name, change] : changes) {
        CaptureFitSettings other = quick();
        change(other);
        EXPECT_FALSE(takes_exemplars(rig, other, folder.path("stages"))) << name;
    }
    // Another lamp makes another stack even with the same pictures.
    Rig moved = rig;
    moved.lights[7].intensity[1] *= 1.01;
    EXPECT_FALSE(takes_exemplars(moved, quick(), folder.path("stages")));
}

TEST(CaptureFitSettingsOf, OnesOwnEtaIsUsed) {
    const Folder folder;
    const Rig rig = small_stack(folder.path("stack"), 12, 0.0);
    CaptureFitSettings other = quick();
    other.eta = 2.0;
    CaptureFit fit(rig, other, folder.path("stages"), {});
    fit.find_exemplars();
    EXPECT_EQ(fit.report().eta, 2.0);
}

}  // namespace
}  // namespace burnish::test
