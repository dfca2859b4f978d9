// The real-time renderer: a scene and an environment in, a linear float picture out.
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
    bent_normal   // what today's engines do (Filament, three.js, glTF sample renderer): comparison
};
enum class BackgroundKind { environment, color, transparent };

struct RenderOptions {
    int width = 1280;
    int height = 720;
    int samples = 64;              // jittered sub-pixel samples, >= 1
    int image_light_samples = 16;  // environment samples a pixel and sub-pixel sample
    ImageLight image_light = ImageLight::importance;
    float environment_intensity = 1.0f;
    float environment_rotation = 0.0f;  // radians about +y
    BackgroundKind background = BackgroundKind::environment;
    glm::vec3 background_color{0.05f};  // linear
    float background_blur = 0.0f;       // 0..1
    unsigned seed = 0;
};

// Frame-cost variants of the benchmark (K11 Fig 11, K12 Table I).
enum class ShadingVariant { full, gouraud, anisotropic };

class Renderer {
  public:
    // Uploads everything. Throws Error when something is too large for the device.
    Renderer(Context& context, const Scene& scene, const Environment* environment);
    ~Renderer();

    // Linear RGBA (alpha = coverage when the background is transparent, else 1). Every pixel finite.
    Image render(const Camera& camera, const RenderOptions& options, const Progress& progress = {});

    // Materials may be changed between renders (method, mdf, brdf and factors, not textures).
    void set_materials(const std::vector<Material>& materials);

    // For the benchmark: draws `frames` frames into the float target with no read-back, one sample
    // each, and returns wall seconds for all of them after glFinish.
    double time_frames(const Camera& camera, const RenderOptions& options, int frames,
                       ShadingVariant variant = ShadingVariant::full);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace burnish::gpu
