// Progress and cancellation of long work. The work calls `step`; the caller decides what to show
// and when to stop it. Nothing here is shared by the whole process: each piece of work has the
// token that its caller gave it.
//
// Thread safety: a CancelToken may be used from any number of threads and from signal handlers. A
// Progress may be copied and read from several threads; its report is called by the thread that
// steps.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

// A request to stop that work looks at. Copies share one state, which lives as long as the last
// copy.
class CancelToken {
  public:
    CancelToken() : cancelled_(std::make_shared<std::atomic<bool>>(false)) {}

    // Async-signal-safe.
    void cancel() const noexcept { cancelled_->store(true, std::memory_order_relaxed); }
    // The token can be used for another piece of work.
    void reset() const noexcept { cancelled_->store(false, std::memory_order_relaxed); }
    bool cancelled() const noexcept { return cancelled_->load(std::memory_order_relaxed); }

  private:
    static_assert(std::atomic<bool>::is_always_lock_free, "signal handlers set it");
    std::shared_ptr<std::atomic<bool>> cancelled_;
};

class Progress {
  public:
    // `report(stage, done in [0,1])` is called from the working thread; it may throw Interrupted.
    using Report = std::function<void(std::string_view stage, double done)>;

    Progress() = default;  // reports nothing and is never cancelled
    explicit Progress(Report report) : report_(std::move(report)) {}
    explicit Progress(CancelToken token) : token_(std::move(token)) {}
    Progress(Report report, CancelToken token)
        : report_(std::move(report)), token_(std::move(token)) {}

    // Throws Interrupted when the token is cancelled, else reports. `done` is clamped to [0,1].
    void step(std::string_view stage, double done) const;

    // For loops that have nothing to report.
    bool cancelled() const noexcept { return token_ && token_->cancelled(); }
    void throw_if_cancelled() const;

    // The same token, another report: of a part of the work.
    Progress with_report(Report report) const;

  private:
    Report report_;
    std::optional<CancelToken> token_;
};

}  // namespace burnish
