#include "viewer/window/picture.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "burnish/error.hpp"
#include "gpu/device/cloth_store.hpp"
#include "viewer/window/app_parts.hpp"

namespace burnish::viewer {
namespace {

constexpr int kLargestSide = 8192;
constexpr int kSeriesOfPreparation = 15;  // no pane's
// Triangles of a picture in motion. llvmpipe takes 0.2 s of processor time for a million on 2026's
// processors: these take 5 ms of a frame. Hardware draws two million in about as long; not measured.
constexpr std::size_t kSoftwareTriangles = 25'000, kHardwareTriangles = 2'000'000;
// What vertices see is not looked for in a motion, but in one that goes on for longer, as a turntable does.
constexpr double kLongMotion_s = 5.0;
constexpr double kQuiet_s = 0.5;  // at rest, before programs for changes are compiled
// Of a frame, for programs of materials: a change of one material shows itself, and not first a simple picture.
constexpr double kCompile_s = 0.3;
constexpr std::size_t kFewMaterials = 2;  // whose programs a motion may wait for
constexpr double kRate = 30.0;            // frames a second that a moving picture holds
// Shares of the resolution between which a moving picture chooses.
constexpr std::array<double, 6> kScales = {1.0, 0.75, 0.55, 0.4, 0.3, 0.2};

// In its scope nothing is drawn by coarse means of a cloth that was not before.
class FullCloths {
  public:
    explicit FullCloths(gpu::Context& context) : context_(context) {
        context_.cloths().prefer_coarse(false);
    }
    ~FullCloths() { context_.cloths().prefer_coarse(true); }
    FullCloths(const FullCloths&) = delete;
    FullCloths& operator=(const FullCloths&) = delete;

  private:
    gpu::Context& context_;
};

}  // namespace

struct Picture::Shown {
    unsigned framebuffer = 0, texture = 0;
    int width = 0, height = 0;

    Shown() {
        glGenFramebuffers(1, &framebuffer);
        glGenTextures(1, &texture);
    }
    ~Shown() {
        glDeleteFramebuffers(1, &framebuffer);
        glDeleteTextures(1, &texture);
    }
    Shown(const Shown&) = delete;
    Shown& operator=(const Shown&) = delete;

