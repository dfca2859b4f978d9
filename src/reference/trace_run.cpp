#include "reference/trace_run.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

#include "burnish/error.hpp"
#include "core/index_of.hpp"
#include "core/parallel.hpp"

namespace burnish {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFirstSave = 2.0;  // seconds

// Samples between two looks at the error, and the first looks.
constexpr std::uint32_t kRound = 16;

std::uint32_t next_round(std::uint32_t done) {
    return done < kRound ? std::max(2 * done, 1U) : (done / kRound + 1) * kRound;
}

class Run {
  public:
    Run(const PathTracer& tracer, TraceSums& sums, const TracePlan& plan, const Progress& progress)
        : tracer_(tracer),
          sums_(sums),
          plan_(plan),
          progress_(progress),
          own_(samples_of_shard(plan.samples, plan.shard)),
          pixels_(static_cast<double>(sums.width()) * sums.height()) {}

    TraceEnd until_end(const std::function<void()>& save) {
        saved_ = Clock::now();
        error_ = sums_.relative_error();
        for (std::uint32_t target = std::min(next_round(sums_.fewest_samples()), own_);;
             target = std::min(next_round(target), own_)) {
            while (sums_.fewest_samples() < target) {
                add_until(target);
                if (cancelled_) return TraceEnd::cancelled;
                if (is_late()) return TraceEnd::time;
                if (since(saved_) > save_after()) {
                    save();
                    saved_ = Clock::now();
                }
            }
            if (plan_.error > 0.0) {
                error_ = sums_.relative_error();
                if (error_ <= own_target()) return TraceEnd::error;
            }
            if (target >= own_) return TraceEnd::samples;
        }
    }

  private:
    static double since(Clock::time_point from) {
        return std::chrono::duration<double>(Clock::now() - from).count();
    }
    bool is_late() const { return plan_.seconds > 0.0 && since(start_) >= plan_.seconds; }
    // A shard has a part of the samples, and so much more noise.
    double own_target() const {
        return plan_.error * std::sqrt(static_cast<double>(plan_.shard.count));
    }
    // Sooner at first: what is lost is never more than half of what was done, or kFirstSave.
    double save_after() const {
        return std::min(std::max(since(start_) / 2.0, kFirstSave), plan_.save_every);
    }
    bool must_pause() {
        if (progress_.cancelled()) cancelled_ = true;
        return cancelled_ || is_late() || since(saved_) > save_after();
    }

    // Brings every tile to `target` samples, or pauses.
    void add_until(std::uint32_t target) {
        parallel_for(index_of(sums_.tile_count()), 1, [&](std::size_t begin, std::size_t) {
            const int tile = static_cast<int>(begin);
            while (sums_.samples(tile) < target && !must_pause()) add_sample(tile);
            report();
        });
    }

    void add_sample(int tile) {
        const std::uint32_t number =
            static_cast<std::uint32_t>(plan_.shard.index) +
            sums_.samples(tile) * static_cast<std::uint32_t>(plan_.shard.count);
        const TraceSums::Tile t = sums_.tile(tile);
        for (int y = t.y0; y < t.y1; ++y)
            for (int x = t.x0; x < t.x1; ++x) sums_.add(x, y, tracer_.sample(x, y, number));
        sums_.count_sample(tile);
        added_ += static_cast<std::uint64_t>((t.x1 - t.x0) * (t.y1 - t.y0));
    }

    double share_done() const {
        double done = (static_cast<double>(added_) / pixels_ + static_cast<double>(first_)) / own_;
        if (plan_.seconds > 0.0) done = std::max(done, since(start_) / plan_.seconds);
        // Noise falls with the root of the number of samples.
        if (plan_.error > 0.0 && std::isfinite(error_) && error_ > 0.0)
            done = std::max(done, std::pow(own_target() / error_, 2.0));
        return std::min(done, 1.0);
    }

    void report() {
        const std::unique_lock lock(reporting_, std::try_to_lock);
        if (!lock) return;
        try {
            progress_.step("trace", share_done());
        } catch (const Interrupted&) {
            cancelled_ = true;
        }
    }

    const PathTracer& tracer_;
    TraceSums& sums_;
    TracePlan plan_;
    const Progress& progress_;
    std::uint32_t own_;
    double pixels_;
    std::uint32_t first_ = sums_.fewest_samples();
    Clock::time_point start_ = Clock::now(), saved_ = start_;
    std::atomic<std::uint64_t> added_{0};
    std::atomic<bool> cancelled_{false};
    double error_ = 0.0;
    std::mutex reporting_;
};

}  // namespace

std::uint32_t samples_of_shard(std::uint32_t samples, const TraceShard& shard) {
    const auto index = static_cast<std::uint32_t>(shard.index);
    const auto count = static_cast<std::uint32_t>(shard.count);
    return samples > index ? (samples - index - 1) / count + 1 : 0;
}

TraceEnd run_trace(const PathTracer& tracer, TraceSums& sums, const TracePlan& plan,
                   const Progress& progress, const std::function<void()>& save) {
    if (plan.samples < 1 || plan.samples > kMostTraceSamples)
        throw Error("trace", "samples", "1 to " + std::to_string(kMostTraceSamples),
                    std::to_string(plan.samples));
    if (samples_of_shard(plan.samples, plan.shard) == 0) return TraceEnd::samples;
    return Run(tracer, sums, plan, progress).until_end(save);
}

}  // namespace burnish
