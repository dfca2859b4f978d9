// Shows the progress of long work on standard error: as a line that is overwritten, or as JSON.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace burnish::cli {

enum class ProgressMode { automatic = 0, bar = 1, json = 2, off = 3 };
std::span<const std::string_view> progress_mode_names();

// `show` may be called from any thread. The destructor erases the line on a terminal.
class ProgressDisplay {
  public:
    explicit ProgressDisplay(ProgressMode mode);
    ProgressDisplay(const ProgressDisplay&) = delete;
    ProgressDisplay& operator=(const ProgressDisplay&) = delete;
    ~ProgressDisplay();

    void show(std::string_view stage, double done);

  private:
    using Clock = std::chrono::steady_clock;

    // The contents of one update. Times in seconds; time left and rate are of the stage.
    struct Moment {
        double done = 0;
        double elapsed_s = 0;
        double rate = 0;  // fraction of the whole per second; 0 while unknown
        std::optional<double> left_s;
    };
    Moment moment_at(Clock::time_point now, double done) const;
    bool is_due(Clock::time_point now, bool news) const;
    void draw_bar(const Moment& moment);
    void print_json(const Moment& moment) const;

    ProgressMode mode_;
    std::mutex mutex_;
    Clock::time_point start_ = Clock::now();
    std::string stage_;
    Clock::time_point stage_start_ = start_;
    double stage_from_ = 0;  // fraction done at the first update of the stage
    std::optional<Clock::time_point> last_shown_;
    bool bar_on_screen_ = false;
};

}  // namespace burnish::cli
