#include "gpu/device/section_timer.hpp"

#include <utility>

#include "gpu/device/gl.hpp"

namespace burnish::gpu {

SectionTimer::SectionTimer(const Context& context, std::size_t sections)
    : context_(context), seconds_(sections, 0.0) {}

void SectionTimer::measure(bool on) {
    if (on && idle_.empty()) {
        idle_.push_back(std::make_unique<DeviceTimer>(context_));
        by_device_ = idle_.front()->available() && !context_.is_software();
    }
    if (on) take();
    on_ = on;
}

void SectionTimer::begin(std::size_t section) {
    section_ = section;
    if (!by_device_) {
        glFinish();
        start_ = std::chrono::steady_clock::now();
        return;
    }
    if (idle_.empty()) idle_.push_back(std::make_unique<DeviceTimer>(context_));
    pending_.push_back({section, std::move(idle_.back())});
    idle_.pop_back();
    pending_.back().timer->begin();
}

void SectionTimer::end() {
    if (by_device_) {
        pending_.back().timer->end();
        return;
    }
    glFinish();
    seconds_[section_] +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::vector<double> SectionTimer::take() {
    for (Query& query : pending_) {
        // A disjoint event leaves a section out.
        seconds_[query.section] += query.timer->seconds().value_or(0.0);
        idle_.push_back(std::move(query.timer));
    }
    pending_.clear();
    return std::exchange(seconds_, std::vector<double>(seconds_.size(), 0.0));
}

}  // namespace burnish::gpu
