#include "reference/trace_run.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <atomic>
#include <filesystem>
#include <fstream>

#include "burnish/error.hpp"
#include "gpu/test_scene.hpp"
#include "reference/scene_print.hpp"
#include "reference/surfaces.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

constexpr int kWidth = 37, kHeight = 21;  // not of whole tiles

class TraceRun : public testing::Test {
  protected:
    TraceRun() {
        scene = test::one_object(test::uv_sphere(24, 12), test::rough_metal());
        scene.lights.push_back(test::directional({1.0f, 1.0f, 1.0f}));
        settings.width = kWidth;
        settings.height = kHeight;
    }

    static Camera view() {
        Camera camera;
        camera.yfov = 0.9f;
        return camera;
    }
    PathTracer tracer() const { return {scene, sky, view(), settings, 2, true}; }
    static TraceSums empty() { return {kWidth, kHeight, true}; }
    static TracePlan plan(std::uint32_t samples, TraceShard shard = {}) {
        TracePlan p;
        p.samples = samples;
        p.shard = shard;
        return p;
    }
    TraceSums traced(const TracePlan& p) const {
        TraceSums sums = empty();
        run_trace(tracer(), sums, p, {}, [] {});
        return sums;
    }

    test::ScratchFolder folder;
    Scene scene;
    Environment sky = test::constant_environment({0.5f, 0.6f, 0.7f});
    RenderSettings settings;
};

TEST_F(TraceRun, IsTheSameOnAnyNumberOfThreads) {
    const TraceSums many = traced(plan(9));
    const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE(many == traced(plan(9)));
    EXPECT_EQ(many.fewest_samples(), 9u);
}

TEST_F(TraceRun, OfAnotherSeedIsAnother) {
    const TraceSums first = traced(plan(2));
    settings.seed = 1;
    EXPECT_FALSE(first == traced(plan(2)));
}

TEST_F(TraceRun, GoesOnToTheLastBitAfterBeingStoppedAgainAndAgain) {
    const TraceSums whole = traced(plan(21));
    const std::filesystem::path path = folder / "stopped.sums";
    const PathTracer paths = tracer();
    write_sums(path, {7, {}, {{"name", "value"}}, empty()});
    int stops = 0;
    for (;;) {
        SumsFile file = read_sums(path);
        EXPECT_EQ(file.print, 7u);
        EXPECT_EQ(file.words.at("name"), "value");
        const CancelToken token;
        std::atomic<int> reports{0};
        // At another place each time, in the middle of tiles and between them.
        const Progress progress(
            [&](std::string_view, double) {
                if (++reports > 1 + stops % 5) token.cancel();
            },
            token);
        const TraceEnd end = run_trace(paths, file.sums, plan(21), progress, [] {});
        write_sums(path, file);
        if (end == TraceEnd::samples) break;
        ASSERT_LT(++stops, 1000);
    }
    EXPECT_GT(stops, 3);
    EXPECT_TRUE(whole == read_sums(path).sums);
}

TEST_F(TraceRun, OfShardsMergedIsThatOfOne) {
    const TraceSums whole = traced(plan(13));
    for (const int count : {2, 3, 7}) {
        TraceSums sums = empty();
        for (int i = count - 1; i >= 0; --i) sums.merge(traced(plan(13, {i, count})));
        EXPECT_TRUE(whole == sums) << count;
    }
}

TEST_F(TraceRun, StopsAtAnErrorAtTheSameSampleAlways) {
    TracePlan p = plan(4096);
    p.error = 0.08;
    const TraceSums sums = traced(p);
    EXPECT_LE(sums.relative_error(), 0.08);
    EXPECT_LT(sums.fewest_samples(), 4096u);
    EXPECT_TRUE(sums == traced(p));
}

// The stated error is at least the true one: points that are spread evenly have less than independent ones.
TEST_F(TraceRun, StatesAnErrorThatIsNotBelowTheTrueOne) {
    const Image truth = traced(plan(1024)).picture();
    const TraceSums few = traced(plan(16));
    const Image noisy = few.picture();
    double squares = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < truth.pixels.size(); i += 4) {
        const auto y = [&](const Image& m) {
            return 0.2126 * static_cast<double>(m.pixels[i]) +
                   0.7152 * static_cast<double>(m.pixels[i + 1]) +
                   0.0722 * static_cast<double>(m.pixels[i + 2]);
        };
        squares += (y(truth) - y(noisy)) * (y(truth) - y(noisy));
        mean += y(truth);
    }
    const double pixels = kWidth * kHeight;
    const double error = std::sqrt(squares / pixels) / (mean / pixels);
    EXPECT_LT(error, 1.1 * few.relative_error());
    EXPECT_GT(error, 0.1 * few.relative_error());
}

TEST_F(TraceRun, SavesWhileItGoesOn) {
    TracePlan p = plan(1 << 14);
    p.save_every = 0.0;
    p.seconds = 0.3;
    int saves = 0;
    TraceSums sums = empty();
    EXPECT_EQ(run_trace(tracer(), sums, p, {}, [&] { ++saves; }), TraceEnd::time);
    EXPECT_GT(saves, 0);
}

TEST(SumsFile, OfAnotherKindCutOrChangedIsRefused) {
    const test::ScratchFolder folder;
    const std::filesystem::path path = folder / "part.sums";
    write_sums(path, {1, {1, 3}, {}, TraceSums(5, 4, false)});
    EXPECT_EQ(read_sums(path).shard.count, 3);
    std::string bytes;
    {
        std::ifstream in(path, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(in), {});
    }
    const auto refused = [&](const std::string& changed) {
        std::ofstream(path, std::ios::binary) << changed;
        EXPECT_THROW(read_sums(path), Error);
    };
    refused("");
    refused("P6 3 3 255\n");
    refused(bytes.substr(0, bytes.size() / 2));
    refused(bytes + "x");
    std::string flipped = bytes;
    flipped[bytes.size() / 2] = static_cast<char>(flipped[bytes.size() / 2] ^ 1);
    refused(flipped);
    std::string huge = bytes;
    huge.replace(huge.find("width=5"), 7, "width=9999999");
    refused(huge);
}

TEST(ScenePrint, TellsScenesApart) {
    const Scene scene = test::one_object(test::unit_plane(), test::rough_metal());
    const Environment sky = test::constant_environment(glm::vec3(1.0f));
    const RenderSettings settings;
    const auto print = [&](const Scene& s, const RenderSettings& r, int depth) {
        return scene_print(s, sky, Camera{}, r, depth);
    };
    const std::uint64_t first = print(scene, settings, 2);
    EXPECT_EQ(first, print(scene, settings, 2));
    EXPECT_NE(first, print(scene, settings, 3));
    Scene changed = scene;
    changed.materials[0].method = Method::rotate_arc;
    EXPECT_NE(first, print(changed, settings, 2));
    changed = scene;
    changed.meshes[0].positions[2].y += 1e-4f;
    EXPECT_NE(first, print(changed, settings, 2));
    RenderSettings other = settings;
    other.seed = 3;
    EXPECT_NE(first, print(scene, other, 2));
    other = settings;
    other.samples = 3;  // a trace may go on to more samples
    EXPECT_EQ(first, print(scene, other, 2));
}

}  // namespace
}  // namespace burnish
