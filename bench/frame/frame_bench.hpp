// The scene on which frames are timed, and the techniques that are: shared by `burnish bench frame`
// and `make bench`. A brushed steel torus with a map of bumps, one directional light, one sample a
// pixel (K11 Fig 11, K12 Table I; the papers name neither mesh nor picture size).
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

// Of what the torus is: the brushed steel, or a table of distributions (app/frame_tabulated.hpp).
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
// follow-grain under image light in three ways, and follow-grain of tabulated materials of many
// texels and of one.
std::span<const Technique> techniques();
// Throws UsageError that suggests the nearest and names `where`.
const Technique& technique_named(std::string_view name, std::string_view where);

struct FrameCase {
    int triangles = 102400;  // a wish: the torus comes near it
    int width = 1280;
    int height = 720;
};

// Throws Error for a picture that the device cannot hold, a software device's memory included.
void require_size(const gpu::Context& context, const FrameCase& frame_case);

// What is drawn, in words for a report.
struct FrameSubject {
    std::string mesh, material, normal_map, light, environment, tabulated;
    int image_light_samples = 0;
};
FrameSubject frame_subject();

// One mesh and picture size, ready to be timed. Destroy it before its context.
class FrameBench {
  public:
    // `image_light`: an environment is made too. Throws as require_size does.
    FrameBench(gpu::Context& context, const FrameCase& frame_case, bool image_light);
    ~FrameBench();

    std::size_t triangles() const { return triangles_; }
    std::size_t covered_pixels() const { return covered_; }

    // `frames` frames; more than one are warmed up by another before them.
    gpu::FrameTimes time(const Technique& technique, int frames);

    // The techniques by turns.
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
