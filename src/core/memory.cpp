#include "core/memory.hpp"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace burnish {
namespace {

constexpr std::uint64_t kUnknown = std::numeric_limits<std::uint64_t>::max();

std::optional<std::uint64_t> number_in(const char* file) {
    std::ifstream in(file);
    std::uint64_t value = 0;
    if (in >> value) return value;
    return std::nullopt;  // missing, or "max"
}

std::uint64_t available_to_system() {
    std::ifstream in("/proc/meminfo");
    std::string key, unit;
    std::uint64_t kilobytes = 0;
    while (in >> key >> kilobytes) {
        if (key == "MemAvailable:") return kilobytes * 1024;
        std::getline(in, unit);
    }
    return kUnknown;
}

// Version 2 of control groups, as seen from inside a container; version 1 otherwise.
std::uint64_t left_in_group() {
    struct Files {
        const char *limit, *used;
    };
    constexpr Files kFiles[] = {{"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"},
                                {"/sys/fs/cgroup/memory/memory.limit_in_bytes",
                                 "/sys/fs/cgroup/memory/memory.usage_in_bytes"}};
    for (const Files& files : kFiles) {
        const auto limit = number_in(files.limit), used = number_in(files.used);
        if (limit && used) return *limit > *used ? *limit - *used : 0;
    }
    return kUnknown;
}

std::uint64_t left_in_address_space() {
    struct rlimit limit {};
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnknown;
    const std::uint64_t page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    const std::uint64_t used = number_in("/proc/self/statm").value_or(0) * page;
    return limit.rlim_cur > used ? limit.rlim_cur - used : 0;
}

}  // namespace

std::uint64_t available_memory() {
    return std::min({available_to_system(), left_in_group(), left_in_address_space()});
}

void keep_freed_memory() {
#ifdef __GLIBC__
    constexpr int kLargest = 256 << 20;
    mallopt(M_MMAP_THRESHOLD, kLargest);
    mallopt(M_TRIM_THRESHOLD, kLargest);
#endif
}

}  // namespace burnish
