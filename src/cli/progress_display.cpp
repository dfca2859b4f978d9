#include "cli/progress_display.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace burnish::cli {
namespace {

constexpr std::array<std::string_view, 4> kModeNames = {"auto", "bar", "json", "off"};

using Seconds = std::chrono::duration<double>;
constexpr Seconds kSilence{1.0};      // shorter work shows no bar in automatic mode
constexpr Seconds kBarInterval{0.1};  // faster updates would not be seen
constexpr Seconds kJsonInterval{0.5};
constexpr std::size_t kBarWidth = 24;

std::string clock_text(double seconds) {
    const auto whole = static_cast<long long>(std::llround(std::min(seconds, 1e9)));
    if (whole >= 3600) {
        return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    }
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string json_text(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return quoted + '"';
}

void put_on_stderr(const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

}  // namespace

std::span<const std::string_view> progress_mode_names() {
    return kModeNames;
}

ProgressDisplay::ProgressDisplay(ProgressMode mode) : mode_(mode) {
    if (mode == ProgressMode::automatic && ::isatty(STDERR_FILENO) == 0) mode_ = ProgressMode::off;
}

ProgressDisplay::~ProgressDisplay() {
    if (bar_on_screen_) put_on_stderr(::isatty(STDERR_FILENO) != 0 ? "\r\x1b[K" : "\n");
}

void ProgressDisplay::show(std::string_view stage, double done) {
    if (mode_ == ProgressMode::off) return;
    const std::lock_guard lock(mutex_);
    const Clock::time_point now = Clock::now();
    const bool new_stage = stage != stage_ || !last_shown_;
    if (stage != stage_) {
        stage_ = stage;
        stage_start_ = now;
        stage_from_ = done;
    }
    if (!is_due(now, new_stage || done >= 1.0)) return;
    last_shown_ = now;
    const Moment moment = moment_at(now, done);
    if (mode_ == ProgressMode::json) {
        print_json(moment);
    } else {
        draw_bar(moment);
    }
}

ProgressDisplay::Moment ProgressDisplay::moment_at(Clock::time_point now, double done) const {
    Moment moment;
    moment.done = done;
    moment.elapsed_s = Seconds(now - start_).count();
    const double stage_s = Seconds(now - stage_start_).count();
    const double gained = done - stage_from_;
    if (gained > 0.0 && stage_s > 0.0) {
        moment.rate = gained / stage_s;
        moment.left_s = (1.0 - done) / moment.rate;
    }
    return moment;
}

// Whether an update is due; `news`: a stage begins or ends.
bool ProgressDisplay::is_due(Clock::time_point now, bool news) const {
    if (mode_ == ProgressMode::automatic && now - start_ < kSilence) return false;
    if (news || !last_shown_) return true;
    return now - *last_shown_ >= (mode_ == ProgressMode::json ? kJsonInterval : kBarInterval);
}

void ProgressDisplay::draw_bar(const Moment& moment) {
    const auto filled = static_cast<std::size_t>(moment.done * static_cast<double>(kBarWidth));
    std::string line = fmt::format("{:<12.24} {:3.0f} % [{:-<{}}]", stage_, 100.0 * moment.done,
                                   std::string(filled, '#'), kBarWidth);
    if (moment.left_s) {
        line +=
            fmt::format(" {:.3g} %/s, {} left", 100.0 * moment.rate, clock_text(*moment.left_s));
    } else {
        line += fmt::format(" {}", clock_text(moment.elapsed_s));
    }
    put_on_stderr("\r" + line + (::isatty(STDERR_FILENO) != 0 ? "\x1b[K" : ""));
    bar_on_screen_ = true;
}

void ProgressDisplay::print_json(const Moment& moment) const {
    const std::string left = moment.left_s ? fmt::format("{:.3f}", *moment.left_s) : "null";
    put_on_stderr(fmt::format(R"({{"stage":{},"done":{:.4f},"elapsed_s":{:.3f},"left_s":{}}})"
                              "\n",
                              json_text(stage_), moment.done, moment.elapsed_s, left));
}

}  // namespace burnish::cli
