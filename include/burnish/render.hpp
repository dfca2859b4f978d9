// Rendering as `burnish render` does it: from a file and parameters to pictures on disk.
//
// Threads: any number may render at a time, each in a context of its own.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/error.hpp"
#include "burnish/progress.hpp"
#include "burnish/shading_names.hpp"
#include "burnish/stage.hpp"
#include "burnish/turntable.hpp"

namespace BURNISH_API burnish {

// Frames of a turntable, both included.
struct FrameRange {
    int first = 0, last = 0;  // 0 <= first <= last < the number of frames
};

inline constexpr int kDefaultFilmRate = 24;

struct RenderRequest {
    StageRequest stage;
    // .png .jpg .tif (display) or .exr (linear); of a turntable also a film, .mp4, .webm or .apng
    std::filesystem::path output;
    std::vector<Method> compare;  // two or more: a labelled sheet of these methods
    int gl_device = -1;           // -1: the first hardware device, else software
    std::string command;          // kept in the pictures' metadata

    int turntable = 0;  // pictures of a full turn, at most 9999; 0: a still
    // Of a turntable alone.
    std::optional<Turn> turn;          // none: the object
    std::optional<FrameRange> frames;  // none: all; numbers of files are those of the whole turn
    bool resume = false;               // pictures that are there are kept
    std::optional<int> fps;            // of a film, 1 to 120; none: kDefaultFilmRate
    bool keep_frames = false;          // the pictures of a film are not deleted
};

struct RenderReport {
    std::vector<std::filesystem::path> written;
    std::vector<std::string> warnings;  // what will look different, one line each
    std::vector<std::string> notes;     // what was chosen, one line each
    std::string device;                 // GL_RENDERER; "": nothing had to be drawn
};

// Every output is written whole or not at all. Throws UsageError for combinations that make no
// sense, before anything is rendered, and Error for everything else that fails: a film without the
// program ffmpeg before anything is rendered, frames of another turn that `resume` finds likewise.
RenderReport render(const RenderRequest& request, const Progress& progress = {});

}  // namespace burnish
