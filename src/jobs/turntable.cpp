#include "jobs/turntable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "burnish/context.hpp"
#include "burnish/image_io.hpp"
#include "burnish/renderer.hpp"
#include "burnish/turntable.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "jobs/film.hpp"
#include "jobs/lit_visibility.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDescription = "burnish:turntable";

Turn turn_of(const RenderRequest& request) {
    return request.turn.value_or(Turn::object);
}

FrameRange range_of(const RenderRequest& request) {
    return request.frames.value_or(FrameRange{0, request.turntable - 1});
}

// A frame of the turn and the picture of it.
struct Frame {
    int index = 0;
    fs::path file;
    Metadata metadata;
    bool kept = false;  // it was there
};

// What tells the pictures of two turns apart that have the same parameters: the turn, the file's name
// without its folder, so that pictures of several machines go together, lights and background.
std::string description_of(const RenderRequest& request, const Stage& stage, int index) {
    std::string text = fmt::format(
        "{}, frame {} of {}, of {}", turn_names()[static_cast<std::size_t>(turn_of(request))],
        index, request.turntable, fs::path(request.stage.input).filename().string());
    for (const std::string& light : request.stage.lights) text += ", light " + light;
    return fmt::format("{}, background {}", text,
                       background_names()[static_cast<std::size_t>(stage.settings.background)]);
}

std::vector<std::string_view> items_of(std::string_view text) {
    constexpr std::string_view kBetween = "; ";
    std::vector<std::string_view> items;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(kBetween), text.size());
        items.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + kBetween.size(), text.size()));
    }
    return items;
}

// The first item of a list "a; b; c" that another list lacks.
std::string_view first_missing(std::string_view from, std::string_view in) {
    const std::vector<std::string_view> others = items_of(in);
    for (const std::string_view item : items_of(from))
        if (std::ranges::find(others, item) == others.end()) return item;
    return {};
}

std::string value_of(const Metadata& metadata, const std::string& key) {
    const auto found = metadata.find(key);
    return found == metadata.end() ? "" : found->second;
}

// Throws Error unless the file is a picture of this frame as this run would draw it. Not compared: the
// command, which states the range too; the device, as several may share a turn.
void require_same(const Frame& frame) {
    const Metadata found = read_image_info(frame.file).metadata;
    for (const char* key :
         {"burnish:version", kDescription, "burnish:environment", "burnish:parameters"}) {
        const std::string wanted = value_of(frame.metadata, key), other = value_of(found, key);
        if (wanted == other) continue;
        const auto named = [](std::string_view item) {
            return item.empty() ? std::string("nothing there") : std::string(item);
        };
        throw Error(frame.file.string(), key, named(first_missing(wanted, other)),
                    named(first_missing(other, wanted)) +
                        ": a picture of another turn; without --resume it is drawn anew");
    }
}

std::vector<Frame> frames_of(const RenderRequest& request, const Stage& stage,
                             const Metadata& metadata) {
    const fs::path name = is_film(request.output) ? film_pictures(request.output) : request.output;
    std::vector<Frame> frames;
    for (int i = range_of(request).first; i <= range_of(request).last; ++i) {
        Frame frame{i, numbered(name, i), metadata, false};
        frame.metadata[kDescription] = description_of(request, stage, i);
        std::error_code error;
        frame.kept = request.resume && fs::exists(frame.file, error);
        if (frame.kept) require_same(frame);
        frames.push_back(std::move(frame));
    }
    return frames;
}

void draw_missing(const RenderRequest& request, const Stage& stage, std::vector<Frame>& frames,
                  RenderReport& report, const Progress& progress) {
    const auto missing = static_cast<std::size_t>(std::ranges::count(frames, false, &Frame::kept));
    if (missing == 0) return;
    gpu::Context context(request.gl_device);
    gpu::Renderer renderer(context);
    LitVisibility visibility = put_stage(renderer, stage, progress);
    report.warnings.insert(report.warnings.end(), visibility.warnings().begin(),
                           visibility.warnings().end());
    report.device = context.renderer();
    std::size_t done = 0;
    for (Frame& frame : frames) {
        if (frame.kept) continue;
        const TurntableFrame turned =
            turntable_frame(stage.camera, stage.scene.lights, stage.settings.environment_rotation,
                            turn_of(request), frame.index, request.turntable);
        // The camera's turn leaves the lights, and the shadows that were made of them.
        if (turn_of(request) != Turn::camera) {
            renderer.set_lights(turned.lights);
            renderer.set_visibility(
                visibility.lit(turned.lights, turned.environment_rotation, progress));
        }
        RenderSettings settings = stage.settings;
        settings.environment_rotation = turned.environment_rotation;
        frame.metadata["burnish:device"] = context.renderer();
        write_picture(frame.file,
                      renderer.render(turned.camera, settings, part_of(progress, done++, missing)),
                      stage, frame.metadata);
        report.written.push_back(frame.file);
    }
}

