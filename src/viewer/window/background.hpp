// Work off the frame: one piece at a time, on a thread of its own, with progress and cancellation.
//
// Threads: start, poll and cancel from one thread. Lifetime: the destructor cancels and waits.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "burnish/error.hpp"
#include "burnish/progress.hpp"

namespace burnish::viewer {

class Background {
  public:
    ~Background() { stop(); }
    Background() = default;
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    // Cancels what runs, and runs `work` on its own thread; `finish` is called by poll() on the calling
    // thread when it is done, `fail` with one line when it has thrown. Neither is called for work that
    // was cancelled.
    template <typename Result>
    void start(std::string name, std::function<Result(const Progress&)> work,
               std::function<void(Result)> finish, std::function<void(const std::string&)> fail) {
        stop();
        name_ = std::move(name);
        token_ = CancelToken();
        done_ = false;
        share_ = 0;
        auto result = std::make_shared<std::optional<Result>>();
        auto error = std::make_shared<std::string>();
        const CancelToken token = token_;
        settle_ = [=] {
            if (token.cancelled()) return;
            if (*result) return finish(std::move(**result));
            fail(*error);
        };
        thread_ = std::thread([this, token, result, error, work = std::move(work)] {
            try {
                const Progress progress(
                    [this](std::string_view stage, double done) {
                        const std::lock_guard lock(mutex_);
                        stage_ = stage;
                        share_ = done;
                    },
                    token);
                *result = work(progress);
            } catch (const std::exception& e) {
                *error = one_line(e.what());
            }
            done_ = true;
            if (wake_) wake_();
        });
    }

    // Called on the working thread at the end of work, so that a waiting window wakes.
    void on_done(std::function<void()> wake) { wake_ = std::move(wake); }

    bool running() const { return thread_.joinable(); }
    const std::string& name() const { return name_; }
    std::pair<std::string, double> progress() const {
        const std::lock_guard lock(mutex_);
        return {stage_, share_};
    }

    // Settles work that is done. True when something was settled.
    bool poll() {
        if (!thread_.joinable() || !done_) return false;
        thread_.join();
        const std::function<void()> settle = std::exchange(settle_, {});
        settle();
        return true;
    }

    // Asks the work to end. poll() settles it then, and calls nothing.
    void cancel() { token_.cancel(); }

    void stop() {
        if (!thread_.joinable()) return;
        token_.cancel();
        thread_.join();
        settle_ = {};
    }

  private:
    std::thread thread_;
    CancelToken token_;
    std::atomic<bool> done_{false};
    mutable std::mutex mutex_;
    std::string stage_, name_;
    double share_ = 0;
    std::function<void()> settle_, wake_;
};

}  // namespace burnish::viewer
