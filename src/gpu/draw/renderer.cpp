#include "burnish/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <string>
#include <type_traits>
#include <utility>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "burnish/render_settings.hpp"
#include "core/machine.hpp"
#include "gpu/device/device_timer.hpp"
#include "gpu/device/draw_state.hpp"
#include "gpu/draw/passes.hpp"
#include "scene/camera/pixel_offsets.hpp"

namespace burnish::gpu {
namespace {

// Pixels. The targets of a tile of 2048 take 230 MB.
constexpr int kLargestTile = 2048;
constexpr int kLargestPicture = 16384;

void require_sound(const RenderSettings& o) {
    const auto within = [](const char* key, int value, int low, int high) {
        if (value >= low && value <= high) return;
        throw Error("render", key, std::to_string(low) + " to " + std::to_string(high),
                    std::to_string(value));
    };
    within("width", o.width, 1, kLargestPicture);
    within("height", o.height, 1, kLargestPicture);
    within("samples", o.samples, 1, 1 << 20);
    within("image_light_samples", o.image_light_samples, 1, 4096);
    within("tile_size", o.tile_size, 0, kLargestPicture);
    if (!(o.robust_limit >= 0.0f && std::isfinite(o.robust_limit)))
        throw Error("render", "robust_limit", "a radiance, or 0 for the plain mean",
                    fmt::format("{}", o.robust_limit));
}

// Throws Error when image light would be an approximation, which tabulated lobes do not have.
void require_drawable(const DeviceScene& scene, const RenderSettings& o) {
    const bool sampled = o.image_light == ImageLight::importance ||
                         o.image_light == ImageLight::off || o.view == SurfaceView::albedo;
    if (!scene.any_tabulated() || sampled || scene.environment() == nullptr ||
        !(o.environment_intensity > 0.0f))
        return;
    throw Error("render", "image_light", "importance or off for a tabulated material",
                o.image_light == ImageLight::prefiltered ? "prefiltered" : "bent-normal");
}

Tile tile_of(const PixelRegion& region, const RenderSettings& o) {
    const bool inside = region.x >= 0 && region.y >= 0 && region.width > 0 && region.height > 0 &&
                        region.x <= o.width - region.width && region.y <= o.height - region.height;
    if (!inside)
        throw Error(
            "begin", "region", fmt::format("a part of {} x {} pixels", o.width, o.height),
            fmt::format("{} x {} at ({}, {})", region.width, region.height, region.x, region.y));
    return {region.x, region.y, region.width, region.height};
}

void require_one_tile(const char* doing, int width, int height, const Context& context) {
    const int side = std::min(context.max_texture_size(), kLargestPicture);
    if (width <= side && height <= side) return;
    throw Error(doing, "size", "at most " + std::to_string(side), "more");
}

float writable(float v) {
    return std::isfinite(v) ? std::clamp(v, 0.0f, 65504.0f) : 0.0f;
}

void show_albedo(float* rgb) {
    const f32::vec3 shown = f32::color_of_albedo({rgb[0], rgb[1], rgb[2]});
    rgb[0] = shown.x;
    rgb[1] = shown.y;
    rgb[2] = shown.z;
}

// What is read back of a tile: the sum of its frames, and the weights of a robust mean.
struct Sums {
    std::vector<float> sum, weights;
    int samples = 0;
};

// Writes the mean of the frames of a tile to its place in the picture, with row 0 at the top.
void store(const Sums& of, const Tile& tile, const RenderSettings& o, Image& image) {
    const bool transparent = o.background == BackgroundKind::transparent;
    const float scale = 1.0f / static_cast<float>(of.samples);
    for (int y = 0; y < tile.height; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.width);
        const float* from = of.sum.data() + row * 4;
        const float* weight = of.weights.empty() ? nullptr : of.weights.data() + row;
        float* to = image.at(tile.x, image.height - 1 - (tile.y + y));
        for (int x = 0; x < tile.width; ++x, from += 4, to += 4) {
            const float alpha = transparent ? std::min(writable(from[3] * scale), 1.0f) : 1.0f;
            // Sums are premultiplied. An alpha below 1e-6 is rounding error and must not divide.
            float each = !transparent ? scale : alpha > 1e-6f ? scale / alpha : 0.0f;
            if (weight != nullptr && each > 0.0f) each = 1.0f / weight[x];
            for (int c = 0; c < 3; ++c) to[c] = writable(from[c] * each);
            if (o.view == SurfaceView::albedo) show_albedo(to);
            to[3] = alpha;
        }
    }
}

}  // namespace

