// What a picture of a scene is to be: size, samples, lights that count, background. Every renderer
// takes it.
//
// Threads and lifetime: plain values; copies are independent, and any number of threads may read
// one.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "burnish/api.hpp"
#include "burnish/shading_names.hpp"

namespace BURNISH_API burnish {

enum class ImageLight {
    off,
    importance,   // the specular sees the perturbed anisotropic MDF: importance sampled, filtered
    bent_normal,  // what today's engines do (Filament, three.js, glTF sample renderer): comparison
    prefiltered   // the same lobe by a few look-ups along its major axis: for real time
};
enum class BackgroundKind { environment, color, transparent };

// Names in the order of the enumerations: the choices of the parameters image_light and background.
std::span<const std::string_view> image_light_names();
std::span<const std::string_view> background_names();

// How opaque surfaces are shaded. Small triangles make forward shading pay several times a pixel
// (hardware shades blocks of 2 x 2, llvmpipe of 4 x 4); deferred writes normal, tangent and texture
// coordinates first and shades once. Materials with masks, vertex colours or textures that differ
// in texture coordinates are always drawn forward.
enum class SurfacePass {
    automatic,  // deferred when there are many triangles for the pixels of the picture
    forward,
    deferred
};

// What a picture shows of every surface: the radiance towards the eye, or a quantity behind it, for
// looking for the cause of a picture. A quantity is shown as a color that tone map `linear`
// and exposure 0 display: vectors v as (v + 1) / 2, numbers from dark blue (0) to light yellow (the
// highest value named below). Blended surfaces are drawn as opaque ones, and there is no background. The
// albedo needs no light and sees neither shadow nor occlusion; its color is that of the mean of all samples.
enum class SurfaceView {
    radiance,
    normal,            // geometric, of the world
    perturbed_normal,  // n~, of the world
    tangent,           // of the world
    grain,    // along the grooves: hue by its angle to the tangent, saturated by anisotropy
    alpha_x,  // roughness along the lobe's x axis, widened by the normal map: 0 to 1
    alpha_y,  // across
    tilt,     // |d|, the sine of the angle between n and n~: 0 to 1
    texture_coordinates,  // (u, v) modulo 1 in red and green, a checker of whole units
    slope_variance,       // that the normal map adds, square root along the larger axis: 0 to 1
    moments,          // of the slopes under the mip of the normal map, as square roots: deviations
                      // along tangent (red) and bitangent (green); blue: signed root of covariance
    albedo,           // of the whole surface towards the eye, sampled in a white furnace: gray 0 to
                      // 1; red where the lobe gains energy, darker up to 2
    not_finite,       // magenta where the radiance is infinite or no number, else gray
    highlight_error,  // angle from the peak of the lobe to that of follow-grain: 0 to 45 degrees
    openness          // share of a uniform environment that reaches a diffuse surface: 0 to 1
};
std::span<const std::string_view> surface_view_names();  // in the order of the enumeration

// The defaults are those of the parameters of the same names: the parameter table reads them here.
struct RenderSettings {
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
    bool shadows = true;                // of punctual lights; they are never darkened otherwise
    bool ground = false;                // a shadow on the plane under the scene (ground.hpp)
    bool visibility = true;  // what Renderer::set_visibility was given is taken into account
    // For who finds it (burnish/visibility.hpp); a renderer does not read them.
    int bounces = 2;
    int visibility_rays = 256;
    // For pictures that are displayed: the radiance from which on a color is as good as white. A sample
    // with a brighter channel gets the weight limit / brightest, so that it neither sparkles nor leaves
    // an edge jagged. That darkens only pixels with such samples. 0: the plain mean, which keeps energy,
    // and which views of quantities have always.
    float robust_limit = 0.0f;
    unsigned seed = 0;
    int tile_size = 0;  // pixels a side; 0: chosen, so that memory is bounded
    SurfacePass surface_pass = SurfacePass::automatic;
    SurfaceView view = SurfaceView::radiance;
    std::optional<Method> method;  // of all materials, in place of their own
    // For pictures of a scene in motion: draws each mesh by its coarse triangles
    // (Renderer::set_coarse_mesh), and makes a missing shadow on the ground from few lights.
    bool coarse = false;

    bool operator==(const RenderSettings&) const = default;
};

}  // namespace burnish
