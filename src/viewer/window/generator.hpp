// The generator of scratches in a session: coarse maps while a slider is dragged, full ones in the
// background when it is let go, which then become the document's.
//
// Threads: the main thread. Lifetime: one of each App, which it is given in every call.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "viewer/generate/scratches.hpp"
#include "viewer/window/background.hpp"

namespace burnish::viewer {

class App;

class Generator {
  public:
    // `state_folder`: empty for a cache that goes with the session.
    explicit Generator(const std::filesystem::path& state_folder);
    ~Generator();
    Generator(const Generator&) = delete;
    Generator& operator=(const Generator&) = delete;

    // Shows coarse maps of the changed choice on the selected material, or on all. What cannot be
    // engraved is in fault(), and the maps that were shown stay.
    void change(App& app, const std::function<void(ScratchChoice&)>& what);
    // The change is complete: the full maps are made, once the coarse ones have been seen.
    void finish();
    // Full maps that are being made are given up; the choice is again what the document says.
    void cancel(App& app);

    // In each frame: before the picture follows the document, after that, and when it is on the screen.
    void settle(App& app);
    void show(App& app);
    void shown();

    const ScratchChoice& choice() const { return choice_; }
    bool working() const { return finish_ || background_.running(); }
    const Background& background() const { return background_; }
    const std::string& fault() const { return fault_; }
    double preview_ms() const {
        return preview_ms_;
    }  // from the last change to the screen; 0: none yet
    const std::filesystem::path& cache() const { return cache_; }

  private:
    using Clock = std::chrono::steady_clock;
    struct Look {
        ScratchTextures maps;
        std::optional<int> material;
        double tile_mm = 0;
    };

    struct Full {
        std::string folder;
        ScratchTextures maps;
    };

    void start(App& app);
    void adopt(App& app, Full full);
    void follow(const App& app);
    void drop(App& app);

    std::filesystem::path cache_;
    bool cache_is_own_ = false;
    ScratchChoice choice_;
    std::string known_ =
        "?";  // what the document was scratched with when the choice was taken from it
    std::map<std::string, ScratchChoice> made_;  // by the folder that was made of it
    std::optional<Look> look_;
    bool fresh_ = false;  // the look is not yet on the picture
    bool finish_ = false;
    std::optional<Clock::time_point> changed_;  // not yet on the screen
    double preview_ms_ = 0;
    std::string fault_;
    Background background_;
};

}  // namespace burnish::viewer
