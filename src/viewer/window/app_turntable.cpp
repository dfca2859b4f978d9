// The part of App that saves turntables.
#include <fmt/format.h>

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

// The renderer's lights are the scene's again where this ends.
class LightsOfFrames {
  public:
    LightsOfFrames(gpu::Renderer& renderer, const Scene& scene)
        : renderer_(renderer), scene_(scene) {}
    LightsOfFrames(const LightsOfFrames&) = delete;
    LightsOfFrames& operator=(const LightsOfFrames&) = delete;
    ~LightsOfFrames() {
        try {
            renderer_.set_lights(scene_.lights);
        } catch (const Error&) {
            // The device is lost: the window finds that out by itself.
        }
    }
    void set(std::span<const Light> lights) { renderer_.set_lights(lights); }

  private:
    gpu::Renderer& renderer_;
    const Scene& scene_;
};

// The renderer's vertices see what the window has found again where this ends.
class VisibilityOfFrames {
  public:
    explicit VisibilityOfFrames(Picture& picture) : picture_(picture) {}
    VisibilityOfFrames(const VisibilityOfFrames&) = delete;
    VisibilityOfFrames& operator=(const VisibilityOfFrames&) = delete;
    ~VisibilityOfFrames() {
        try {
            picture_.restore_visibility();
        } catch (const Error&) {
            // The device is lost: the window finds that out by itself.
        }
    }

  private:
    Picture& picture_;
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
    LightsOfFrames lights(picture.renderer(), stage.scene);
    LitVisibility visibility(
        stage,
        stage.environment.radiance.empty() ? nullptr : prepare_environment(stage.environment), {});
    const VisibilityOfFrames seen(picture);
    for (int i = 0; i < frames; ++i) {
        const TurntableFrame frame = turntable_frame(
            stage.camera, stage.scene.lights, stage.settings.environment_rotation, turn, i, frames);
        if (turn != Turn::camera) {
            lights.set(frame.lights);
            picture.renderer().set_visibility(
                visibility.lit(frame.lights, frame.environment_rotation, {}));
        }
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