struct Renderer::Impl {
    explicit Impl(Context& c) : context(c), scene(c), painter(c, scene) {}

    // Scope of a public call: makes the context current and preserves the state of its host.
    class Use {
      public:
        explicit Use(Impl& impl) : host_(current(impl)) {}

      private:
        static Context& current(Impl& impl) {
            impl.context.make_current();
            return impl.context;
        }
        HostState host_;
    };

    // Samples of one tile of a picture.
    struct Series {
        Camera camera;
        RenderSettings settings;
        Tile tile;
        LightCount light_count = LightCount::compiled;
        std::vector<glm::dvec2> offsets = pixel_offsets(settings.samples);
        int samples = 0;
        bool stale = false;     // the scene was edited
        bool stood_in = false;  // the last sample is none of the mean
    };

    // A series and the images that it is drawn into.
    struct Slot {
        std::optional<Targets> targets;
        std::optional<Series> series;
    };

    Targets& targets_for(int width, int height) {
        std::optional<Targets>& targets = slot().targets;
        if (!targets || targets->width() != width || targets->height() != height) {
            targets.reset();
            targets.emplace(context, width, height);
        }
        return *targets;
    }

    Slot& slot() { return slots[selected]; }
    const Slot& slot() const { return slots[selected]; }

    Frame frame_of(const Series& s) {
        Frame frame;
        frame.options = &s.settings;
        frame.tile = s.tile;
        frame.sample = s.samples;
        // Beyond the wished number the offsets repeat.
        frame.offset = s.offsets[static_cast<std::size_t>(s.samples) % s.offsets.size()];
        frame.light_count = s.light_count;
        // Series that a window shows are those whose programs take any number of lights.
        frame.stands_in = compile_budget_s.has_value() &&
                          s.light_count == LightCount::at_run_time && painter.can_stand_in(frame);
        Bounds bounds = scene.bounds();
        if (s.settings.ground) {
            const Bounds ground = scene.ground().bounds();
            bounds = {glm::min(bounds.low, ground.low), glm::max(bounds.high, ground.high)};
        }
        frame.view =
            make_view(s.camera, bounds, s.settings.width, s.settings.height, s.tile, frame.offset);
        return frame;
    }

    // Clears the sum, prepares the frame and starts the series at sample 0.
    void start(const Progress& progress) {
        Series& series = *slot().series;
        require_drawable(scene, series.settings);
        series.samples = 0;
        const Frame frame = frame_of(series);
        painter.prepare(frame, painter.sees_ground(frame), progress);
        slot().targets->clear_sum(is_robust(series.settings));
        series.stale = series.stood_in = false;
    }

    void add() {
        Series& series = *slot().series;
        if (series.stood_in) {
            slot().targets->clear_sum(is_robust(series.settings));
            series.samples = 0;
        }
        const Frame frame = frame_of(series);
        stand_ins = painter.compile_some(frame, compile_budget_s.value_or(0.0));
        series.stood_in = stand_ins > 0;
        painter.paint(frame, *slot().targets);
        painter.accumulate(frame, *slot().targets);
        ++series.samples;
        ++timed_samples;
    }

    // Writes the mean of the tile to `place` of a picture.
    void store_into(Image& image, const Tile& place) {
        const Series& series = *slot().series;
        const Targets& targets = *slot().targets;
        store({targets.read_sum(place.width, place.height),
               targets.read_weights(place.width, place.height), series.samples},
              place, series.settings, image);
    }

    void make_stale() {
        for (Slot& slot : slots)
            if (slot.series) slot.series->stale = true;
    }

    struct EndOfSeries {
        std::optional<Series>& series;
        ~EndOfSeries() { series.reset(); }
    };

