#include "core/parallel.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace burnish {
namespace {

// The writes before a loop happen before its ranges, and the ranges happen before its return. oneTBB
// orders them by atomics that the thread sanitizer does not see, because the library is not compiled
// with it. Under the sanitizer, two counters of our own say the same: callers publish `begun`, which
// ranges observe, and ranges publish `ended`, which callers observe. They are global, so that a range
// observes the first before it reads anything of its caller.
#if defined(__SANITIZE_THREAD__)
std::atomic<std::size_t> begun{0}, ended{0};
void publish(std::atomic<std::size_t>& counter) {
    counter.fetch_add(1, std::memory_order_acq_rel);
}
void observe(const std::atomic<std::size_t>& counter) {
    static_cast<void>(counter.load(std::memory_order_acquire));
}
#else
constexpr int begun = 0, ended = 0;  // NOLINT(readability-identifier-naming)
void publish(int) {}
void observe(int) {}
#endif

// The time in which a range runs; it ends when the body throws, too.
struct RangeOrder {
    RangeOrder() { observe(begun); }
    RangeOrder(const RangeOrder&) = delete;
    RangeOrder& operator=(const RangeOrder&) = delete;
    ~RangeOrder() { publish(ended); }
};

}  // namespace

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
    if (count == 0) return;
    grain = std::clamp<std::size_t>(grain, 1, count);
    const std::size_t ranges = (count - 1) / grain + 1;
    const auto run = [&](std::size_t range) {
        const RangeOrder order;
        const std::size_t begin = range * grain;
        body(begin, begin + std::min(grain, count - begin));
    };
    publish(begun);
    oneapi::tbb::parallel_for(std::size_t{0}, ranges, run);
    observe(ended);
}

}  // namespace burnish
