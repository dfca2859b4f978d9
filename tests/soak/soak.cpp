// Renders random scenes at low resolution in one process until the time is up: every pixel must be
// finite, everything broken must be refused in words, and memory must not grow. Prints what it did
// every minute. Usage: burnish_soak [--seconds N] [--seed N] [--first N] [--stages N]
//
// A failure names the seed and the number of its stage; `--seed S --first N --stages 1` repeats it.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

#include "burnish/context.hpp"
#include "burnish/error.hpp"
#include "burnish/renderer.hpp"
#include "memory_use.hpp"
#include "random_scene.hpp"

namespace burnish::soak {
namespace {

constexpr int kNoDevice = 77;
// Shaders take longer to compile than small pictures to draw.
constexpr int kModelsOfAStage = 2, kPicturesOfAModel = 8;
constexpr std::uint64_t kStagesOfAContext = 10;

struct Settings {
    double seconds = 5.0;
    std::uint64_t seed = 1;
    std::uint64_t first = 0;
    std::uint64_t stages = UINT64_MAX;
};

Settings settings_of(int count, char** arguments) {
    Settings settings;
    for (int i = 1; i + 1 < count; i += 2) {
        const std::string name = arguments[i];
        if (name == "--seconds")
            settings.seconds = std::stod(arguments[i + 1]);
        else if (name == "--seed")
            settings.seed = std::stoull(arguments[i + 1]);
        else if (name == "--first")
            settings.first = std::stoull(arguments[i + 1]);
        else if (name == "--stages")
            settings.stages = std::stoull(arguments[i + 1]);
        else
            throw std::runtime_error("unknown flag " + name);
    }
    return settings;
}

struct Counts {
    std::uint64_t stages = 0, pictures = 0, refusals = 0;
};

void expect_finite(const Image& image) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float v = image.pixels[i];
        if (std::isfinite(v) && v >= 0.0f && v <= 65504.0f) continue;
        throw std::runtime_error(fmt::format("value {} of the picture is {}", i, v));
    }
}

template <typename Action>
void expect_refusal(const std::string& what, Action action) {
    try {
        action();
    } catch (const Error& error) {
        if (std::strpbrk(error.what(), "\r\n") == nullptr) return;
        throw std::runtime_error(what + ": an error of two lines");
    }
    throw std::runtime_error(what + ": not refused");
}

gpu::Renderer renderer_of(gpu::Context& context, const Stage& stage) {
    return {context, stage.scene,
            stage.environment.radiance.empty() ? nullptr : &stage.environment};
}

void run_broken(gpu::Context& context, Random& random, Counts& counts) {
    const BadValue bad = bad_value(random);
    ParameterValues values;
    expect_refusal(fmt::format("{} '{}'", bad.name, bad.text),
                   [&] { values.set(bad.name, bad.text, ""); });
    Stage stage = random_stage(random);
    const std::string way = break_stage(stage, random);
    expect_refusal(way, [&] { renderer_of(context, stage).render(stage.camera, stage.settings); });
    counts.refusals += 2;
}

void run_stage(gpu::Context& context, Random& random, Counts& counts) {
    Stage stage = random_stage(random);
    gpu::Renderer renderer = renderer_of(context, stage);
    for (int model = 0; model < kModelsOfAStage; ++model) {
        for (int picture = 0; picture < kPicturesOfAModel; ++picture) {
            expect_finite(renderer.render(stage.camera, stage.settings));
            ++counts.pictures;
            change_numbers(stage, random);
            renderer.set_materials(stage.scene.materials);
        }
        change_models(stage, random);
        renderer.set_materials(stage.scene.materials);
    }
    ++counts.stages;
}

class Clock {
  public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void report(double seconds, const Counts& counts, const MemoryUse& use, const char* when) {
    constexpr double kMiB = 1024.0 * 1024.0;
    fmt::print(
        "{:6.1f} min {}: {} stages, {} pictures, {} refusals, resident {:.1f} MiB, live {:.2f} "
        "MiB\n",
        seconds / 60.0, when, counts.stages, counts.pictures, counts.refusals,
        static_cast<double>(use.resident) / kMiB, static_cast<double>(use.live) / kMiB);
    std::fflush(stdout);
}

// Watches memory. What stays when a context has gone is what can leak; in between, drivers hold on
// to deleted textures until they need the place. The first fifth of the time fills caches and is
// left out.
class Watch {
  public:
    explicit Watch(double seconds) : warm_(seconds / 5.0) {}

    void look(double now, const Counts& counts) {
        if (now < next_) return;
        report(now, counts, memory_use(), "running");
        next_ += 60.0;
    }
    void look_between_contexts(double now, const Counts& counts) {
        const MemoryUse use = memory_use();
        report(now, counts, use, "no context");
        if (now < warm_) return;
        resident_.add(now / 60.0, static_cast<double>(use.resident));
        live_.add(now / 60.0, static_cast<double>(use.live));
    }
    void finish(double now, const Counts& counts) const {
        report(now, counts, memory_use(), "end");
        fmt::print(
            "slope without a context, after {:.1f} min: resident {:.1f} KiB/min, live {:.1f} "
            "KiB/min\n",
            warm_ / 60.0, resident_.bytes_per_minute() / 1024.0, live_.bytes_per_minute() / 1024.0);
    }

  private:
    double warm_;
    double next_ = 60.0;
    Trend resident_, live_;
};

void run(const Settings& settings) {
    auto context = std::make_unique<gpu::Context>();
    fmt::print("{}; seed {}\n", context->renderer(), settings.seed);
    const Clock clock;
    Watch watch(settings.seconds);
    Counts counts;
    for (std::uint64_t n = 0; n < settings.stages && clock.seconds() < settings.seconds; ++n) {
        const std::uint64_t stage = settings.first + n;
        // Odd multipliers keep neighbouring numbers apart.
        Random random(settings.seed * 0x9E3779B97F4A7C15U + stage * 0xD1B54A32D192ED03U);
        try {
            if (n > 0 && n % kStagesOfAContext == 0) {
                context.reset();
                watch.look_between_contexts(clock.seconds(), counts);
                context = std::make_unique<gpu::Context>();
            }
            if (one_in(random, 8)) run_broken(*context, random, counts);
            run_stage(*context, random, counts);
        } catch (const std::exception& error) {
            throw std::runtime_error(fmt::format("--seed {} --first {} --stages 1: {}",
                                                 settings.seed, stage, error.what()));
        }
        watch.look(clock.seconds(), counts);
    }
    watch.finish(clock.seconds(), counts);
}

}  // namespace
}  // namespace burnish::soak

int main(int count, char** arguments) {
    try {
        const burnish::soak::Settings settings = burnish::soak::settings_of(count, arguments);
        try {
            const burnish::gpu::Context probe;
        } catch (const burnish::Error& error) {
            fmt::print("SKIPPED, nothing was tested: {}\n", error.what());
            return burnish::soak::kNoDevice;
        }
        burnish::soak::run(settings);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "burnish_soak: %s\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