    template <typename Edit>
    auto edit(Edit change) {
        const Use use(*this);
        if constexpr (std::is_void_v<decltype(change(scene))>) {
            change(scene);
            make_stale();
        } else {
            const auto id = change(scene);
            make_stale();
            return id;
        }
    }

    void require_samples(const char* doing) const {
        if (slot().series && slot().series->samples > 0) return;
        throw Error(doing, "samples", "one at least: begin and add_sample", "none");
    }

    Context& context;
    DeviceScene scene;
    Painter painter;
    std::optional<double> compile_budget_s;
    int stand_ins = 0;                          // in the last sample of a series
    int timed_samples = 0, timed_presents = 0;  // since the times of passes were taken
    std::array<Slot, 16> slots;
    std::size_t selected = 0;
};

Renderer::Renderer(Context& context) {
    context.make_current();
    const HostState host(context);
    impl_ = std::make_unique<Impl>(context);
}

Renderer::Renderer(Context& context, const Scene& scene, const Environment* environment,
                   const Progress& progress)
    : Renderer(context) {
    set_scene(scene, progress);
    set_environment(environment, progress);
}

Renderer::~Renderer() {
    try {
        impl_->context.make_current();
    } catch (const Error&) {  // the context is lost, with everything in it
    }
}

void Renderer::set_scene(const Scene& scene, const Progress& progress) {
    impl_->edit([&](DeviceScene& s) { s.set_scene(scene, progress); });
}

void Renderer::set_environment(const Environment* environment, const Progress& progress) {
    const bool none = environment == nullptr || environment->radiance.empty();
    set_environment(none ? nullptr : prepare_environment(*environment, progress));
}

void Renderer::set_environment(std::shared_ptr<const PreparedEnvironment> prepared) {
    impl_->edit([&](DeviceScene& s) { s.set_environment(prepared); });
}

void Renderer::set_lights(std::span<const Light> lights) {
    impl_->edit([&](DeviceScene& s) { s.set_lights(lights); });
}

void Renderer::set_visibility(std::shared_ptr<const Visibility> visibility) {
    impl_->edit([&](DeviceScene& s) { s.set_visibility(visibility.get()); });
}

int Renderer::add_material(const Material& material, const Progress& progress) {
    return impl_->edit([&](DeviceScene& s) { return s.add_material(material, progress); });
}

void Renderer::update_material(int id, const Material& material, const Progress& progress) {
    impl_->edit([&](DeviceScene& s) { s.update_material(id, material, progress); });
}

void Renderer::set_materials(const std::vector<Material>& materials, const Progress& progress) {
    impl_->edit([&](DeviceScene& s) { s.update_materials(materials, progress); });
}

void Renderer::refine_cloths() {
    impl_->edit([&](DeviceScene& s) { s.refine_cloths(); });
}

int Renderer::add_texture(Texture texture) {
    return impl_->edit([&](DeviceScene& s) { return s.add_texture(std::move(texture)); });
}

void Renderer::update_texture(int id, Texture texture, const Progress& progress) {
    impl_->edit([&](DeviceScene& s) { s.update_texture(id, std::move(texture), progress); });
}

int Renderer::add_mesh(const Mesh& mesh) {
    return impl_->edit([&](DeviceScene& s) { return s.add_mesh(mesh); });
}

void Renderer::update_mesh(int id, const Mesh& mesh) {
    impl_->edit([&](DeviceScene& s) { s.update_mesh(id, mesh); });
}

void Renderer::set_coarse_mesh(int id, std::span<const std::uint32_t> indices) {
    const Impl::Use use(*impl_);
    impl_->scene.set_coarse_mesh(id, indices);
    for (Impl::Slot& slot : impl_->slots)
        if (slot.series && slot.series->settings.coarse) slot.series->stale = true;
}

int Renderer::add_instance(const Instance& instance) {
    return impl_->edit([&](DeviceScene& s) { return s.add_instance(instance); });
}

void Renderer::update_instance(int id, const Instance& instance) {
    impl_->edit([&](DeviceScene& s) { s.update_instance(id, instance); });
}

