// The picture of the viewer: panes drawn by one renderer, quickly while things move and refined at rest
// until they are what `burnish render` gives.
//
// Threads: the one on which the window's context is current. Lifetime: destroy it before the context.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/renderer.hpp"
#include "viewer/document/editor.hpp"
#include "viewer/generate/scratches.hpp"
#include "viewer/prepare/motion_data.hpp"
#include "viewer/prepare/visible_light.hpp"
#include "viewer/prepare/warm_up.hpp"

namespace burnish::viewer {

// A view of the scene: the whole picture or a part of it.
struct Pane {
    std::optional<Method> method;  // in place of the materials' own
    SurfaceView view = SurfaceView::radiance;
    double left = 0, right = 1;  // in parts of the picture's width
    bool operator==(const Pane&) const = default;
};

class Picture {
  public:
    explicit Picture(gpu::Context& context);
    ~Picture();
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;

    // Uploads what the editor has changed since the last call, and starts the picture anew where it
    // changes. Throws Error for what the device cannot take; the picture is then what it was.
    void follow(const Editor& editor);
    // Shows the materials with these maps in place of the scene's: scratches that are not in the document
    // yet. It ends with the next change of materials or textures that follow() brings.
    void preview(const std::vector<ScratchPreview>& materials, const ScratchTextures& maps);
    void end_preview(const Editor& editor);
    bool previewing() const { return previewing_; }
    // Size in device pixels, at most 8192 a side.
    void set_size(int width, int height);
    void set_panes(std::vector<Pane> panes);
    // While true, resolution and samples drop to hold the rate.
    void set_moving(bool moving);
    // Draws again from the first sample (shaders were reloaded).
    void restart();

    // Adds samples to panes for about `budget_s`, one at the least, and shows them in the textures.
    // Returns false when every pane was at rest.
    bool refine(double budget_s);
    bool at_rest() const;
    // Drawn with all samples, but what vertices see is still being found.
    bool waits() const { return is_drawn() && visible_.working(); }
    // At rest, refine() still prepares what a motion or a change of the model needs.
    bool prepares() const;
    int samples() const;  // of the pane that has fewest
    // Whether something was shown since this was made, be it simple pictures of materials to come.
    bool has_shown() const { return has_shown_; }
    // Number of materials that are drawn simply until their programs are compiled.
    int stand_ins() const { return stand_ins_; }
    int wanted_samples() const { return settings_.samples; }
    double scale() const { return shown_scale_; }  // of the resolution shown
    double last_sample_s() const { return sample_s_; }

    std::size_t pane_count() const { return panes_.size(); }
    const Pane& pane(std::size_t index) const { return panes_[index]; }
    // A texture whose lower left corner is that of the pane; 0: nothing was drawn yet.
    unsigned texture(std::size_t index) const;
    // Colors of a pane as the display has them, 8 bits.
    Image shown(std::size_t index) const;

    gpu::Renderer& renderer() { return *renderer_; }
    std::shared_ptr<const PreparedEnvironment> environment() const { return environment_; }
    // After another visibility was given to the renderer: what the picture has found, again.
    void restore_visibility() { visible_.give_again(*renderer_); }
    // Another picture of the scene, of any size. Ends and restarts the panes.
    Image render(const Camera& camera, const RenderSettings& settings, const Progress& progress);

  private:
    struct Shown;  // framebuffer and texture of a pane
    using Clock = std::chrono::steady_clock;

    RenderSettings pane_settings(const Pane& pane) const;
    RenderSettings settings_in_motion(RenderSettings settings, bool prepared) const;
    gpu::PixelRegion region_of(const Pane& pane, int width, int height) const;
    void begin_panes();
    void present_panes();
    void adapt_scale();
    void prepare_motion();
    bool is_done(std::size_t index) const;
    bool is_drawn() const;

    gpu::Context& context_;
    std::unique_ptr<gpu::Renderer> renderer_;
    std::optional<Revisions> followed_;
    bool previewing_ = false;
    int preview_normal_ = -1, preview_stretch_ = -1;  // textures of the renderer's; -1: none
    Camera camera_;
    RenderSettings settings_;
    double exposure_ev_ = 0;
    ToneMap tone_map_ = ToneMap::khronos_neutral;
    bool any_tabulated_ = false, lit_ = false;
    MotionTables tables_;
    MotionMeshes meshes_;
    MotionCloths cloths_;
    WarmUp warm_up_;
    VisibleLight visible_;
    std::shared_ptr<const PreparedEnvironment> environment_;
    std::vector<std::pair<Brdf, Mdf>> models_;  // of the materials
    bool motion_prepared_ = false;
    std::optional<Clock::time_point> rest_since_;
    std::vector<Pane> panes_{Pane{}};
    std::vector<std::unique_ptr<Shown>> shown_;
    std::vector<int> samples_;
    int width_ = 1, height_ = 1;
    bool moving_ = false, begun_ = false, display_changed_ = false;
    std::size_t materials_ = 0;
    int stand_ins_ = 0;
    bool new_scene_ = false, has_shown_ = false;
    double moving_scale_ = 0.5, shown_scale_ = 1, sample_s_ = 0;
    std::optional<Clock::time_point> last_moving_frame_, moving_since_;
};

}  // namespace burnish::viewer
