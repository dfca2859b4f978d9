// How much memory there is to be had, for jobs that are to be refused before they start.
#pragma once

#include <cstdint>

namespace burnish {

// Bytes that this process can still use: the least of what the kernel calls available, what its
// control group leaves and what the limit of its address space leaves. The largest number when
// nothing of it is known.
std::uint64_t available_memory();

// For programs that time software rendering: the allocator keeps freed blocks of up to 256 MiB
// instead of giving them back to the system. llvmpipe asks anew every few frames for the memory of
// transformed vertices (44 MB for 100 k triangles), whose page faults can take longer than the
// frames.
void keep_freed_memory();

}  // namespace burnish
