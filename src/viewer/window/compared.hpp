// The picture of a difference between two panes: signed, or perceived (FLIP).
//
// Threads: the one on which the window's context is current. Lifetime: destroy it before the context.
#pragma once

#include <optional>

#include "viewer/document/document.hpp"
#include "viewer/window/picture.hpp"

namespace burnish::viewer {

class Compared {
  public:
    Compared() = default;
    ~Compared();
    Compared(const Compared&) = delete;
    Compared& operator=(const Compared&) = delete;

    // Makes the picture of a pane of `b` against one of `a` where they have changed. FLIP takes a while, so that
    // it is made at rest alone.
    void update(const Picture& a, std::size_t pane_a, const Picture& b, std::size_t pane_b,
                const Compare& compare);
    unsigned texture() const { return texture_; }  // 0: none yet; row 0 at the top
    double mean() const { return mean_; }          // of FLIP, or of the absolute difference
    double most() const { return most_; }
    void invalidate() { made_of_.reset(); }

  private:
    struct Source {
        CompareMode mode;
        int samples;
        double scale, gain;
        bool operator==(const Source&) const = default;
    };
    std::optional<Source> made_of_;
    unsigned texture_ = 0;
    double mean_ = 0, most_ = 0;
};

}  // namespace burnish::viewer
