// burnish bench frame: costs of frames by technique (K11 Fig 11, K12 Table I and Fig 7), on the
// available GL.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/frame/frame_bench.hpp"
#include "bench/frame/timer_check.hpp"
#include "burnish/progress.hpp"

namespace burnish::plot {
struct Figure;
}

namespace burnish {

struct FrameCostRequest {
    std::vector<FrameCase> cases;       // one or more
    std::vector<Technique> techniques;  // gouraud and normal-map are always measured
    int rounds = 15;                    // interleaved
    double sample_s = 0.06;             // approximate length of one sample
    int gl_device = -1;                 // -1: the first hardware device, else software
    std::filesystem::path output;       // OUT.json, with OUT.md and OUT.svg beside it; empty: none
    std::string command;                // for metadata
};

// The default cases: five meshes at 1280x720, and 102 k triangles at 1920x1080 and 3840x2160.
// Quick: 4 k and 102 k triangles at 1280x720.
std::vector<FrameCase> default_frame_cases(bool quick);

// All techniques on the default cases with suitable rounds and samples. Quick: a rough estimate in
// less than a minute on two cores without a GPU.
FrameCostRequest default_frame_request(bool quick);

// A technique and its bases, measured in alternation: the bases first, itself last (`normal-map`
// has one base, `gouraud` none and no samples).
struct TechniqueCost {
    Technique technique;
    std::vector<Technique> subjects;  // those of `samples`, in its order
    RoundSamples samples;

    // Index in `subjects`; empty if absent.
    std::optional<std::size_t> place_of(std::string_view name) const;
    Estimated against(std::string_view base, Clock clock) const;
    Estimated frame_s(Clock clock) const;
};

struct FrameCaseCost {
    FrameCase asked;
    std::size_t triangles = 0;
    std::size_t covered_pixels = 0;
    std::vector<TechniqueCost> costs;  // in the order of `techniques`
    // K12 Fig 7: normal-map, rotate-approx, rotate-exact in alternation, with twice the rounds; no
    // samples unless both rotations are requested.
    TechniqueCost rotation;

    // Ratio of `cost` to Gouraud shading; for gouraud itself 1, and its time measured with
    // normal-map.
    Estimated against_gouraud(const TechniqueCost& cost, Clock clock) const;
    Estimated frame_s(const TechniqueCost& cost, Clock clock) const;
};

struct FrameCost {
    std::string device, driver;  // GL_RENDERER, GL_VERSION
    bool software = false;
    TimerVerdict timer;
    std::string processor;
    unsigned threads = 0;
    double load_before = 0, load_after = 0;  // averages over the last minute; negative: unknown
    std::string date;                        // UTC, of the start
    std::string command;
    int rounds = 0;
    double sample_s = 0;
    std::vector<FrameCaseCost> cases;
    std::vector<std::string> warnings;

    // Marks a timer as unusable, with the reason, that passed its check but gave no time for a
    // sample: otherwise ratios would exist for some techniques only.
    void distrust_silent_timer();

    // The clock of the ratios: the device's if its timer is reliable, else wall time.
    Clock clock() const { return timer.usable ? Clock::device : Clock::wall; }
};

// Measures. Throws UsageError for an invalid request and Error for an unsuitable device, both
// before measuring, and Interrupted. Creates its own context. Programs should call
// keep_freed_memory() (core/memory.hpp) first: otherwise the times include llvmpipe's page faults.
FrameCost measure_frame_cost(const FrameCostRequest& request, const Progress& progress = {});

// Every sample, with medians and spreads.
std::string frame_cost_json(const FrameCost& cost);
// Tables with the papers' figures beside ours.
std::string frame_cost_markdown(const FrameCost& cost);
// Bars, a row of panels for each case.
plot::Figure frame_cost_figure(const FrameCost& cost);
std::string frame_cost_svg(const FrameCost& cost);

// Measures and writes OUT.json, OUT.md and OUT.svg, all or none; returns their paths.
struct FrameCostReport {
    FrameCost cost;
    std::vector<std::filesystem::path> written;  // empty without an output
};
FrameCostReport bench_frame(const FrameCostRequest& request, const Progress& progress = {});

}  // namespace burnish
