// A trace from its first sample to its last: tiles over all cores, until enough is known.
#pragma once

#include <cstdint>
#include <functional>

#include "burnish/progress.hpp"
#include "reference/path_tracer.hpp"
#include "reference/sums_file.hpp"

namespace burnish {

// When to stop, at whichever comes first.
struct TracePlan {
    std::uint32_t samples = 64;  // a pixel, of all shards together; 1 to kMostTraceSamples
    double error = 0.0;          // TraceSums::relative_error of all shards together; 0: never
    double seconds = 0.0;        // of the clock; 0: never
    TraceShard shard;
    double save_every = 30.0;  // seconds; sooner in the first minute
};

enum class TraceEnd { samples, error, time, cancelled };

// Goes on with the sums. Errors are looked at after numbers of samples that depend on nothing but the plan, so that
// two runs stop at the same sample. `save` is called now and then while no sample is being added. Does not throw when
// `progress` is cancelled: the samples of every tile are whole.
TraceEnd run_trace(const PathTracer& tracer, TraceSums& sums, const TracePlan& plan,
                   const Progress& progress, const std::function<void()>& save);

// Samples of a pixel that a shard takes of `samples`.
std::uint32_t samples_of_shard(std::uint32_t samples, const TraceShard& shard);

}  // namespace burnish
