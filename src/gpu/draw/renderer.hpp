// The real-time renderer: a scene and an environment in, a linear float picture out.
//
// What it does, where a choice had to be made:
// - Pixels are filtered by a triangle of half width 1 pixel, sampled by jittering the whole view.
// - Only the horizon of the perturbed normal counts for light: a mapped bump matches a modelled
// one.
//   Where the VIEW is below the perturbed horizon the specular term is 0 and the diffuse one stays.
// - The diffuse term is base (1 - metallic) / pi (1 - F(n~.wi)) (1 - F(|n~.wo|)), F Schlick's with
//   the dielectric F0; under an environment the first factor is its cosine-weighted mean.
// - Occlusion maps darken image light only, its reflections by the rule in shade.glsl.
// - Blended instances are sorted back to front by the middle of their boxes, their triangles are
//   not.
// - Back faces of double-sided materials have their whole tangent frame turned over: the sheet seen
//   from behind, where a dent is a bump.
#pragma once

#include <memory>
#include <optional>

#include "burnish/progress.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/scene.hpp"
#include "gpu/device/context.hpp"

namespace burnish::gpu {

// Frame-cost variants of the benchmark (K11 Fig 11, K12 Table I): the full shading, lighting at the
// vertices only, and the full shading without the normal map.
enum class ShadingVariant { full, gouraud, anisotropic };

// What some frames took, all of them together, seconds.
struct FrameTimes {
    double wall_s = 0;
    double cpu_s = 0;                // processor time of all threads of the program
    std::optional<double> device_s;  // as the device's timer says, true or not (device_timer.hpp)
};

// Destroy it before its context.
class Renderer {
  public:
    // Uploads everything; nothing of `scene` is referred to afterwards. `environment` may be null.
    // Throws Error when something is broken or too large for the device.
    Renderer(Context& context, const Scene& scene, const Environment* environment);
    ~Renderer();

    // Linear RGBA (alpha = coverage when the background is transparent, else 1; not premultiplied).
    // Every value is finite and in [0, 65504].
    Image render(const Camera& camera, const RenderSettings& options,
                 const Progress& progress = {});

    // Materials may be changed between renders (method, mdf, brdf and factors, not textures
    // nor how a normal map is filtered).
    void set_materials(const std::vector<Material>& materials);

    // For benchmarks: draws `frames` frames into the float target with no read-back, one sample
    // each, between two glFinish. `warm_up` frames before them are not counted.
    FrameTimes measure_frames(const Camera& camera, const RenderSettings& options, int frames,
                              int warm_up, ShadingVariant variant = ShadingVariant::full);

    // Their wall seconds, after one frame that warms up.
    double time_frames(const Camera& camera, const RenderSettings& options, int frames,
                       ShadingVariant variant = ShadingVariant::full);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace burnish::gpu
