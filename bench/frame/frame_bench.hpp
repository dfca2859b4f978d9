// The scene and the techniques that are timed, shared by `burnish bench frame` and `make bench`. A
// brushed steel torus with a bump map, one directional light, one sample per pixel (K11 Fig 11, K12
// Table I; the papers name neither mesh nor picture size).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/frame/interleave.hpp"
#include "burnish/context.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "burnish/shading_names.hpp"

namespace burnish {

// The torus's material: brushed steel, or a table of distributions
// (bench/frame/frame_tabulated.hpp).
enum class BenchMaterial { steel, texels, one_texel };

struct Technique {
    std::string_view name;
    Method method;
    gpu::ShadingVariant variant;
    ImageLight image_light;
    BenchMaterial material;

    bool tabulated() const { return material != BenchMaterial::steel; }
    bool lit_by_image() const { return image_light != ImageLight::off; }
};

// gouraud, aniso (the anisotropic lobe without the normal map), every method that reads the map,
// follow-grain under image light in three ways, and follow-grain with tabulated materials of many
// texels and of one.
std::span<const Technique> techniques();
// Throws UsageError that names `where` and suggests the nearest technique.
const Technique& technique_named(std::string_view name, std::string_view where);

struct FrameCase {
    int triangles = 102400;  // requested; the torus has about this number
    int width = 1280;
    int height = 720;
};

// Throws Error for a picture too large for the device, or for the memory if the device is software.
void require_size(const gpu::Context& context, const FrameCase& frame_case);

// The drawn subject in words, for a report.
struct FrameSubject {
    std::string mesh, material, normal_map, light, environment, tabulated;
    int image_light_samples = 0;
};
FrameSubject frame_subject();

// A mesh at one picture size, ready to be timed. Destroy it before its context.
class FrameBench {
  public:
    // `image_light`: also creates an environment. Throws as require_size does.
    FrameBench(gpu::Context& context, const FrameCase& frame_case, bool image_light);
    ~FrameBench();

    std::size_t triangles() const { return triangles_; }
    std::size_t covered_pixels() const { return covered_; }

    // Times `frames` frames; for more than one, draws a warm-up frame first.
    gpu::FrameTimes time(const Technique& technique, int frames);

    // Times the techniques in alternation.
    RoundSamples interleave(std::span<const Technique* const> subjects,
                            const InterleaveOptions& options,
                            const std::function<void(double)>& tick);

  private:
    struct Stage;
    std::unique_ptr<Stage> stage_;
    std::size_t triangles_ = 0;
    std::size_t covered_ = 0;
};

}  // namespace burnish
