// burnish trace: a picture by paths, offline, and the sum of what several processes have traced.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/trace.hpp"
#include "cli/commands/commands.hpp"
#include "cli/integer_flag.hpp"
#include "cli/scene_flags.hpp"
#include "cli/session.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kTraceExamples = R"(
Examples:
  burnish trace scene.json -o picture.exr --samples 256
  burnish trace builtin:sphere --metal steel --alpha-x 0.08 --alpha-y 0.4 \
      --normal-map builtin:bumps --error 0.01 -o picture.png
  burnish trace scene.json -o picture.exr --max-time 600 --layers
  burnish trace scene.json -o picture.exr --resume
  mpirun -n 8 burnish trace scene.json -o picture.exr --shard env
  burnish trace --merge picture.exr.*of8.sums -o picture.exr
Flags and parameters are those of `burnish render`; those of its image light say nothing here.)";

struct TraceFlags {
    SceneFlags scene;
    TraceRequest request;  // without its stage
    std::string output;
    int depth = -1;  // -1: none was given
    std::optional<std::string> shard;
    std::vector<std::string> merge;
};

void print_trace(const TraceReport& report) {
    print_report(report.warnings, report.written, report.notes);
    if (report.interrupted) throw Interrupted();
}

void run_trace(TraceFlags& flags, const Session& session) {
    if (!flags.merge.empty()) {
        MergeRequest merge;
        merge.parts.assign(flags.merge.begin(), flags.merge.end());
        if (!flags.scene.stage.input.empty()) merge.parts.emplace_back(flags.scene.stage.input);
        merge.output = flags.output;
        merge.command = session.command_line();
        print_trace(merge_traces(merge, session.progress()));
        return;
    }
    TraceRequest& request = flags.request;
    request.stage = stage_request(flags.scene);
    if (request.stage.input.empty())
        throw UsageError("trace", "", "a MODEL or SCENE, or --merge", "neither");
    request.output = flags.output;
    request.command = session.command_line();
    if (flags.depth >= 0) request.depth = flags.depth;
    if (flags.shard) request.shard = parse_shard(*flags.shard);
    print_trace(trace(request, session.progress()));
}

void add_trace_flags(CLI::App& command, TraceFlags& flags) {
    constexpr const char* kGroup = "Trace";
    TraceRequest& request = flags.request;
    add_integer(command, "--depth", flags.depth, {0, 1000},
                "reflections between surfaces; 0: lights and environment alone; default: --bounces "
                "where it is given, else 8")
        ->group(kGroup);
    command
        .add_option(
            "--error", request.error,
            "stop when the estimated noise of the picture is this share of its mean, such as "
            "0.01; --samples is the most that are taken")
        ->type_name("NUMBER")
        ->group(kGroup);
    command
        .add_option("--max-time", request.max_time_s,
                    "stop after so many seconds; --resume goes on")
        ->type_name("SECONDS")
        ->group(kGroup);
    command
        .add_flag("--resume", request.resume,
                  "go on with OUT.sums, which a trace that was stopped has left")
        ->group(kGroup);
    command
        .add_flag("--keep-sums", request.keep_sums, "keep OUT.sums, to go on with --resume later")
        ->group(kGroup);
    command
        .add_flag("--layers", request.layers,
                  ".exr: variance, albedo, normal, grain and depth as further parts of the file")
        ->group(kGroup);
    command
        .add_option("--shard", flags.shard,
                    "INDEX/COUNT, such as 0/8: trace every COUNT-th sample, and write the sums to "
                    "OUT.INDEXofCOUNT.sums; env: take both from mpirun, Slurm or PMI")
        ->type_name("SHARD")
        ->group(kGroup);
    command.add_option("--merge", flags.merge, "add up these files of sums, and write the picture")
        ->type_name("SUMS")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group(kGroup);
}

}  // namespace

void add_trace_command(CLI::App& parent, Session& session) {
    CLI::App* command = parent.add_subcommand("trace", "Trace a model or a scene file by paths");
    const auto flags = std::make_shared<TraceFlags>();
    command
        ->add_option("-o,--output", flags->output,
                     ".exr (linear), .png, .jpg or .tif (tone mapped)")
        ->required()
        ->type_name("FILE");
    add_scene_flags(*command, flags->scene, false);
    add_trace_flags(*command, *flags);
    add_scene_parameter_flags(*command, flags->scene);
    command->footer(kTraceExamples);
    command->callback([flags, &session] { run_trace(*flags, session); });
}

}  // namespace burnish::cli
