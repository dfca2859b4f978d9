// What traces write: pictures with layers, and what a file of sums says of the picture that is made of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "burnish/trace.hpp"
#include "jobs/render.hpp"
#include "reference/sums_file.hpp"

namespace burnish {

// What sums must have in common to be added.
struct SumsKey {
    std::uint64_t print = 0;
    TraceShard shard;
};

// For merge_traces, which has no stage: exposure, tone map, how display files are written, and metadata.
std::map<std::string, std::string> words_of(const TraceRequest& request, const Stage& stage);

// Color, variance and, where there are any, the other layers as parts of one OpenEXR file.
void write_layers(const std::filesystem::path& path, const TraceSums& sums,
                  const Metadata& metadata);

}  // namespace burnish
