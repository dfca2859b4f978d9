#include "burnish/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "burnish/display.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/file_lock.hpp"
#include "core/files.hpp"
#include "core/memory.hpp"
#include "jobs/render.hpp"
#include "jobs/trace_output.hpp"
#include "reference/path_tracer.hpp"
#include "reference/scene_print.hpp"
#include "reference/sums_file.hpp"
#include "reference/trace_run.hpp"

namespace burnish {
namespace {

constexpr int kUsualDepth = 8, kMostDepth = 1000;
constexpr std::uint32_t kMostWithoutNumber = 65536;  // samples, where error or time end the trace

void check(const TraceRequest& r) {
    require_image_extension(r.output);
    if (r.layers && !r.shard && !holds_linear(r.output))
        throw UsageError(r.output.string(), "", "a .exr for --layers",
                         r.output.extension().string());
    if (r.depth && (*r.depth < 0 || *r.depth > kMostDepth))
        throw UsageError("--depth", "", fmt::format("0 to {}", kMostDepth),
                         fmt::to_string(*r.depth));
    if (!(r.error >= 0.0) || std::isinf(r.error))
        throw UsageError("--error", "", "a number of at least 0", fmt::to_string(r.error));
    if (!(r.max_time_s >= 0.0) || std::isinf(r.max_time_s))
        throw UsageError("--max-time", "", "a number of at least 0", fmt::to_string(r.max_time_s));
}

int reflections_of(const TraceRequest& request, const Stage& stage) {
    if (request.depth) return *request.depth;
    return stage.values.is_set("bounces") ? stage.settings.bounces : kUsualDepth;
}

std::uint32_t samples_of(const TraceRequest& request, const Stage& stage) {
    const bool other_end = request.error > 0.0 || request.max_time_s > 0.0;
    if (other_end && !stage.values.is_set("samples")) return kMostWithoutNumber;
    return static_cast<std::uint32_t>(std::max(stage.settings.samples, 1));
}

// Warns of parameters of the real-time renderer that say nothing here.
void warn_of_idle(const TraceRequest& request, const Stage& stage, TraceReport& report) {
    const auto warn = [&](const char* name, const char* why) {
        if (stage.values.is_set(name))
            report.warnings.push_back(fmt::format("{}: {}: nothing changes", flag_of(name), why));
    };
    if (stage.settings.image_light != ImageLight::off)
        warn("image_light", "paths sample the environment itself");
    warn("image_light_samples", "every sample of a pixel looks at the environment once");
    warn("visibility_rays", "paths find what surfaces see of one another");
    warn("robust_mean", "a trace has the plain mean");
    if (request.depth) warn("bounces", "--depth says it");
    if (holds_linear(request.output)) {
        warn("bit_depth", ".exr holds 32-bit floats");
        warn("dither", ".exr holds 32-bit floats");
    }
}

void require_memory(const TraceRequest& request, const Stage& stage) {
    // Sums, and their bytes once more while they are written.
    const std::uint64_t needed =
        2 * TraceSums::bytes_of(stage.settings.width, stage.settings.height, request.layers);
    const std::uint64_t there = available_memory();
    if (needed <= there) return;
    throw Error(
        "trace", "memory",
        fmt::format("{} MB for the sums of {} x {} pixels{}", needed >> 20, stage.settings.width,
                    stage.settings.height, request.layers ? " and layers" : ""),
        fmt::format("{} MB that are free", there >> 20));
}

// The sums to go on with, or empty ones.
TraceSums first_sums(const TraceRequest& request, const Stage& stage, const SumsKey& key,
                     TraceReport& report) {
    const std::filesystem::path path = sums_path(request.output, request.shard);
    const bool there = std::filesystem::exists(path);
    if (!request.resume) {
        if (there)
            report.warnings.push_back(
                fmt::format("{}: the sums of an earlier trace: they are overwritten (--resume goes "
                            "on with them)",
                            path.string()));
        return {stage.settings.width, stage.settings.height, request.layers};
    }
    if (!there) {
        report.notes.push_back(
            fmt::format("{} is not there: the trace begins with its first sample", path.string()));
        return {stage.settings.width, stage.settings.height, request.layers};
    }
    SumsFile file = read_sums(path);
    if (file.print != key.print || file.shard.index != key.shard.index ||
        file.shard.count != key.shard.count || file.sums.has_layers() != request.layers)
        throw Error(path.string(), "", "sums of this scene with these parameters",
                    "those of another trace (without --resume the trace begins anew)");
    report.notes.push_back(
        fmt::format("goes on after {} samples a pixel", file.sums.fewest_samples()));
    return std::move(file.sums);
}

// The picture and the sums, or of a shard the sums alone.
void save(const TraceRequest& request, const Stage& stage, const SumsKey& key,
          const TraceSums& sums) {
    write_sums(sums_path(request.output, request.shard),
               {key.print, key.shard, words_of(request, stage), sums});
    if (request.shard) return;
    const Metadata metadata = picture_metadata(request.command, stage);
    if (request.layers)
        write_layers(request.output, sums, metadata);
    else
        write_picture(request.output, sums.picture(), stage, metadata);
}

std::string end_note(const TraceRequest& request, TraceEnd end, const TraceReport& report) {
    const std::string so_far =
        std::isfinite(report.error)
            ? fmt::format("{} samples a pixel, estimated noise {:.3g} of the mean", report.samples,
                          report.error)
            : fmt::format("{} samples a pixel", report.samples);
    if (end == TraceEnd::cancelled)
        return fmt::format("stopped after {}; --resume goes on", so_far);
    if (end == TraceEnd::time)
        return fmt::format("{} s are over after {}; --resume goes on", request.max_time_s, so_far);
    return so_far;
}

}  // namespace

std::filesystem::path sums_path(const std::filesystem::path& output,
                                const std::optional<TraceShard>& shard) {
    const std::string part = shard ? fmt::format(".{}of{}", shard->index, shard->count) : "";
    return output.string() + part + ".sums";
}

TraceReport trace(const TraceRequest& request, const Progress& progress) {
    check(request);
    const std::filesystem::path sums_file = sums_path(request.output, request.shard);
    require_writable(request.shard ? sums_file : request.output);
    const FileLock lock(sums_file);
    progress.step("load", 0);
    const Stage stage = set_stage(request.stage);
    TraceReport report;
    report.warnings = stage.scene.warnings;
    report.notes = stage.scene.notes;
    warn_of_idle(request, stage, report);
    require_memory(request, stage);

    const int reflections = reflections_of(request, stage);
    const TraceShard shard = request.shard.value_or(TraceShard{});
    const SumsKey key{
        scene_print(stage.scene, stage.environment, stage.camera, stage.settings, reflections),
        shard};
    const PathTracer tracer(stage.scene, stage.environment, stage.camera, stage.settings,
                            reflections);
    TraceSums sums = first_sums(request, stage, key, report);
    const TracePlan plan{samples_of(request, stage), request.error, request.max_time_s, key.shard};
    const TraceEnd end =
        run_trace(tracer, sums, plan, progress, [&] { save(request, stage, key, sums); });
    save(request, stage, key, sums);

    report.samples = sums.fewest_samples();
    report.error = sums.relative_error();
    report.interrupted = end == TraceEnd::cancelled;
    const bool goes_on = end == TraceEnd::cancelled || end == TraceEnd::time;
    report.notes.push_back(end_note(request, end, report));
    if (!request.shard) report.written.push_back(request.output);
    if (request.shard || goes_on || request.keep_sums)
        report.written.push_back(sums_file);
    else
        std::filesystem::remove(sums_file);
    return report;
}

}  // namespace burnish
