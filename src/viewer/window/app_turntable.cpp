// The part of App that saves turntables.
#include <fmt/format.h>

#include <optional>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/turntable.hpp"
#include "core/files.hpp"
#include "jobs/film.hpp"
#include "jobs/lit_visibility.hpp"
#include "jobs/render.hpp"
#include "viewer/window/app.hpp"

namespace burnish::viewer {
namespace {

constexpr int kFilmRate = 24;  // frames a second

// The lights of the frames of a turn, and what vertices see in them. The renderer has those of the scene again where
// this ends.
class LightsOfFrames {
  public:
    LightsOfFrames(Picture& picture, const Stage& stage)
        : picture_(picture), stage_(stage), visibility_(stage, picture.environment(), {}) {}
    LightsOfFrames(const LightsOfFrames&) = delete;
    LightsOfFrames& operator=(const LightsOfFrames&) = delete;
    ~LightsOfFrames() {
        try {
            picture_.renderer().set_lights(stage_.scene.lights);
            picture_.restore_visibility();
        } catch (const Error&) {
            // The device is lost: the window finds that out by itself.
        }
    }
    void set(const TurntableFrame& frame) {
        picture_.renderer().set_lights(frame.lights);
        picture_.renderer().set_visibility(
            visibility_.lit(frame.lights, frame.environment_rotation, {}));
    }

  private:
    Picture& picture_;
    const Stage& stage_;
    LitVisibility visibility_;
};

}  // namespace

void App::save_turntable(const std::filesystem::path& path, int frames, Turn turn) {
    const bool film = is_film(path);
    if (film) require_film_maker(path);
    if (!film) require_image_extension(path);
    require_writable(path);
    const std::filesystem::path pictures = film ? film_pictures(path) : path;
    if (film) std::filesystem::create_directory(pictures.parent_path());
    const Stage& stage = editor.stage();
    // The camera's turn leaves the lights.
    std::optional<LightsOfFrames> lights;
    if (turn != Turn::camera) lights.emplace(picture, stage);
    for (int i = 0; i < frames; ++i) {
        const TurntableFrame frame = turntable_frame(
            stage.camera, stage.scene.lights, stage.settings.environment_rotation, turn, i, frames);
        if (lights) lights->set(frame);
        RenderSettings settings = stage.settings;
        settings.environment_rotation = frame.environment_rotation;
        settings.width = picture_width;
        settings.height = picture_height;
        if (film) settings.background = film_background(path, settings.background);
        const std::filesystem::path file = numbered(pictures, i);
        write_image(file, drawn(frame.camera, settings, holds_linear(file)), {},
                    write_options(editor.stage().values));
    }
    if (!film) return say(fmt::format("saved {} frames beside {}", frames, path.string()));
    FilmRequest request;
    request.output = path;
    request.count = frames;
    request.fps = kFilmRate;
    request.width = picture_width;
    request.height = picture_height;
    request.alpha = film_background(path, stage.settings.background) == BackgroundKind::transparent;
    make_film(request, {});
    remove_film_pictures(request);
    say(fmt::format("saved {}: {} frames at {} a second", path.string(), frames, kFilmRate));
}

}  // namespace burnish::viewer