void Renderer::remove_instance(int id) {
    impl_->edit([&](DeviceScene& s) { s.remove_instance(id); });
}

void Renderer::prepare(const RenderSettings& settings, const Progress& progress) {
    require_sound(settings);
    require_drawable(impl_->scene, settings);
    const Impl::Use use(*impl_);
    Frame frame;
    frame.options = &settings;
    frame.light_count = LightCount::at_run_time;
    impl_->painter.prepare(frame, settings.ground, progress);
    impl_->context.programs().get("fullscreen.vert", "display.frag", "");
}

void Renderer::select_series(int number) {
    if (number < 0 || number >= static_cast<int>(impl_->slots.size()))
        throw Error("series", "", fmt::format("a number below {}", impl_->slots.size()),
                    std::to_string(number));
    impl_->selected = static_cast<std::size_t>(number);
}

void Renderer::end_series() {
    const Impl::Use use(*impl_);
    impl_->slot() = {};
}

void Renderer::begin(const Camera& camera, const RenderSettings& settings,
                     const std::optional<PixelRegion>& region) {
    require_sound(settings);
    require_drawable(impl_->scene, settings);
    const Tile tile =
        region ? tile_of(*region, settings) : Tile{0, 0, settings.width, settings.height};
    require_one_tile("begin", tile.width, tile.height, impl_->context);
    const Impl::Use use(*impl_);
    impl_->targets_for(tile.width, tile.height);
    impl_->slot().series = Impl::Series{camera, settings, tile, LightCount::at_run_time};
    impl_->start({});
}

SurfacePass Renderer::pass_of(const RenderSettings& settings) const {
    Frame frame;
    frame.options = &settings;
    const bool deferred = impl_->painter.defers(frame, impl_->scene.any_tabulated());
    return deferred ? SurfacePass::deferred : SurfacePass::forward;
}

void Renderer::set_compile_budget(std::optional<double> seconds) {
    impl_->compile_budget_s = seconds;
}

int Renderer::stand_ins() const {
    return impl_->stand_ins;
}

void Renderer::add_sample() {
    std::optional<Impl::Series>& series = impl_->slot().series;
    if (!series) throw Error("add_sample", "", "begin before it", "none");
    const Impl::Use use(*impl_);
    if (series->stale) impl_->start({});
    impl_->add();
    check_gl("drawing a sample");
}

int Renderer::samples_done() const {
    const std::optional<Impl::Series>& series = impl_->slot().series;
    return series && !series->stale && !series->stood_in ? series->samples : 0;
}

void Renderer::present(unsigned framebuffer, int width, int height, double exposure_ev,
                       ToneMap tone_map) {
    impl_->require_samples("present");
    const Impl::Use use(*impl_);
    const Impl::Series& series = *impl_->slot().series;
    Program& program = impl_->context.programs().get("fullscreen.vert", "display.frag", "");
    const auto time = impl_->painter.timed(Pass::display);
    ++impl_->timed_presents;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
    program.use();
    program.set("u_size", glm::ivec2(series.tile.width, series.tile.height));
    program.set("u_share", 1.0f / static_cast<float>(series.samples));
    program.set("u_gain", static_cast<float>(std::exp2(exposure_ev)));
    program.set("u_tone_map", static_cast<int>(tone_map));
    program.set("u_robust", is_robust(series.settings) ? 1.0f : 0.0f);
    program.set("u_albedo", series.settings.view == SurfaceView::albedo ? 1 : 0);
    program.set("u_transparent",
                series.settings.background == BackgroundKind::transparent ? 1.0f : 0.0f);
    impl_->slot().targets->show_sum(program, impl_->painter.empty_vertex_array());
    check_gl("presenting a picture");
}

Image Renderer::picture() {
    impl_->require_samples("picture");
    const Impl::Use use(*impl_);
    const Tile& tile = impl_->slot().series->tile;
    Image image(tile.width, tile.height, 4);
    impl_->store_into(image, {0, 0, tile.width, tile.height});
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    check_gl("reading a picture");
    return image;
}

