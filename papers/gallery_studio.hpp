// Renders pictures for the gallery as `burnish render` does. Private to papers/gallery*.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/image.hpp"
#include "burnish/progress.hpp"
#include "burnish/renderer.hpp"

namespace burnish {

// A picture in terms of command line options.
struct PictureSpec {
    std::string input;
    std::vector<std::pair<std::string, std::string>> parameters;  // of the parameter table
    std::string environment = "builtin:studio";                   // "none": black
    std::vector<std::string> lights;

    // A copy with one parameter set, or several.
    PictureSpec with(std::string name, std::string value) const;
    PictureSpec with(const std::vector<std::pair<std::string, std::string>>& more) const;
};

struct Picture {
    Image linear;   // RGBA
    Image display;  // RGB, sRGB-encoded
    std::string command;
};

class GalleryStudio {
  public:
    GalleryStudio(bool quick, int gl_device);
    ~GalleryStudio();

    // `side`: pixels of the square on the page; the picture has twice as many.
    Picture picture(const PictureSpec& spec, double side, const Progress& progress);
    // Coverage of the model: one channel, of the same size as `picture`.
    Image mask(const PictureSpec& spec, double side, const Progress& progress);

    // Seconds of a frame with one sample per pixel, for the last picture's scene and size.
    double frame_seconds();

    bool quick() const { return quick_; }
    const gpu::Context& context() const { return context_; }

  private:
    struct Set;  // the stage of the last picture
    Set& set_for(const PictureSpec& spec, double side);

    bool quick_;
    gpu::Context context_;
    gpu::Renderer renderer_;  // of the last picture's scene
    std::unique_ptr<Set> set_;
};

}  // namespace burnish
