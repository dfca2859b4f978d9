// The chunks of a PNG file, from IHDR to IEND. Needed until OpenImageIO hands libpng's complaints
// to its caller and refuses damaged files: 2.4 lets libpng print them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "image/guard/byte_cursor.hpp"

namespace burnish {

// Throws Error when a chunk is missing or cut short, one that makes the picture fails its checksum,
// or the sizes make no sense. libpng would find most of that itself, but prints its finds to the
// standard error stream.
void check_png(const ByteCursor& file);

// The file without the chunks we have no use for (colour profiles, thumbnails, unknown or damaged
// ones ...), which libpng would decompress, complain about on the standard error stream, or obey.
// Empty when there are none. `bytes` have passed check_png.
std::vector<std::byte> without_unused_chunks(std::span<const std::byte> bytes);

}  // namespace burnish
