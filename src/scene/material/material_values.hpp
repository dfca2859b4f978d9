// A material's numbers as the values that shading/ takes, without regard to its textures: the one
// translation of a Material. The CPU evaluates these values, the renderer uploads them.
//
// Threads: functions of their arguments.
#pragma once

#include <glm/vec2.hpp>

#include "burnish/f32.hpp"
#include "burnish/f64.hpp"
#include "burnish/scene.hpp"

namespace burnish {

template <typename Surface>
struct LayersOver;
template <>
struct LayersOver<f32::SurfaceMaterial> {
    using Type = f32::SurfaceLayers;
};
template <>
struct LayersOver<f64::SurfaceMaterial> {
    using Type = f64::SurfaceLayers;
};

// `Surface`: f32::SurfaceMaterial or f64::SurfaceMaterial.
template <typename Surface>
struct MaterialValues {
    using Float = decltype(Surface::ks);

    // Colored by base_color and metallic. Of cloth: the lobe is widened by the fuzz of its fibers. Of
    // a tabulated material: kBrdfTabulated with the Fresnel factor of its refractive index; the lobe
    // and the colors are the table's.
    Surface surface;
    // Linear Rec. 709, multiplied by base color textures and vertex colors. 1 for cloth and tables,
    // which bring their own.
    dialect::Vec3<Float> base_color;
    Float metallic = 0;            // multiplied by the metallic texture; 0 for tables
    dialect::Vec2<Float> stretch;  // (cos, sin) of the angle from the tangent to the lobe's x axis
    bool grooves_along_x = true;
    // How a perturbed normal acts. Under the geometric normal all methods are `none`.
    Method method = Method::none;
    bool conserve = false;     // the energy-conserving form of deform-smooth
    bool compensated = false;  // surface_compensated is due, by the albedo seen from the eye
    // Coat and sheen; the coat's normal is (0, 0, 1).
    typename LayersOver<Surface>::Type layers;
    bool layered = false;  // one of them is there
};

template <typename Surface>
MaterialValues<Surface> material_values(const Material& material);
extern template MaterialValues<f32::SurfaceMaterial> material_values(const Material&);
extern template MaterialValues<f64::SurfaceMaterial> material_values(const Material&);

// The lobe of material_values in single precision.
f32::Lobe lobe_of(const Material& material);

// The roughness pair (alpha_x, alpha_y) of a material, at least 0.001 as in the shaders.
glm::vec2 alpha_of(const Material& material);

}  // namespace burnish
