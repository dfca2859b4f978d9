// The real-time renderer: a scene and an environment in, pictures out, while both are edited.
//
// Choices that the literature leaves open:
// - Pixels are filtered by a triangle of half width 1 pixel, sampled by jittering the whole view.
// - The horizon of the perturbed normal bounds the light: a mapped bump matches a modeled one. A
//   view below that horizon sees the normal turned until it faces the view (normal_facing).
// - The diffuse term is base (1 - metallic) / pi (1 - F(n~.wi)) (1 - F(|n~.wo|)), F Schlick's with
//   the dielectric F0; under an environment the first factor is its cosine-weighted mean.
// - Occlusion maps darken image light only, its reflections by the rule in shade.glsl.
// - Blended instances are sorted back to front by the centers of their boxes; their triangles
//   are not.
// - Back faces of double-sided materials have their whole tangent frame turned over: the sheet seen
//   from behind, where a dent is a bump.
//
// Threads: all calls come from the thread on which the context is current, or may be made current;
// two renderers of one context are used one after the other. Lifetime: destroy a renderer before
// its context. Nothing that is passed in is referred to after the call; a copy of textures and
// environment is kept, meshes are on the device alone, a prepared environment is shared.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/context.hpp"
#include "burnish/display.hpp"
#include "burnish/prepared_environment.hpp"
#include "burnish/progress.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/scene.hpp"
#include "burnish/upload_counts.hpp"
#include "burnish/visibility.hpp"

namespace burnish {
namespace BURNISH_API gpu {

// Frame-cost variants of the benchmark (K11 Fig 11, K12 Table I): the full shading, lighting at the
// vertices only, and the full shading without the normal map.
enum class ShadingVariant { full, gouraud, anisotropic };

// Seconds that a number of frames took together.
struct FrameTimes {
    double wall_s = 0;
    double cpu_s = 0;                // processor time of all threads of the program
    std::optional<double> device_s;  // as the device's timer says, true or not (device_timer.hpp)
};

// What a sample is drawn by, in this order. `display` is no part of a sample: it is what present does.
enum class Pass {
    shadow_maps,
    surface_data,  // normals, tangents and texture coordinates, for deferred shading
    shading,       // of opaque surfaces, lights and image light together
    background,
    ground,   // the shadow on it
    blended,  // surfaces
    sum,      // of samples
    display   // exposure, tone map, encoding
};
inline constexpr std::size_t kPassCount = 8;
std::span<const std::string_view> pass_names();  // in the order of the enumeration

// Seconds by Pass, of a number of samples and of calls of present together.
struct PassTimes {
    std::array<double, kPassCount> seconds{};
    int samples = 0;
    int presents = 0;
    // True: by queries of the device, which change nothing. False, on software renderers: by the clock,
    // every pass waiting for the one before, which makes frames longer than they are otherwise.
    bool by_device = false;
};

// Pixels of a picture; (0, 0) is the lower left one.
struct PixelRegion {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    bool operator==(const PixelRegion&) const = default;
};

class Renderer {
  public:
    // Of an empty scene without light.
    explicit Renderer(Context& context);
    // Uploads everything. `environment` may be null. Throws Error when something is broken or too
    // large for the device, Interrupted when `progress` is cancelled.
    Renderer(Context& context, const Scene& scene, const Environment* environment,
             const Progress& progress = {});
    ~Renderer();

    // Edits. An id is the index into the vector of the scene: it stays for the renderer's life, or
    // until set_scene. An edit uploads what it brings and nothing else. It throws Error for an id
    // that does not exist and for what is broken or too large for the device, Interrupted when
    // `progress` is cancelled; the renderer then draws what it drew before. An edit ends the series
    // of samples in progress: the next add_sample begins it anew.

    // Meshes and textures that equal those on the device stay there.
    void set_scene(const Scene& scene, const Progress& progress = {});
    // Null: no environment. The first function prepares the environment and uploads it; the second
    // uploads one that another thread, say, has prepared.
    void set_environment(const Environment* environment, const Progress& progress = {});
    void set_environment(std::shared_ptr<const PreparedEnvironment> prepared);
    // At most 16 without an area and 8 with one.
    void set_lights(std::span<const Light> lights);
    // What the vertices see of the environment (burnish/visibility.hpp), of all instances; null: everything. An
    // edit of a mesh, or of the mesh of an instance, forgets it for that instance; after other edits it stays.
    // Throws Error where it is of another scene.
    void set_visibility(std::shared_ptr<const Visibility> visibility);

    int add_material(const Material& material, const Progress& progress = {});
    void update_material(int id, const Material& material, const Progress& progress = {});
    // All of them, as many as there are.
    void set_materials(const std::vector<Material>& materials, const Progress& progress = {});

