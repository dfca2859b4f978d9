#include "core/parallel.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace burnish {
namespace {

// All that was written before the loop happens before its ranges, and the ranges before the return.
// oneTBB sees to that by atomics that the thread sanitizer does not see, because the library is not
// compiled with it. Under the sanitizer these say the same.
#if defined(__SANITIZE_THREAD__)
class VisibleOrder {
  public:
    void observe() { static_cast<void>(count_.load(std::memory_order_acquire)); }
    void publish() { count_.fetch_add(1, std::memory_order_acq_rel); }

  private:
    std::atomic<std::size_t> count_{0};
};
#else
struct VisibleOrder {
    void observe() {}
    void publish() {}
};
#endif

struct Range {
    explicit Range(VisibleOrder& order_) : order(order_) { order.observe(); }
    Range(const Range&) = delete;
    Range& operator=(const Range&) = delete;
    ~Range() { order.publish(); }  // when the body throws as well
    VisibleOrder& order;
};

}  // namespace

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
    if (count == 0) return;
    grain = std::clamp<std::size_t>(grain, 1, count);
    const std::size_t ranges = (count - 1) / grain + 1;
    VisibleOrder order;
    order.publish();
    oneapi::tbb::parallel_for(std::size_t{0}, ranges, [&](std::size_t range) {
        const Range ordered(order);
        const std::size_t begin = range * grain;
        body(begin, begin + std::min(grain, count - begin));
    });
    order.observe();
}

}  // namespace burnish
