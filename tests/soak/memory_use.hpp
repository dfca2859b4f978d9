// How much memory this process holds, and whether it grows.
#pragma once

#include <cstdint>
#include <vector>

namespace burnish::soak {

struct MemoryUse {
    std::uint64_t resident = 0;  // bytes in memory
    std::uint64_t live = 0;      // bytes of the heap that somebody still holds
};
MemoryUse memory_use();

// Least-squares slope of bytes over minutes.
class Trend {
  public:
    void add(double minutes, double bytes) { points_.push_back({minutes, bytes}); }
    double bytes_per_minute() const;  // 0 before there are two points

  private:
    struct Point {
        double x, y;
    };
    std::vector<Point> points_;
};

}  // namespace burnish::soak
