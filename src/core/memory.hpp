// How much memory there is to be had, for jobs that are to be refused before they start.
#pragma once

#include <cstdint>

namespace burnish {

// Bytes that this process can still use: the least of what the kernel calls available, what its
// control group leaves and what the limit of its address space leaves. The largest number when
// nothing of it is known.
std::uint64_t available_memory();

}  // namespace burnish
