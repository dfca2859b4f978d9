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
#include "burnish/scene.hpp"
#include "gpu/context.hpp"

namespace burnish::gpu {

enum class ImageLight {
    off,
    importance,   // the specular sees the perturbed anisotropic MDF: importance sampled, filtered
    bent_normal,  // what today's engines do (Filament, three.js, glTF sample renderer): comparison
    prefiltered   // the same lobe by a few look-ups along its major axis: for real time
};
enum class BackgroundKind { environment, color, transparent };

// How opaque surfaces are shaded. Small triangles make forward shading pay several times a pixel
// (hardware shades blocks of 2 x 2, llvmpipe of 4 x 4); deferred writes normal, tangent and texture
// coordinates first and shades once. Materials with masks, vertex colours or textures that differ
// in texture coordinates are always drawn forward.
enum class SurfacePass {
    automatic,  // deferred when there are many triangles for the pixels of the picture
    forward,
    deferred
};

struct RenderOptions {
    int width = 1280;
    int height = 720;
    int samples = 64;              // jittered sub-pixel samples, >= 1
    int image_light_samples = 16;  // environment samples a pixel and sub-pixel sample
    ImageLight image_light = ImageLight::importance;
    bool filter_image_samples = true;  // false: every sample reads the sharp environment
    bool filter_cloth = true;  // false: cloth is the point at a sample's middle, however far
    float environment_intensity = 1.0f;
    float environment_rotation = 0.0f;  // radians about +y
    BackgroundKind background = BackgroundKind::environment;
    glm::vec3 background_color{0.05f};  // linear; also when there is no environment
    float background_blur = 0.0f;       // 0..1
    bool shadows = false;               // of punctual lights; they are never darkened otherwise
    bool ground = false;                // a shadow on the plane under the scene (ground.hpp)
    unsigned seed = 0;
    int tile_size = 0;  // pixels a side; 0: chosen, so that memory is bounded
    SurfacePass surface_pass = SurfacePass::automatic;
};

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
    Image render(const Camera& camera, const RenderOptions& options, const Progress& progress = {});

    // Materials may be changed between renders (method, mdf, brdf and factors, not textures
    // nor how a normal map is filtered).
    void set_materials(const std::vector<Material>& materials);

    // For benchmarks: draws `frames` frames into the float target with no read-back, one sample
    // each, between two glFinish. `warm_up` frames before them are not counted.
    FrameTimes measure_frames(const Camera& camera, const RenderOptions& options, int frames,
                              int warm_up, ShadingVariant variant = ShadingVariant::full);

    // Their wall seconds, after one frame that warms up.
    double time_frames(const Camera& camera, const RenderOptions& options, int frames,
                       ShadingVariant variant = ShadingVariant::full);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace burnish::gpu
