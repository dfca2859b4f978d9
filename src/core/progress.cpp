#include "burnish/progress.hpp"

#include <atomic>

#include "burnish/error.hpp"

namespace burnish {
namespace {

// Lock-free: only then may a signal handler set it.
std::atomic<bool> interrupt_flag{false};
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

void Progress::step(std::string_view stage, double done) const {
    if (interrupt_requested()) throw Interrupted();
    if (!report_) return;
    // The comparisons are written so that NaN becomes 0.
    report_(stage, done > 0.0 ? (done < 1.0 ? done : 1.0) : 0.0);
}

void request_interrupt() noexcept {
    interrupt_flag.store(true, std::memory_order_relaxed);
}

bool interrupt_requested() noexcept {
    return interrupt_flag.load(std::memory_order_relaxed);
}

void clear_interrupt() noexcept {
    interrupt_flag.store(false, std::memory_order_relaxed);
}

}  // namespace burnish
