#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <set>
#include <utility>

#include "burnish/display.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/file_lock.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "jobs/trace_output.hpp"

namespace burnish {
namespace {

constexpr int kMostShards = 1 << 20;

std::string word(const SumsFile& file, const std::string& name, const std::string& otherwise) {
    const auto found = file.words.find(name);
    return found == file.words.end() ? otherwise : found->second;
}

void require_of_one_trace(const SumsFile& first, const SumsFile& other,
                          const std::filesystem::path& path) {
    const bool same = first.print == other.print && first.shard.count == other.shard.count &&
                      first.sums.width() == other.sums.width() &&
                      first.sums.height() == other.sums.height() &&
                      first.sums.has_layers() == other.sums.has_layers();
    if (!same)
        throw Error(path.string(), "", "a part of the same trace as the first file",
                    "another scene, other parameters or another number of shards");
}

void write_merged(const MergeRequest& request, const SumsFile& file, const TraceSums& sums) {
    Metadata metadata;
    for (const auto& [name, value] : file.words)
        if (name.starts_with("burnish:")) metadata[name] = value;
    metadata["burnish:command"] = request.command;
    if (sums.has_layers() && holds_linear(request.output)) {
        write_layers(request.output, sums, metadata);
        return;
    }
    const Image linear = sums.picture();
    if (holds_linear(request.output)) {
        write_image(request.output, linear, metadata, {});
        return;
    }
    const double exposure = std::strtod(word(file, "exposure_ev", "0").c_str(), nullptr);
    const int tone_map = std::atoi(word(file, "tone_map", "0").c_str());
    const int known = std::clamp(tone_map, 0, static_cast<int>(tone_map_names().size()) - 1);
    WriteOptions options;
    options.bits = word(file, "bits", "8") == "16" ? 16 : 8;
    options.dither = word(file, "dither", "1") == "1";
    write_image(request.output, to_display(linear, exposure, static_cast<ToneMap>(known)), metadata,
                options);
}

int whole(std::string_view text, const std::string& where) {
    int value = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < 0 ||
        value > kMostShards)
        throw UsageError(where, "", fmt::format("a whole number from 0 to {}", kMostShards),
                         shown(std::string(text)));
    return value;
}

TraceShard checked(TraceShard shard, const std::string& where) {
    if (shard.count >= 1 && shard.index < shard.count) return shard;
    throw UsageError(where, "", "INDEX/COUNT with an index from 0 to COUNT - 1",
                     fmt::format("{}/{}", shard.index, shard.count));
}

// A variable of the environment as a number; none where it is not set.
std::optional<int> variable(const char* name) {
    const char* text = std::getenv(name);
    return text == nullptr ? std::nullopt : std::optional(whole(text, name));
}

// Elements of an array of jobs of Slurm; their numbers may begin anywhere and have a step.
std::optional<TraceShard> shard_of_array() {
    const auto id = variable("SLURM_ARRAY_TASK_ID"), count = variable("SLURM_ARRAY_TASK_COUNT");
    if (!id || !count) return std::nullopt;
    const int step = std::max(variable("SLURM_ARRAY_TASK_STEP").value_or(1), 1);
    return TraceShard{(*id - variable("SLURM_ARRAY_TASK_MIN").value_or(0)) / step, *count};
}

std::optional<TraceShard> shard_of_task() {
    constexpr std::array<std::array<const char*, 2>, 4> kVariables = {{
        {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
        {"SLURM_PROCID", "SLURM_NTASKS"},
        {"PMI_RANK", "PMI_SIZE"},
        {"PMIX_RANK", "PMIX_SIZE"},
    }};
    for (const auto& [rank, size] : kVariables) {
        const auto index = variable(rank), count = variable(size);
        if (index && count) return TraceShard{*index, *count};
    }
    return std::nullopt;
}

TraceShard shard_of_environment(const std::string& where) {
    const auto array = shard_of_array(), task = shard_of_task();
    if (!array && !task)
        throw UsageError(where, "",
                         "the variables of mpirun (OMPI_COMM_WORLD_RANK), Slurm (SLURM_PROCID, "
                         "SLURM_ARRAY_TASK_ID) or PMI (PMI_RANK) for env",
                         "none of them");
    // Every task of every element of an array is a shard of its own.
    const TraceShard outer = array.value_or(TraceShard{}), inner = task.value_or(TraceShard{});
    return checked({outer.index * inner.count + inner.index, outer.count * inner.count}, where);
}

}  // namespace

TraceReport merge_traces(const MergeRequest& request, const Progress& progress) {
    require_image_extension(request.output);
    if (request.parts.empty()) throw UsageError("--merge", "", "one or more files of sums", "none");
    require_writable(request.output);
    const FileLock lock(sums_path(request.output));
    SumsFile first = read_sums(request.parts.front());
    std::set<int> shards = {first.shard.index};
    for (std::size_t i = 1; i < request.parts.size(); ++i) {
        progress.step("merge", static_cast<double>(i) / static_cast<double>(request.parts.size()));
        const SumsFile part = read_sums(request.parts[i]);
        require_of_one_trace(first, part, request.parts[i]);
        if (!shards.insert(part.shard.index).second)
            throw Error(request.parts[i].string(), "", "each shard once",
                        fmt::format("shard {} again", part.shard.index));
        first.sums.merge(part.sums);
    }
    TraceReport report;
    const auto missing = first.shard.count - static_cast<int>(shards.size());
    if (missing > 0)
        report.warnings.push_back(fmt::format(
            "{} of {} shards are missing: the picture has more noise", missing, first.shard.count));
    write_merged(request, first, first.sums);
    report.written.push_back(request.output);
    report.samples = first.sums.fewest_samples();
    report.error = first.sums.relative_error();
    report.notes.push_back(fmt::format("{} samples a pixel, estimated noise {:.3g} of the mean",
                                       report.samples, report.error));
    return report;
}

TraceShard parse_shard(const std::string& text, const std::string& where) {
    if (text == "env") return shard_of_environment(where);
    const std::size_t slash = text.find('/');
    if (slash == text.npos)
        throw UsageError(where, "", "INDEX/COUNT, such as 0/8, or env", shown(text));
    return checked({whole(std::string_view(text).substr(0, slash), where),
                    whole(std::string_view(text).substr(slash + 1), where)},
                   where);
}

}  // namespace burnish
