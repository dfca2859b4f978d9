// Flat samples whose every texel is known, and what a camera sees of them: the truth of simulated
// captures (docs/theory/capture-model.md). In double precision through shading/.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/image.hpp"
#include "burnish/virtual_ndf.hpp"

namespace BURNISH_API burnish {

struct VirtualTexel {
    int ndf = 0;         // index of VirtualSample::ndfs
    double grain = 0.0;  // radians: direction of the groove, counter-clockwise from +x
    Vec3d diffuse{};     // albedo
    Vec3d specular{};    // k_s F(1)
    Vec3d normal{0.0, 0.0, 1.0};
};

struct VirtualSample {
    std::string name;
    int width = 0, height = 0;
    double width_mm = 0.0, height_mm = 0.0;
    double eta = 1.5;  // exact dielectric Fresnel, relative to normal incidence; 0: none
    std::vector<VirtualNdf> ndfs;
    std::vector<VirtualTexel> texels;  // row 0 at the top

    const VirtualTexel& at(int column, int row) const {
        return texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column)];
    }
};

// Names that make_virtual_sample knows, each with a line of help.
struct VirtualPreset {
    std::string_view name, help;
};
std::span<const VirtualPreset> virtual_presets();

struct VirtualSettings {
    int width = 64, height = 64;
    double width_mm = 60.0;
    // At 1.5 no preset reflects more light than it receives, at angles up to 85 degrees.
    double eta = 1.5;
    double tilt_deg = 0.0;  // normals wave by up to this
};

// Throws UsageError for an unknown name.
VirtualSample make_virtual_sample(std::string_view preset, const VirtualSettings& settings);

// rho(i, o) of a texel, rgb, directions in sample space; 0 below its horizon.
Vec3d virtual_brdf(const VirtualSample& sample, const VirtualTexel& texel, const Vec3d& to_light,
                   const Vec3d& to_eye);

struct VirtualCamera {
    // Standard deviation: share of the value plus kNoiseFloor of what a white diffuser would show
    // in its place.
    double noise = 0.0;
    double clip = 0.0;  // pixels end at this many times a white diffuser; 0: nowhere
    std::uint64_t seed = 1;
};
inline constexpr double kNoiseFloor = 0.02;

// What the rig's light `light` shows: I = rho (n.i) L cos^m / r^2 for every pixel, in units of the
// rig's intensities. The same whatever the number of threads.
Image virtual_picture(const VirtualSample& sample, const Rig& rig, std::size_t light,
                      const VirtualCamera& camera);

// The brightest that a white diffuser on the sample becomes under any light of the rig.
double white_level(const VirtualSample& sample, const Rig& rig);

// Rigs without pictures. Lights of the bar shine straight down, cos^1, from 40 mm above.
struct VirtualRigSettings {
    double camera_tilt_deg = 45.0;
    double camera_distance_mm = 600.0;  // 0: far away
};
Rig make_bar_rig(const VirtualSample& sample, int leds, int steps, const VirtualRigSettings& rig);
Rig make_dome_rig(const VirtualSample& sample, int lights, const VirtualRigSettings& rig);

}  // namespace burnish