    void resize(int w, int h) {
        if (w == width && h == height) return;
        width = w;
        height = h;
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, w, h, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        glBindTexture(GL_TEXTURE_2D, 0);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }
};

Picture::Picture(gpu::Context& context)
    : context_(context),
      renderer_(std::make_unique<gpu::Renderer>(context)),
      cloths_(context),
      warm_up_(context) {
    // A change of a weave shows in the next frame.
    context_.cloths().prefer_coarse(true);
}

Picture::~Picture() = default;

void Picture::follow(const Editor& editor) {
    const Revisions& now = editor.revisions();
    if (followed_ == now) return;
    const Stage& stage = editor.stage();
    const bool first = !followed_;
    const Revisions before = followed_.value_or(Revisions{});
    if (first || now.scene != before.scene || now.geometry != before.geometry ||
        now.textures != before.textures) {
        renderer_->set_scene(stage.scene);
        meshes_.follow(stage.scene,
                       context_.is_software() ? kSoftwareTriangles : kHardwareTriangles);
        new_scene_ = true;
        previewing_ = false;
        preview_normal_ = preview_stretch_ = -1;
    } else {
        if (now.materials != before.materials) {
            renderer_->set_materials(stage.scene.materials);
            previewing_ = false;
        }
        if (now.lights != before.lights) renderer_->set_lights(stage.scene.lights);
    }
    if (first || now.environment != before.environment) {
        environment_ =
            stage.environment.radiance.empty() ? nullptr : prepare_environment(stage.environment);
        renderer_->set_environment(environment_);
    }
    any_tabulated_ = std::ranges::any_of(
        stage.scene.materials, [](const Material& m) { return tabulated_of(m) != nullptr; });
    lit_ = !stage.environment.radiance.empty();
    materials_ = stage.scene.materials.size();
    if (first || now.materials != before.materials || now.scene != before.scene) {
        std::vector<std::pair<Brdf, Mdf>> models = models_with_tables(stage.scene);
        if (models != models_) motion_prepared_ = false;
        models_ = std::move(models);
    }
    if (first || now.environment != before.environment || now.scene != before.scene)
        motion_prepared_ = false;
    Revisions as_before = now;
    as_before.display = before.display;
    const bool display_only = !first && as_before == before;
    camera_ = stage.camera;
    const float limit = robust_limit(stage.values);
    const bool same_limit = settings_.robust_limit == limit;
    settings_ = stage.settings;
    settings_.robust_limit = limit;
    exposure_ev_ = stage.exposure_ev;
    tone_map_ = stage.tone_map;
    display_changed_ = true;
    if (!display_only || !same_limit) begun_ = false;
    const auto same = [&](std::uint64_t Revisions::*part) { return now.*part == before.*part; };
    if (first || !same(&Revisions::scene) || !same(&Revisions::materials) ||
        !same(&Revisions::textures) || !same(&Revisions::lights) ||
        !same(&Revisions::environment) || !same(&Revisions::settings))
        warm_up_.follow(stage, renderer_->pass_of(settings_));
    VisibleLight::Change change;
    change.geometry = first || !same(&Revisions::scene) || !same(&Revisions::geometry);
    change.textures = !same(&Revisions::textures);
    change.materials = !same(&Revisions::materials);
    change.light = !same(&Revisions::lights) || !same(&Revisions::environment);
    change.forgotten = change.geometry || change.textures;
    visible_.follow(stage, environment_, change, *renderer_);
    followed_ = now;
}

void Picture::preview(const std::vector<ScratchPreview>& materials, const ScratchTextures& maps) {
    if (!followed_) return;
    const auto put = [&](int& id, const Texture& texture) {
        if (id < 0)
            id = renderer_->add_texture(texture);
        else
            renderer_->update_texture(id, texture);
    };
    put(preview_normal_, maps.normal);
    if (std::ranges::any_of(materials, &ScratchPreview::follows))
        put(preview_stretch_, maps.anisotropy);
    for (const ScratchPreview& preview : materials) {
        Material shown = preview.shown;
        shown.normal_texture.texture = preview_normal_;
        if (preview.follows) shown.anisotropy_texture.texture = preview_stretch_;
        renderer_->update_material(preview.material, shown);
    }
    previewing_ = true;
    begun_ = false;
}

void Picture::end_preview(const Editor& editor) {
    // Where the materials have changed since, follow() sets them.
    if (!previewing_ || !followed_ || followed_->scene != editor.revisions().scene ||
        followed_->materials != editor.revisions().materials ||
        followed_->textures != editor.revisions().textures)
        return;
    renderer_->set_materials(editor.stage().scene.materials);
    previewing_ = false;
    begun_ = false;
}

void Picture::set_size(int width, int height) {
    width = std::clamp(width, 1, kLargestSide);
    height = std::clamp(height, 1, kLargestSide);
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    begun_ = false;
}

void Picture::set_panes(std::vector<Pane> panes) {
    if (panes == panes_ || panes.empty()) return;
    for (std::size_t i = panes.size(); i < panes_.size(); ++i) {
        renderer_->select_series(static_cast<int>(i));
        renderer_->end_series();
    }
    panes_ = std::move(panes);
    begun_ = false;
}

void Picture::set_moving(bool moving) {
    if (moving == moving_) return;
    moving_ = moving;
    moving_since_.reset();
    if (moving) moving_since_ = Clock::now();
    last_moving_frame_.reset();
    begun_ = false;
}

void Picture::restart() {
    begun_ = false;
}

RenderSettings Picture::pane_settings(const Pane& pane) const {
    RenderSettings o = settings_;
    const double scale = moving_ ? moving_scale_ : 1.0;
    o.width = std::max(1, static_cast<int>(std::lround(width_ * scale)));
    o.height = std::max(1, static_cast<int>(std::lround(height_ * scale)));
    o.method = pane.method;
    o.view = pane.view;
    return moving_ ? settings_in_motion(o, motion_prepared_) : o;
}

RenderSettings Picture::settings_in_motion(RenderSettings o, bool prepared) const {
    o.samples = 1;
    o.coarse = true;
    // Tabulated materials have no prefiltered light.
    const bool blurred = prepared && !any_tabulated_ && o.image_light == ImageLight::importance;
    if (blurred) o.image_light = ImageLight::prefiltered;
    if (o.image_light == ImageLight::importance || o.view == SurfaceView::albedo)
        o.image_light_samples = std::min(o.image_light_samples, 2);
    // One choice for all resolutions of a motion: the other would be compiled on the frame.
    if (prepared && !any_tabulated_) o.surface_pass = SurfacePass::deferred;
    return o;
}

gpu::PixelRegion Picture::region_of(const Pane& pane, int width, int height) const {
    const auto edge = [width](double part) {
        return std::clamp(static_cast<int>(std::lround(part * width)), 0, width);
    };
    const int left = std::min(edge(pane.left), width - 1);
    return {left, 0, std::max(edge(pane.right) - left, 1), height};
}

void Picture::begin_panes() {
    samples_.assign(panes_.size(), 0);
    while (shown_.size() < panes_.size()) shown_.push_back(std::make_unique<Shown>());
    shown_.resize(panes_.size());
    shown_scale_ = moving_ ? moving_scale_ : 1.0;
    for (std::size_t i = 0; i < panes_.size(); ++i) {
        const RenderSettings o = pane_settings(panes_[i]);
        const gpu::PixelRegion region = region_of(panes_[i], o.width, o.height);
        renderer_->select_series(static_cast<int>(i));
        renderer_->begin(camera_, o, region);
    }
    begun_ = true;
}

bool Picture::is_done(std::size_t index) const {
    return samples_[index] >= (moving_ ? 1 : settings_.samples);
}

bool Picture::at_rest() const {
    return is_drawn() && !visible_.working();
}

bool Picture::is_drawn() const {
    if (!begun_ || moving_ || display_changed_ || cloths_.any()) return false;
    for (std::size_t i = 0; i < panes_.size(); ++i)
        if (!is_done(i)) return false;
    return true;
}

int Picture::samples() const {
    return begun_ && !samples_.empty() ? *std::ranges::min_element(samples_) : 0;
}

// The time between frames of a moving picture decides the next one's resolution.
void Picture::adapt_scale() {
    if (!moving_) return;
    const Clock::time_point now = Clock::now();
    if (last_moving_frame_) {
        const double period = std::chrono::duration<double>(now - *last_moving_frame_).count();
        const auto place = std::ranges::find(kScales, moving_scale_);
        const auto index =
            static_cast<std::size_t>(place == kScales.end() ? 2 : place - kScales.begin());
        // Between 0.6 and 1 periods of the rate nothing changes, so that it does not swing.
        if (period > 1.0 / kRate && index + 1 < kScales.size()) {
            moving_scale_ = kScales[index + 1];
        } else if (period < 0.6 / kRate && index > 0) {
            moving_scale_ = kScales[index - 1];
        }
    }
    last_moving_frame_ = now;
}

bool Picture::prepares() const {
    return followed_ &&
           ((!motion_prepared_ && !any_tabulated_) || meshes_.working() || !warm_up_.done());
}

// At rest: the first frame of a motion then compiles and blurs nothing. Programs are compiled whole
// when something is drawn by them.
void Picture::prepare_motion() {
    if (!followed_ || motion_prepared_ || any_tabulated_) return;
    const bool lit = lit_ && settings_.image_light == ImageLight::importance;
    if (lit && !tables_.ready(context_, models_)) return;
    RenderSettings o = settings_in_motion(settings_, true);
    o.width = width_;
    o.height = height_;
    o.method = panes_.front().method;
    o.view = panes_.front().view;
    renderer_->select_series(kSeriesOfPreparation);
    renderer_->begin(camera_, o, gpu::PixelRegion{width_ / 2, height_ / 2, 1, 1});
    renderer_->add_sample();
    const bool compiled = renderer_->stand_ins() == 0;
    renderer_->end_series();
    motion_prepared_ = compiled;
}

bool Picture::refine(double budget_s) {
    if (!followed_) return false;
    visible_.hold(moving_since_ && seconds_since(*moving_since_) < kLongMotion_s);
    meshes_.give(*renderer_);
    if (cloths_.give(*renderer_)) begun_ = false;
    if (moving_) {
        adapt_scale();
        begun_ = false;  // every frame of a motion is a picture of its own
    } else {
        cloths_.begin();
        // After the first samples, which it would delay.
        if (samples() > 0) visible_.step();
    }
    if (visible_.give(*renderer_)) begun_ = false;
    if (waits()) return false;
    if (at_rest()) {
        if (!rest_since_) rest_since_ = Clock::now();
        prepare_motion();
        // What a motion needs of the scene itself comes first.
        if (seconds_since(*rest_since_) > kQuiet_s && (motion_prepared_ || any_tabulated_))
            warm_up_.step(settings_in_motion(settings_, motion_prepared_));
        return false;
    }
    rest_since_.reset();
    // The first picture of a scene comes at once, and a motion of many materials does not wait for them.
    const bool hurries = new_scene_ || (moving_ && materials_ > kFewMaterials);
    renderer_->set_compile_budget(hurries ? 0.0 : kCompile_s);
    new_scene_ = false;
    if (!begun_) begin_panes();
    const auto start = Clock::now();
    bool added = true;
    stand_ins_ = 0;
    while (added && stand_ins_ == 0) {
        added = false;
        for (std::size_t i = 0; i < panes_.size(); ++i) {
            if (is_done(i)) continue;
            renderer_->select_series(static_cast<int>(i));
            renderer_->add_sample();
            samples_[i] = renderer_->samples_done();
            stand_ins_ = std::max(stand_ins_, renderer_->stand_ins());
            added = true;
        }
        if (!moving_) glFinish();
        sample_s_ = seconds_since(start);
        if (sample_s_ > budget_s) break;
    }
    present_panes();
    has_shown_ = true;
    display_changed_ = false;
    if (at_rest()) prepare_motion();
    return true;
}

void Picture::present_panes() {
    for (std::size_t i = 0; i < panes_.size(); ++i) {
        const RenderSettings o = pane_settings(panes_[i]);
        const gpu::PixelRegion region = region_of(panes_[i], o.width, o.height);
        shown_[i]->resize(region.width, region.height);
        renderer_->select_series(static_cast<int>(i));
        const bool radiance = panes_[i].view == SurfaceView::radiance;
        renderer_->present(shown_[i]->framebuffer, region.width, region.height,
                           radiance ? exposure_ev_ : 0.0, radiance ? tone_map_ : ToneMap::linear);
    }
}

unsigned Picture::texture(std::size_t index) const {
    return index < shown_.size() && shown_[index]->width > 0 ? shown_[index]->texture : 0;
}

Image Picture::shown(std::size_t index) const {
    const Shown& shown = *shown_.at(index);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(shown.width) *
                                    static_cast<std::size_t>(shown.height) * 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, shown.framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, shown.width, shown.height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    Image image(shown.width, shown.height, 3);
    for (int y = 0; y < shown.height; ++y) {
        const std::uint8_t* from = bytes.data() + static_cast<std::size_t>(shown.height - 1 - y) *
                                                      static_cast<std::size_t>(shown.width) * 4;
        float* to = image.at(0, y);
        for (int x = 0; x < shown.width; ++x)
            for (int c = 0; c < 3; ++c)
                to[3 * x + c] = static_cast<float>(from[4 * x + c]) / 255.0f;
    }
    return image;
}

Image Picture::render(const Camera& camera, const RenderSettings& settings,
                      const Progress& progress) {
    begun_ = false;
    const FullCloths full(context_);
    cloths_.finish(*renderer_);
    visible_.finish(*renderer_);
    renderer_->select_series(0);
    return renderer_->render(camera, settings, progress);
}

}  // namespace burnish::viewer
