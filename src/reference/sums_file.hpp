// Sums of samples on disk: what a trace goes on from, and what shards hand over to be merged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "burnish/trace_shard.hpp"
#include "reference/trace_sums.hpp"

namespace burnish {

struct SumsFile {
    std::uint64_t print = 0;  // of what is traced (scene_print.hpp)
    TraceShard shard;
    std::map<std::string, std::string> words;  // what writers of pictures want to know
    TraceSums sums;
};

// Written whole or not at all. Throws Error.
void write_sums(const std::filesystem::path& path, const SumsFile& file);
// Throws Error naming the file for missing, damaged and foreign ones.
SumsFile read_sums(const std::filesystem::path& path);

}  // namespace burnish
