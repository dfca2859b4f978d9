#include "memory_use.hpp"

#include <malloc.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>

#ifdef __SANITIZE_ADDRESS__
// The sanitizer's own face; GCC 12 of Debian comes without its header.
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();

// Mesa leaves two blocks of 56 bytes behind when its driver is unloaded, after which no suppression
// can name it: leaks show as a slope here instead. Freed memory is held back for 32 MiB, not 256,
// which would look like growth for minutes.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
    return "detect_leaks=0:quarantine_size_mb=32";
}
#endif

namespace burnish::soak {

MemoryUse memory_use() {
    MemoryUse use;
    std::ifstream in("/proc/self/statm");
    std::uint64_t pages = 0;
    if (in >> pages >> pages) use.resident = pages * static_cast<std::uint64_t>(::getpagesize());
#ifdef __SANITIZE_ADDRESS__
    use.live = __sanitizer_get_current_allocated_bytes();  // its allocator stands in for malloc
#else
    const struct mallinfo2 info = ::mallinfo2();
    use.live = info.uordblks + info.hblkhd;
#endif
    return use;
}

double Trend::bytes_per_minute() const {
    if (points_.size() < 2) return 0.0;
    const auto count = static_cast<double>(points_.size());
    double x = 0, y = 0;
    for (const Point& point : points_) {
        x += point.x / count;
        y += point.y / count;
    }
    double covariance = 0, variance = 0;
    for (const Point& point : points_) {
        covariance += (point.x - x) * (point.y - y);
        variance += (point.x - x) * (point.x - x);
    }
    return variance > 0 ? covariance / variance : 0.0;
}

}  // namespace burnish::soak