Image Renderer::render(const Camera& camera, const RenderSettings& settings,
                       const Progress& progress) {
    require_sound(settings);
    const Impl::Use use(*impl_);
    const int side = std::min(settings.tile_size > 0 ? settings.tile_size : kLargestTile,
                              impl_->context.max_texture_size());
    impl_->targets_for(std::min(side, settings.width), std::min(side, settings.height));
    const std::vector<Tile> tiles = tiles_of(settings.width, settings.height, side);
    Image image(settings.width, settings.height, 4);
    const double total = static_cast<double>(tiles.size()) * settings.samples;
    double done = 0;
    const Impl::EndOfSeries end{impl_->slot().series};
    for (const Tile& tile : tiles) {
        impl_->slot().series = Impl::Series{camera, settings, tile};
        impl_->start(progress);
        for (int sample = 0; sample < settings.samples; ++sample) {
            // Progress at every fourth sample: cancellation is prompt, and the device rarely waits.
            if (sample % 4 == 0) {
                glFinish();
                progress.step("render", done / total);
            }
            impl_->add();
            done += 1;
        }
        impl_->store_into(image, tile);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    check_gl("rendering");
    progress.step("render", 1.0);
    return image;
}

FrameTimes Renderer::measure_frames(const Camera& camera, const RenderSettings& settings,
                                    int frames, int warm_up, ShadingVariant variant) {
    require_sound(settings);
    require_drawable(impl_->scene, settings);
    require_one_tile("measure_frames", settings.width, settings.height, impl_->context);
    const Impl::Use use(*impl_);
    const Impl::EndOfSeries end{impl_->slot().series};
    RenderSettings single = settings;
    single.samples = 1;
    const Impl::Series once{camera, single, {0, 0, settings.width, settings.height}};
    Targets& targets = impl_->targets_for(settings.width, settings.height);
    Frame frame = impl_->frame_of(once);
    frame.variant = variant;
    impl_->painter.prepare(frame, impl_->painter.sees_ground(frame), {});
    // Each frame is submitted by itself, as the buffer swap of a window would.
    const std::vector<glm::dvec2> offsets = pixel_offsets(frames + warm_up);
    const auto paint = [&](int sample) {
        frame.sample = sample;
        frame.offset = offsets[static_cast<std::size_t>(sample)];  // so that shadows are drawn anew
        impl_->painter.paint(frame, targets);
        glFlush();
    };
    for (int i = 0; i < warm_up; ++i) paint(i);
    const DeviceTimer timer(impl_->context);
    glFinish();
    FrameTimes times;
    const double cpu = process_cpu_seconds();
    const auto start = std::chrono::steady_clock::now();
    timer.begin();
    for (int i = 0; i < frames; ++i) paint(i);
    timer.end();
    glFinish();
    times.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    times.cpu_s = process_cpu_seconds() - cpu;
    times.device_s = timer.seconds();
    check_gl("timing frames");
    return times;
}

double Renderer::time_frames(const Camera& camera, const RenderSettings& settings, int frames,
                             ShadingVariant variant) {
    return measure_frames(camera, settings, frames, 1, variant).wall_s;
}

std::span<const std::string_view> pass_names() {
    static constexpr std::array<std::string_view, kPassCount> kNames = {
        "shadow-maps", "surface-data", "shading", "background",
        "ground",      "blended",      "sum",     "display"};
    return kNames;
}

void Renderer::measure_passes(bool on) {
    const Impl::Use use(*impl_);
    impl_->painter.timer().measure(on);
    impl_->timed_samples = impl_->timed_presents = 0;
}

PassTimes Renderer::take_pass_times() {
    const Impl::Use use(*impl_);
    PassTimes times;
    std::ranges::copy(impl_->painter.timer().take(), times.seconds.begin());
    times.samples = std::exchange(impl_->timed_samples, 0);
    times.presents = std::exchange(impl_->timed_presents, 0);
    times.by_device = impl_->painter.timer().by_device();
    return times;
}

UploadCounts Renderer::uploads() const {
    return impl_->scene.uploads();
}

}  // namespace burnish::gpu
