#include "gpu/draw/renderer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "burnish/error.hpp"
#include "burnish/render_settings.hpp"
#include "core/machine.hpp"
#include "gpu/device/device_timer.hpp"
#include "gpu/draw/passes.hpp"

namespace burnish::gpu {
namespace {

// 2048: a tile's targets take 230 MB.
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
}

// What a tabulated lobe has no shortcut for.
void require_drawable(const DeviceScene& scene, const RenderSettings& o) {
    const bool any = std::ranges::any_of(
        scene.materials, [](const Material& m) { return tabulated_of(m) != nullptr; });
    const bool sampled =
        o.image_light == ImageLight::importance || o.image_light == ImageLight::off;
    if (!any || sampled || !scene.environment || !(o.environment_intensity > 0.0f)) return;
    throw Error("render", "image_light", "importance or off for a tabulated material",
                o.image_light == ImageLight::prefiltered ? "prefiltered" : "bent-normal");
}

float writable(float v) {
    return std::isfinite(v) ? std::clamp(v, 0.0f, 65504.0f) : 0.0f;
}

// The mean of `samples` frames of a tile into its place in the picture, the right way up.
void store(const std::vector<float>& sum, const Tile& tile, int samples, bool transparent,
           Image& image) {
    const float scale = 1.0f / static_cast<float>(samples);
    for (int y = 0; y < tile.height; ++y) {
        const float* from =
            sum.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.width) * 4;
        float* to = image.at(tile.x, image.height - 1 - (tile.y + y));
        for (int x = 0; x < tile.width; ++x, from += 4, to += 4) {
            const float alpha = transparent ? std::min(writable(from[3] * scale), 1.0f) : 1.0f;
            // Sums are premultiplied; below 1e-6 there is nothing but rounding to divide.
            const float each = !transparent ? scale : alpha > 1e-6f ? scale / alpha : 0.0f;
            for (int c = 0; c < 3; ++c) to[c] = writable(from[c] * each);
            to[3] = alpha;
        }
    }
}

}  // namespace

struct Renderer::Impl {
    Impl(Context& c, const Scene& s, const Environment* environment)
        : context(c), scene(c, s, environment), painter(c, scene) {}

    Targets& targets_for(int width, int height) {
        if (!targets || targets->width() != width || targets->height() != height) {
            targets.reset();
            targets.emplace(context, width, height);
        }
        return *targets;
    }

    Frame frame_of(const Camera& camera, const RenderSettings& options, const Tile& tile,
                   int sample) {
        Frame frame;
        frame.options = &options;
        frame.tile = tile;
        frame.sample = sample;
        Bounds bounds = scene.bounds;
        if (options.ground) {
            const Bounds ground = scene.ground.bounds();
            bounds = {glm::min(bounds.low, ground.low), glm::max(bounds.high, ground.high)};
        }
        frame.view =
            make_view(camera, bounds, options.width, options.height, tile, pixel_offset(sample));
        return frame;
    }

    Context& context;
    DeviceScene scene;
    Painter painter;
    std::optional<Targets> targets;
};

Renderer::Renderer(Context& context, const Scene& scene, const Environment* environment) {
    context.make_current();
    impl_ = std::make_unique<Impl>(context, scene, environment);
}

Renderer::~Renderer() {
    try {
        impl_->context.make_current();
    } catch (const Error&) {  // the context is lost, and everything in it with it
    }
}

void Renderer::set_materials(const std::vector<Material>& materials) {
    if (materials.size() != impl_->scene.materials.size()) {
        throw Error("materials", "", std::to_string(impl_->scene.materials.size()),
                    std::to_string(materials.size()));
    }
    impl_->scene.materials = drawn_materials(materials);
}

Image Renderer::render(const Camera& camera, const RenderSettings& options,
                       const Progress& progress) {
    require_sound(options);
    require_drawable(impl_->scene, options);
    impl_->context.make_current();
    const int side = std::min(options.tile_size > 0 ? options.tile_size : kLargestTile,
                              impl_->context.max_texture_size());
    const std::vector<Tile> tiles = tiles_of(options.width, options.height, side);
    Targets& targets =
        impl_->targets_for(std::min(side, options.width), std::min(side, options.height));
    Image image(options.width, options.height, 4);
    const bool transparent = options.background == BackgroundKind::transparent;
    const double total = static_cast<double>(tiles.size()) * options.samples;
    double done = 0;
    for (const Tile& tile : tiles) {
        targets.clear_sum();
        for (int sample = 0; sample < options.samples; ++sample) {
            // Every fourth: often enough for Ctrl-C, and the device is not kept waiting.
            if (sample % 4 == 0) {
                glFinish();
                progress.step("render", done / total);
            }
            impl_->painter.paint(impl_->frame_of(camera, options, tile, sample), targets);
            impl_->painter.accumulate(targets);
            done += 1;
        }
        store(targets.read_sum(tile.width, tile.height), tile, options.samples, transparent, image);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    check_gl("rendering");
    progress.step("render", 1.0);
    return image;
}

FrameTimes Renderer::measure_frames(const Camera& camera, const RenderSettings& options, int frames,
                                    int warm_up, ShadingVariant variant) {
    require_sound(options);
    require_drawable(impl_->scene, options);
    impl_->context.make_current();
    const int side = std::min(impl_->context.max_texture_size(), kLargestPicture);
    if (options.width > side || options.height > side) {
        throw Error("measure_frames", "size", "at most " + std::to_string(side), "more");
    }
    RenderSettings once = options;
    once.samples = 1;
    Targets& targets = impl_->targets_for(options.width, options.height);
    const Tile tile{0, 0, options.width, options.height};
    Frame frame = impl_->frame_of(camera, once, tile, 0);
    frame.variant = variant;
    // Each frame is sent off by itself, as the swap of a window would.
    const auto paint = [&](int sample) {
        frame.sample = sample;
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

double Renderer::time_frames(const Camera& camera, const RenderSettings& options, int frames,
                             ShadingVariant variant) {
    return measure_frames(camera, options, frames, 1, variant).wall_s;
}

}  // namespace burnish::gpu
