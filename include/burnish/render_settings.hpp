// What a picture of a scene is to be: size, samples, lights that count, background. Every renderer
// takes it.
//
// Threads and lifetime: plain values; copies are independent, and any number of threads may read
// one.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "burnish/api.hpp"

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
    unsigned seed = 0;
    int tile_size = 0;  // pixels a side; 0: chosen, so that memory is bounded
    SurfacePass surface_pass = SurfacePass::automatic;

    bool operator==(const RenderSettings&) const = default;
};

}  // namespace burnish