    // Woven materials that were drawn with coarse means of their yarns (ClothStore) take full ones, where
    // they are there by now.
    void refine_cloths();

    // A texture is uploaded when a material uses it, in each form that materials read it in.
    int add_texture(Texture texture);
    void update_texture(int id, Texture texture, const Progress& progress = {});

    int add_mesh(const Mesh& mesh);
    void update_mesh(int id, const Mesh& mesh);
    // Sets the triangles by which pictures with RenderSettings::coarse draw the mesh: three indices
    // each into its vertices, as coarse_indices returns them. Empty: the mesh's own. They stay with the mesh
    // on the device: set_scene keeps them for equal meshes. Ends series that are coarse.
    void set_coarse_mesh(int id, std::span<const std::uint32_t> indices);

    int add_instance(const Instance& instance);
    void update_instance(int id, const Instance& instance);  // one that was removed is there again
    void remove_instance(int id);                            // its id is not given to another

    // Makes what pictures with these settings need beyond the scene: compiled shaders, tables, the
    // blurred environment, the shadow on the ground. begin and render do the same where it was not
    // done; this call keeps it off the frame. When `progress` is cancelled, what was made by then
    // stays, and the renderer draws what it drew before.
    void prepare(const RenderSettings& settings, const Progress& progress = {});

    // Several series may go on side by side, each with images of its own: views of one scene that are
    // shown together. begin, add_sample, samples_done, present and picture speak of the selected
    // one, number 0 at first. Numbers from 0 to 15; Error for another. end_series frees the images
    // of the selected one.
    void select_series(int number);
    void end_series();

    // A series of samples of one picture, whose mean may be shown after each. `settings.samples` is
    // the number that the series is meant to reach: textures are read as finely as so many samples
    // allow. Another size than the last series had makes new images to draw into. The number of
    // lights is no part of the shaders: another number compiles nothing. `region`: only these pixels
    // are drawn, and present and picture give them alone. Throws Error for settings out of range and
    // for a region that is empty or leaves the picture.
    void begin(const Camera& camera, const RenderSettings& settings,
               const std::optional<PixelRegion>& region = {});
    // The pass that SurfacePass::automatic takes for a picture with these settings.
    SurfacePass pass_of(const RenderSettings& settings) const;
    void add_sample();  // Error when nothing was begun
    // Seconds that add_sample may take to compile programs of materials, and begin takes none; one program is
    // compiled at least unless it is 0. For the other materials a simple program stands in: such a sample is to
    // be presented, and the next add_sample begins the mean anew. None, as at first: begin compiles everything.
    // Views other than radiance, and scenes that only lights with an area light, are never stood in for.
    void set_compile_budget(std::optional<double> seconds);
    // Number of materials that were stood in for in the last sample of the last series.
    int stand_ins() const;
    int samples_done() const;  // of the mean: 0 while materials are stood in for
    // The mean so far as a display shows it, sRGB-encoded RGBA, into the lower left width x height
    // pixels of a framebuffer (0: the window's); as to_display(picture()) within 1/255. A
    // framebuffer of another size than the picture's gets the nearest pixels. Alpha is coverage
    // under a transparent background, which color is not multiplied by, else 1. Error when there is
    // no sample.
    void present(unsigned framebuffer, int width, int height, double exposure_ev, ToneMap tone_map);
    // The mean so far, linear, as render returns it. Error when there is no sample.
    Image picture();

    // Linear RGBA (alpha = coverage when the background is transparent, else 1; not premultiplied).
    // Every value is finite and in [0, 65504]. Large pictures are drawn in tiles. Ends a series.
    Image render(const Camera& camera, const RenderSettings& settings,
                 const Progress& progress = {});

    // For benchmarks: draws `frames` frames into the float target with no read-back, one sample
    // each, between two glFinish. `warm_up` frames before them are not counted. Ends a series.
    FrameTimes measure_frames(const Camera& camera, const RenderSettings& settings, int frames,
                              int warm_up, ShadingVariant variant = ShadingVariant::full);

    // Their wall seconds, after one frame that warms up.
    double time_frames(const Camera& camera, const RenderSettings& settings, int frames,
                       ShadingVariant variant = ShadingVariant::full);

    // From now on the passes of add_sample and present are timed, or no longer, as at first. While off,
    // it costs nothing. Not during measure_frames.
    void measure_passes(bool on);
    // What was measured since the last call. It waits for the device where that is not done: best asked
    // for in the next frame.
    PassTimes take_pass_times();

    // For tests and benchmarks: uploads since the renderer was made.
    UploadCounts uploads() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace gpu
}  // namespace burnish
