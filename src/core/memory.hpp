// The memory that is available, so that a job that does not fit is refused before it starts.
#pragma once

#include <cstdint>

namespace burnish {

// Bytes that this process can still use: the least of the kernel's available memory, the rest of
// its control group's limit and the rest of its address space's limit. The largest number when none
// of the three is known.
std::uint64_t available_memory();

// For programs that time software rendering: the allocator keeps freed blocks of up to 256 MiB
// instead of giving them back to the system. Every few frames llvmpipe allocates memory for
// transformed vertices (44 MB for 100 k triangles), whose page faults can take longer than the
// frames.
void keep_freed_memory();

}  // namespace burnish
