// Limits that every reader of pictures keeps.
#pragma once

#include <cstdint>

namespace burnish {

// Bytes that are decoded at a time, so that a file whose first rows are broken costs no more.
inline constexpr std::uint64_t kBandBytes = std::uint64_t{32} << 20;

// Channels of one picture or part.
inline constexpr int kMaxChannels = 64;

}  // namespace burnish