void write_film(const RenderRequest& request, const Stage& stage, const std::vector<Frame>& frames,
                RenderReport& report, const Progress& progress) {
    FilmRequest film;
    film.output = request.output;
    film.first = frames.front().index;
    film.count = static_cast<int>(frames.size());
    film.fps = request.fps.value_or(kDefaultFilmRate);
    film.width = stage.settings.width;
    film.height = stage.settings.height;
    film.alpha = stage.settings.background == BackgroundKind::transparent;
    film.comment = request.command;
    make_film(film, progress);
    if (film_is_padded(film))
        report.notes.push_back(fmt::format(
            "{}: its sides have to be even: the last column or row of {}x{} is repeated",
            request.output.string(), film.width, film.height));
    const fs::path folder = frames.front().file.parent_path();
    const bool kept_some = std::ranges::any_of(frames, &Frame::kept);
    if (request.keep_frames || kept_some) {
        if (kept_some && !request.keep_frames)
            report.notes.push_back(
                fmt::format("{}: pictures were there before: none is deleted", folder.string()));
        report.written.push_back(request.output);
        return;
    }
    remove_film_pictures(film);
    report.written = {request.output};
}

[[noreturn]] void throw_without(std::string_view flag, std::string_view wanted) {
    throw UsageError(flag, "", std::string(wanted) + " beside it", "none");
}

}  // namespace

void check_turntable(const RenderRequest& request) {
    const bool film = is_film(request.output);
    if (request.turntable <= 0) {
        if (film)
            throw UsageError(request.output.string(), "",
                             "--turntable COUNT for a film, or a .png, .jpg, .tif or .exr",
                             request.output.extension().string());
        if (request.turn) throw_without("--turn", "--turntable COUNT");
        if (request.frames) throw_without("--frames", "--turntable COUNT");
        if (request.resume) throw_without("--resume", "--turntable COUNT");
    }
    if (!film && request.fps) throw_without("--fps", "-o FILE of a film (.mp4, .webm, .apng)");
    if (!film && request.keep_frames)
        throw_without("--keep-frames", "-o FILE of a film (.mp4, .webm, .apng)");
    if (request.fps && (*request.fps < 1 || *request.fps > 120))
        throw UsageError("--fps", "", "a whole number from 1 to 120", std::to_string(*request.fps));
    if (!request.frames) return;
    const auto [first, last] = *request.frames;
    if (first < 0 || first > last)
        throw UsageError("--frames", "", "A-B with A up to B, such as 0-11",
                         fmt::format("{}-{}", first, last));
    if (last >= request.turntable)
        throw UsageError("--frames", "",
                         fmt::format("frames from 0 to {} (--turntable {})", request.turntable - 1,
                                     request.turntable),
                         std::to_string(last));
}

RenderReport render_turntable(const RenderRequest& request, Stage& stage, const Metadata& metadata,
                              const Progress& progress) {
    RenderReport report;
    const bool film = is_film(request.output);
    if (film)
        stage.settings.background = film_background(request.output, stage.settings.background);
    if (turn_of(request) == Turn::light && stage.scene.lights.empty() &&
        stage.environment.radiance.empty())
        report.warnings.emplace_back(
            "--turn light: there are no lights and no environment: all frames are alike");
    std::vector<Frame> frames = frames_of(request, stage, metadata);
    const fs::path folder = frames.front().file.parent_path();
    std::error_code error;
    if (film) fs::create_directory(folder, error);
    require_writable(frames.front().file);
    try {
        draw_missing(request, stage, frames, report, progress);
    } catch (...) {
        if (film) fs::remove(folder, error);  // stays where pictures are in it
        throw;
    }
    if (request.resume)
        report.notes.push_back(fmt::format("--resume: kept {} of {}",
                                           std::ranges::count(frames, true, &Frame::kept),
                                           plural(frames.size(), "picture")));
    if (film) write_film(request, stage, frames, report, progress);
    return report;
}

}  // namespace burnish
