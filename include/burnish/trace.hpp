// Tracing paths as `burnish trace` does it: from a file and parameters to a picture that is right but for its noise,
// over the same materials, lights and cameras as burnish/render.hpp. docs/theory/tracer.md.
//
// Threads: any number may trace at a time, each works on all cores. Pictures do not depend on the number of threads.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/progress.hpp"
#include "burnish/stage.hpp"
#include "burnish/trace_shard.hpp"

namespace BURNISH_API burnish {

struct TraceRequest {
    StageRequest stage;  // its parameter `samples`: samples a pixel, of all shards together
    std::filesystem::path output;  // .exr (linear), .png, .jpg or .tif (display)
    // Reflections between surfaces, 0 to 1000; none: the parameter `bounces` where it is set, else 8.
    std::optional<int> depth;
    // Stops when the estimated noise of the picture, over its mean, is at most this; 0: at `samples` alone. With it or
    // `max_time_s`, and no `samples` set, at most 65536 samples are taken.
    double error = 0.0;
    double max_time_s = 0.0;  // stops after so many seconds; 0: never
    // Writes the sums of its samples to sums_path in place of a picture; merge_traces adds them up.
    std::optional<TraceShard> shard;
    bool resume = false;  // goes on with the sums of an earlier trace that did not reach its end
    bool layers =
        false;  // .exr: variance, albedo, normal, grain and depth as further parts of the file
    bool keep_sums = false;  // keeps the sums of a trace that has reached its end, to go on later
    std::string command;     // kept in the picture's metadata
};

struct TraceReport {
    std::vector<std::filesystem::path> written;
    std::vector<std::string> warnings;  // what will look different, one line each
    std::vector<std::string> notes;     // what was chosen, one line each
    std::uint32_t samples = 0;          // of every pixel, at the least
    double error = 0.0;                 // as TraceRequest::error; infinite below two samples
    bool interrupted = false;  // `progress` was cancelled; what was traced by then is written
};

// Where the sums of a trace lie, beside its picture: "a.exr" -> "a.exr.sums", of a shard "a.exr.2of8.sums".
std::filesystem::path sums_path(const std::filesystem::path& output,
                                const std::optional<TraceShard>& shard = {});

// Every output is written whole or not at all; now and then while it goes on, and at its end. Throws UsageError for
// combinations that make no sense before anything is traced, and Error for everything else that fails: another trace
// into the same file at the same time, sums of another scene, too little memory.
TraceReport trace(const TraceRequest& request, const Progress& progress = {});

struct MergeRequest {
    std::vector<std::filesystem::path> parts;  // files of sums
    std::filesystem::path output;
    std::string command;
};

// The picture of all samples of the parts, bit for bit that of one trace of them all. Throws Error for parts of
// different scenes and for one part twice; a warning names shards that are not there.
TraceReport merge_traces(const MergeRequest& request, const Progress& progress = {});

// "2/8", or "env": the rank and the number of tasks that mpirun, Slurm (tasks or arrays) or PMI have set. Throws
// UsageError naming `where`.
TraceShard parse_shard(const std::string& text, const std::string& where = "--shard");

}  // namespace burnish
